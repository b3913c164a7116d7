// Which files the words of a command line stand for: files as they are, folders, and patterns that
// the shell did not expand or cannot: numbers of frames in their natural order.
#pragma once

#include "command_line.hpp"

#include <string>
#include <vector>

namespace meniscus {

/// What INPUT may be, for the help of verbs.
inline constexpr const char* input_kinds =
    "files, folders, or patterns in quotes: '*', '?' and '[...]' as in a shell, '{}' for the "
    "number "
    "of a frame, '{0..99}' and '{0:99:10}' for some of them, the last one included";

/// The files that `words` stand for, in the order of the words. A word that is the name of a file
/// stands for it. A folder stands for the snapshots in it, checkpoints and logs of `simulate` left
/// out; a pattern for the files whose names it matches: both in natural order, 2 before 10. A file
/// that was named before is left out. Throws InputError, naming the word, where nothing is there,
/// where a folder holds snapshots of different kinds, or where a pattern cannot be understood.
std::vector<Path> input_files(const std::vector<Path>& words);

/// Whether the name is that of a checkpoint of `meniscus simulate`.
bool is_checkpoint_name(const Path& file);

/// Whether `a` comes before `b` where runs of digits count as numbers.
bool is_before(const std::string& a, const std::string& b);

} // namespace meniscus
