// Powers that a process gives up before it looks at bytes from elsewhere: a fault in a library that
// reads them is then a crash and nothing else. What is given up cannot be had back. For the sources
// of data/ only.
#pragma once

namespace meniscus {

/// Closes all descriptors but these two, which are above 2, and lets 0 to 2 lead to /dev/null.
/// Those of others stay open on kernels before 5.9.
void close_all_but(int one, int other);

/// Lets the system refuse all calls but those by which memory is had, open descriptors are read and
/// written, and the process ends: no file, program or network can be opened, and no process but its
/// own be sent a signal (seccomp(2)). Does nothing on processors and kernels that cannot.
void allow_memory_and_open_descriptors_only();

} // namespace meniscus
