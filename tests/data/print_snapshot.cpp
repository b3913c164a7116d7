// Prints what read_snapshot makes of a file, for read_files_of_vtk.py: a line of the dimension and
// the type of the positions, then one line for the positions and one for each array of point data:
// its type and number of components, its values, and after a tab its name.
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/text/text.hpp>

#include <cstdio>
#include <exception>
#include <type_traits>

namespace {

template <class Number>
void print_values(const std::vector<Number>& values, int components, const std::string& name) {
    const char* kind = std::is_floating_point_v<Number> ? "f"
                       : std::is_signed_v<Number>       ? "i"
                                                        : "u";
    std::printf("%s%zu %d", kind, sizeof(Number), components);
    for (const Number value : values)
        if constexpr (std::is_integral_v<Number>)
            std::printf(" %s", std::to_string(value).c_str());
        else
            std::printf(" %s", meniscus::number_text(static_cast<double>(value)).c_str());
    std::printf("\t%s\n", name.c_str());
}

void print(const meniscus::Snapshot& snapshot) {
    const bool is_single = snapshot.position_precision == meniscus::Precision::float32;
    std::printf("%d %s\n", snapshot.dimension, is_single ? "f4" : "f8");
    std::vector<double> coordinates;
    for (const auto& position : snapshot.positions)
        coordinates.insert(coordinates.end(), position.begin(), position.end());
    print_values(coordinates, 3, "positions");
    for (const meniscus::PointArray& array : snapshot.point_data) {
        std::visit([&](const auto& values) { print_values(values, array.components, array.name); },
                   array.values);
    }
}

} // namespace

int main(int argc, char** argv) {
    try {
        print(meniscus::read_snapshot(argc > 1 ? argv[1] : ""));
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
