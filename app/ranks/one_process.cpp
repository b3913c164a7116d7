// The program without MPI.
#include "ranks_of_program.hpp"

#include <stdexcept>

namespace meniscus {

Ranks& ranks_of_program() {
    return one_process();
}

void end_ranks() {}

bool is_other_rank() {
    return false;
}

void hand_out(Ranks& /*ranks*/, const std::vector<std::size_t>& /*pieces*/,
              const WorkOnPiece& /*work*/, const TakeResult& /*take*/) {
    throw std::logic_error("one process has nobody to hand work to");
}

} // namespace meniscus
