#include "torch_plugin.hpp"

#include "torch_trainer.hpp"

#include <meniscus/data/text/errors.hpp>

#include <dlfcn.h>
#include <filesystem>

namespace meniscus {
namespace {

constexpr const char* module_name = "libmeniscus_torch_trainer.so";

/// Beside the running program, by the relative path that build tree and installation share.
std::filesystem::path module_of_this_program() {
    std::error_code failure;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", failure);
    return failure ? std::filesystem::path(module_name)
                   : program.parent_path() / MENISCUS_MODULE_FOLDER / module_name;
}

/// The module stays loaded until the program ends: libtorch does not survive being unloaded.
void* load_module() {
    const auto here = module_of_this_program();
    if (void* module = dlopen(here.c_str(), RTLD_NOW | RTLD_LOCAL))
        return module;
    const std::string reason = dlerror();
    if (void* module = dlopen(module_name, RTLD_NOW | RTLD_LOCAL))
        return module;
    throw FailureError("the libtorch module cannot be loaded (" + reason +
                       "); install libtorch and meniscus again; train "
                       "--objective neyman-pearson needs none");
}

template <class Function>
Function* find_fit(const std::string& kind) {
    static void* const module = load_module();
    const std::string name = "meniscus_fit_" + kind;
    void* const symbol = dlsym(module, name.c_str());
    if (symbol == nullptr)
        throw FailureError("the libtorch module has no function " + name +
                           "; it belongs to another version, install meniscus again");
    return reinterpret_cast<Function*>(symbol);
}

/// Scenes weigh the same, whatever their number of particles; the weights add up to one.
std::vector<MeniscusTrainingPart> training_parts(const std::vector<LabelledState>& states) {
    const SceneGroups groups = group_by_scene(states);
    std::vector<std::size_t> particles(groups.names.size());
    for (std::size_t s = 0; s < states.size(); ++s)
        particles[groups.of_state[s]] += states[s].size();
    std::vector<MeniscusTrainingPart> parts;
    for (std::size_t s = 0; s < states.size(); ++s) {
        const std::size_t in_scene = particles[groups.of_state[s]];
        const double share = static_cast<double>(groups.names.size() * in_scene);
        parts.push_back({states[s].first.data(), states[s].neighbor_count.data(),
                         states[s].uncovered_fraction.data(), states[s].size(),
                         states[s].count_scale, in_scene == 0 ? 0 : 1 / share});
    }
    return parts;
}

} // namespace

bool has_torch_trainer() {
    return MENISCUS_TRAINER != 0;
}

Line fit_with_torch(const std::string& objective, const std::vector<LabelledState>& states,
                    double label_threshold, std::uint64_t seed) {
    if (!has_torch_trainer())
        throw FailureError("objective '" + objective +
                           "' needs libtorch, and this program was built without it "
                           "(MENISCUS_TRAINER=OFF); train with --objective neyman-pearson");
    const auto parts = training_parts(states);
    const MeniscusTrainingSet set{parts.data(), parts.size(), label_threshold, seed};
    MeniscusFit fit{};
    find_fit<MeniscusFitFunction>(objective)(&set, &fit);
    if (fit.message[0] != '\0')
        throw FailureError("objective '" + objective + "': " + fit.message);
    return {fit.k, fit.d};
}

void check_has_torch_trainer(const std::string& what) {
    if (!has_torch_trainer())
        throw FailureError(what + " needs libtorch, and this program was built without it "
                                  "(MENISCUS_TRAINER=OFF)");
}

std::vector<double> fit_curvature_with_torch(const CurvatureFitSet& set, std::size_t terms) {
    check_has_torch_trainer("the fit of a curvature map");
    const MeniscusCurvatureSet rows{set.features.data(),
                                    set.truth.data(),
                                    set.weight.data(),
                                    set.group.data(),
                                    set.truth.size(),
                                    terms,
                                    static_cast<std::size_t>(set.group.back()) + 1,
                                    set.bias_penalty};
    MeniscusCurvatureFit fit{};
    find_fit<decltype(meniscus_fit_curvature)>("curvature")(&rows, &fit);
    if (fit.message[0] != '\0')
        throw FailureError(std::string("the fit of a curvature map: ") + fit.message);
    return {fit.coefficients, fit.coefficients + terms};
}

} // namespace meniscus
