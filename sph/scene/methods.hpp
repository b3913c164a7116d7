// What scenes say of pressure solvers and of surface-tension models, each known by its name. A
// method tells about itself in a row: the keys of a scene that it reads, and what the step has to
// know of it. The file of a method ends in its row, and pressure/pressure_solvers.hpp and
// tension/tension_models.hpp list the methods: a new one is its file and its place in the list.
#pragma once

#include "scene.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace meniscus {

class JsonReader;

/// A key of a scene's section "pressure", and the option that it sets. An option whose default is
/// out of range has none: the key must be there.
struct PressureKey {
    const char* name;
    std::variant<double PressureOptions::*, int PressureOptions::*, bool PressureOptions::*> option;
    double min = 0; ///< smallest and largest number; for a truth value without a meaning
    double max = 0;
};

/// Of all options, in their order.
inline constexpr PressureKey pressure_keys[] = {
    {"density_error", &PressureOptions::density_error, 1e-7, 0.5},
    {"divergence_error", &PressureOptions::divergence_error, 0, 0.5},
    {"min_iterations", &PressureOptions::min_iterations, 0, 100000},
    {"max_iterations", &PressureOptions::max_iterations, 1, 100000},
    {"clip_negative", &PressureOptions::clip_negative},
    {"sound_speed", &PressureOptions::sound_speed, 1e-9, 1e9},
    {"relaxation", &PressureOptions::relaxation, 0.01, 1},
    {"accelerate", &PressureOptions::accelerate},
};

/// Whether the key may be left out.
bool has_default(const PressureKey& key);

struct PressureSolverRow {
    const char* name;              ///< in scenes
    std::vector<std::string> keys; ///< of pressure_keys; the others have no meaning for it
    /// It takes compression back by iterations, over a time that the step chooses.
    bool iterates;
    /// The longest step that it leaves stable, s; infinity where it sets no limit.
    double (*longest_stable_step)(const Scene& scene);
};

struct TensionModelRow {
    const char* name;              ///< in scenes
    std::vector<std::string> keys; ///< that no other model reads
    /// Sets the options from these keys, those that are there; nullptr without keys. Throws
    /// InputError as read_scene() does.
    void (*read)(const JsonReader& reader, TensionOptions& options);
    bool has_sigma;     ///< the coefficient is sigma in N/m: capillary waves limit the step
    bool finds_surface; ///< with the forces, which are on surface particles alone
};

bool reads_key(const PressureSolverRow& solver, const std::string& key);

/// All pressure solvers, in the order of their list.
const std::vector<PressureSolverRow>& pressure_solvers();

/// The place of a solver in the list. Throws InputError, with the names that there are, where none
/// has that name.
std::size_t pressure_solver_place(const std::string& name);

/// All models of surface tension, in the order of their list.
const std::vector<TensionModelRow>& tension_models();

/// The place of a model in the list; the number of models for "none". Throws InputError, with the
/// names that there are, where none has that name.
std::size_t tension_model_place(const std::string& name);

/// Whether the scene's coefficient is sigma in N/m. Throws as tension_model_place() does.
bool has_sigma(const TensionOptions& options);

/// Whether a step finds the surface: for the model, or to restrict its forces to it. Throws as
/// tension_model_place() does.
bool knows_surface(const TensionOptions& options);

/// The longest step, s, that solver, viscosity (Morris et al. 1997, eq. 26, the smoothing length
/// being half the support radius), capillary waves (Brackbill et al. 1992, eq. 61) and gravity
/// leave stable, whatever the fluid does. Throws as pressure_solver_place() does.
double longest_stable_step(const Scene& scene);

/// The same but for viscosity, which asks for short steps where nothing moves fast.
double longest_inviscid_step(const Scene& scene);

/// The keys of the project's own model beside those that all models have, and what reads them.
std::vector<std::string> meniscus_option_keys();
void read_meniscus_options(const JsonReader& reader, TensionOptions& options);

/// The same of Akinci's adhesion.
void read_adhesion(const JsonReader& reader, TensionOptions& options);

/// The types of all methods of one kind, whose common base is Base.
template <class Base, class... Methods>
struct MethodList {
    /// The rows of the methods, in their order.
    static auto rows() { return std::vector{Methods::row()...}; }

    /// The method at that place, made from these arguments; nullptr beyond the end.
    template <class... Arguments>
    static std::unique_ptr<Base> make(std::size_t place, const Arguments&... arguments) {
        using Make = std::unique_ptr<Base> (*)(const Arguments&...);
        constexpr Make make_each[] = {make_one<Methods, Arguments...>...};
        return place < sizeof...(Methods) ? make_each[place](arguments...) : nullptr;
    }

private:
    template <class Method, class... Arguments>
    static std::unique_ptr<Base> make_one(const Arguments&... arguments) {
        return std::make_unique<Method>(arguments...);
    }
};

} // namespace meniscus
