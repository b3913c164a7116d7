// Surface tension in a step (runtime/surface_tension.hpp), compiled for several instruction sets
// (surface_step_*.cpp), of which the best is picked at run time. All give the same bits. What goes
// in and out are the structs of meniscus.h, plain data that means the same in each of them; the C
// interface and the `meniscus` command stand on it.
#pragma once

#include "meniscus.h"

#include <cstddef>
#include <memory>

namespace meniscus {

/// The most threads that options may ask for.
inline constexpr int most_threads = 1024;

/// One fluid and its memory; for one caller at a time. Arguments are as meniscus.h says and are not
/// checked here, but for options.
class SurfaceStep {
public:
    virtual ~SurfaceStep() = default;

    virtual void reserve(std::size_t particles, std::size_t neighbors) = 0;
    virtual void set_samples(std::size_t samples) = 0;
    virtual void set_line(double k, double d) = 0;
    virtual void step(const meniscus_particles& particles) = 0;
    virtual void balance_momentum(const meniscus_particles& particles) = 0;
    [[nodiscard]] virtual meniscus_results results() const = 0;
};

/// The options by default, or those of the 2020 paper.
meniscus_options default_options();
meniscus_options options_of_paper();

/// The one for this machine; `precision` is a meniscus_precision. Throws std::invalid_argument,
/// naming it, where an option, the dimension or the precision is out of its range.
std::unique_ptr<SurfaceStep> surface_step(const meniscus_options& options, int dimension,
                                          int precision);

/// Those for each instruction set; for the tests. Empty where this machine lacks it.
std::unique_ptr<SurfaceStep> surface_step_baseline(const meniscus_options& options, int dimension,
                                                   int precision);
std::unique_ptr<SurfaceStep> surface_step_avx2(const meniscus_options& options, int dimension,
                                               int precision);
std::unique_ptr<SurfaceStep> surface_step_avx512(const meniscus_options& options, int dimension,
                                                 int precision);

} // namespace meniscus
