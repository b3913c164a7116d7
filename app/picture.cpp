// meniscus picture: a state as PNG or SVG, for papers and pages.
#include "command_line.hpp"
#include "usage.hpp"

#include <meniscus/app/picture/draw_particles.hpp>
#include <meniscus/app/picture/picture_file.hpp>
#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/files.hpp>
#include <meniscus/data/text/text.hpp>

#include <cmath>
#include <fmt/format.h>
#include <memory>
#include <tuple>
#include <utility>

namespace meniscus {
namespace {

struct PictureCommand {
    Path input;
    Path output;
    std::string color = "class";
    std::string range;
    std::string size = "1200,800";
    std::string view = "30,20";
    std::string cut;
    std::optional<std::string> title;
    std::optional<double> diameter;
    std::optional<int> dimension;
    std::optional<std::uint64_t> frame;
    bool with_boundary = false;
    bool quiet = false;
};

/// "30,20": two finite numbers.
std::pair<double, double> pair_from_text(const char* option, const std::string& text) {
    const std::size_t comma = text.find(',');
    const auto first = number_from_text(text.substr(0, comma));
    const auto second =
        comma == std::string::npos ? std::nullopt : number_from_text(text.substr(comma + 1));
    if (!first || !second || !std::isfinite(*first) || !std::isfinite(*second))
        throw InputError(std::string(option) + " " + quoted_text(text) +
                         " is not understood; expected two numbers, such as 30,20");
    return {*first, *second};
}

std::pair<int, int> size_from_text(const std::string& text) {
    const auto [width, height] = pair_from_text("--size", text);
    for (const double pixels : {width, height})
        if (!(pixels >= 200 && pixels <= 4000 && pixels == std::floor(pixels)))
            throw InputError("--size " + quoted_text(text) +
                             " is not understood; expected whole numbers from 200 to 4000");
    return {static_cast<int>(width), static_cast<int>(height)};
}

/// "x", "y<0.2", "z>0": an axis, and what of it stays.
Cut cut_from_text(const std::string& text) {
    const auto refuse = [&] {
        throw InputError("--cut " + quoted_text(text) +
                         " is not understood; expected an axis and what stays of it, as in x, "
                         "y<0.2 or z>0");
    };
    const std::size_t axis = text.empty() ? 3 : std::string("xyz").find(text[0]);
    if (axis > 2)
        refuse();
    Cut cut{axis, {}, false};
    if (text.size() == 1)
        return cut;
    cut.place = number_from_text(text.substr(2));
    cut.keeps_larger = text[1] == '>';
    if ((text[1] != '<' && text[1] != '>') || !cut.place || !std::isfinite(*cut.place))
        refuse();
    return cut;
}

/// What a ball measures across: the spacing of particles, stored or found.
double diameter_of(const Snapshot& snapshot) {
    if (snapshot.particle_spacing)
        return *snapshot.particle_spacing;
    if (snapshot.particle_volume)
        return std::pow(*snapshot.particle_volume, 1.0 / snapshot.dimension);
    if (snapshot.support_radius)
        return *snapshot.support_radius / 2;
    throw InputError("the size of particles is not known; give it with --diameter");
}

PictureOptions options_of(const PictureCommand& command, const Snapshot& snapshot) {
    PictureOptions options;
    std::tie(options.width, options.height) = size_from_text(command.size);
    std::tie(options.azimuth, options.elevation) = pair_from_text("--view", command.view);
    if (!command.cut.empty())
        options.cut = cut_from_text(command.cut);
    options.with_boundary = command.with_boundary;
    options.diameter = command.diameter ? *command.diameter : diameter_of(snapshot);
    if (!(options.diameter > 0 && std::isfinite(options.diameter)))
        throw InputError(
            fmt::format("--diameter must be positive and finite, found {}", options.diameter));
    options.title = command.title ? *command.title : scene_of(snapshot, command.input);
    return options;
}

void run_picture(const PictureCommand& command) {
    check_picture_name(command.output);
    check_can_be_written(command.output);
    check_is_not_an_input(command.output, {command.input});
    ReadChoices choices;
    choices.dimension = command.dimension;
    choices.frame = command.frame;
    const Snapshot snapshot = read_snapshot(command.input, choices);
    std::optional<std::pair<double, double>> range;
    if (!command.range.empty())
        range = pair_from_text("--range", command.range);
    if (range && !(range->first < range->second))
        throw InputError("--range expects the smaller number first");
    size_from_text(command.size); // before anything is drawn
    pair_from_text("--view", command.view);
    const std::string bytes = naming_file(command.input, [&] {
        const Coloring coloring = coloring_of(snapshot, command.color, range);
        return picture_bytes(draw_particles(snapshot, coloring, options_of(command, snapshot)),
                             command.output);
    });
    const WriteGuard guard;
    write_whole(command.output, bytes);
    if (!command.quiet)
        print_text(fmt::format("{}: {} particles of {}\n", printable(command.output.string()),
                               snapshot.size(), printable(command.input.string())));
}

} // namespace

void add_picture(CLI::App& command) {
    auto options = std::make_shared<PictureCommand>();
    auto* verb = command.add_subcommand("picture", "Draw a state as PNG or SVG");
    verb->add_option("INPUT", options->input, "Snapshot, as for label")->required();
    verb->add_option("-o,--output", options->output, "Picture to write, .png or .svg")->required();
    verb->add_option("--color", options->color,
                     "class (as classified, else as labelled), or point data by its name, such as "
                     "uncovered_fraction, density or velocity")
        ->capture_default_str();
    verb->add_option("--range", options->range,
                     "Smallest and largest number of the color bar (default: those there are)")
        ->type_name("LOW,HIGH");
    verb->add_option("--cut", options->cut,
                     "Axis to cut along, and what stays: x (up to the middle), y<0.2, z>0");
    verb->add_option("--view", options->view,
                     "Degrees to the right of the z axis and above the plane of x and z from which "
                     "a state in three dimensions is seen")
        ->type_name("RIGHT,UP")
        ->capture_default_str();
    verb->add_option("--size", options->size, "Width and height in pixels, 200 to 4000")
        ->type_name("WIDTH,HEIGHT")
        ->capture_default_str();
    verb->add_option("--title", options->title, "Words above (default: the scene)");
    verb->add_option("--diameter", options->diameter,
                     "Diameter of the balls in m (default: the spacing of particles)");
    verb->add_option("--dimension", options->dimension,
                     "2 or 3, where the file does not store it (default: as for label)")
        ->check(CLI::IsMember({2, 3}));
    verb->add_option("--frame", options->frame,
                     "Which state of a file that holds several, counted from 0 (default: the last)")
        ->check(whole_numbers());
    verb->add_flag("--walls", options->with_boundary, "Boundary particles, too, in gray");
    add_quiet_option(*verb, options->quiet);
    add_examples(*verb, {{"meniscus picture labelled/dam.vtkhdf -o dam.png --cut z",
                          "a dam cut in the middle, by class"}});
    verb->callback([options] { run_picture(*options); });
}

} // namespace meniscus
