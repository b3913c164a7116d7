// What a file seems to be that no reader takes, and what to do about it, for the message that
// refuses it.
#pragma once

#include <filesystem>
#include <string>

namespace meniscus {

/// "Houdini's newer .bgeo (JSON); save it as ...". Throws InputError where the file is missing or
/// empty.
std::string description_of(const std::filesystem::path& file);

} // namespace meniscus
