// The same work on many files: in parallel where they are many and small, with what is said of them
// in their order, how far it is, and a summary in place of a line a file where they are many.
#pragma once

#include "command_line.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace meniscus {

/// What there is to say of one file that was worked on.
struct FileReport {
    std::vector<std::string> warnings;   ///< a line each
    std::string text;                    ///< lines for standard output
    bool is_up_to_date = false;          ///< there was nothing to do
    std::array<std::size_t, 3> counts{}; ///< of FileBatch::counted, for the summary
    std::string found{};                 ///< for FileBatch::collect, packed (packing.hpp)
};

struct FileBatch {
    std::string doing;                    ///< "labelling"
    std::string done;                     ///< "labelled"
    std::array<const char*, 3> counted{}; ///< what FileReport::counts are of; null: no summary
    int threads = 0;                      ///< 0: all cores
    bool quiet = false;
    bool keep_going = false; ///< a file that is at fault stops no other
    /// Takes what was found in a file, in no certain order, one at a time; null: nothing is.
    std::function<void(std::size_t, const std::string&)> collect = nullptr;
    // Where several ranks share the files:
    /// Whether all ranks work on a file together; null: on none. Asked on the first rank.
    std::function<bool(std::size_t)> is_shared = nullptr;
    /// The work on such a file, which every rank does.
    std::function<FileReport(std::size_t)> work_together = nullptr;
};

/// Whether so many threads work on a file each: they hold as many in memory.
bool are_many_and_small(const std::vector<Path>& files, int threads);

/// Adds --keep-going to a verb.
void add_keep_going_option(CLI::App& verb, bool& keep_going);

/// Calls `work(index, threads)` for each file. `threads` is how many it may use: all of the batch,
/// or one where files are worked on in parallel. Prints what it returns. Throws what work throws
/// for the first file at fault, then or, with keep_going, as an InputError that counts them at the
/// end; the files before that one are done. Of several ranks (app/ranks/) each takes the largest
/// file that is left when it is free, and the first prints and throws; on others nothing is thrown.
void for_each_file(const std::vector<Path>& files, const FileBatch& batch,
                   const std::function<FileReport(std::size_t, int)>& work);

/// The same where `outputs` are written, one of each file: lists those that are there as a series
/// (frame_series.hpp), whatever is thrown after.
void write_for_each_file(const std::vector<Path>& files, const std::vector<Path>& outputs,
                         const FileBatch& batch,
                         const std::function<FileReport(std::size_t, int)>& work);

} // namespace meniscus
