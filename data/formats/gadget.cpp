// GADGET's HDF5 snapshots, which SWIFT and others write too: the gas, /PartType0, is the fluid.
// Fields of one or three values a particle are point data under the names of the file.
#include "detail/hdf5_formats.hpp"

#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace meniscus {
namespace {

const std::string group = "/PartType0";

bool holds_gadget(const Hdf5Source& source) {
    return exists(source, group) && exists(source, group + "/Coordinates");
}

void read_positions(const Hdf5Source& source, Snapshot& snapshot) {
    const Dataset points = open_dataset(source, group + "/Coordinates");
    if (points.dimensions.size() != 2 || points.dimensions[1] != 3)
        fail(source, points.path, "particles x 3 coordinates", shown(points.dimensions));
    snapshot.position_precision =
        std::holds_alternative<std::vector<float>>(empty_values(source, points))
            ? Precision::float32
            : Precision::float64;
    snapshot.positions.resize(points.dimensions[0]);
    read_into(source, points, number_type<double>(), snapshot.positions.data());
    snapshot.dimension = dimension_of(snapshot.positions);
}

/// Fields of another shape, such as abundances of elements, are left out and said.
void read_fields(const Hdf5Source& source, Snapshot& snapshot) {
    std::string left_out;
    for (const std::string& name : array_names_in(source, group)) {
        if (name == "Coordinates")
            continue;
        const Dataset dataset = open_dataset(source, group + "/" + name);
        const Dimensions& found = dataset.dimensions;
        if (found.empty() || found.size() > 2 || found[0] != snapshot.size() ||
            (found.size() == 2 && (found[1] < 1 || found[1] > 1000))) {
            left_out += (left_out.empty() ? "" : ", ") + quoted_text(name);
            continue;
        }
        const int components = found.size() == 2 ? static_cast<int>(found[1]) : 1;
        snapshot.point_data.push_back({name, components, read_numbers(source, dataset)});
    }
    if (!left_out.empty())
        snapshot.notes.push_back("left out for their shape: " + left_out);
}

/// What else is in the file and in which units.
void add_notes(const Hdf5Source& source, Snapshot& snapshot) {
    std::string others;
    for (const char* type : {"1", "2", "3", "4", "5", "6"})
        if (exists(source, "/PartType" + std::string(type)))
            others += (others.empty() ? "" : ", ") + std::string("PartType") + type;
    if (!others.empty())
        snapshot.notes.push_back("fluid: PartType0; ignored: " + others);
    snapshot.notes.push_back("lengths are taken in the units of the file; a box is periodic only "
                             "with --periodic");
}

Snapshot gadget_snapshot(const Hdf5Source& source, const ReadChoices& /*choices*/) {
    Snapshot snapshot;
    read_positions(source, snapshot);
    read_fields(source, snapshot);
    if (exists(source, "/Header")) {
        const auto time = number_attribute<double>(source, "/Header", "Time", 1);
        if (!time.empty() && std::isfinite(time[0]))
            snapshot.time = time[0];
    }
    add_notes(source, snapshot);
    return snapshot;
}

} // namespace

Hdf5Format gadget_format() {
    return {"GADGET", holds_gadget, gadget_snapshot};
}

} // namespace meniscus
