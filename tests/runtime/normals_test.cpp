// Smoothing of normals and normals from positions.
#include <meniscus/runtime/surface/normals.hpp>

#include "random_caps.hpp"
#include "threaded_loop.hpp"

// Compilers warn of its vectors of 64 bytes.
#define EIGEN_DONT_VECTORIZE
#include <Eigen/Eigenvalues>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace meniscus {
namespace {

template <class Real>
constexpr double tolerance = sizeof(Real) == sizeof(double) ? 1e-12 : 2e-5;

/// Random particles around the origin as find_exposure leaves them, some covered, some without a
/// normal, with pairs between all that are closer than 1.
template <class Real, int Dimension>
class RandomCloud {
public:
    SurfaceParticles<Real, Dimension> list;
    std::vector<Vector3> positions;

    explicit RandomCloud(unsigned seed, std::size_t count = 150) : engine(seed) {
        std::uniform_real_distribution<double> place(-1.2, 1.2);
        for (std::size_t i = 0; i < count; ++i)
            positions.push_back({place(engine), place(engine), Dimension == 3 ? place(engine) : 0});
        list.slot_of.assign(count, static_cast<std::int32_t>(count));
        number_candidates(list);
        for (std::size_t slot = 0; slot < count; ++slot)
            set(slot, std::uniform_real_distribution<double>(-0.3, 1)(engine));
        add_pairs();
    }

    /// An exposure below 0 means covered; one up to 0.1 that the openings cancel out.
    void set(std::size_t slot, double exposure) {
        const bool has_normal = exposure > 0.1;
        const Vector3 normal = random_direction(engine, Dimension);
        list.surface_class[slot] = exposure < 0 ? SurfaceClass::covered : SurfaceClass::surface;
        list.exposure[slot] = has_normal ? static_cast<Real>(exposure) : 0;
        list.weight[slot] = list.exposure[slot];
        for (int axis = 0; axis < Dimension; ++axis)
            list.normal[slot][axis] = has_normal ? static_cast<Real>(normal[axis]) : 0;
    }

    void add_pairs() {
        for (std::size_t slot = 0; slot < list.size(); ++slot) {
            list.pairs_count[slot] = 0;
            for (std::size_t other = 0; other < list.size(); ++other) {
                const Vector3 step = difference(positions[other], positions[slot]);
                const double distance = std::sqrt(dot(step, step));
                if (other == slot || distance >= 1)
                    continue;
                auto& pair = list.pairs[list.pairs_begin[slot] + list.pairs_count[slot]++];
                pair = {static_cast<std::uint32_t>(other), static_cast<Real>(1 - distance), {}};
                for (int axis = 0; axis < Dimension; ++axis)
                    pair.step[axis] = static_cast<Real>(step[axis]);
            }
        }
    }

    [[nodiscard]] Vector3 normal(std::size_t slot) const {
        Vector3 vector{};
        for (int axis = 0; axis < Dimension; ++axis)
            vector[axis] = static_cast<double>(list.normal[slot][axis]);
        return vector;
    }

    [[nodiscard]] std::vector<Vector3> normals() const {
        std::vector<Vector3> all;
        for (std::size_t slot = 0; slot < list.size(); ++slot)
            all.push_back(normal(slot));
        return all;
    }

private:
    std::mt19937_64 engine;
};

double length(const Vector3& vector) {
    return std::sqrt(dot(vector, vector));
}

/// Eqs. 4 to 6 over all particles.
template <class Cloud>
Vector3 blended(const Cloud& cloud, double tau, std::size_t slot) {
    Vector3 average{};
    for (std::size_t other = 0; other < cloud.positions.size(); ++other) {
        const double distance = length(difference(cloud.positions[other], cloud.positions[slot]));
        if (other != slot && distance < 1)
            average = sum(average, scaled(1 - distance, cloud.normal(other)));
    }
    return sum(scaled(1 - tau, cloud.normal(slot)), scaled(tau, average));
}

template <class Cloud>
void expect_unit_or_zero(const Cloud& cloud, double allowed) {
    for (const Vector3& normal : cloud.normals())
        EXPECT_TRUE(length(normal) == 0 || std::fabs(length(normal) - 1) <= allowed);
}

template <class Real, int Dimension>
void test_smoothing() {
    std::vector<std::array<Real, Dimension>> before;
    for (unsigned seed = 0; seed < 10; ++seed) {
        RandomCloud<Real, Dimension> cloud(seed);
        const double tau = 0.1 * seed;
        std::vector<Vector3> expected;
        for (std::size_t slot = 0; slot < cloud.list.size(); ++slot)
            expected.push_back(blended(cloud, tau, slot));
        const auto old = cloud.normals();
        smooth_normals<Real, Dimension>(tau, SerialLoop{}, cloud.list, before);
        for (std::size_t slot = 0; slot < expected.size(); ++slot) {
            const double size = length(expected[slot]);
            const bool had_normal = length(old[slot]) > 0;
            const Vector3 wanted =
                had_normal && size > 0 ? scaled(1 / size, expected[slot]) : Vector3{};
            // Rounding weighs more where normals cancel out.
            EXPECT_LE(length(difference(cloud.normal(slot), wanted)),
                      tolerance<Real> * (1 + 1 / size))
                << slot;
        }
        expect_unit_or_zero(cloud, tolerance<Real>);
    }
}

TEST(Normals, AreSmoothedByTheFormula) {
    test_smoothing<float, 2>();
    test_smoothing<double, 2>();
    test_smoothing<float, 3>();
    test_smoothing<double, 3>();
}

template <class Real, int Dimension>
void test_no_share() {
    RandomCloud<Real, Dimension> cloud(1);
    const auto old = cloud.normals();
    std::vector<std::array<Real, Dimension>> before;
    smooth_normals<Real, Dimension>(0, SerialLoop{}, cloud.list, before);
    mix_in_covariance_normals<Real, Dimension>(0, SerialLoop{}, cloud.list);
    for (std::size_t slot = 0; slot < old.size(); ++slot)
        EXPECT_LE(length(difference(cloud.normal(slot), old[slot])), tolerance<Real> / 10);
}

TEST(Normals, StayAsTheyAreWithoutShareOfTheNeighbors) {
    test_no_share<float, 2>();
    test_no_share<double, 3>();
}

template <class Real, int Dimension>
void test_passes() {
    RandomCloud<Real, Dimension> cloud(2);
    const auto old = cloud.normals();
    std::vector<std::array<Real, Dimension>> before;
    for (int pass = 0; pass < 20; ++pass)
        smooth_normals<Real, Dimension>(0.5, SerialLoop{}, cloud.list, before);
    mix_in_covariance_normals<Real, Dimension>(0.5, SerialLoop{}, cloud.list);
    expect_unit_or_zero(cloud, tolerance<Real>);
    int without = 0;
    for (std::size_t slot = 0; slot < old.size(); ++slot)
        if (length(old[slot]) == 0) {
            ++without;
            EXPECT_EQ(length(cloud.normal(slot)), 0) << slot;
        }
    EXPECT_GT(without, 20);
}

TEST(Normals, AreOfLengthOneOrZeroHoweverOftenSmoothed) {
    test_passes<float, 2>();
    test_passes<double, 2>();
    test_passes<float, 3>();
    test_passes<double, 3>();
}

TEST(Normals, OfANonSurfaceParticleStayZeroAndThatOfALoneOneItsOwn) {
    RandomCloud<double, 3> cloud(3, 60);
    for (std::size_t slot = 0; slot < 60; ++slot)
        cloud.set(slot, slot == 0 ? 1 : -1);
    const Vector3 own = cloud.normal(0);
    std::vector<std::array<double, 3>> before;
    mix_in_covariance_normals<double, 3>(1, SerialLoop{}, cloud.list);
    smooth_normals<double, 3>(0.5, SerialLoop{}, cloud.list, before);
    EXPECT_GE(cloud.list.pairs_count[0], 3U);
    EXPECT_LE(length(difference(cloud.normal(0), own)), 1e-15);
    for (std::size_t slot = 1; slot < 60; ++slot)
        EXPECT_EQ(length(cloud.normal(slot)), 0);
}

TEST(Normals, DoNotDependOnTheLoop) {
    RandomCloud<float, 3> serial(4);
    RandomCloud<float, 3> threaded(4);
    std::vector<std::array<float, 3>> before;
    mix_in_covariance_normals<float, 3>(0.5, SerialLoop{}, serial.list);
    smooth_normals<float, 3>(0.5, SerialLoop{}, serial.list, before);
    mix_in_covariance_normals<float, 3>(0.5, ThreadedLoop{4}, threaded.list);
    smooth_normals<float, 3>(0.5, ThreadedLoop{4}, threaded.list, before);
    EXPECT_EQ(serial.list.normal, threaded.list.normal);
}

template <int Dimension>
using Matrix = Eigen::Matrix<double, Dimension, Dimension>;

/// The eigenvectors of a matrix, in the order of their eigenvalues.
template <int Dimension>
Eigen::SelfAdjointEigenSolver<Matrix<Dimension>> solved(const Matrix<Dimension>& matrix) {
    return Eigen::SelfAdjointEigenSolver<Matrix<Dimension>>(matrix);
}

/// |sine| of the angle between a vector and the eigenvector of the least eigenvalue.
template <int Dimension>
double sine_to_minor(const Vector3& vector, const Matrix<Dimension>& matrix) {
    Eigen::Matrix<double, Dimension, 1> ours;
    for (int axis = 0; axis < Dimension; ++axis)
        ours[axis] = vector[axis];
    const Eigen::Matrix<double, Dimension, 1> minor =
        solved<Dimension>(matrix).eigenvectors().col(0);
    return (ours - ours.dot(minor) * minor).norm();
}

template <int Dimension>
void test_eigenvector() {
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 300; ++trial) {
        // Often nearly flat, as the covariance of particles on a surface is.
        Matrix<Dimension> root;
        for (int a = 0; a < Dimension; ++a)
            for (int b = 0; b < Dimension; ++b)
                root(a, b) = normal(engine) * std::pow(10, -trial % 4 * b);
        const Matrix<Dimension> matrix = root * root.transpose();
        std::array<std::array<double, Dimension>, Dimension> ours{};
        for (int a = 0; a < Dimension; ++a)
            for (int b = 0; b < Dimension; ++b)
                ours[a][b] = matrix(a, b);
        const Vector3 minor = normals::minor_eigenvector<Dimension>(ours);
        const auto values = solved<Dimension>(matrix).eigenvalues();
        const double gap = (values[1] - values[0]) / values[Dimension - 1];
        EXPECT_NEAR(length(minor), 1, 1e-12);
        EXPECT_LE(sine_to_minor<Dimension>(minor, matrix), 1e-13 / gap) << trial;
    }
}

TEST(NormalsFromPositions, TakeTheEigenvectorThatEigenFinds) {
    test_eigenvector<2>();
    test_eigenvector<3>();
}

/// Eq. 7 with each particle's weight.
template <int Dimension, class Cloud>
Matrix<Dimension> covariance(const Cloud& cloud, std::size_t slot) {
    using Vector = Eigen::Matrix<double, Dimension, 1>;
    std::vector<Vector> places;
    std::vector<double> weights;
    Vector center = Vector::Zero();
    double weight_sum = 0;
    for (std::size_t other = 0; other < cloud.positions.size(); ++other) {
        const Vector3 step = difference(cloud.positions[other], cloud.positions[slot]);
        if (length(step) >= 1)
            continue;
        places.push_back(Eigen::Map<const Vector>(step.data()));
        weights.push_back(static_cast<double>(cloud.list.weight[other]));
        center += weights.back() * places.back();
        weight_sum += weights.back();
    }
    Matrix<Dimension> sum = Matrix<Dimension>::Zero();
    for (std::size_t n = 0; n < places.size(); ++n) {
        const Vector v = places[n] - center / weight_sum;
        const double q = v.norm();
        const double spline = q > 1     ? 0
                              : q > 0.5 ? 2 * std::pow(1 - q, 3)
                                        : 6 * (q * q * q - q * q) + 1;
        sum += weights[n] * spline * v * v.transpose();
    }
    return sum;
}

template <class Real, int Dimension>
void test_covariance() {
    const RandomCloud<Real, Dimension> cloud(6);
    RandomCloud<Real, Dimension> mixed(6);
    mix_in_covariance_normals<Real, Dimension>(1, SerialLoop{}, mixed.list);
    int compared = 0;
    for (std::size_t slot = 0; slot < cloud.list.size(); ++slot) {
        if (length(cloud.normal(slot)) == 0)
            continue;
        const auto matrix = covariance<Dimension>(cloud, slot);
        const auto values = solved<Dimension>(matrix).eigenvalues();
        const double gap = (values[1] - values[0]) / values[Dimension - 1];
        EXPECT_LE(sine_to_minor<Dimension>(mixed.normal(slot), matrix), tolerance<Real> / gap);
        EXPECT_GE(dot(mixed.normal(slot), cloud.normal(slot)), -tolerance<Real>);
        ++compared;
    }
    EXPECT_GT(compared, 50);
}

TEST(NormalsFromPositions, AreThoseOfTheWeightedCovarianceOnTheSampledNormalsSide) {
    test_covariance<float, 2>();
    test_covariance<double, 2>();
    test_covariance<float, 3>();
    test_covariance<double, 3>();
}

template <class Real, int Dimension>
void test_plane() {
    std::mt19937_64 engine(7);
    const Vector3 normal = random_direction(engine, Dimension);
    RandomCloud<Real, Dimension> cloud(8, 60);
    for (Vector3& position : cloud.positions)
        position = difference(position, scaled(dot(position, normal), normal));
    for (std::size_t slot = 0; slot < cloud.list.size(); ++slot)
        cloud.set(slot, 1);
    cloud.add_pairs();
    const auto sampled = cloud.normals();
    mix_in_covariance_normals<Real, Dimension>(1, SerialLoop{}, cloud.list);
    for (std::size_t slot = 0; slot < cloud.list.size(); ++slot) {
        const Vector3 wanted = scaled(std::copysign(1, dot(sampled[slot], normal)), normal);
        EXPECT_LE(length(difference(cloud.normal(slot), wanted)), tolerance<Real>) << slot;
    }
}

TEST(NormalsFromPositions, OfAPlaneAreExact) {
    test_plane<float, 2>();
    test_plane<double, 2>();
    test_plane<float, 3>();
    test_plane<double, 3>();
}

TEST(NormalsFromPositions, AreMixedIn) {
    const RandomCloud<double, 3> sampled(9);
    RandomCloud<double, 3> pure(9);
    RandomCloud<double, 3> mixed(9);
    mix_in_covariance_normals<double, 3>(1, SerialLoop{}, pure.list);
    mix_in_covariance_normals<double, 3>(0.3, SerialLoop{}, mixed.list);
    for (std::size_t slot = 0; slot < mixed.list.size(); ++slot) {
        const Vector3 wanted =
            sum(scaled(0.7, sampled.normal(slot)), scaled(0.3, pure.normal(slot)));
        EXPECT_LE(length(difference(scaled(length(wanted), mixed.normal(slot)), wanted)), 1e-12);
    }
}

} // namespace
} // namespace meniscus
