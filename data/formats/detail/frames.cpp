#include "frames.hpp"

#include <meniscus/data/text/errors.hpp>

namespace meniscus {

std::uint64_t frame_to_read(const ReadChoices& choices, std::uint64_t count) {
    const std::uint64_t frame = choices.frame.value_or(count - 1);
    if (frame >= count)
        throw InputError("--frame " + std::to_string(frame) + ": expected one of 0 to " +
                         std::to_string(count - 1) + ", as the file holds " +
                         std::to_string(count) + (count == 1 ? " state" : " states"));
    return frame;
}

void note_frame(Snapshot& snapshot, const ReadChoices& choices, std::uint64_t frame,
                std::uint64_t count, const std::string& place) {
    snapshot.provenance["frame"] = std::to_string(frame);
    if (count == 1)
        return;
    const std::string which =
        choices.frame ? "state " + std::to_string(frame) + " of 0 to " + std::to_string(count - 1)
                      : "the last of " + std::to_string(count) + " states";
    snapshot.notes.push_back(which + " is read" + (place.empty() ? "" : ", " + place) +
                             (choices.frame ? "" : "; --frame chooses another"));
}

void expect_no_frame(const ReadChoices& choices) {
    if (choices.frame)
        throw InputError("--frame " + std::to_string(*choices.frame) +
                         ": expected a file that may hold several states, found a format of one; "
                         "leave --frame out");
}

} // namespace meniscus
