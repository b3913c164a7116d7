#include "snapshots.hpp"

#include "module.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

namespace meniscus {
namespace {

template <class Real>
Positions positions_of(const py::handle& object, const char* name) {
    const auto array = contiguous<Real>(object, name);
    const py::ssize_t columns = array.ndim() == 2 ? array.shape(1) : 0;
    if (columns != 2 && columns != 3)
        throw InputError(std::string(name) +
                         " must have two or three coordinates a row, found the shape " +
                         shape_text(array));
    const auto axes = static_cast<std::size_t>(columns);
    Positions places(static_cast<std::size_t>(array.shape(0)));
    const Real* from = array.data();
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t axis = 0; axis < axes; ++axis)
            places[i][axis] = static_cast<double>(from[i * axes + axis]);
    return places;
}

bool is_float32(const py::handle& array) {
    return py::isinstance<py::array_t<float>>(array);
}

Positions positions_of(const py::handle& array, const char* name) {
    return is_float32(array) ? positions_of<float>(array, name) : positions_of<double>(array, name);
}

/// Tries the types of a file's arrays in turn; true where the array is of that one.
template <class Value>
bool take_values(const py::array& array, ArrayValues& values) {
    if (!py::isinstance<py::array_t<Value>>(array))
        return false;
    const auto taken = py::array_t<Value, py::array::c_style>::ensure(array);
    values = std::vector<Value>(taken.data(), taken.data() + taken.size());
    return true;
}

template <std::size_t... Types>
bool take_any_values(const py::array& array, ArrayValues& values, std::index_sequence<Types...>) {
    return (take_values<typename std::variant_alternative_t<Types, ArrayValues>::value_type>(
                array, values) ||
            ...);
}

PointArray point_array(const std::string& name, const py::handle& object, std::size_t rows) {
    auto array = py::array::ensure(object);
    if (!array || array.ndim() < 1 || array.ndim() > 2 ||
        static_cast<std::size_t>(array.shape(0)) != rows ||
        (array.ndim() == 2 && array.shape(1) == 0))
        throw InputError("array '" + name + "' must have one row for each of " +
                         std::to_string(rows) + " particles, found the shape " +
                         (array ? shape_text(array) : "of no array"));
    if (array.dtype().kind() == 'b')
        array = array.attr("view")("uint8");
    PointArray made;
    made.name = name;
    made.components = array.ndim() == 1 ? 1 : static_cast<int>(array.shape(1));
    constexpr auto types = std::make_index_sequence<std::variant_size_v<ArrayValues>>{};
    if (!take_any_values(array, made.values, types))
        throw InputError("array '" + name + "' is of " +
                         py::str(array.dtype()).cast<std::string>() +
                         ", expected whole numbers of 8 to 64 bits, float32 or float64");
    return made;
}

template <class Value>
std::vector<Value> in_type(const Positions& places) {
    std::vector<Value> values;
    values.reserve(3 * places.size());
    for (const auto& place : places)
        for (const double coordinate : place)
            values.push_back(static_cast<Value>(coordinate));
    return values;
}

template <class Value>
std::optional<Value> optional_of(const py::handle& object, const char* name) {
    return object.attr(name).cast<std::optional<Value>>();
}

/// Two-dimensional states lie in a plane of constant z.
void check_is_flat(const Positions& positions) {
    std::optional<double> z;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (!std::isfinite(positions[i][2]))
            continue;
        if (positions[i][2] != z.value_or(positions[i][2]))
            throw InputError("dimension is 2, but particle " + std::to_string(i) +
                             " has z = " + number_text(positions[i][2]) + " and others before it " +
                             number_text(*z));
        z = positions[i][2];
    }
}

/// One radius for all where each particle has the same.
void set_common_radius(Snapshot& snapshot) {
    if (snapshot.support_radius || find_array(snapshot, "support_radius") == nullptr)
        return;
    const SupportRadii radii = support_radii(snapshot);
    if (!radii.vary())
        snapshot.support_radius = radii.max;
}

} // namespace

std::mutex& file_access() {
    static std::mutex access;
    return access;
}

Snapshot snapshot_from_python(const py::handle& object) {
    Snapshot made;
    const py::object positions = object.attr("positions");
    made.positions = positions_of(positions, "positions");
    made.position_precision = is_float32(positions) ? Precision::float32 : Precision::float64;
    made.dimension = object.attr("dimension").cast<int>();
    if (made.dimension != 2 && made.dimension != 3)
        throw InputError("dimension must be 2 or 3, found " + std::to_string(made.dimension));
    if (made.dimension == 2)
        check_is_flat(made.positions);
    for (const auto& [name, values] : object.attr("arrays").cast<py::dict>())
        set_array(made, point_array(name.cast<std::string>(), values, made.size()));
    if (const py::object boundary = object.attr("boundary"); !boundary.is_none())
        made.boundary = positions_of(boundary, "boundary");
    made.support_radius = optional_of<double>(object, "support_radius");
    made.particle_spacing = optional_of<double>(object, "particle_spacing");
    made.particle_volume = optional_of<double>(object, "particle_volume");
    made.time = optional_of<double>(object, "time");
    made.scene = object.attr("scene").cast<std::string>();
    made.provenance = object.attr("provenance").cast<std::map<std::string, std::string>>();
    return made;
}

py::dict snapshot_to_python(Snapshot&& snapshot) {
    using namespace py::literals;
    py::dict arrays;
    for (PointArray& array : snapshot.point_data)
        std::visit(
            [&](auto& values) {
                arrays[py::str(array.name)] =
                    array_of(std::move(values), static_cast<std::size_t>(array.components));
            },
            array.values);
    py::object positions;
    if (snapshot.position_precision == Precision::float32)
        positions = array_of(in_type<float>(snapshot.positions), 3);
    else
        positions = array_of(std::move(snapshot.positions));
    py::object boundary = py::none();
    if (!snapshot.boundary.empty())
        boundary = array_of(std::move(snapshot.boundary));
    return py::dict("positions"_a = positions, "arrays"_a = arrays, "boundary"_a = boundary,
                    "dimension"_a = snapshot.dimension,
                    "support_radius"_a = snapshot.support_radius,
                    "particle_spacing"_a = snapshot.particle_spacing,
                    "particle_volume"_a = snapshot.particle_volume, "time"_a = snapshot.time,
                    "scene"_a = snapshot.scene, "provenance"_a = snapshot.provenance);
}

void add_snapshots(py::module_& module) {
    module.def("read", [](const std::filesystem::path& file, std::optional<std::int64_t> frame) {
        ReadChoices choices;
        if (frame && *frame < 0)
            throw InputError("frame must not be negative, found " + std::to_string(*frame));
        choices.frame = frame;
        Snapshot snapshot = [&] {
            const py::gil_scoped_release released;
            const std::lock_guard<std::mutex> alone(file_access());
            Snapshot read = read_snapshot(file, choices);
            read.scene = scene_of(read, file);
            set_common_radius(read);
            return read;
        }();
        return snapshot_to_python(std::move(snapshot));
    });
    module.def("write", [](const py::object& object, const std::filesystem::path& file) {
        const Snapshot snapshot = snapshot_from_python(object);
        const py::gil_scoped_release released;
        const std::lock_guard<std::mutex> alone(file_access());
        write_vtkhdf(snapshot, file);
    });
}

} // namespace meniscus
