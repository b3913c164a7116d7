#include "cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <meniscus/runtime/math/angles.hpp>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

namespace meniscus::test {
namespace {

using Place = std::array<double, 3>;
using LatticePlace = std::array<int, 3>;

double product(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Calls visit with the steps to the neighbors on a lattice: 26, in two dimensions 8.
template <class Visit>
void for_lattice_neighbors(int dimension, Visit&& visit) {
    const int depth = dimension == 3 ? 1 : 0;
    for (int z = -depth; z <= depth; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (x != 0 || y != 0 || z != 0)
                    visit(LatticePlace{x, y, z});
}

void mark(HardCase& hard_case, std::size_t i, Expected expected) {
    Expected& before = hard_case.expected[i];
    if (before != Expected::either && before != expected)
        throw std::logic_error(hard_case.name + ": particle " + std::to_string(i) +
                               " is both open and closed");
    before = expected;
}

/// Directions from a particle to what may cover part of its sphere. A little more than do: what
/// stands on a limit may fall on either side of it.
std::vector<Place> directions_of_coverers(const HardCase& hard_case, std::size_t i) {
    constexpr double slack = 1e-3;
    const double inverse_radius = 1 / hard_case.support_radius;
    std::vector<Place> directions;
    const auto add = [&](const Place& other) {
        Place step;
        for (int axis = 0; axis < 3; ++axis)
            step[axis] = (other[axis] - hard_case.positions[i][axis]) * inverse_radius;
        const double square = product(step, step);
        if (square > (1 + slack) * (1 + slack))
            return;
        const double distance = std::sqrt(square);
        if (distance < 0.2 * (1 - slack))
            return;
        for (double& coordinate : step)
            coordinate /= distance;
        directions.push_back(step);
    };
    for (std::size_t j = 0; j < hard_case.size(); ++j)
        if (j != i)
            add(hard_case.positions[j]);
    for (const Place& other : hard_case.boundary)
        add(other);
    return directions;
}

/// The first argument: a direction that no neighbor is near to.
bool is_open(int dimension, const std::vector<Place>& coverers) {
    constexpr double cosine = 0.59; // of more than the largest cap
    std::vector<Place> candidates;
    for_lattice_neighbors(dimension, [&](const LatticePlace& step) {
        candidates.push_back({static_cast<double>(step[0]), static_cast<double>(step[1]),
                              static_cast<double>(step[2])});
    });
    Place outward{};
    for (const Place& coverer : coverers)
        for (int axis = 0; axis < 3; ++axis)
            outward[axis] -= coverer[axis];
    if (product(outward, outward) > 1e-12)
        candidates.push_back(outward);
    return std::any_of(candidates.begin(), candidates.end(), [&](const Place& candidate) {
        const double limit = cosine * std::sqrt(product(candidate, candidate));
        return std::all_of(coverers.begin(), coverers.end(), [&](const Place& coverer) {
            return product(candidate, coverer) < limit;
        });
    });
}

void expect_open(HardCase& hard_case) {
    hard_case.expected.resize(hard_case.size(), Expected::either);
    for (std::size_t i = 0; i < hard_case.size(); ++i)
        if (is_open(hard_case.dimension, directions_of_coverers(hard_case, i)))
            mark(hard_case, i, Expected::surface);
}

void expect_all(HardCase& hard_case, Expected expected) {
    hard_case.expected.assign(hard_case.size(), expected);
}

/// Points of a lattice; spacing 1.
struct Lattice {
    int dimension;
    double support_radius; ///< in spacings
    std::vector<LatticePlace> fluid;
    std::vector<LatticePlace> boundary;
};

using Inside = std::function<bool(const LatticePlace&)>;

Lattice lattice(int dimension, double support_radius, int reach, const Inside& is_fluid,
                const Inside& is_boundary = {}) {
    Lattice result{dimension, support_radius, {}, {}};
    const int depth = dimension == 3 ? reach : 0;
    for (int z = -depth; z <= depth; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x)
                if (is_fluid({x, y, z}))
                    result.fluid.push_back({x, y, z});
                else if (is_boundary && is_boundary({x, y, z}))
                    result.boundary.push_back({x, y, z});
    return result;
}

Inside in_ball(double radius) {
    return [=](const LatticePlace& n) {
        return n[0] * n[0] + n[1] * n[1] + n[2] * n[2] <= radius * radius;
    };
}

Inside in_block(int reach) {
    return [=](const LatticePlace& n) {
        return std::abs(n[0]) <= reach && std::abs(n[1]) <= reach && std::abs(n[2]) <= reach;
    };
}

/// The fluid on a lattice, each particle moved by up to `jitter` spacings along each axis, with
/// what both arguments say.
HardCase fluid_on(const Lattice& lattice, const std::string& name, const std::string& why,
                  double jitter = 0) {
    HardCase hard_case;
    hard_case.name = name;
    hard_case.why = why;
    hard_case.dimension = lattice.dimension;
    hard_case.support_radius = lattice.support_radius;
    std::mt19937_64 generator(1);
    const auto place_of = [&](const LatticePlace& n) {
        Place place{};
        for (int axis = 0; axis < lattice.dimension; ++axis) {
            const double share = static_cast<double>(generator() >> 11) * 0x1p-53;
            place[axis] = n[axis] + jitter * (2 * share - 1);
        }
        return place;
    };
    for (const LatticePlace& n : lattice.fluid)
        hard_case.positions.push_back(place_of(n));
    for (const LatticePlace& n : lattice.boundary)
        hard_case.boundary.push_back({n[0] * 1.0, n[1] * 1.0, n[2] * 1.0});
    expect_open(hard_case);
    std::set<LatticePlace> taken(lattice.fluid.begin(), lattice.fluid.end());
    taken.insert(lattice.boundary.begin(), lattice.boundary.end());
    const int may_miss = lattice.support_radius == 2 && jitter == 0 ? 1 : 0;
    for (std::size_t i = 0; i < hard_case.size(); ++i) {
        int missing = 0;
        for_lattice_neighbors(lattice.dimension, [&](const LatticePlace& step) {
            const LatticePlace& n = lattice.fluid[i];
            missing += taken.count({n[0] + step[0], n[1] + step[1], n[2] + step[2]}) == 0 ? 1 : 0;
        });
        if (missing <= may_miss && lattice.support_radius <= 2.75)
            mark(hard_case, i, Expected::interior);
    }
    return hard_case;
}

/// The same case elsewhere, larger or turned, or in another order. What is expected stays.
HardCase renamed(HardCase hard_case, const std::string& name, const std::string& why) {
    hard_case.name = name;
    hard_case.why = why;
    return hard_case;
}

template <class Change>
HardCase changed(HardCase hard_case, const Change& change) {
    for (Positions* places : {&hard_case.positions, &hard_case.boundary})
        for (Place& place : *places)
            change(place);
    return hard_case;
}

HardCase moved(const HardCase& hard_case, const Place& by) {
    return changed(hard_case, [&](Place& place) {
        for (int axis = 0; axis < hard_case.dimension; ++axis)
            place[axis] += by[axis];
    });
}

HardCase scaled(HardCase hard_case, double factor) {
    hard_case.support_radius *= factor;
    return changed(hard_case, [&](Place& place) {
        for (double& coordinate : place)
            coordinate *= factor;
    });
}

HardCase turned(const HardCase& hard_case, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> angle(0, 2 * pi);
    std::array<double, 3> turns{angle(generator), angle(generator), angle(generator)};
    return changed(hard_case, [&](Place& place) {
        for (int axis = hard_case.dimension == 2 ? 2 : 0; axis < 3; ++axis) {
            const double cosine = std::cos(turns[axis]);
            const double sine = std::sin(turns[axis]);
            double& first = place[(axis + 1) % 3];
            double& second = place[(axis + 2) % 3];
            const double before = first;
            first = cosine * before - sine * second;
            second = sine * before + cosine * second;
        }
    });
}

HardCase shuffled(const HardCase& hard_case, std::uint64_t seed) {
    std::vector<std::size_t> order(hard_case.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937_64(seed));
    HardCase result = hard_case;
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.positions[i] = hard_case.positions[order[i]];
        result.expected[i] = hard_case.expected[order[i]];
        if (!hard_case.masses.empty())
            result.masses[i] = hard_case.masses[order[i]];
    }
    return result;
}

HardCase plain(int dimension, const std::string& name, const std::string& why,
               Positions positions) {
    HardCase hard_case;
    hard_case.name = name;
    hard_case.why = why;
    hard_case.dimension = dimension;
    hard_case.positions = std::move(positions);
    return hard_case;
}

/// Particles that are surface, all with that lambda, because geometry leaves no other choice.
HardCase all_surface(int dimension, const std::string& name, const std::string& why,
                     Positions positions, double uncovered_fraction = -1) {
    HardCase hard_case = plain(dimension, name, why, std::move(positions));
    expect_all(hard_case, Expected::surface);
    hard_case.uncovered_fraction = uncovered_fraction;
    return hard_case;
}

void add_few_particles(int dimension, std::vector<HardCase>& all) {
    const auto add = [&](const char* name, const char* why, Positions positions, double fraction) {
        all.push_back(all_surface(dimension, name, why, std::move(positions), fraction));
    };
    all.push_back(plain(dimension, "no_particle", "nothing to label, and no error", {}));
    add("isolated", "surface, lambda 1: nothing covers it", {{0.3, 0.2, 0}}, 1);
    const double cosine = 0.61; // of the cap of a neighbor at h / 2
    add("pair", "surface: each covers one cap of the other, lambda is 1 less the cap",
        {{0, 0, 0}, {0.5, 0, 0}}, 1 - (dimension == 3 ? (1 - cosine) / 2 : std::acos(cosine) / pi));
    add("coincident_pair", "surface, lambda 1: a particle in the same place covers nothing",
        {{1, 1, 0}, {1, 1, 0}}, 1);
    add("hundreds_in_one_place", "surface, lambda 1: none of 400 covers another",
        Positions(400, {0.7, -0.4, 0}), 1);
    add("neighbor_at_inner_limit",
        "surface, lambda 1: at exactly r1 - r2 = 0.2 h the neighbor's sphere touches from inside",
        {{0, 0, 0}, {0.2, 0, 0}}, 1);
    add("neighbor_at_h", "surface, lambda 1: at exactly h it is no neighbor",
        {{0, 0, 0}, {1, 0, 0}}, 1);
    add("neighbor_an_ulp_within_h",
        "surface, lambda 1: within the band of 1e-5 of h it counts as at h",
        {{0, 0, 0}, {std::nextafter(1.0, 0.0), 0, 0}}, 1);
}

void add_thin_ones(int dimension, std::vector<HardCase>& all) {
    Positions filament;
    for (int n = 0; n < 40; ++n)
        filament.push_back({0.5 * n, 0, 0});
    all.push_back(all_surface(dimension, "filament", "all surface: nothing stands beside the line",
                              filament));
    Positions ring;
    for (int n = 0; n < 40; ++n)
        ring.push_back({3.2 * std::cos(2 * pi * n / 40), 3.2 * std::sin(2 * pi * n / 40), 0});
    all.push_back(
        all_surface(dimension, "ring", "all surface: neighbors stand along the ring alone", ring));
    const auto layers = [&](std::initializer_list<double> heights) {
        Positions places;
        for (const double height : heights)
            for (int x = 0; x < 12; ++x)
                for (int z = 0; z < (dimension == 3 ? 12 : 1); ++z)
                    places.push_back({0.5 * x, height, 0.5 * z});
        return places;
    };
    if (dimension == 3)
        all.push_back(all_surface(3, "sheet", "all surface: one particle thick, open on both sides",
                                  layers({0})));
    for (const auto& [name, distance] :
         {std::pair{"two_sheets_at_0_6_h", 0.6}, {"two_sheets_at_0_1_h", 0.1}})
        all.push_back(all_surface(dimension, name,
                                  "all surface: each is open on the side away from the other",
                                  layers({0, distance})));
    HardCase three =
        plain(dimension, "three_sheets",
              "outer ones surface; the middle one interior but for its rim", layers({0, 0.5, 1}));
    expect_open(three);
    for (std::size_t i = 0; i < three.size(); ++i) {
        const auto& [x, y, z] = three.positions[i];
        const auto is_inner = [](double along) { return along > 0.4 && along < 5.1; };
        if (y == 0.5 && is_inner(x) && (dimension == 2 || is_inner(z)))
            mark(three, i, Expected::interior);
    }
    all.push_back(three);
}

const char* const lattice_rule =
    "interior with all lattice neighbors, surface where a direction has no neighbor within the "
    "largest cap";

void add_lattices(int dimension, std::vector<HardCase>& all) {
    for (const auto& [text, radius] : {std::pair{"2", 2.0}, {"2_5", 2.5}}) {
        const auto block = fluid_on(lattice(dimension, radius, 4, in_block(4)),
                                    std::string("lattice_h_") + text, lattice_rule);
        all.push_back(block);
        all.push_back(
            renamed(moved(block, {3.7 / 3, -17.1 / 7, 11.3 / 9}), block.name + "_moved",
                    "as where it was: the band keeps rounding from deciding what is at h"));
        all.push_back(renamed(turned(block, 3), block.name + "_turned",
                              "as before it was turned, for the same reason"));
        all.push_back(renamed(shuffled(moved(turned(block, 5), {0.1, 0.2, 0.3}), 7),
                              block.name + "_turned_shuffled", "as before, in any order"));
    }
}

void add_shapes(int dimension, std::vector<HardCase>& all) {
    const auto add = [&](const char* name, const char* why, int reach, const Inside& inside) {
        all.push_back(fluid_on(lattice(dimension, 2, reach, inside), name, why));
    };
    add("cube_corner", "corners, edges and faces surface, all behind them interior", 3,
        in_block(3));
    add("concave_edge", "flanks surface; interior where at most one lattice neighbor is missing", 4,
        [](const LatticePlace& n) { return n[0] <= 0 || n[1] <= 0; });
    if (dimension == 3)
        add("concave_corner",
            "flanks surface; the particle in the corner misses one neighbor, which the others "
            "cover: interior",
            4, [](const LatticePlace& n) { return n[0] <= 0 || n[1] <= 0 || n[2] <= 0; });
    for (const auto& [name, radius] : {std::pair{"one_missing", 0.5},
                                       {"radius_1", 1.1},
                                       {"radius_1_5", 1.5},
                                       {"radius_1_8", 1.8},
                                       {"radius_2_5", 2.5},
                                       {"radius_3_5", 3.5}}) {
        const Inside ball = in_ball(radius + 3.2);
        const Inside bubble = in_ball(radius);
        all.push_back(fluid_on(
            lattice(dimension, 2, 7, [&](const LatticePlace& n) { return ball(n) && !bubble(n); }),
            std::string("bubble_") + name,
            radius < 1 ? "interior around the missing particle: the others cover its direction"
                       : "surface around the bubble where a direction is open"));
    }
    const Inside ball = in_ball(5.2);
    all.push_back(fluid_on(
        lattice(
            dimension, 2, 6, [&](const LatticePlace& n) { return n[1] >= 0 && ball(n); },
            [](const LatticePlace& n) { return n[1] < 0 && n[1] > -3; }),
        "droplet_at_wall", "interior at the wall, whose particles cover; surface at the rim"));
}

HardCase droplet(int dimension) {
    return fluid_on(lattice(dimension, 2, 6, in_ball(5.2)), "droplet", lattice_rule);
}

void add_masses(int dimension, std::vector<HardCase>& all) {
    HardCase heavy =
        renamed(droplet(dimension), "mass_ratio_1e6", "as with equal masses: lambda knows no mass");
    std::mt19937_64 generator(11);
    for (std::size_t i = 0; i < heavy.size(); ++i)
        heavy.masses.push_back(generator() % 2 == 0 ? 1e-3 : 1e3);
    all.push_back(heavy);
    heavy.masses.assign(heavy.size(), 1e-3);
    for (std::size_t i = 0; i < heavy.size(); ++i)
        if (heavy.expected[i] == Expected::surface)
            heavy.masses[i] = 1e3;
    all.push_back(renamed(heavy, "heavy_surface_1e6", heavy.why));
    std::fill(heavy.masses.begin(), heavy.masses.end(), 1.0);
    heavy.masses[0] = std::numeric_limits<double>::quiet_NaN();
    heavy.refused = Refused::always;
    all.push_back(renamed(heavy, "mass_nan", "refused: a mass must be positive and finite"));
}

void add_bunches(int dimension, std::vector<HardCase>& all) {
    HardCase bunch = renamed(droplet(dimension), "hundreds_in_one_place_inside",
                             "interior: 300 particles in the middle are covered by those around");
    bunch.positions.resize(bunch.size() + 300, {0, 0, 0});
    bunch.expected.resize(bunch.size(), Expected::interior);
    all.push_back(bunch);
    HardCase below = renamed(droplet(dimension), "hundreds_in_one_place_below_surface",
                             "surface above the 300 particles as without them");
    below.positions.resize(below.size() + 300, {0, 4, 0});
    below.expected.resize(below.size(), Expected::either);
    below.line_misses = "more neighbors than it was trained for";
    all.push_back(below);
}

void add_scales(int dimension, std::vector<HardCase>& all) {
    const HardCase base = droplet(dimension);
    const auto of_water = [&](const char* name, double h) {
        HardCase water = renamed(scaled(base, h / base.support_radius), name,
                                 "as at any scale, with the masses of water");
        water.masses.assign(water.size(), 1000 * std::pow(h / 2, dimension));
        all.push_back(water);
    };
    of_water("radius_1e_minus_9", 1e-9);
    of_water("radius_1e9", 1e9);
    const HardCase unit = turned(scaled(base, 1 / base.support_radius), 13);
    const auto far = [&](const char* name, const char* why, double distance, Refused refused) {
        all.push_back(renamed(moved(unit, {distance, -distance, distance}), name, why));
        all.back().refused = refused;
    };
    far("far_1e4",
        "as at the origin, though float keeps three digits of the spacing; a warning in float", 1e4,
        Refused::never);
    far("far_1e7", "as at the origin in double; refused in float, which resolves h alone there",
        1e7, Refused::in_float);
    far("far_1e10", "as at the origin in double; refused in float", 1e10, Refused::in_float);
    far("far_1e17", "refused: neither type holds the spacing", 1e17, Refused::always);
}

void add_densities(int dimension, std::vector<HardCase>& all) {
    const double full = dimension == 3 ? 4 * pi / 3 : pi;
    for (const int mean : {20, 30, 40, 50, 60}) {
        const double radius = std::pow((mean + 1) / full, 1.0 / dimension);
        const Lattice places = lattice(dimension, std::min(radius, 2.75), 6, in_ball(5.5));
        // Both arguments hold for the lattice neighbors of a smaller radius; wider caps add to it.
        HardCase state = fluid_on(places, "mean_count_" + std::to_string(mean),
                                  "jittered lattice: closed behind the surface, open on it", 0.1);
        if (radius > 2.75) {
            state.support_radius = radius;
            expect_all(state, Expected::either);
            expect_open(state);
        }
        if (mean > (dimension == 3 ? 43 : 16)) // the most in its training states
            state.line_misses = "more neighbors than it was trained for";
        all.push_back(state);
    }
    const double radius = dimension == 3 ? 6.5 : 18.5;
    HardCase crowded =
        fluid_on(lattice(dimension, radius, 20, in_ball(radius + 1.5)), "over_1000_neighbors",
                 "middle interior: it has every lattice point within h; rim surface");
    for (std::size_t i = 0; i < crowded.size(); ++i)
        if (product(crowded.positions[i], crowded.positions[i]) < 1.5)
            mark(crowded, i, Expected::interior);
    crowded.line_misses = "it was trained for h = 2 spacings";
    all.push_back(crowded);
}

void add_odd_numbers(int dimension, std::vector<HardCase>& all) {
    const HardCase base = droplet(dimension);
    const auto with = [&](const char* name, const char* why, double coordinate, Refused refused) {
        all.push_back(renamed(base, name, why));
        all.back().positions[base.size() / 2][1] = coordinate;
        all.back().refused = refused;
        return &all.back();
    };
    with("position_nan", "refused: a position must be finite",
         std::numeric_limits<double>::quiet_NaN(), Refused::always);
    with("position_infinite", "refused: a position must be finite",
         std::numeric_limits<double>::infinity(), Refused::always);
    with("position_beyond_float", "refused in double too: 1e300 is more radii than it resolves",
         1e300, Refused::always);
    with("position_denormal", "as with 0 in its place", 4e-320, Refused::never);
    HardCase tiny = renamed(scaled(base, 1e-320), "all_denormal",
                            "refused: the support radius has lost its digits");
    tiny.refused = Refused::always;
    all.push_back(tiny);
    HardCase none = renamed(base, "radius_nan", "refused: the radius must be positive and finite");
    none.support_radius = std::numeric_limits<double>::quiet_NaN();
    none.refused = Refused::always;
    all.push_back(none);
    none.support_radius = 0;
    all.push_back(renamed(none, "radius_zero", none.why));
}

} // namespace

double spacing_of(const HardCase& hard_case) {
    const auto starts_with = [&](const char* text) { return hard_case.name.rfind(text, 0) == 0; };
    const bool is_unit = starts_with("lattice_h_2_5") || starts_with("mean_count_") ||
                         starts_with("over_1000_neighbors");
    return is_unit ? 1 : hard_case.support_radius / 2;
}

std::vector<HardCase> hard_cases(int dimension) {
    std::vector<HardCase> all;
    add_few_particles(dimension, all);
    add_thin_ones(dimension, all);
    add_lattices(dimension, all);
    add_shapes(dimension, all);
    add_masses(dimension, all);
    add_bunches(dimension, all);
    add_scales(dimension, all);
    add_densities(dimension, all);
    add_odd_numbers(dimension, all);
    return all;
}

HardCase turned_about_first(const HardCase& hard_case, std::uint64_t seed) {
    if (hard_case.positions.empty())
        return hard_case;
    const Place& first = hard_case.positions[0];
    return turned(moved(hard_case, {-first[0], -first[1], -first[2]}), seed);
}

Snapshot snapshot_of(const HardCase& hard_case) {
    Snapshot snapshot;
    snapshot.dimension = hard_case.dimension;
    snapshot.positions = hard_case.positions;
    snapshot.boundary = hard_case.boundary;
    snapshot.support_radius = hard_case.support_radius;
    if (!hard_case.masses.empty())
        set_array(snapshot, {"mass", 1, hard_case.masses});
    return snapshot;
}

} // namespace meniscus::test
