// Surface tension in the step of a solver in Python, over its own arrays.
#include "arrays.hpp"
#include "list_checks.hpp"
#include "module.hpp"

#include <pybind11/stl.h>

#include <meniscus/bindings/step/surface_step.hpp>
#include <meniscus/classifier/model/model.hpp>
#include <meniscus/runtime/neighbors/position_resolution.hpp>
#include <meniscus/runtime/surface/option_table.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

namespace meniscus {
namespace {

using namespace py::literals;

template <class Value>
py::object value_of(const SurfaceOption<Value>& option, const SurfaceTensionOptions& options) {
    if constexpr (std::is_enum_v<Value>)
        return py::str(option.range.words[static_cast<std::size_t>(options.*option.member)]);
    else
        return py::cast(options.*option.member);
}

[[noreturn]] void refuse_value(const char* name, const OptionRange& range,
                               const py::handle& found) {
    throw InputError(std::string(name) + " must be " + range.text + ", found " +
                     py::str(found).cast<std::string>());
}

template <class Value>
void set_option(const SurfaceOption<Value>& option, const py::handle& given,
                SurfaceTensionOptions& options) {
    if constexpr (std::is_enum_v<Value>) {
        for (const int word : {0, 1})
            if (py::isinstance<py::str>(given) &&
                given.cast<std::string>() == option.range.words[word]) {
                options.*option.member = static_cast<Value>(word);
                return;
            }
    } else {
        try {
            if (is_in_range(option.range, given.cast<double>())) {
                options.*option.member = given.cast<Value>(); // whole numbers take no others
                return;
            }
        } catch (const py::cast_error&) { // refused below
        }
    }
    refuse_value(option.name, option.range, given);
}

/// Defaults, ranges and meanings, for messages and docs.
py::dict option_table() {
    py::dict table;
    for_each_surface_option([&](const auto& option) {
        table[option.name] = py::dict(
            "default"_a = value_of(option, {}), "paper"_a = value_of(option, paper_options()),
            "unit"_a = option.unit, "range"_a = option.range.text, "meaning"_a = option.meaning);
    });
    return table;
}

SurfaceTensionOptions options_from(const py::dict& given, const std::optional<Model>& model,
                                   bool paper, int dimension, std::string& warning) {
    SurfaceTensionOptions options = paper ? paper_options() : SurfaceTensionOptions{};
    if (given.contains("spacing_ratio")) // which a line follows
        options.spacing_ratio = given["spacing_ratio"].cast<double>();
    if (model) {
        const std::string fluid = "the fluid";
        check_dimension(*model, dimension, fluid);
        warning = outside_trained_range(*model, {{fluid, options.spacing_ratio, {}}});
        set_classifier(options, *model);
    }
    for_each_surface_option([&](const auto& option) {
        if (given.contains(option.name))
            set_option(option, given[option.name], options);
    });
    return options;
}

void demand(bool holds, const std::string& what) {
    if (!holds)
        throw InputError(what);
}

/// Signed and unsigned integers of one size have the same bits below 2^31, and what is negative
/// becomes too large.
bool has_integers_of(const py::array& array, py::ssize_t size) {
    const char kind = array.dtype().kind();
    return (kind == 'i' || kind == 'u') && array.itemsize() == size;
}

py::array_t<std::uint32_t> index_array(const py::handle& object, const char* name) {
    const py::array array = py::array::ensure(object, py::array::c_style);
    demand(array && array.ndim() == 1 &&
               (has_integers_of(array, 4) || has_integers_of(array, 8) || array.size() == 0),
           std::string(name) + " must be one row of whole numbers of 32 or 64 bits");
    if (array.size() == 0)
        return py::array_t<std::uint32_t>(0);
    if (array.itemsize() == 4)
        return array.attr("view")("uint32");
    const auto wide = py::array_t<std::uint64_t>(array.attr("view")("uint64"));
    py::array_t<std::uint32_t> made(array.size());
    std::transform(
        wide.data(), wide.data() + wide.size(), made.mutable_data(), [](std::uint64_t index) {
            return static_cast<std::uint32_t>(
                std::min<std::uint64_t>(index, std::numeric_limits<std::uint32_t>::max()));
        });
    return made;
}

py::array offset_array(const py::handle& object, std::size_t rows, const char* name) {
    py::array array = py::array::ensure(object, py::array::c_style);
    demand(array && array.ndim() == 1 && (has_integers_of(array, 4) || has_integers_of(array, 8)),
           std::string(name) + " must be one row of whole numbers of 32 or 64 bits");
    demand(static_cast<std::size_t>(array.size()) == rows + 1,
           std::string(name) + " must have " + std::to_string(rows + 1) +
               " entries, one more than there are particles, found " +
               std::to_string(array.size()));
    return array;
}

/// What a step is called with: the arrays, kept while it runs, and where they lie.
struct StepArrays {
    StepParticles particles;
    std::vector<py::object> kept;
    std::size_t entries = 0;          ///< of the lists
    std::size_t boundary_entries = 0; ///< likewise
    std::size_t boundary_count = 0;
};

template <class Value>
const Value* values_of(const py::dict& given, const char* name, std::size_t count,
                       StepArrays& arrays) {
    const py::object object = given[name];
    if (object.is_none())
        return nullptr;
    auto array = contiguous<Value>(object, name);
    demand(array.ndim() == 1 && static_cast<std::size_t>(array.size()) == count,
           std::string(name) + " must have " + std::to_string(count) +
               " entries, found the shape " + shape_text(array));
    const Value* data = array.data();
    arrays.kept.push_back(std::move(array));
    return data;
}

template <class Real>
const Real* places_of(const py::dict& given, const char* name, int dimension, std::size_t& count,
                      std::size_t& stride, StepArrays& arrays) {
    auto array = contiguous<Real>(given[name], name);
    demand(array.ndim() == 2 && array.shape(1) >= dimension,
           std::string(name) + " must have at least " + std::to_string(dimension) +
               " coordinates a row, found the shape " + shape_text(array));
    count = static_cast<std::size_t>(array.shape(0));
    stride = static_cast<std::size_t>(array.shape(1));
    const Real* data = array.data();
    arrays.kept.push_back(std::move(array));
    return data;
}

const std::uint32_t* indices_of(const py::dict& given, const char* name, std::size_t& entries,
                                StepArrays& arrays) {
    auto array = index_array(given[name], name);
    entries = static_cast<std::size_t>(array.size());
    const std::uint32_t* data = array.data();
    arrays.kept.push_back(std::move(array));
    return data;
}

template <class Real>
void take_boundary(const py::dict& given, int dimension, StepArrays& arrays) {
    if (given["boundary_positions"].is_none())
        return;
    StepParticles& particles = arrays.particles;
    std::size_t stride = 0;
    particles.boundary_positions = places_of<Real>(given, "boundary_positions", dimension,
                                                   arrays.boundary_count, stride, arrays);
    demand(stride == particles.stride,
           "boundary_positions must have as many columns as positions, " +
               std::to_string(particles.stride) + ", found " + std::to_string(stride));
    py::array offsets =
        offset_array(given["boundary_offsets"], particles.count, "boundary_offsets");
    demand((offsets.itemsize() == 8) == particles.wide_offsets,
           "boundary_offsets must be of as many bits as offsets");
    particles.boundary_offsets = offsets.data();
    arrays.kept.push_back(std::move(offsets));
    particles.boundary_neighbors =
        indices_of(given, "boundary_indices", arrays.boundary_entries, arrays);
    particles.boundary_weights =
        values_of<Real>(given, "boundary_weights", arrays.boundary_count, arrays);
}

template <class Real>
void take_radius(const py::dict& given, StepArrays& arrays) {
    const py::object radius = given["support_radius"];
    if (py::array::ensure(radius).ndim() == 0) {
        arrays.particles.support_radius = radius.cast<double>();
        demand(is_usable_radius<Real>(arrays.particles.support_radius),
               "support_radius must be positive and finite, and its square within the range of "
               "the number type, found " +
                   py::str(radius).cast<std::string>());
        return;
    }
    arrays.particles.support_radii =
        values_of<Real>(given, "support_radius", arrays.particles.count, arrays);
}

/// The arguments of a step as they lie in memory. Throws InputError, naming the array, where one
/// has another shape or type than it must.
template <class Real>
StepArrays step_arrays(const py::dict& given, int dimension) {
    StepArrays arrays;
    StepParticles& particles = arrays.particles;
    particles.positions =
        places_of<Real>(given, "positions", dimension, particles.count, particles.stride, arrays);
    demand(particles.count < std::size_t{std::numeric_limits<std::int32_t>::max()},
           "positions must be of less than 2^31 particles");
    py::array offsets = offset_array(given["offsets"], particles.count, "offsets");
    particles.wide_offsets = offsets.itemsize() == 8;
    particles.offsets = offsets.data();
    arrays.kept.push_back(std::move(offsets));
    particles.neighbors = indices_of(given, "indices", arrays.entries, arrays);
    take_radius<Real>(given, arrays);
    particles.masses = values_of<Real>(given, "masses", particles.count, arrays);
    particles.ids = values_of<std::uint32_t>(given, "ids", particles.count, arrays);
    particles.candidates = values_of<std::uint8_t>(given, "candidates", particles.count, arrays);
    take_boundary<Real>(given, dimension, arrays);
    return arrays;
}

void check_all_lists(const StepArrays& arrays) {
    const StepParticles& of = arrays.particles;
    check_lists_exist(
        {of.offsets, of.wide_offsets, of.count, of.neighbors, arrays.entries, of.count}, "");
    if (of.boundary_positions != nullptr)
        check_lists_exist({of.boundary_offsets, of.wide_offsets, of.count, of.boundary_neighbors,
                           arrays.boundary_entries, arrays.boundary_count},
                          "boundary_");
}

template <class Real>
void check_finite(const void* values, std::size_t count, std::size_t stride, int dimension,
                  const std::string& name) {
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < dimension; ++axis)
            demand(std::isfinite(real[i * stride + static_cast<std::size_t>(axis)]),
                   name + "[" + std::to_string(i) + "] is not finite");
}

template <class Real>
void check_positive(const void* values, std::size_t count, const std::string& name) {
    const auto* real = static_cast<const Real*>(values);
    for (std::size_t i = 0; real != nullptr && i < count; ++i)
        demand(real[i] > 0 && std::isfinite(real[i]),
               name + "[" + std::to_string(i) + "] is not positive and finite");
}

template <class Real>
void check_values(const StepArrays& arrays, int dimension) {
    const StepParticles& of = arrays.particles;
    check_finite<Real>(of.positions, of.count, of.stride, dimension, "positions");
    check_positive<Real>(of.masses, of.count, "masses");
    check_positive<Real>(of.support_radii, of.count, "support_radius");
    if (of.boundary_positions == nullptr)
        return;
    check_finite<Real>(of.boundary_positions, arrays.boundary_count, of.stride, dimension,
                       "boundary_positions");
    check_positive<Real>(of.boundary_weights, arrays.boundary_count, "boundary_weights");
}

/// A copy of what the last step found: memory of its own, whatever the next step does.
template <class Real>
struct FoundSurface {
    std::vector<std::uint32_t> particle;
    std::vector<std::uint8_t> surface_class;
    std::vector<Real> uncovered_fraction, normal, curvature, force;

    FoundSurface(const SurfaceStepResults& found, int dimension)
        : particle(found.particle, found.particle + found.slots),
          surface_class(found.surface_class, found.surface_class + found.slots),
          uncovered_fraction(reals(found.uncovered_fraction, found.slots)),
          normal(reals(found.normal, found.slots * static_cast<std::size_t>(dimension))),
          curvature(reals(found.curvature, found.slots)),
          force(reals(found.force, found.slots * static_cast<std::size_t>(dimension))) {}

    static std::vector<Real> reals(const void* values, std::size_t count) {
        const auto* real = static_cast<const Real*>(values);
        return std::vector<Real>(real, real + count);
    }
};

/// Serves one thread at a time; others wait, without the interpreter's lock.
class SharedStep {
    std::string warning; ///< about what the line was trained on; before what sets it
    int dimension;
    bool is_double;
    std::unique_ptr<SurfaceStep> surface;
    std::mutex access;

    template <class Act>
    auto alone(const Act& act) {
        const py::gil_scoped_release released;
        const std::lock_guard<std::mutex> locked(access);
        return act();
    }

public:
    SharedStep(int its_dimension, bool its_is_double, const std::optional<Model>& model, bool paper,
               int threads, const py::dict& options)
        : dimension(its_dimension), is_double(its_is_double),
          surface(surface_step(options_from(options, model, paper, dimension, warning),
                               {dimension, is_double, threads})) {}

    [[nodiscard]] const std::string& warning_of_line() const { return warning; }

    py::dict step(const py::dict& given, bool balanced) {
        return is_double ? step_in<double>(given, balanced) : step_in<float>(given, balanced);
    }

    void check(const py::dict& given) {
        if (is_double)
            check_in<double>(given);
        else
            check_in<float>(given);
    }

    void reserve(std::size_t particles, std::size_t neighbors) {
        alone([&] { surface->reserve(particles, neighbors); });
    }

    void set_samples(std::size_t samples) {
        check_option("samples", option_ranges::samples, static_cast<double>(samples));
        alone([&] { surface->set_samples(samples); });
    }

    void set_line(double k, double d) {
        check_option("k", option_ranges::line, k);
        check_option("d", option_ranges::line, d);
        alone([&] { surface->set_line(k, d); });
    }

    void set_surface_tension(double sigma) {
        alone([&] { surface->set_surface_tension(sigma); });
    }

    void set_contact_angle(double angle) {
        alone([&] { surface->set_contact_angle(angle); });
    }

    void set_fade(double fade) {
        alone([&] { surface->set_fade(fade); });
    }

    void set_smoothing(int normal_passes, int curvature_passes) {
        alone([&] { surface->set_smoothing(normal_passes, curvature_passes); });
    }

private:
    template <class Real>
    py::dict step_in(const py::dict& given, bool balanced) {
        const StepArrays arrays = step_arrays<Real>(given, dimension);
        FoundSurface<Real> found = alone([&] {
            check_all_lists(arrays);
            surface->step(arrays.particles);
            if (balanced)
                surface->balance_momentum(arrays.particles);
            return FoundSurface<Real>(surface->results(), dimension);
        });
        const auto axes = static_cast<std::size_t>(dimension);
        return py::dict("particle"_a = array_of(std::move(found.particle)),
                        "surface_class"_a = array_of(std::move(found.surface_class)),
                        "uncovered_fraction"_a = array_of(std::move(found.uncovered_fraction)),
                        "normal"_a = array_of(std::move(found.normal), axes),
                        "curvature"_a = array_of(std::move(found.curvature)),
                        "force"_a = array_of(std::move(found.force), axes),
                        "count"_a = arrays.particles.count);
    }

    template <class Real>
    void check_in(const py::dict& given) {
        const StepArrays arrays = step_arrays<Real>(given, dimension);
        alone([&] {
            check_all_lists(arrays);
            check_values<Real>(arrays, dimension);
            surface->check(arrays.particles);
        });
    }
};

} // namespace

void add_surface_tension(py::module_& module) {
    module.attr("surface_options") = option_table();
    py::class_<SharedStep>(module, "SurfaceTension")
        .def(py::init<int, bool, const std::optional<Model>&, bool, int, const py::dict&>())
        .def_property_readonly("warning", &SharedStep::warning_of_line)
        .def("step", &SharedStep::step)
        .def("check", &SharedStep::check)
        .def("reserve", &SharedStep::reserve)
        .def("set_samples", &SharedStep::set_samples)
        .def("set_line", &SharedStep::set_line)
        .def("set_surface_tension", &SharedStep::set_surface_tension)
        .def("set_contact_angle", &SharedStep::set_contact_angle)
        .def("set_fade", &SharedStep::set_fade)
        .def("set_smoothing", &SharedStep::set_smoothing);
}

} // namespace meniscus
