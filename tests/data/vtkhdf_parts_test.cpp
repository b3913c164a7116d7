// Snapshot files in parts: what is read of some rows, and what is written as it is fetched.
#include "fetched_snapshot.hpp"
#include "test_folder.hpp"

#include <meniscus/data/formats/vtkhdf.hpp>
#include <meniscus/data/text/errors.hpp>

#include <cmath>
#include <numeric>

namespace meniscus {
namespace {

Snapshot sample(std::size_t particles) {
    Snapshot snapshot;
    std::vector<float> velocity;
    std::vector<std::int64_t> id(particles);
    std::iota(id.begin(), id.end(), -5);
    for (std::size_t i = 0; i < particles; ++i) {
        const double x = 0.1 * static_cast<double>(i);
        snapshot.positions.push_back({x, std::sin(x), -x});
        for (int axis = 0; axis < 3; ++axis)
            velocity.push_back(static_cast<float>(x) + static_cast<float>(axis));
    }
    snapshot.point_data = {{"velocity", 3, velocity}, {"id", 1, id}};
    snapshot.boundary = {{1, 2, 3}, {4, 5, 6}};
    snapshot.support_radius = 0.25;
    snapshot.scene = "parts";
    snapshot.provenance["made"] = "by a test";
    return snapshot;
}

using VtkhdfParts = TestFolder;

TEST_F(VtkhdfParts, FetchedRowsGiveTheSameBytes) {
    for (const std::size_t particles : {0U, 1U, 30U, 400'000U}) {
        const Snapshot snapshot = sample(particles);
        write_vtkhdf(snapshot, folder / "whole.vtkhdf");
        for (const std::uint64_t rows : {1U, 50'000U, 1U << 18}) {
            write_vtkhdf(fetched_from(snapshot, rows), folder / "fetched.vtkhdf");
            EXPECT_TRUE(bytes_of(folder / "whole.vtkhdf") == bytes_of(folder / "fetched.vtkhdf"))
                << particles << " particles, " << rows << " rows at once";
        }
    }
}

TEST_F(VtkhdfParts, FetchingThatFailsLeavesNothing) {
    const Snapshot snapshot = sample(100'000);
    FetchedSnapshot fetched = fetched_from(snapshot, 1);
    fetched.values = [](std::size_t, std::uint64_t, std::uint64_t) -> ArrayValues {
        throw InputError("no values");
    };
    EXPECT_THROW(write_vtkhdf(fetched, folder / "fetched.vtkhdf"), InputError);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
    write_vtkhdf(snapshot, folder / "whole.vtkhdf"); // HDF5 is free again
    EXPECT_EQ(read_vtkhdf(folder / "whole.vtkhdf").size(), snapshot.size());
}

TEST_F(VtkhdfParts, PartsAreThoseOfTheWhole) {
    const Snapshot snapshot = sample(100'000);
    write_vtkhdf(snapshot, folder / "whole.vtkhdf");
    const Snapshot outline = read_vtkhdf_outline(folder / "whole.vtkhdf");
    EXPECT_EQ(outline.particles_in_file, snapshot.size());
    EXPECT_EQ(outline.size(), 0U);
    EXPECT_EQ(outline.support_radius, snapshot.support_radius);
    EXPECT_EQ(outline.provenance, snapshot.provenance);
    ASSERT_EQ(outline.point_data.size(), 2U);
    EXPECT_EQ(outline.point_data[1].components, 3);
    EXPECT_TRUE(std::holds_alternative<std::vector<float>>(outline.point_data[1].values));
    const Snapshot part = read_vtkhdf_part(folder / "whole.vtkhdf", {70'000, 20'000, {"velocity"}});
    EXPECT_EQ(part.first_particle, 70'000U);
    EXPECT_EQ(part.positions,
              Positions(snapshot.positions.begin() + 70'000, snapshot.positions.begin() + 90'000));
    EXPECT_EQ(part.point_data.at(0).values, some_of(snapshot.point_data[0], 70'000, 20'000));
    EXPECT_EQ(read_vtkhdf_boundary(folder / "whole.vtkhdf"), snapshot.boundary);
    EXPECT_THROW(read_vtkhdf_part(folder / "whole.vtkhdf", {90'000, 10'001, {}}), InputError);
}

} // namespace
} // namespace meniscus
