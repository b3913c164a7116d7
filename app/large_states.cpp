#include "large_states.hpp"

#include <meniscus/app/ranks/ranks_of_program.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/known_names.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/periodic_copies.hpp>
#include <meniscus/data/slabs/process_memory.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cstring>
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

[[noreturn]] void refuse(const Path& file, const std::string& verb, std::uint64_t needed,
                         const std::string& why) {
    throw InputError(fmt::format("{}: takes about {} to {}, more than --memory allows, and "
                                 "cannot be read in parts: {}",
                                 file.string(), mebibytes(needed), verb, why));
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
std::string obstacle(const Snapshot& outline, const LargeStateOptions& large,
                     bool has_boundary_file) {
    const InputOptions& options = large.input;
    if (!large.obstacle.empty())
        return large.obstacle;
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
    if ((!options.periodic.empty() || outline.provenance.count("periodic") > 0) &&
        find_array(outline, "phase") != nullptr)
        return "it is periodic and has phases";
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
                                      const LargeStateOptions& options,
                                      const MemoryInOnePass& needed_by) {
    if (options.memory == 0)
        return {};
    if (!is_vtkhdf(input)) {
        const std::uint64_t needed =
            bytes_a_byte * std::filesystem::file_size(input) + own_memory();
        if (needed > options.memory)
            refuse(input, options.verb, needed, "that is only for the project's own files");
        return {};
    }
    LargeState large{input, {}};
    Snapshot& frame = large.state.frame;
    frame = read_vtkhdf_outline(input);
    if (options.input.particle_spacing) // for what is made of it
        frame.particle_spacing = options.input.particle_spacing;
    const std::uint64_t needed = needed_by(frame) + own_memory() + 76 * boundary.positions.size();
    if (needed <= options.memory)
        return {};
    const std::string why = obstacle(frame, options, !boundary.positions.empty());
    if (!why.empty())
        refuse(input, options.verb, needed, why);
    complete(frame, input, boundary, options);
    large.state.size = frame.particles_in_file;
    large.state.read = [input](std::uint64_t first, std::uint64_t count,
                               const std::vector<std::string>& arrays) {
        return read_rows(input, first, count, arrays);
    };
    return large;
}

void set_periodic(LargeState& large, const InputOptions& options, Ranks& ranks) {
    Snapshot& frame = large.state.frame;
    const auto stored = frame.provenance.find("periodic");
    const std::string text = !options.periodic.empty()          ? options.periodic
                             : stored != frame.provenance.end() ? stored->second
                                                                : "";
    if (text.empty())
        return;
    std::string near;
    do_together(ranks, [&] {
        constexpr std::uint64_t at_once = 1 << 17;
        const PeriodicBox box = periodic_box(text);
        const std::uint64_t end = first_of_share(large.state.size, ranks.rank() + 1, ranks.size());
        for (std::uint64_t first = first_of_share(large.state.size, ranks.rank(), ranks.size());
             first < end; first += at_once) {
            const Positions rows =
                read_rows(large.file, first, std::min(at_once, end - first), {}).positions;
            const auto chosen = near_periodic_sides(rows, first, frame, box, *frame.support_radius);
            for (std::size_t i = 0; i < rows.size(); ++i)
                if (chosen[i] != 0)
                    near.append(reinterpret_cast<const char*>(&rows[i]), sizeof rows[i]);
        }
    });
    frame.positions.clear();
    for (const std::string& bytes : gather(ranks, near))
        for (std::size_t at = 0; at < bytes.size(); at += sizeof frame.positions[0])
            std::memcpy(&frame.positions.emplace_back(), &bytes[at], sizeof frame.positions[0]);
    do_together(ranks, [&] { set_periodic(frame, options); });
    frame.positions = Positions();
}

std::uint64_t write_large(const LargeState& large, const Snapshot& frame, const FoundValues& found,
                          const Path& output, Ranks& ranks) {
    FetchedSnapshot fetched;
    fetched.frame = frame;
    fetched.size = large.state.size;
    fetched.positions = [&](std::uint64_t first, std::uint64_t count) {
        return read_rows(large.file, first, count, {}).positions;
    };
    fetched.values = [&](std::size_t place, std::uint64_t first, std::uint64_t count) {
        const PointArray& array = fetched.frame.point_data[place];
        if (auto values = found(array, first, count))
            return std::move(*values);
        return read_values(large.file, array, first, count);
    };
    return write_together(fetched, output, ranks);
}

std::string slab_line(const SlabFigures& figures, Ranks& ranks) {
    std::vector<std::uint64_t> sums = {figures.halo, figures.sent};
    ranks.sum(sums);
    std::vector<double> peak = {static_cast<double>(peak_memory())};
    ranks.max(peak);
    std::string line = fmt::format(
        "    in {} slabs; {} particles twice, as neighbors of others; at most {:.0f} MiB of memory",
        figures.slabs, sums[0], peak[0] / 0x1p20);
    if (ranks.size() > 1)
        line += fmt::format("; {} ranks exchanged {:.1f} MiB", ranks.size(),
                            static_cast<double>(sums[1]) / 0x1p20);
    return line + "\n";
}

} // namespace meniscus
