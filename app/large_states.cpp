#include "large_states.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/known_names.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/periodic_copies.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace meniscus {
namespace {

/// What the program takes for itself, and MPI where there are several ranks.
std::uint64_t own_memory() {
    return std::uint64_t{ranks_of_program().size() > 1 ? 52U : 28U} << 20;
}

/// Bytes that a file of another format takes in memory are told by its size alone.
constexpr std::uint64_t bytes_a_byte = 8;

std::string mebibytes(std::uint64_t bytes) {
    return fmt::format("{} MiB", (bytes >> 20) + 1);
}

[[noreturn]] void refuse(const Path& file, std::uint64_t needed, const std::string& why) {
    throw InputError(fmt::format("{}: takes about {} to label, more than --memory allows, and "
                                 "cannot be read in parts: {}",
                                 file.string(), mebibytes(needed), why));
}

bool has_same_names(const Snapshot& outline) {
    Snapshot settled = outline;
    use_our_names(settled);
    return std::equal(settled.point_data.begin(), settled.point_data.end(),
                      outline.point_data.begin(), outline.point_data.end(),
                      [](const PointArray& a, const PointArray& b) {
                          return a.name == b.name && a.components == b.components;
                      });
}

/// What keeps a state from being read in rows; empty: nothing.
std::string obstacle(const Snapshot& outline, const InputOptions& options, bool has_boundary_file) {
    const auto has_name = [](const PointArray& array) { return lowered(array.name) == "type"; };
    if (!options.fluid.empty() || !options.walls.empty() || !options.ignored.empty() ||
        std::any_of(outline.point_data.begin(), outline.point_data.end(), has_name))
        return "its particles are chosen by their data";
    if (!outline.dimension_is_stated || !has_same_names(outline))
        return "another program wrote it";
    if (options.frame)
        return "--frame is for files of several states";
    if (options.dimension.value_or(outline.dimension) != outline.dimension)
        return "--dimension is not what it says";
    if (outline.dimension == 2 && has_boundary_file)
        return "its plane must be known for --boundary";
    if (!options.periodic.empty() || outline.provenance.count("periodic") > 0)
        return "it is periodic";
    if (!outline.support_radius && !options.support_radius && !options.particle_radius)
        return "it has no support radius for all of its particles; give one by --support-radius";
    return {};
}

/// As read_to_label completes what it has read.
void complete(Snapshot& frame, const Path& file, const Boundary& boundary,
              const LargeStateOptions& options) {
    set_options(frame, file, options.input);
    if (options.no_boundary)
        remove_periodic_copies(frame);
    else if (boundary.positions.empty())
        frame.boundary = read_vtkhdf_boundary(file);
    set_boundary(frame, boundary);
}

Snapshot read_rows(const Path& file, std::uint64_t first, std::uint64_t count,
                   const std::vector<std::string>& arrays) {
    return read_vtkhdf_part(file, {first, count, arrays});
}

ArrayValues read_values(const Path& file, const PointArray& array, std::uint64_t first,
                        std::uint64_t count) {
    Snapshot part = read_vtkhdf_part(file, {first, count, {array.name}, false});
    ArrayValues& values = part.point_data.at(0).values;
    const std::size_t found = std::visit([](const auto& all) { return all.size(); }, values);
    if (values.index() != array.values.index() ||
        found != count * static_cast<std::uint64_t>(array.components))
        throw InputError(
            fmt::format("{}: '{}' has changed while it was read", file.string(), array.name));
    return std::move(values);
}

std::vector<std::uint8_t> is_surface(const std::vector<double>& lambda) {
    std::vector<std::uint8_t> surface(lambda.size());
    std::transform(lambda.begin(), lambda.end(), surface.begin(), [](double one) {
        return static_cast<std::uint8_t>(one > zero_uncovered_fraction);
    });
    return surface;
}

/// Rows of an array that labelling adds, as the frame's empty array has them; nothing where it is
/// one of the input's own.
std::optional<ArrayValues> label_values(const PointArray& array, const RowResults& rows,
                                        std::uint64_t first, std::uint64_t count,
                                        const LabelOptions& options) {
    const auto column = [&](std::size_t number) { return rows.column(number, first, count); };
    if (array.name == "uncovered_fraction")
        return column(lambda_column);
    if (array.name == "surface")
        return stored_classes(is_surface(column(lambda_column)));
    if (array.name == "valid")
        return stored_classes(rows.was_added(first, count));
    if (array.name == "mass_offset")
        return column(mass_offset_column);
    if (array.name == "neighbor_count") {
        std::vector<double> counts = column(count_column);
        if (std::holds_alternative<std::vector<std::uint32_t>>(array.values))
            return std::vector<std::uint32_t>(counts.begin(), counts.end());
        return counts;
    }
    for (std::size_t f = 0; f < options.features.size(); ++f)
        if (array.name == feature_list[options.features[f]].name)
            return column(label_columns + f);
    return std::nullopt;
}

/// Writes a file that each rank has its share of. Returns the bytes that this one sent.
std::uint64_t write_together(const FetchedSnapshot& fetched, const Path& output, Ranks& ranks) {
    if (ranks.size() == 1) {
        const WriteGuard guard;
        write_vtkhdf(fetched, output);
        return 0;
    }
    const PackedDatasets packed = pack_vtkhdf(fetched, output.parent_path(), ranks);
    do_together(ranks, [&] {
        if (ranks.rank() > 0)
            return;
        const WriteGuard guard;
        write_vtkhdf(fetched, packed, output);
    });
    return packed.bytes_sent();
}

} // namespace

void add_memory_option(CLI::App& verb, std::uint64_t& memory, const std::string& meaning) {
    verb.add_option("--memory", memory,
                    "Memory that may be taken, as in 8GB or 500MB (default: no limit). " + meaning)
        ->transform(CLI::AsSizeValue(false))
        ->type_name("SIZE");
}

std::optional<LargeState> large_state(const Path& input, const Boundary& boundary,
                                      const LargeStateOptions& options, const LabelOptions& label) {
    if (options.memory == 0)
        return {};
    if (!is_vtkhdf(input)) {
        const std::uint64_t needed =
            bytes_a_byte * std::filesystem::file_size(input) + own_memory();
        if (needed > options.memory)
            refuse(input, needed, "that is only for the project's own files");
        return {};
    }
    LargeState large{input, {}};
    Snapshot& frame = large.state.frame;
    frame = read_vtkhdf_outline(input);
    const std::uint64_t needed =
        memory_in_one_pass(frame, label) + own_memory() + 76 * boundary.positions.size();
    if (needed <= options.memory)
        return {};
    const std::string why = obstacle(frame, options.input, !boundary.positions.empty());
    if (!why.empty())
        refuse(input, needed, why);
    complete(frame, input, boundary, options);
    large.state.size = frame.particles_in_file;
    large.state.read = [input](std::uint64_t first, std::uint64_t count,
                               const std::vector<std::string>& arrays) {
        return read_rows(input, first, count, arrays);
    };
    return large;
}

std::uint64_t write_large(const LargeState& large, const LabelsInFile& labels,
                          const LabelOptions& options, const Path& output, Ranks& ranks) {
    FetchedSnapshot fetched;
    fetched.frame = large.state.frame;
    fetched.size = large.state.size;
    const SupportRadii radius = *fetched.frame.support_radius;
    Labels none;
    none.features.resize(options.features.size());
    none.spacing_ratio = labels.spacing_ratio;
    add_labels(fetched.frame, none, radius, options);
    fetched.positions = [&](std::uint64_t first, std::uint64_t count) {
        return read_rows(large.file, first, count, {}).positions;
    };
    fetched.values = [&](std::size_t place, std::uint64_t first, std::uint64_t count) {
        const PointArray& array = fetched.frame.point_data[place];
        if (auto found = label_values(array, *labels.rows, first, count, options))
            return std::move(*found);
        return read_values(large.file, array, first, count);
    };
    return write_together(fetched, output, ranks);
}

} // namespace meniscus
