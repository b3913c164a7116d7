#include "normal_schemes.hpp"

#include <meniscus/labeler/sampling/directions.hpp>

#include <algorithm>

namespace meniscus {
namespace {

using List = SurfaceParticles<double, 3>;

void expose_from_table(const NormalCase& some, std::uint64_t /*seed*/, SampleDirections& directions,
                       List& list) {
    expose<3>(some, directions, {}, list);
}

void expose_drawing(const NormalCase& some, std::uint64_t seed, SampleDirections& directions,
                    List& list) {
    expose<3>(some, directions, {}, list, RandomEachTime<3>{seed, directions});
}

void expose_exactly(const NormalCase& some, std::uint64_t /*seed*/, SampleDirections& directions,
                    List& list) {
    SurfaceTensionOptions exact;
    exact.coverage = CoverageMethod::exact;
    expose<3>(some, directions, exact, list);
}

/// Of a scheme of the labeler.
NormalScheme tabulated(const std::string& name, const std::string& scheme) {
    return {name,
            [scheme](std::size_t samples, std::uint64_t seed, SampleDirections& directions) {
                fill_from_scheme(scheme, 3, samples, seed, directions);
            },
            expose_from_table};
}

void fill_one_set(std::size_t samples, std::uint64_t /*seed*/, SampleDirections& directions) {
    fill_from_scheme("random", 3, samples, 0, directions);
    directions.sets = 1;
}

void fill_nothing(std::size_t /*samples*/, std::uint64_t /*seed*/, SampleDirections&) {}

} // namespace

void fill_from_scheme(const std::string& name, int dimension, std::size_t samples,
                      std::uint64_t seed, SampleDirections& directions) {
    const SamplingScheme scheme = sampling_scheme(name);
    std::vector<std::vector<Direction>> sets(
        std::clamp(direction_table_size / samples, std::size_t{1}, sample_directions::max_sets));
    for (std::size_t set = 0; set < sets.size(); ++set) {
        sets[set].resize(samples);
        scheme.fill(dimension, scheme.per_particle ? seed : mix_bits(mix_bits(seed) + set), set,
                    sets[set]);
    }
    fill_directions(
        samples, false, [&](std::size_t set, std::size_t k) { return sets[set][k]; },
        [&](std::size_t) { return 1 / static_cast<double>(samples); }, directions);
}

const std::vector<NormalScheme>& normal_schemes() {
    static const std::vector<NormalScheme> schemes = {
        {"random", fill_one_set, expose_drawing},
        tabulated("random table", "table"),
        tabulated("blue noise", "blue-noise"),
        tabulated("Halton 2-3", "halton"),
        {"outward", fill_outward_directions<3>, expose_from_table},
        {"exact", fill_nothing, expose_exactly, CoverageMethod::exact},
    };
    return schemes;
}

const NormalScheme& normal_scheme(const std::string& name) {
    const auto& schemes = normal_schemes();
    return *std::find_if(schemes.begin(), schemes.end(),
                         [&](const NormalScheme& scheme) { return scheme.name == name; });
}

} // namespace meniscus
