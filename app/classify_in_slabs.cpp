#include "classify_in_slabs.hpp"

#include <meniscus/classifier/model/classify_snapshot.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/particle_arrays.hpp>
#include <meniscus/data/particles/particle_volumes.hpp>
#include <meniscus/data/ranks/packing.hpp>
#include <meniscus/runtime/surface/surface_particles.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace meniscus {
namespace {

/// Arrays of the classes, in the order of their columns.
struct ClassArray {
    const char* name;
    int components;
    bool is_class; ///< stored in a byte
};
constexpr ClassArray class_arrays[] = {
    {"predicted_surface", 1, true},           {"surface_class", 1, true},
    {"runtime_uncovered_fraction", 1, false}, {"runtime_normal", 3, false},
    {"runtime_curvature", 1, false},          {"runtime_force", 3, false}};
constexpr std::size_t class_columns = 10;

/// Neighbors a particle, about, and some more.
double listed_neighbors(int dimension, double spacing_ratio) {
    constexpr double pi = 3.14159265358979;
    const double sphere =
        dimension == 2 ? pi * std::pow(spacing_ratio, 2) : 4 * pi / 3 * std::pow(spacing_ratio, 3);
    return 10 + 1.3 * sphere;
}

/// Positions, their copies, the search, offsets and lists, candidates with all that is found of
/// them, and results of all particles.
std::uint64_t bytes_to_classify(int dimension, double spacing_ratio) {
    return 320 + static_cast<std::uint64_t>(4 * listed_neighbors(dimension, spacing_ratio));
}

/// What ratio the file suggests; that of usual scenes where it does not.
double likely_ratio(const Snapshot& outline) {
    const double radius = outline.support_radius.value_or(0);
    if (radius > 0 && outline.particle_volume)
        return *stored_spacing_ratio(outline, radius);
    return radius > 0 && outline.particle_spacing ? radius / *outline.particle_spacing : 2.5;
}

constexpr std::size_t count_bins = 1024; ///< as median_neighbor_count has them

/// One rank's work on one state.
class ClassifyWork {
public:
    ClassifyWork(const RowsOfState& state, const SlabClassifyOptions& options,
                 const SlabOptions& slabs, Ranks& ranks)
        : state(state), options(options), slab_options(slabs), ranks(ranks),
          particles(state, {"mass", "phase", "id"}, slabs, ranks) {}

    ClassesInFile run() {
        if (std::string doubt = particles.read(options.skip_invalid); !doubt.empty())
            classes.warnings.push_back(std::move(doubt));
        find_spacing();
        const Model* model = nullptr;
        do_together(ranks, [&] { // each chooses the same
            model = &options.model(classes.spacing_ratio);
            check_dimension(*model, state.frame.dimension, "the snapshot");
            classes.rows = std::make_unique<RowResults>(state.size, class_columns,
                                                        slab_options.scratch, ranks);
        });
        particles.sort({layers(),
                        bytes_to_classify(state.frame.dimension, classes.spacing_ratio) +
                            particles.array_bytes(),
                        8});
        particles.for_slabs(
            [&](const Snapshot& slab, PartOfState& part) { classify(slab, part, *model); });
        classes.rows->settle();
        add_counts(*model);
        classes.slabs = particles.slabs();
        classes.halo = particles.halo();
        classes.bytes_sent = particles.bytes_sent() + classes.rows->bytes_sent();
        return std::move(classes);
    }

private:
    const RowsOfState& state;
    const SlabClassifyOptions& options;
    const SlabOptions& slab_options;
    Ranks& ranks;
    StateInSlabs particles;
    ClassesInFile classes;
    std::vector<std::uint64_t> interior = std::vector<std::uint64_t>(count_bins);
    std::string doubt; ///< of the support radius, by the first slab

    /// As far as forces depend on particles (docs/cluster.md).
    [[nodiscard]] int layers() const {
        return 2 + options.surface.normal_passes + options.surface.curvature_passes;
    }

    void find_spacing() {
        if (const auto stored = stored_spacing_ratio(state.frame, *state.frame.support_radius)) {
            classes.spacing_ratio = *stored;
            return;
        }
        particles.sort({1, 24 + 24 + 24 + 8 + 4 + 8 + 8 + 8 + 2 + particles.array_bytes(), 8});
        classes.spacing_ratio = particles.measured_spacing_ratio(options.threads);
    }

    void classify(const Snapshot& loaded, const PartOfState& part, const Model& model) {
        Snapshot slab = loaded;
        slab.boundary = state.frame.boundary;
        if (find_array(slab, "id") == nullptr) // what keys samples in the whole
            set_array(slab, {"id", 1,
                             std::vector<std::int64_t>(part.numbers.begin(), part.numbers.end())});
        if (part.is_first)
            doubt = doubtful_support_radius(slab, *state.frame.support_radius, part.own);
        const Classes found =
            classify_part(slab, part, model, classes.spacing_ratio, options.threads);
        find_surface(slab, found, model, options.surface, false, options.threads);
        set_array(slab, {"predicted_surface", 1, stored_classes(found.surface)});
        store(slab, found, part);
    }

    void store(const Snapshot& slab, const Classes& found, const PartOfState& part) {
        std::vector<std::vector<double>> values;
        for (const ClassArray& array : class_arrays)
            values.push_back(as_doubles(*find_array(slab, array.name)));
        std::array<double, class_columns> numbers{};
        for (std::size_t i = 0; i < part.own.size(); ++i) {
            if (part.own[i] == 0)
                continue;
            auto next = numbers.begin();
            for (std::size_t a = 0; a < values.size(); ++a) {
                const auto width = static_cast<std::size_t>(class_arrays[a].components);
                next = std::copy_n(values[a].begin() + static_cast<std::ptrdiff_t>(i * width),
                                   width, next);
            }
            classes.rows->add(part.numbers[i], numbers.data());
            count(found, values[1][i], i);
        }
    }

    void count(const Classes& found, double surface_class, std::size_t i) {
        classes.counts.candidates += found.surface[i];
        classes.counts.surface +=
            surface_class == static_cast<double>(SurfaceClass::surface) ? 1 : 0;
        if (found.surface[i] == 0)
            ++interior[std::min(static_cast<std::size_t>(found.neighbor_count[i]), count_bins - 1)];
    }

    void add_counts(const Model& model) {
        std::vector<std::uint64_t> sums = {classes.counts.candidates, classes.counts.surface};
        ranks.sum(sums);
        classes.counts = {sums[0], sums[1]};
        ranks.sum(interior);
        if (std::string warning = range_warning(model, classes.spacing_ratio, median_of_interior());
            !warning.empty())
            classes.warnings.push_back(std::move(warning));
        for (const std::string& said : gather(ranks, doubt))
            if (!said.empty())
                classes.warnings.push_back(said);
    }

    /// As median_neighbor_count.
    [[nodiscard]] std::optional<double> median_of_interior() const {
        std::uint64_t all = 0;
        for (const std::uint64_t particles_with : interior)
            all += particles_with;
        std::uint64_t below = 0;
        for (std::size_t bin = 0; all > 0 && bin < count_bins; ++bin) {
            below += interior[bin];
            if (2 * below >= all)
                return static_cast<double>(bin);
        }
        return {};
    }
};

} // namespace

ClassesInFile classify_in_slabs(const RowsOfState& state, const SlabClassifyOptions& options,
                                const SlabOptions& slabs, Ranks& ranks) {
    return ClassifyWork(state, options, slabs, ranks).run();
}

void add_empty_classes(Snapshot& frame) {
    set_array(frame, {"valid", 1, std::vector<std::int8_t>()});
    for (const ClassArray& array : class_arrays)
        if (array.is_class)
            set_array(frame, {array.name, 1, std::vector<std::int8_t>()});
        else
            set_array(frame, {array.name, array.components, std::vector<double>()});
}

std::optional<ArrayValues> class_values(const PointArray& array, const RowResults& rows,
                                        std::uint64_t first, std::uint64_t count) {
    if (array.name == "valid")
        return stored_classes(rows.was_added(first, count));
    std::size_t column = 0;
    for (const ClassArray& known : class_arrays) {
        const auto width = static_cast<std::size_t>(known.components);
        if (array.name != known.name) {
            column += width;
            continue;
        }
        std::vector<double> values(count * width);
        for (std::size_t component = 0; component < width; ++component) {
            const auto some = rows.column(column + component, first, count);
            for (std::uint64_t i = 0; i < count; ++i)
                values[i * width + component] = some[i];
        }
        if (known.is_class)
            return std::vector<std::int8_t>(values.begin(), values.end());
        return values;
    }
    return std::nullopt;
}

std::uint64_t memory_to_classify(const Snapshot& outline) {
    std::uint64_t row = bytes_to_classify(outline.dimension, likely_ratio(outline));
    for (const PointArray& array : outline.point_data)
        row += static_cast<std::uint64_t>(array.components) * 8;
    return outline.particles_in_file * row + outline.boundary.size() * 76;
}

} // namespace meniscus
