// A snapshot is the state of an SPH simulation at one instant: particle positions and whatever
// arrays the solver stored with them, in the order and with the number types that they came in.
// Positions are held in double, which represents every float exactly; `position_precision`
// remembers what the file had, so that writing gives the same bytes back. Two-dimensional states
// have z = 0.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace meniscus {

/// Positions in metres, one row a particle; z is 0 in two dimensions.
using Positions = std::vector<std::array<double, 3>>;

using ArrayValues =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>,
                 std::vector<double>>;

/// Data per particle: `components` values for each particle, particle by particle.
struct PointArray {
    std::string name;
    int components = 1;
    ArrayValues values;
};

enum class Precision { float32, float64 };

/// More arrays than this are no state of a fluid, and a file that has them is refused.
inline constexpr std::size_t max_arrays = 1000;

struct Snapshot {
    int dimension = 3; ///< 2 or 3
    Positions positions;
    Precision position_precision = Precision::float64; ///< type that positions are written in
    std::vector<PointArray> point_data;                ///< names are unique
    Positions boundary; ///< wall particles and periodic copies, which cover; may be empty
    bool dimension_is_stated = false;       ///< by the file, else it is what the positions suggest
    std::optional<double> support_radius;   ///< kernel radius h in m
    std::optional<double> particle_spacing; ///< initial distance of particles in m
    std::optional<double> particle_volume;  ///< of a particle at rest, m^3 (in 2D m^2)
    std::optional<double> time;             ///< simulated time in s
    std::string scene;                      ///< empty when none is stored
    /// What made the data, as text by name (group `/meniscus` of the file). Never a date, a host,
    /// a path or a thread count: the same input and options give the same bytes.
    std::map<std::string, std::string> provenance;
    /// Where only a part of a file's particles was read: how many there are before it, and in all.
    std::uint64_t first_particle = 0;
    std::uint64_t particles_in_file = 0;
    /// What a reader had to decide or leave out, for whoever reads the file; never written.
    std::vector<std::string> notes;

    [[nodiscard]] std::size_t size() const { return positions.size(); }
};

/// The array of that name, or nullptr.
const PointArray* find_array(const Snapshot& snapshot, std::string_view name);

/// Adds the array, replacing one of the same name. The number of values must be
/// components * snapshot.size(), else std::invalid_argument.
void set_array(Snapshot& snapshot, PointArray array);

/// The array of that name, of one component. Throws InputError, naming the array, where it is
/// missing or has several components.
const PointArray& scalar_array(const Snapshot& snapshot, std::string_view name);

/// The values of a one-component array as doubles. Throws as scalar_array does.
std::vector<double> scalar_values(const Snapshot& snapshot, std::string_view name);

/// Values as doubles, whatever their stored type.
std::vector<double> as_doubles(const PointArray& array);

/// 1 where all coordinates are finite, else 0.
std::vector<std::uint8_t> finite_positions(const Snapshot& snapshot);

/// The dimension that the positions themselves suggest: 2 where two or more particles with finite
/// positions all have the same z, else 3. For files that do not store it.
int dimension_of(const Positions& positions);

/// The scene that a state belongs to: the stored one, else the file's stem without a trailing
/// frame number ("dam_0014.vtk" -> "dam").
std::string scene_of(const Snapshot& snapshot, const std::filesystem::path& file);

} // namespace meniscus
