// The C interface in the hands of a host that gets everything wrong but the lengths of its arrays,
// which no library can know. Whatever is called in whatever order, each call answers with one of
// the statuses of meniscus.h, and what passes meniscus_check gives finite results.
#include "fuzz_file.hpp"

#include <meniscus/bindings/c/meniscus.h>

#include <fuzzer/FuzzedDataProvider.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace meniscus {
namespace {

constexpr std::size_t max_particles = 12;
constexpr std::size_t max_entries = 256;

/// Numbers near what is meant, and those that nobody means.
double number_from(FuzzedDataProvider& bytes) {
    switch (bytes.ConsumeIntegralInRange<int>(0, 9)) {
    case 0:
        return bytes.ConsumeFloatingPoint<double>();
    case 1:
        return std::numeric_limits<double>::quiet_NaN();
    case 2:
        return std::numeric_limits<double>::infinity();
    case 3:
        return 0;
    default:
        return bytes.ConsumeIntegral<std::int8_t>() / 32.0;
    }
}

template <class Real>
std::vector<Real> numbers_from(FuzzedDataProvider& bytes, std::size_t count) {
    std::vector<Real> numbers(count);
    for (Real& number : numbers)
        number = static_cast<Real>(number_from(bytes));
    return numbers;
}

/// What a host calls with: arrays as long as meniscus.h wants them, or longer.
template <class Real>
struct Host {
    std::vector<Real> positions;
    std::vector<Real> numbers;
    std::vector<std::uint64_t> offsets; ///< long enough for either width
    std::vector<std::uint32_t> neighbors;
    std::vector<std::uint8_t> candidates;
    std::vector<Real> results;
    meniscus_particles particles = {};

    explicit Host(FuzzedDataProvider& bytes) {
        const auto count = bytes.ConsumeIntegralInRange<std::size_t>(0, max_particles);
        positions = numbers_from<Real>(bytes, 4 * count);
        numbers = numbers_from<Real>(bytes, 3 * count);
        offsets.resize(count + 1);
        neighbors.resize(max_entries);
        candidates.resize(count);
        results.resize(4 * count);
        particles.size = bytes.ConsumeProbability<float>() < 0.9F ? sizeof particles : 8;
        particles.count = count;
        particles.positions =
            bytes.ConsumeIntegral<std::uint8_t>() > 4 ? positions.data() : nullptr;
        particles.stride = bytes.ConsumeIntegralInRange<std::size_t>(0, 4);
        particles.support_radius = bytes.ConsumeBool() ? 1 : number_from(bytes);
        if (bytes.ConsumeBool())
            particles.masses = numbers.data();
        if (bytes.ConsumeIntegral<std::uint8_t>() > 250)
            particles.support_radii = numbers.data();
        particles.offset_bits = bytes.ConsumeBool() ? 32 : bytes.ConsumeBool() ? 64 : 7;
        if (bytes.ConsumeBool())
            fill_all_pairs();
        else
            fill_lists(bytes);
        particles.offsets = offsets.data();
        particles.neighbors = neighbors.data();
        if (bytes.ConsumeIntegral<std::uint8_t>() > 200)
            particles.candidates = candidates.data();
    }

    void set_offset(std::size_t place, std::uint64_t value) {
        if (particles.offset_bits == 64)
            offsets[place] = value;
        else
            reinterpret_cast<std::uint32_t*>(offsets.data())[place] =
                static_cast<std::uint32_t>(value);
    }

    void fill_all_pairs() {
        std::size_t entry = 0;
        for (std::size_t i = 0; i < particles.count; ++i) {
            for (std::size_t j = 0; j < particles.count; ++j)
                if (i != j)
                    neighbors[entry++] = static_cast<std::uint32_t>(j);
            set_offset(i + 1, entry);
        }
    }

    void fill_lists(FuzzedDataProvider& bytes) {
        for (std::size_t i = 0; i <= particles.count; ++i)
            set_offset(i, bytes.ConsumeIntegral<std::uint8_t>());
        for (std::uint32_t& neighbor : neighbors)
            neighbor = bytes.remaining_bytes() > 0 ? bytes.ConsumeIntegral<std::uint8_t>() : 0;
    }
};

meniscus_options options_from(FuzzedDataProvider& bytes) {
    meniscus_options options;
    require((bytes.ConsumeBool() ? meniscus_options_init(&options, sizeof options)
                                 : meniscus_options_paper(&options, sizeof options)) == MENISCUS_OK,
            "options have defaults");
    options.spacing_ratio = 2;
    options.threads = 1;
    double* const numbers[] = {&options.k,
                               &options.d,
                               &options.boundary_weight,
                               &options.radius_ratio,
                               &options.fade,
                               &options.tau,
                               &options.covariance_share,
                               &options.surface_tension,
                               &options.spacing_ratio,
                               &options.contact_angle};
    int* const choices[] = {&options.coverage, &options.verification,  &options.curvature,
                            &options.force,    &options.normal_passes, &options.curvature_passes};
    while (bytes.ConsumeIntegralInRange<int>(0, 3) == 0 && bytes.remaining_bytes() > 0) {
        *numbers[bytes.ConsumeIntegralInRange<std::size_t>(0, 9)] = number_from(bytes);
        *choices[bytes.ConsumeIntegralInRange<std::size_t>(0, 5)] =
            bytes.ConsumeIntegralInRange<int>(-1, 3);
    }
    options.samples = bytes.ConsumeIntegralInRange<std::size_t>(0, 64);
    return options;
}

/// The status, which is one of four, and has words where it is not MENISCUS_OK.
int checked(int status) {
    require(status >= MENISCUS_OK && status <= MENISCUS_FAILURE, "there are four statuses");
    const std::string_view words = meniscus_last_error();
    require(status == MENISCUS_OK || !words.empty(), "what fails says why");
    require(words.find('\n') == std::string_view::npos, "an error message is one line");
    return status;
}

template <class Real>
void require_finite(const meniscus_surface* surface, std::size_t dimension) {
    meniscus_results found = {};
    found.size = sizeof found;
    require(checked(meniscus_get_results(surface, &found)) == MENISCUS_OK, "a step has results");
    const auto* force = static_cast<const Real*>(found.force);
    for (std::size_t i = 0; i < found.slots * dimension; ++i)
        require(std::isfinite(force[i]), "forces of checked particles are finite");
}

template <class Real>
void call_one(meniscus_surface* surface, std::size_t dimension, Host<Real>& host,
              FuzzedDataProvider& bytes) {
    const meniscus_particles* particles = &host.particles;
    switch (bytes.ConsumeIntegralInRange<int>(0, 11)) {
    case 0:
        checked(meniscus_reserve(surface, bytes.ConsumeIntegralInRange<std::size_t>(0, 100), 40));
        break;
    case 1:
        checked(meniscus_set_samples(surface, bytes.ConsumeIntegral<std::uint8_t>()));
        break;
    case 2:
        checked(meniscus_set_samples_for_time_step(surface, number_from(bytes), number_from(bytes),
                                                   bytes.ConsumeIntegral<std::uint8_t>()));
        break;
    case 3:
        checked(meniscus_set_line(surface, number_from(bytes), number_from(bytes)));
        break;
    case 4:
        checked(meniscus_set_surface_tension(surface, number_from(bytes)));
        break;
    case 5:
        checked(meniscus_set_contact_angle(surface, number_from(bytes)));
        break;
    case 6:
        checked(meniscus_set_smoothing(surface, bytes.ConsumeIntegralInRange<int>(-1, 3),
                                       bytes.ConsumeIntegralInRange<int>(-1, 3)));
        break;
    case 7:
        checked(meniscus_scatter(surface, nullptr, nullptr, nullptr, nullptr, nullptr,
                                 bytes.ConsumeIntegralInRange<std::size_t>(0, 4)));
        break;
    default: // the rest of a step, as far as a host may go
        if (checked(meniscus_check(surface, particles)) != MENISCUS_OK ||
            checked(meniscus_step(surface, particles)) != MENISCUS_OK)
            return;
        require_finite<Real>(surface, dimension);
        checked(meniscus_balance_momentum(surface, particles));
        checked(meniscus_add_accelerations(surface, nullptr, number_from(bytes),
                                           host.results.data(), dimension));
    }
}

template <class Real>
void call_all(FuzzedDataProvider& bytes, int precision) {
    const meniscus_options options = options_from(bytes);
    const int dimension = bytes.ConsumeIntegralInRange<int>(1, 4);
    meniscus_surface* surface = nullptr;
    if (checked(meniscus_create(&surface, &options, dimension, precision)) != MENISCUS_OK) {
        require(surface == nullptr, "what cannot be created is not there");
        return;
    }
    Host<Real> host(bytes);
    for (int calls = 0; calls < 8 && bytes.remaining_bytes() > 0; ++calls)
        call_one(surface, static_cast<std::size_t>(dimension), host, bytes);
    meniscus_destroy(surface);
}

} // namespace
} // namespace meniscus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider bytes(data, size);
    if (bytes.ConsumeBool())
        meniscus::call_all<float>(bytes, MENISCUS_FLOAT);
    else
        meniscus::call_all<double>(bytes, MENISCUS_DOUBLE);
    return 0;
}
