// Processes that share one task: what a state, or a campaign, that is worked on in parts needs of
// them. One process is the case of one rank, and does the same work in the same order; app/ranks/
// has the one of MPI. All calls are collective: each rank makes the same ones in the same order.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

class Ranks {
public:
    virtual ~Ranks() = default;

    [[nodiscard]] virtual int rank() const = 0; ///< of this process, from 0
    [[nodiscard]] virtual int size() const = 0; ///< number of processes

    /// Sends each rank its bytes, `for_rank[r]` to rank r, and returns what the ranks had for this
    /// one, in their order.
    virtual std::vector<std::string> exchange(std::vector<std::string> for_rank) = 0;

    /// Replaces each value by its sum, its minimum or its maximum over all ranks.
    virtual void sum(std::vector<std::uint64_t>& values) = 0;
    virtual void min(std::vector<double>& values) = 0;
    virtual void max(std::vector<double>& values) = 0;
};

/// This process alone.
Ranks& one_process();

/// The first of a rank's share of so many things that follow on each other; `rank` may be the
/// number of ranks, where the last share ends.
inline std::uint64_t first_of_share(std::uint64_t count, int rank, int ranks) {
    const auto part = static_cast<std::uint64_t>(rank);
    const auto parts = static_cast<std::uint64_t>(ranks);
    return count / parts * part + count % parts * part / parts;
}

/// Does this rank's share of a step. Where that throws on any rank, all throw the error of the
/// first of them, so that none waits for another. InputError and FailureError stay what they are.
void do_together(Ranks& ranks, const std::function<void()>& share);

/// What each rank says, on all of them, in the order of ranks.
std::vector<std::string> gather(Ranks& ranks, const std::string& said);

/// The value at a place, in ascending order, of positive numbers that all ranks have together:
/// `visit` calls its argument with each one of this rank, four times in all. Memory does not grow
/// with their number.
double nth_of_all(Ranks& ranks, std::uint64_t place,
                  const std::function<void(const std::function<void(double)>&)>& visit);

} // namespace meniscus
