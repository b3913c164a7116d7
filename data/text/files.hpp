// Whole files in and out: bytes, their hash, and writing that leaves a file whole or not at all.
// Errors name the file, what was expected and what was found.
#pragma once

#include "descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace meniscus {

/// Opens a regular file for reading, without waiting for anything, under a number above those of
/// the standard streams. Throws InputError where it is missing, of another kind, or closed to us;
/// FailureError where the machine cannot open it.
Descriptor open_regular_file(const std::filesystem::path& file);

/// Bytes in an open file; the path is its name in messages. Throws FailureError where the machine
/// cannot tell.
std::uint64_t size_of(const Descriptor& opened, const std::filesystem::path& file);

/// The file's bytes, at most the first `max`. Throws as open_regular_file does, InputError where
/// the file is empty, and FailureError where it cannot be read.
std::string read_whole(const std::filesystem::path& file, std::size_t max = std::string::npos);

/// SHA-256 of the file's bytes as 64 hexadecimal digits (what `sha256sum` prints). Throws as
/// open_regular_file does, and FailureError where the file cannot be read.
std::string file_hash(const std::filesystem::path& file);

/// Throws InputError where `file` cannot be created or replaced: an empty name, the name of a
/// folder or device, a folder that is missing or not writable. For finding out before long work.
void check_can_be_written(const std::filesystem::path& file);

/// Writes bytes to `file` by way of a new file of a random name beside it that is renamed at the
/// end, so that `file` appears whole or not at all. A file that is replaced hands on its rights; a
/// symbolic link stays one, and what it leads to is written. What a killed process of the same user
/// left there, `file`.DIGITS.partial, is removed. Throws as check_can_be_written does, and
/// FailureError where another process is writing the same file or where writing fails midway
/// (nothing is left behind then).
void write_whole(const std::filesystem::path& file, std::string_view bytes);

/// The same where `fill` writes, to a descriptor that is open for reading and writing. What it
/// throws leaves nothing behind.
void write_whole(const std::filesystem::path& file, const std::function<void(int)>& fill);

/// Throws the FailureError of a file that cannot be written for that error of the system.
[[noreturn]] void fail_to_write(const std::filesystem::path& file, int error);

} // namespace meniscus
