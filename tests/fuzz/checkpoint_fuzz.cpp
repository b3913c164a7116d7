// Checkpoints, as a run reads them that goes on: of what a snapshot file can hold, with the sum of
// its content right or not, since whoever forges one can write the sum, too. The files themselves
// are vtkhdf_fuzz's.
#include "fuzz_file.hpp"

#include <meniscus/runtime/version.hpp>
#include <meniscus/sph/run/checkpoint.hpp>

#include <fuzzer/FuzzedDataProvider.h>

namespace meniscus {
namespace {

constexpr const char* some_scene = R"({"duration": 0.5, "name": "tank"})";
constexpr const char* longer_scene = R"({"duration": 1, "name": "tank"})";
constexpr const char* some_run =
    R"({"steps":8,"time_step":0.005,"next_frame":5,"usual_step":0.005,"steps_since_frame":0,
"unconverged_steps":0,"pressure_iterations":0,"divergence_iterations":0,"time_since_frame":0.0,
"density_error":0.0,"max_density_error":0.0,"divergence_error":0.0,"max_divergence_error":0.0,
"tension_force":0.0,"tension_force_deviation":0.0,"pressure_force":0.0,"pressure_force_deviation":)";

ArrayValues values_of(FuzzedDataProvider& bytes, std::size_t count) {
    if (bytes.ConsumeBool()) {
        std::vector<double> values(count);
        for (double& value : values)
            value = bytes.ConsumeFloatingPoint<double>();
        return values;
    }
    std::vector<std::uint32_t> values(count);
    for (std::uint32_t& value : values)
        value = bytes.ConsumeIntegral<std::uint32_t>();
    return values;
}

Snapshot snapshot_of(FuzzedDataProvider& bytes) {
    Snapshot snapshot;
    snapshot.positions.resize(bytes.ConsumeIntegralInRange<std::size_t>(0, 4));
    if (bytes.ConsumeBool())
        snapshot.time = bytes.ConsumeFloatingPoint<double>();
    for (const char* name : {"id", "velocity", "solver_pressure", "solver_divergence"}) {
        const auto components = bytes.ConsumeIntegralInRange<int>(0, 4);
        if (components > 0)
            snapshot.point_data.push_back(
                {name, components,
                 values_of(bytes, snapshot.size() * static_cast<std::size_t>(components))});
    }
    auto& texts = snapshot.provenance;
    texts["program"] = bytes.ConsumeBool() ? std::string("meniscus ") + program_version
                                           : bytes.ConsumeRandomLengthString();
    texts["scene_text"] = bytes.ConsumeBool() ? some_scene : bytes.ConsumeRandomLengthString();
    texts["run"] = (bytes.ConsumeBool() ? some_run : "") + bytes.ConsumeRandomLengthString() + "}";
    texts["log"] = bytes.ConsumeRandomLengthString();
    texts["sha256"] = bytes.ConsumeBool() ? content_sum(snapshot) : bytes.ConsumeBytesAsString(64);
    return snapshot;
}

} // namespace
} // namespace meniscus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    FuzzedDataProvider bytes(data, size);
    const meniscus::Snapshot snapshot = meniscus::snapshot_of(bytes);
    const std::string scene =
        bytes.ConsumeBool() ? meniscus::longer_scene : bytes.ConsumeRandomLengthString();
    try {
        const auto checkpoint = meniscus::checkpoint_in(snapshot, scene, "checkpoint.vtkhdf");
        meniscus::require(checkpoint.state.velocities.size() == snapshot.size() &&
                              checkpoint.state.ids.size() == snapshot.size(),
                          "a state has a number and a velocity for each particle");
    } catch (const meniscus::InputError& error) {
        meniscus::require(std::string(error.what()).find('\n') == std::string::npos,
                          "an error message is one line");
    }
    return 0;
}
