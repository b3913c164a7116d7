#include "earlier_outputs.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace meniscus {
namespace {

/// Whether the file holds these bytes.
bool holds_text(const Path& file, const std::string& text) {
    std::ifstream stream(file, std::ios::binary);
    std::string block;
    for (;;) {
        const std::size_t kept = std::min(block.size(), text.size() - 1); // may be its beginning
        block.erase(0, block.size() - kept);
        block.resize(kept + (1 << 16));
        stream.read(&block[kept], 1 << 16);
        block.resize(kept + static_cast<std::size_t>(stream.gcount()));
        if (block.find(text) != std::string::npos)
            return true;
        if (!stream)
            return false;
    }
}

} // namespace

std::optional<Snapshot> earlier_output(const Path& output, const char* array) {
    if (!std::filesystem::exists(output))
        return {};
    try {
        Snapshot header = is_hdf5(output) ? read_vtkhdf_header(output) : Snapshot{};
        if (find_array(header, array) != nullptr)
            return header;
    } catch (const InputError&) { // a damaged file, a folder
    }
    throw InputError(fmt::format("{}: exists and is no snapshot with '{}'; remove it or choose "
                                 "another folder with -o",
                                 output.string(), array));
}

bool is_up_to_date(const Path& output, const std::string& request) {
    std::error_code unknown;
    return std::filesystem::is_regular_file(output, unknown) &&
           std::filesystem::file_size(output, unknown) > 0 && is_own_hdf5_of_full_length(output) &&
           holds_text(output, request);
}

void set_input_provenance(Snapshot& snapshot, const Path& input) {
    const Path whole = std::filesystem::canonical(input);
    const Path folder = whole.parent_path();
    snapshot.provenance["input"] =
        (folder.parent_path().filename() / folder.filename() / whole.filename()).string();
    snapshot.provenance["input_hash"] = file_hash(input);
}

void check_made_from_same(const Path& output, const std::optional<Snapshot>& earlier,
                          const Snapshot& snapshot) {
    const auto is_same = [&](const char* name) {
        const auto entry = earlier->provenance.find(name);
        return entry != earlier->provenance.end() && entry->second == snapshot.provenance.at(name);
    };
    if (!earlier || is_same("input_hash") || is_same("input"))
        return;
    const auto name = earlier->provenance.find("input");
    throw InputError(fmt::format("{}: was made from another input{}; choose another folder with "
                                 "-o, or --overwrite",
                                 output.string(),
                                 name == earlier->provenance.end() ? "" : ", " + name->second));
}

} // namespace meniscus
