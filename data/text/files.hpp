// Whole files in and out: bytes, their hash, and writing that leaves a file whole or not at all.
// Errors name the file, what was expected and what was found.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace meniscus {

/// The file's bytes, at most the first `most`. Throws InputError where the file is missing, empty,
/// no regular file, or cannot be read.
std::string read_whole(const std::filesystem::path& file, std::size_t max = std::string::npos);

/// SHA-256 of the file's bytes as 64 hexadecimal digits (what `sha256sum` prints). Throws
/// InputError where the file cannot be read.
std::string file_hash(const std::filesystem::path& file);

/// Throws InputError where `file` cannot be created or replaced: an empty name, the name of a
/// folder or device, a folder that is missing or not writable. For finding out before long work.
void check_can_be_written(const std::filesystem::path& file);

/// Writes bytes to `file` by way of `file`.partial beside it that is renamed at the end, so that
/// `file` appears whole or not at all. What a killed process left there is written over. Throws as
/// check_can_be_written does, and FailureError where another process is writing the same file or
/// where writing fails midway (nothing is left behind then).
void write_whole(const std::filesystem::path& file, std::string_view bytes);

} // namespace meniscus
