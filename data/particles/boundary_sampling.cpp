#include "boundary_sampling.hpp"

#include <meniscus/data/text/errors.hpp>
#include <meniscus/data/text/text.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <unordered_map>

namespace meniscus {
namespace {

using Place = std::array<double, 3>;

constexpr double max_box_points = 5e8;
constexpr double max_mesh_points = 1e8;
constexpr double max_axis_ratio = 1e3;  // half axis over spacing
constexpr double max_coordinate = 1e15; // over spacing
constexpr double min_distance = 0.75;   // of two samples, over spacing
constexpr double min_distance_2d = 0.5; // where a curve bends within a spacing
constexpr double fine_step = 0.25;      // of the places tried, over spacing
constexpr double rounding = 1e-6;       // of a length that should be whole spacings

Place operator+(const Place& a, const Place& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Place operator-(const Place& a, const Place& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Place operator*(double factor, const Place& a) {
    return {factor * a[0], factor * a[1], factor * a[2]};
}

double dot(const Place& a, const Place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double distance(const Place& a, const Place& b) {
    return std::sqrt(dot(b - a, b - a));
}

void check_spacing(double spacing) {
    if (!(spacing > 0) || !std::isfinite(spacing))
        throw InputError("the spacing of wall particles must be positive and finite, found " +
                         number_text(spacing));
}

/// Parts that the length is cut into so that none is longer than `longest`; may be absurdly many.
double exact_parts(double length, double longest) {
    return std::max(1.0, std::ceil(length / longest - rounding));
}

/// The same where the number has been checked.
std::int64_t parts_of(double length, double longest) {
    return static_cast<std::int64_t>(exact_parts(length, longest));
}

double share(std::int64_t part, std::int64_t parts) {
    return static_cast<double>(part) / static_cast<double>(parts);
}

/// Into how many parts of at most a spacing each axis is cut; 0 for z in two dimensions.
std::array<std::int64_t, 3> checked_parts(const BoxSides& box, double spacing, int dimension) {
    check_spacing(spacing);
    std::array<double, 3> parts{};
    for (int axis = 0; axis < dimension; ++axis) {
        const double width = box.high[axis] - box.low[axis];
        if (!(width >= spacing / 2) || !std::isfinite(width))
            throw InputError("a box of wall particles must be finite and at least half a spacing "
                             "of " +
                             number_text(spacing) + " m wide along each axis, found " +
                             number_text(box.low[axis]) + " to " + number_text(box.high[axis]));
        parts[axis] = exact_parts(width, spacing);
    }
    const double points = 2 * ((parts[0] + 1) * (parts[1] + 1) + (parts[1] + 1) * (parts[2] + 1) +
                               (parts[2] + 1) * (parts[0] + 1));
    if (!(points <= max_box_points))
        throw InputError("a box would have about " + rounded_text(points, 2) +
                         " wall particles; make it smaller or take a larger spacing");
    return {std::int64_t(parts[0]), std::int64_t(parts[1]), std::int64_t(parts[2])};
}

/// Takes places, but for those that lie too close to one taken before.
class Samples {
public:
    explicit Samples(double min_distance) : min_distance(min_distance) {}

    void offer(const Place& place) {
        const Cell cell{cell_of(place[0]), cell_of(place[1]), cell_of(place[2])};
        if (has_sample_near(place, cell))
            return;
        cells[cell].push_back(taken.size());
        taken.push_back(place);
    }

    std::vector<Place> taken;

private:
    using Cell = std::array<std::int64_t, 3>;
    struct Hash {
        std::size_t operator()(const Cell& cell) const {
            std::uint64_t mixed = 0;
            for (const std::int64_t index : cell)
                mixed =
                    (mixed ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15U ^ mixed >> 29;
            return mixed;
        }
    };

    [[nodiscard]] std::int64_t cell_of(double coordinate) const {
        return static_cast<std::int64_t>(std::floor(coordinate / min_distance));
    }

    [[nodiscard]] bool has_sample_near(const Place& place, const Cell& center) const {
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k) {
                    const auto cell = cells.find({center[0] + i, center[1] + j, center[2] + k});
                    if (cell == cells.end())
                        continue;
                    for (const std::size_t index : cell->second)
                        if (distance(place, taken[index]) < min_distance)
                            return true;
                }
        return false;
    }

    double min_distance;
    std::unordered_map<Cell, std::vector<std::size_t>, Hash> cells;
};

void offer_line(const Place& from, const Place& to, double step, Samples& samples) {
    const std::int64_t parts = parts_of(distance(from, to), step);
    for (std::int64_t part = 0; part <= parts; ++part)
        samples.offer(from + share(part, parts) * (to - from));
}

/// Rows of places from the longest edge, at most `step` apart, to the corner across.
void offer_triangle(std::array<Place, 3> corners, double step, Samples& samples) {
    while (distance(corners[0], corners[1]) < distance(corners[1], corners[2]) ||
           distance(corners[0], corners[1]) < distance(corners[2], corners[0]))
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
    const auto& [left, right, top] = corners;
    const double length = distance(left, right);
    if (length == 0)
        return;
    const double foot = dot(top - left, right - left) / (length * length);
    const double height = distance(top, left + foot * (right - left));
    const std::int64_t rows = parts_of(height, step);
    for (std::int64_t row = 0; row < rows; ++row)
        offer_line(left + share(row, rows) * (top - left), right + share(row, rows) * (top - right),
                   step, samples);
}

double area(const Place& a, const Place& b, const Place& c) {
    const Place u = b - a;
    const Place v = c - a;
    return distance({}, {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0]}) /
           2;
}

std::array<Place, 3> corners_of(const TriangleMesh& mesh, std::size_t triangle) {
    const auto& [a, b, c] = mesh.triangles[triangle];
    return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

void check_mesh(const TriangleMesh& mesh, double spacing) {
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        for (const double coordinate : mesh.vertices[v])
            if (!(std::abs(coordinate) <= max_coordinate * spacing))
                throw InputError("vertex " + std::to_string(v + 1) + " of the mesh is not finite " +
                                 "or beyond 1e15 spacings of its particles");
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::uint32_t vertex : mesh.triangles[t])
            if (vertex >= mesh.vertices.size())
                throw InputError("triangle " + std::to_string(t + 1) + " of the mesh has vertex " +
                                 std::to_string(vertex + 1) + ", of only " +
                                 std::to_string(mesh.vertices.size()));
    const double points = expected_points(mesh, spacing);
    if (points > max_mesh_points)
        throw InputError("the mesh would have about " + rounded_text(points, 2) +
                         " wall particles; scale it down or take a larger spacing");
}

/// The ellipse as a closed chain of points, dense against the spacing: those of a square's sides,
/// each drawn to the circle and stretched.
std::vector<Place> ellipse_chain(const Place& half_axes, double spacing) {
    const std::int64_t parts = 16 * parts_of(std::max(half_axes[0], half_axes[1]), spacing) + 64;
    std::vector<Place> chain;
    for (int side = 0; side < 4; ++side)
        for (std::int64_t part = 0; part < parts; ++part) {
            std::array<double, 2> p{1, 2 * share(part, parts) - 1};
            for (int turn = 0; turn < side; ++turn)
                p = {-p[1], p[0]};
            const double length = std::sqrt(p[0] * p[0] + p[1] * p[1]);
            chain.push_back({half_axes[0] * p[0] / length, half_axes[1] * p[1] / length, 0});
        }
    chain.push_back(chain.front());
    return chain;
}

void offer_ellipse(const Place& half_axes, double spacing, Samples& samples) {
    const std::vector<Place> chain = ellipse_chain(half_axes, spacing);
    std::vector<double> lengths{0};
    for (std::size_t k = 1; k < chain.size(); ++k)
        lengths.push_back(lengths.back() + distance(chain[k - 1], chain[k]));
    const std::int64_t parts = parts_of(lengths.back(), spacing);
    for (std::int64_t part = 0; part < parts; ++part) {
        const double wanted = share(part, parts) * lengths.back();
        const std::size_t next =
            std::upper_bound(lengths.begin(), lengths.end(), wanted) - lengths.begin();
        const double rest = (wanted - lengths[next - 1]) / (lengths[next] - lengths[next - 1]);
        const Place p = chain[next - 1] + rest * (chain[next] - chain[next - 1]);
        samples.offer(1 / distance({}, {p[0] / half_axes[0], p[1] / half_axes[1], 0}) * p);
    }
}

/// A fine grid on the sides of a cube, drawn to the sphere, which brings no two points farther
/// apart, and stretched.
void offer_ellipsoid(const Place& half_axes, double spacing, Samples& samples) {
    const double longest = *std::max_element(half_axes.begin(), half_axes.end());
    const BoxSides cube{{-1, -1, -1}, {1, 1, 1}, {}};
    for (const Place& p : sample_box(cube, fine_step * spacing / longest, 3)) {
        const Place unit = 1 / distance({}, p) * p;
        samples.offer({half_axes[0] * unit[0], half_axes[1] * unit[1], half_axes[2] * unit[2]});
    }
}

std::string in_line(std::size_t line) {
    return "line " + std::to_string(line) + ": ";
}

std::vector<std::string> words_of(const std::string& line) {
    constexpr const char* blanks = " \t\r\v\f";
    std::vector<std::string> words;
    for (std::size_t start = line.find_first_not_of(blanks); start != std::string::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, start), line.size());
        words.push_back(line.substr(start, end - start));
        start = line.find_first_not_of(blanks, end);
    }
    return words;
}

struct Face {
    std::size_t line = 0;
    std::vector<std::int64_t> corners; ///< counted from 0
};

Place read_vertex(const std::vector<std::string>& words, std::size_t line) {
    if (words.size() < 4)
        throw InputError(in_line(line) + "a vertex must have three numbers, found " +
                         std::to_string(words.size() - 1));
    Place vertex{};
    for (int axis = 0; axis < 3; ++axis)
        if (read_number(words[axis + 1], vertex[axis]) != std::errc() ||
            !std::isfinite(vertex[axis]))
            throw InputError(in_line(line) + "a vertex must have finite numbers, found " +
                             quoted_text(words[axis + 1]));
    return vertex;
}

/// `vertices`: that have come so far, from which negative numbers count back.
Face read_face(const std::vector<std::string>& words, std::size_t line, std::size_t vertices) {
    if (words.size() < 4)
        throw InputError(in_line(line) + "a face must have three corners or more, found " +
                         std::to_string(words.size() - 1));
    Face face{line, {}};
    for (std::size_t word = 1; word < words.size(); ++word) {
        std::int64_t number = 0;
        const std::string vertex = words[word].substr(0, words[word].find('/'));
        if (read_number(vertex, number) != std::errc() || number == 0)
            throw InputError(in_line(line) + "a face's corner must begin with the number of a " +
                             "vertex, from 1 or from -1 back, found " + quoted_text(words[word]));
        face.corners.push_back(number > 0 ? number - 1
                                          : static_cast<std::int64_t>(vertices) + number);
    }
    return face;
}

void add_triangles(const Face& face, TriangleMesh& mesh) {
    const auto vertices = static_cast<std::int64_t>(mesh.vertices.size());
    for (const std::int64_t corner : face.corners)
        if (corner < 0 || corner >= vertices)
            throw InputError(in_line(face.line) + "a face has vertex " +
                             std::to_string(corner + 1) + ", but there are " +
                             std::to_string(vertices));
    const auto corner = [&](std::size_t k) { return static_cast<std::uint32_t>(face.corners[k]); };
    for (std::size_t k = 2; k < face.corners.size(); ++k)
        mesh.triangles.push_back({corner(0), corner(k - 1), corner(k)});
}

TriangleMesh mesh_from(std::istream& stream, const std::filesystem::path& file) {
    TriangleMesh mesh;
    std::vector<Face> faces; // may come before their vertices
    std::string line;
    for (std::size_t number = 1; std::getline(stream, line); ++number) {
        const std::vector<std::string> words = words_of(line);
        if (!words.empty() && words[0] == "v")
            mesh.vertices.push_back(read_vertex(words, number));
        if (!words.empty() && words[0] == "f")
            faces.push_back(read_face(words, number, mesh.vertices.size()));
    }
    if (stream.bad())
        throw FailureError(file.string() + ": cannot be read");
    if (faces.empty())
        throw InputError("holds no face (a line 'f 1 2 3'); expected a Wavefront OBJ file");
    for (const Face& face : faces)
        add_triangles(face, mesh);
    return mesh;
}

} // namespace

std::vector<Place> sample_box(const BoxSides& box, double spacing, int dimension) {
    const std::array<std::int64_t, 3> parts = checked_parts(box, spacing, dimension);
    const auto on_side = [&](std::size_t axis, std::int64_t index) {
        return parts[axis] > 0 && ((index == 0 && !box.open[2 * axis]) ||
                                   (index == parts[axis] && !box.open[2 * axis + 1]));
    };
    const auto coordinate = [&](std::size_t axis, std::int64_t index) {
        const double way = share(index, parts[axis]);
        return (1 - way) * box.low[axis] + way * box.high[axis]; // exact at both ends
    };
    std::vector<Place> points;
    for (std::int64_t i = 0; i <= parts[0]; ++i)
        for (std::int64_t j = 0; j <= parts[1]; ++j) {
            const bool whole_row = on_side(0, i) || on_side(1, j);
            const std::int64_t step = whole_row ? 1 : std::max<std::int64_t>(parts[2], 1);
            for (std::int64_t k = 0; k <= parts[2]; k += step)
                if (whole_row || on_side(2, k))
                    points.push_back({coordinate(0, i), coordinate(1, j),
                                      dimension == 3 ? coordinate(2, k) : 0});
        }
    return points;
}

std::vector<Place> sample_ellipsoid(const Place& center, const Place& half_axes, double spacing,
                                    int dimension) {
    check_spacing(spacing);
    for (int axis = 0; axis < dimension; ++axis)
        if (!std::isfinite(center[axis]) || !(half_axes[axis] >= spacing / 2) ||
            !(half_axes[axis] <= max_axis_ratio * spacing))
            throw InputError(
                "a ball's half axes must be from 0.5 to " + rounded_text(max_axis_ratio, 4) +
                " spacings of " + number_text(spacing) + " m and its center finite, found " +
                number_text(half_axes[axis]) + " m around " + number_text(center[axis]));
    Samples samples((dimension == 2 ? min_distance_2d : min_distance) * spacing);
    if (dimension == 2)
        offer_ellipse(half_axes, spacing, samples);
    else
        offer_ellipsoid(half_axes, spacing, samples);
    for (Place& place : samples.taken)
        for (int axis = 0; axis < dimension; ++axis)
            place[axis] += center[axis];
    return samples.taken;
}

TriangleMesh read_obj(const std::filesystem::path& file) {
    return naming_file(file, [&] {
        std::ifstream stream(file, std::ios::binary);
        if (!stream || !std::filesystem::is_regular_file(file))
            throw InputError("cannot be read; expected a Wavefront OBJ file");
        return mesh_from(stream, file);
    });
}

double expected_points(const TriangleMesh& mesh, double spacing) {
    double points = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto [a, b, c] = corners_of(mesh, t);
        points += area(a, b, c) / spacing / spacing +
                  (distance(a, b) + distance(b, c) + distance(c, a)) / spacing;
    }
    return points;
}

std::vector<Place> sample_mesh(const TriangleMesh& mesh, double spacing) {
    check_spacing(spacing);
    check_mesh(mesh, spacing);
    Samples samples(min_distance * spacing);
    for (const double step : {spacing, fine_step * spacing}) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            for (const Place& corner : corners_of(mesh, t))
                samples.offer(corner);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const auto [a, b, c] = corners_of(mesh, t);
            offer_line(a, b, step, samples);
            offer_line(b, c, step, samples);
            offer_line(c, a, step, samples);
        }
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
            offer_triangle(corners_of(mesh, t), step, samples);
    }
    return samples.taken;
}

} // namespace meniscus
