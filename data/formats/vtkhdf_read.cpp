#include "vtkhdf.hpp"

#include "detail/frames.hpp"
#include "detail/hdf5_formats.hpp"
#include "detail/number_blocks.hpp"
#include <meniscus/data/hdf5/deflate.hpp>
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/hdf5/isolated_read.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view polydata_type = "PolyData";

/// Steps of a series; 1 where the file is none.
std::uint64_t step_count(const Hdf5Source& source) {
    if (!exists(source, "/VTKHDF/Steps"))
        return 1;
    const auto steps = number_attribute<std::int64_t>(source, "/VTKHDF/Steps", "NSteps", 1);
    if (steps.size() != 1 || steps[0] < 1)
        fail(source, "/VTKHDF/Steps attribute NSteps", "a positive number",
             "none that is readable");
    return static_cast<std::uint64_t>(steps[0]);
}

/// A series is one state where it has one step.
void check_is_one_state(const Hdf5Source& source) {
    if (const std::uint64_t steps = step_count(source); steps != 1)
        fail(source, "/VTKHDF/Steps", "one state", "a series of " + std::to_string(steps));
}

/// The time of the one step, where it is stored.
std::optional<double> read_step_time(const Hdf5Source& source) {
    const std::string path = "/VTKHDF/Steps/Values";
    if (!exists(source, "/VTKHDF/Steps") || !exists(source, path))
        return std::nullopt;
    const auto values = as_doubles({"Values", 1, read_numbers(source, open_dataset(source, path))});
    return values.size() == 1 && std::isfinite(values[0]) ? std::make_optional(values[0])
                                                          : std::nullopt;
}

void check_grid(const Hdf5Source& source) {
    const std::string type = text_attribute(source, "/VTKHDF", "Type");
    if (type != grid_type && type != polydata_type) {
        fail(source, "/VTKHDF attribute Type",
             std::string(grid_type) + " or " + std::string(polydata_type),
             type.empty() ? "none that is readable" : "'" + type + "', which is not supported");
    }
    const auto version = number_attribute<std::int64_t>(source, "/VTKHDF", "Version", 2);
    if (version.size() != 2 || version[0] < 1 || version[0] > 2) {
        fail(source, "/VTKHDF attribute Version", "two numbers, the first 1 or 2",
             version.size() == 2 ? std::to_string(version[0]) : "none that is readable");
    }
}

/// HDF5 cuts fractions off where it is asked for integers.
void check_is_whole(const Hdf5Source& source, const Dataset& dataset) {
    if (H5Tget_class(Handle(H5Dget_type(dataset.id), H5Tclose)) == H5T_INTEGER)
        return;
    for (const double number : as_doubles({"", 1, read_numbers(source, dataset)}))
        if (number != std::floor(number))
            fail(source, dataset.path, "whole numbers", number_text(number));
}

/// The sum over the partitions of the grid.
std::uint64_t read_count(const Hdf5Source& source, const std::string& path) {
    const Dataset dataset = open_dataset(source, path);
    check_is_whole(source, dataset);
    std::vector<std::int64_t> counts(value_count(dataset));
    read_into(source, dataset, number_type<std::int64_t>(), counts.data());
    std::uint64_t sum = 0;
    for (const std::int64_t count : counts) {
        const std::uint64_t max = source.bytes * max_compression - sum;
        if (count < 0 || static_cast<std::uint64_t>(count) > max)
            fail(source, path, "counts that the file can hold", std::to_string(count));
        sum += static_cast<std::uint64_t>(count);
    }
    return sum;
}

/// The positions of a file of so many particles, whose precision the snapshot gets.
Dataset open_points(const Hdf5Source& source, std::uint64_t count, Snapshot& snapshot) {
    Dataset points = open_dataset(source, "/VTKHDF/Points");
    if (points.dimensions != Dimensions{count, 3}) {
        fail(source, points.path, std::to_string(count) + " x 3 coordinates",
             shown(points.dimensions));
    }
    const ArrayValues type = empty_values(source, points);
    const bool single = std::holds_alternative<std::vector<float>>(type);
    if (!single && !std::holds_alternative<std::vector<double>>(type))
        fail(source, points.path, "float or double", "integers");
    snapshot.position_precision = single ? Precision::float32 : Precision::float64;
    return points;
}

void read_points(const Hdf5Source& source, Snapshot& snapshot) {
    const std::uint64_t count = read_count(source, "/VTKHDF/NumberOfPoints");
    const Dataset points = open_points(source, count, snapshot);
    snapshot.positions.resize(count);
    read_into(source, points, number_type<double>(), snapshot.positions.data());
}

/// One of the whole numbers of a list that a series has, an entry a step or a partition.
std::uint64_t number_at(const Hdf5Source& source, const std::string& path, std::uint64_t index) {
    const Dataset dataset = open_dataset(source, path);
    if (dataset.dimensions.size() != 1 || dataset.dimensions[0] <= index)
        fail(source, path, "more than " + std::to_string(index) + " numbers",
             shown(dataset.dimensions));
    check_is_whole(source, dataset);
    std::int64_t number = 0;
    read_into(source, dataset, {index, 1}, number_type<std::int64_t>(), &number);
    if (number < 0)
        fail(source, path, "no negative number", std::to_string(number));
    return static_cast<std::uint64_t>(number);
}

/// Rows of a dataset of particles, which must have them, and `width` columns where that is not 0.
Dataset open_rows(const Hdf5Source& source, const std::string& path, const Rows& rows,
                  std::uint64_t width) {
    Dataset dataset = open_dataset(source, path);
    const Dimensions& found = dataset.dimensions;
    if (found.empty() || found.size() > 2 || found[0] < rows.first ||
        found[0] - rows.first < rows.count ||
        (width != 0 && (found.size() != 2 || found[1] != width)))
        fail(source, path, std::to_string(rows.first + rows.count) + " rows or more", shown(found));
    return dataset;
}

/// Where the points of a step lie: those of its partitions, one behind the other.
Rows points_of_step(const Hdf5Source& source, std::uint64_t step) {
    const std::string steps = "/VTKHDF/Steps/";
    const std::uint64_t parts = exists(source, steps + "NumberOfParts")
                                    ? number_at(source, steps + "NumberOfParts", step)
                                    : 1;
    const std::uint64_t first_part = number_at(source, steps + "PartOffsets", step);
    Rows rows = {number_at(source, steps + "PointOffsets", step), 0};
    const std::uint64_t max = source.bytes * max_compression;
    for (std::uint64_t part = 0; part < parts; ++part) {
        rows.count += number_at(source, "/VTKHDF/NumberOfPoints", first_part + part);
        if (rows.count > max || rows.first > max)
            fail(source, "/VTKHDF/NumberOfPoints", "counts that the file can hold", "larger ones");
    }
    return rows;
}

void check_are_vertices(const Hdf5Source& source, const std::string& path,
                        const std::vector<std::uint8_t>& types) {
    for (const std::uint8_t type : types) {
        if (type != vertex_cell && type != poly_vertex_cell) {
            fail(source, path, "particles (vertex cells, type 1)",
                 "cell type " + std::to_string(type) + "; a mesh is no snapshot");
        }
    }
}

/// A mesh has points too, but they are no particles.
void check_cells(const Hdf5Source& source) {
    for (const char* mesh : {"Lines", "Polygons", "Strips"}) {
        const std::string path = "/VTKHDF/" + std::string(mesh);
        if (exists(source, path) && exists(source, path + "/NumberOfCells") &&
            read_count(source, path + "/NumberOfCells") > 0)
            fail(source, path, "no cells but Vertices", "some; a mesh is no snapshot");
    }
    const std::string path = "/VTKHDF/Types";
    if (!exists(source, path))
        return;
    const Dataset types = open_dataset(source, path);
    const std::uint64_t count = read_count(source, "/VTKHDF/NumberOfCells");
    if (types.dimensions != Dimensions{count} ||
        !std::holds_alternative<std::vector<std::uint8_t>>(empty_values(source, types)))
        fail(source, path, std::to_string(count) + " cell types of one byte", "something else");
    constexpr std::uint64_t at_once = 1 << 20;
    std::vector<std::uint8_t> some(std::min(count, at_once));
    for (std::uint64_t first = 0; first < count; first += at_once) {
        some.resize(std::min(at_once, count - first));
        read_into(source, types, {first, some.size()}, number_type<std::uint8_t>(), some.data());
        check_are_vertices(source, path, some);
    }
}

/// Point data of a file of so many particles.
Dataset open_point_data(const Hdf5Source& source, const std::string& name, std::uint64_t size) {
    Dataset dataset = open_dataset(source, "/VTKHDF/PointData/" + name);
    const Dimensions& found = dataset.dimensions;
    if (found.empty() || found.size() > 2 || found[0] != size ||
        (found.size() == 2 && (found[1] < 1 || found[1] > 1'000'000))) {
        fail(source, dataset.path,
             std::to_string(size) + " or " + std::to_string(size) +
                 " x components values, as there are particles",
             shown(found));
    }
    return dataset;
}

int components_of(const Dataset& dataset) {
    return dataset.dimensions.size() == 2 ? static_cast<int>(dataset.dimensions[1]) : 1;
}

void read_point_data(const Hdf5Source& source, Snapshot& snapshot) {
    for (const std::string& name : array_names_in(source, "/VTKHDF/PointData")) {
        const Dataset dataset = open_point_data(source, name, snapshot.size());
        snapshot.point_data.push_back(
            {name, components_of(dataset), read_numbers(source, dataset)});
    }
}

/// A single number of FieldData, where it is stored.
std::optional<double> read_field(const Hdf5Source& source, const std::string& name) {
    const std::string path = "/VTKHDF/FieldData/" + name;
    if (!exists(source, "/VTKHDF/FieldData") || !exists(source, path))
        return std::nullopt;
    const PointArray field{name, 1, read_numbers(source, open_dataset(source, path))};
    const std::vector<double> values = as_doubles(field);
    if (values.size() != 1 || !std::isfinite(values[0])) {
        fail(source, path, "one finite number",
             values.size() == 1 ? number_text(values[0])
                                : std::to_string(values.size()) + " values");
    }
    return values[0];
}

std::optional<double> read_positive(const Hdf5Source& source, const std::string& name) {
    const std::optional<double> value = read_field(source, name);
    if (value && *value <= 0)
        fail(source, "/VTKHDF/FieldData/" + name, "a positive number", number_text(*value));
    return value;
}

void read_field_data(const Hdf5Source& source, Snapshot& snapshot) {
    snapshot.support_radius = read_positive(source, "support_radius");
    snapshot.particle_spacing = read_positive(source, "particle_spacing");
    snapshot.particle_volume = read_positive(source, "particle_volume");
    snapshot.time = read_field(source, "time");
    if (!snapshot.time)
        snapshot.time = read_step_time(source);
    const int suggested = dimension_of(snapshot.positions);
    const std::optional<double> stated = read_field(source, "dimension");
    snapshot.dimension_is_stated = stated.has_value();
    const double dimension = stated.value_or(suggested);
    if (dimension != 2 && dimension != 3)
        fail(source, "/VTKHDF/FieldData/dimension", "2 or 3", number_text(dimension));
    snapshot.dimension = static_cast<int>(dimension);
}

Positions read_boundary(const Hdf5Source& source) {
    const Dataset dataset = open_dataset(source, "/meniscus/boundary");
    if (dataset.dimensions.size() != 2 || dataset.dimensions[1] != 3)
        fail(source, dataset.path, "particles x 3 coordinates", shown(dataset.dimensions));
    if (!std::holds_alternative<std::vector<double>>(empty_values(source, dataset)))
        fail(source, dataset.path, "double", "another type of number");
    Positions boundary(dataset.dimensions[0]);
    read_into(source, dataset, number_type<double>(), boundary.data());
    return boundary;
}

/// All of the group /meniscus but the boundary. Returns whether there is one.
bool read_own_words(const Hdf5Source& source, Snapshot& snapshot) {
    if (!exists(source, "/meniscus"))
        return false; // written by another program
    const std::string version = text_dataset(source, "/meniscus/format_version");
    if (version != format_version) {
        fail(source, "/meniscus/format_version", std::string(format_version),
             "'" + version + "'; a newer meniscus wrote it, update this one");
    }
    if (exists(source, "/meniscus/scene"))
        snapshot.scene = text_dataset(source, "/meniscus/scene");
    for (const std::string& name : array_names_in(source, "/meniscus/provenance"))
        snapshot.provenance[name] = text_dataset(source, "/meniscus/provenance/" + name);
    return true;
}

void read_for_meniscus(const Hdf5Source& source, Snapshot& snapshot) {
    if (read_own_words(source, snapshot) && exists(source, "/meniscus/boundary"))
        snapshot.boundary = read_boundary(source);
}

bool holds_vtkhdf(const Hdf5Source& source) {
    return exists(source, "/VTKHDF");
}

void check_types_of_series(const Hdf5Source& source) {
    const std::string path = "/VTKHDF/Types";
    if (!exists(source, path))
        return;
    for (const double type : as_doubles({"", 1, read_numbers(source, open_dataset(source, path))}))
        check_are_vertices(source, path, {static_cast<std::uint8_t>(type)});
}

/// One step of a series of several. What stands in FieldData may be of any step, and is left out.
Snapshot snapshot_of_step(const Hdf5Source& source, const ReadChoices& choices) {
    const std::uint64_t count = step_count(source);
    const std::uint64_t step = frame_to_read(choices, count);
    const Rows rows = points_of_step(source, step);
    check_types_of_series(source);
    Snapshot snapshot;
    set_positions(snapshot,
                  read_numbers(source, open_rows(source, "/VTKHDF/Points", rows, 3), rows), 3);
    snapshot.dimension = dimension_of(snapshot.positions);
    for (const std::string& name : array_names_in(source, "/VTKHDF/PointData")) {
        const std::string offsets = "/VTKHDF/Steps/PointDataOffsets/" + name;
        const bool has_own =
            exists(source, "/VTKHDF/Steps/PointDataOffsets") && exists(source, offsets);
        const Rows own = {has_own ? number_at(source, offsets, step) : rows.first, rows.count};
        const Dataset dataset = open_rows(source, "/VTKHDF/PointData/" + name, own, 0);
        snapshot.point_data.push_back(
            {name, components_of(dataset), read_numbers(source, dataset, own)});
    }
    const std::string values = "/VTKHDF/Steps/Values";
    if (exists(source, values)) {
        const Rows one = {step, 1};
        const double time =
            as_doubles({"", 1, read_numbers(source, open_rows(source, values, one, 0), one)}).at(0);
        if (std::isfinite(time))
            snapshot.time = time;
    }
    note_frame(snapshot, choices, step, count);
    return snapshot;
}

Snapshot vtkhdf_snapshot(const Hdf5Source& source, const ReadChoices& choices) {
    check_grid(source);
    if (step_count(source) > 1)
        return snapshot_of_step(source, choices);
    if (exists(source, "/VTKHDF/Steps"))
        frame_to_read(choices, 1);
    else
        expect_no_frame(choices);
    Snapshot snapshot;
    read_points(source, snapshot);
    check_cells(source);
    read_point_data(source, snapshot);
    read_field_data(source, snapshot);
    read_for_meniscus(source, snapshot);
    return snapshot;
}

/// One that we have written.
Snapshot read(const OpenedFile& file) {
    const Hdf5Source source = open_source(file);
    check_is_one_state(source);
    return vtkhdf_snapshot(source, {});
}

Snapshot read_header(const OpenedFile& file) {
    const Hdf5Source source = open_source(file);
    check_grid(source);
    check_is_one_state(source);
    Snapshot snapshot;
    for (const std::string& name : array_names_in(source, "/VTKHDF/PointData"))
        snapshot.point_data.push_back({name, 1, {}});
    read_field_data(source, snapshot);
    read_own_words(source, snapshot);
    return snapshot;
}

Snapshot read_outline(const OpenedFile& file) {
    const Hdf5Source source = open_source(file);
    check_grid(source);
    check_is_one_state(source);
    check_cells(source);
    Snapshot snapshot;
    snapshot.particles_in_file = read_count(source, "/VTKHDF/NumberOfPoints");
    open_points(source, snapshot.particles_in_file, snapshot);
    for (const std::string& name : array_names_in(source, "/VTKHDF/PointData")) {
        const Dataset dataset = open_point_data(source, name, snapshot.particles_in_file);
        snapshot.point_data.push_back(
            {name, components_of(dataset), empty_values(source, dataset)});
    }
    read_field_data(source, snapshot);
    read_own_words(source, snapshot);
    return snapshot;
}

Snapshot read_part(const OpenedFile& file, const VtkhdfPart& part) {
    const Hdf5Source source = open_source(file);
    Snapshot snapshot;
    snapshot.first_particle = part.first;
    snapshot.particles_in_file = read_count(source, "/VTKHDF/NumberOfPoints");
    if (part.first + part.count > snapshot.particles_in_file)
        fail(source, "/VTKHDF/NumberOfPoints", std::to_string(part.first + part.count) + " or more",
             std::to_string(snapshot.particles_in_file));
    const Dataset points = open_points(source, snapshot.particles_in_file, snapshot);
    const Rows rows = {part.first, part.count};
    if (part.positions) {
        snapshot.positions.resize(part.count);
        read_into(source, points, rows, number_type<double>(), snapshot.positions.data());
    }
    for (const std::string& name : part.arrays) {
        const Dataset dataset = open_point_data(source, name, snapshot.particles_in_file);
        snapshot.point_data.push_back(
            {name, components_of(dataset), read_numbers(source, dataset, rows)});
    }
    return snapshot;
}

/// A snapshot of the boundary alone.
Snapshot read_boundary_only(const OpenedFile& file) {
    const Hdf5Source source = open_source(file);
    Snapshot snapshot;
    read_for_meniscus(source, snapshot);
    return snapshot;
}

/// An empty snapshot, or an InputError where the file holds no VTKHDF.
Snapshot look_into(const OpenedFile& file) {
    if (!holds_vtkhdf(open_source(file)))
        throw InputError(file.path.string() + ": expected a group /VTKHDF, found none");
    return {};
}

} // namespace

Hdf5Format vtkhdf_format() {
    return {"VTKHDF", holds_vtkhdf, vtkhdf_snapshot, true};
}

bool is_vtkhdf(const fs::path& file) {
    if (!is_hdf5(file))
        return false;
    try {
        read_isolated(file, look_into);
        return true;
    } catch (const InputError&) { // another HDF5 file, or a damaged one
        return false;
    }
}

Snapshot read_vtkhdf(const fs::path& file) {
    if (!is_hdf5(file))
        throw InputError(file.string() + ": expected an HDF5 file, found something else");
    return read_isolated(file, read);
}

Snapshot read_vtkhdf_header(const fs::path& file) {
    return read_isolated(file, read_header);
}

Snapshot read_vtkhdf_outline(const fs::path& file) {
    return read_isolated(file, read_outline);
}

Snapshot read_vtkhdf_part(const fs::path& file, const VtkhdfPart& part) {
    return read_isolated(file, [&](const OpenedFile& opened) { return read_part(opened, part); });
}

Positions read_vtkhdf_boundary(const fs::path& file) {
    return read_isolated(file, read_boundary_only).boundary;
}

} // namespace meniscus
