#include "vtkhdf.hpp"

#include "detail/hdf5_formats.hpp"
#include <meniscus/data/hdf5/deflate.hpp>
#include <meniscus/data/hdf5/hdf5_signature.hpp>
#include <meniscus/data/hdf5/isolated_read.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <optional>
#include <string>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view polydata_type = "PolyData";

/// A series is one state where it has one step.
void check_steps(const Hdf5Source& source) {
    if (!exists(source, "/VTKHDF/Steps"))
        return;
    const auto steps = number_attribute<std::int64_t>(source, "/VTKHDF/Steps", "NSteps", 1);
    if (steps.size() != 1 || steps[0] != 1) {
        fail(source, "/VTKHDF/Steps", "one state a file",
             "a series of " + (steps.size() == 1 ? std::to_string(steps[0]) : "unknown length") +
                 "; store each state by itself");
    }
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
    check_steps(source);
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

Snapshot vtkhdf_snapshot(const Hdf5Source& source, const ReadChoices& /*choices*/) {
    check_grid(source);
    Snapshot snapshot;
    read_points(source, snapshot);
    check_cells(source);
    read_point_data(source, snapshot);
    read_field_data(source, snapshot);
    read_for_meniscus(source, snapshot);
    return snapshot;
}

Snapshot read(const OpenedFile& file) {
    return vtkhdf_snapshot(open_source(file), {});
}

Snapshot read_header(const OpenedFile& file) {
    const Hdf5Source source = open_source(file);
    check_grid(source);
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
    return {"VTKHDF", holds_vtkhdf, vtkhdf_snapshot};
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
