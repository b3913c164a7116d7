// How accurate the runtime's normals are: on the circle of the 2019 preprint and on a saddle as in
// the 2020 article, by sampling scheme, number of samples and smoothing, and what the ratio of
// radii does. Prints the tables of docs/normals.md in Markdown. Usage: normal_accuracy
// circle|schemes|smoothing
//        normal_accuracy time OUTPUT.json        (also errors, for scripts/plot_normals.py)
//        normal_accuracy ratio SNAPSHOT          (a droplet)
#include "normal_tables.hpp"

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>

namespace meniscus {
namespace {

void run(int argument_count, char** arguments) {
    const std::string table = argument_count > 1 ? arguments[1] : "";
    const bool has_file = argument_count == 3;
    const bool has_none = argument_count == 2;
    if (table == "circle" && has_none)
        print_circle_tables();
    else if (table == "schemes" && has_none)
        print_scheme_tables();
    else if (table == "smoothing" && has_none)
        print_smoothing_tables();
    else if (table == "time" && has_file)
        print_time_table(arguments[2]);
    else if (table == "ratio" && has_file)
        print_ratio_table(arguments[2]);
    else
        throw std::runtime_error("usage: normal_accuracy circle|schemes|smoothing, "
                                 "normal_accuracy time OUTPUT.json, or "
                                 "normal_accuracy ratio SNAPSHOT");
}

} // namespace
} // namespace meniscus

int main(int argument_count, char** arguments) {
    try {
        meniscus::run(argument_count, arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "normal_accuracy: %s\n", error.what());
        return 1;
    }
}
