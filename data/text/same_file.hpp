// Whether two names mean one file. Nothing that a program writes may be what it reads, by whatever
// name, link or `..` it is called.
#pragma once

#include <filesystem>
#include <vector>

namespace meniscus {

/// By device and inode or, where neither is there yet, by where the names lead once links and `..`
/// are followed. An empty name means no file.
bool is_same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// Throws InputError, naming it, where a file to be written is one of those that are read.
void check_is_not_an_input(const std::filesystem::path& output,
                           const std::vector<std::filesystem::path>& inputs);

} // namespace meniscus
