#include "shipped_files.hpp"

#include <meniscus/data/text/errors.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

Path shipped_folder(const char* name) {
    std::error_code ignored;
    const Path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    Path folder = program.parent_path().parent_path() / "share/meniscus" / name;
    if (!std::filesystem::is_directory(folder))
        throw InputError(fmt::format("{}: the {} that come with the project are missing; install "
                                     "it again or run it from its build folder",
                                     folder.string(), name));
    return folder;
}

} // namespace

std::vector<Path> sample_snapshots() {
    const Path folder = shipped_folder("samples");
    std::vector<Path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".vtkhdf")
            files.push_back(entry.path());
    if (files.empty())
        throw InputError(fmt::format("{}: the sample snapshots are missing; install the project "
                                     "again or run it from its build folder",
                                     folder.string()));
    std::sort(files.begin(), files.end());
    return files;
}

Path shipped_scenes() {
    return shipped_folder("scenes");
}

Path shipped_studies() {
    return shipped_folder("studies");
}

Path shipped_models() {
    return shipped_folder("models");
}

} // namespace meniscus
