#include "generic_names.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace meniscus {
namespace {

constexpr std::string_view generic_stems[] = {"particledata_fluid", "particledata", "partfluid"};
constexpr std::string_view generic_folders[] = {"vtk",       "partio", "bgeo",
                                                "particles", "output", "."};

template <std::size_t Count>
bool is_one_of(const std::string& name, const std::string_view (&names)[Count]) {
    return std::find(std::begin(names), std::end(names), lowered(name)) != std::end(names);
}

} // namespace

std::string telling_stem(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    const std::size_t last_letter = stem.find_last_not_of("0123456789_");
    const std::string name = stem.substr(0, last_letter + 1);
    if (!is_one_of(name, generic_stems))
        return stem;
    auto folder = std::filesystem::absolute(file).lexically_normal().parent_path();
    while (folder.has_relative_path() && is_one_of(folder.filename().string(), generic_folders))
        folder = folder.parent_path();
    return folder.has_relative_path() ? folder.filename().string() + stem.substr(name.size())
                                      : stem;
}

} // namespace meniscus
