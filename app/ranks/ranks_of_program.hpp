// The processes that this one was started with, by mpirun or srun, where the program is built with
// MENISCUS_MPI; else, or where it was started by itself, this one alone. All that the project has
// of MPI is in this folder.
#pragma once

#include <meniscus/data/ranks/ranks.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// The ranks, all of which must ask for them.
Ranks& ranks_of_program();

/// Ends what ranks_of_program() has begun; nothing where nobody asked. To be called once, at the
/// end, by whatever way.
void end_ranks();

/// Whether this process was started as one of several and is not the first: it prints nothing.
bool is_other_rank();

/// Does a piece of work and returns what rank 0 is to know of it. Must not throw.
using WorkOnPiece = std::function<std::string(std::size_t piece)>;

/// Gets, on rank 0, what is known of a piece; false: no more pieces are to be begun.
using TakeResult = std::function<bool(std::size_t piece, const std::string& result)>;

/// Hands out pieces of work in this order, each to the rank that is free next. Collective; there
/// must be several ranks.
void hand_out(Ranks& ranks, const std::vector<std::size_t>& pieces, const WorkOnPiece& work,
              const TakeResult& take);

} // namespace meniscus
