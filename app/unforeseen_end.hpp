// Ends that no verb foresees. Libraries end the whole program where the machine fails them: libgomp
// without memory or threads, HDF5 without memory, by exit() with a status that means something else
// here. And an exception that comes up while another is thrown, as where memory is at its end,
// reaches nobody. Both become what any failure of the machine is: one line, and exit status 3.
#pragma once

namespace meniscus {

/// From its construction to its end, the end of main(), the program is not to end otherwise. One in
/// a program.
class UnforeseenEnd {
public:
    UnforeseenEnd();
    UnforeseenEnd(const UnforeseenEnd&) = delete;
    UnforeseenEnd& operator=(const UnforeseenEnd&) = delete;
    ~UnforeseenEnd();
};

} // namespace meniscus
