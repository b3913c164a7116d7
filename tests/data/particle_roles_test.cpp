// Fluid and walls in one file, names of other programs, and what is close to a periodic side.
#include "expected_errors.hpp"
#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/particles/known_names.hpp>
#include <meniscus/data/particles/nearest_spacing.hpp>
#include <meniscus/data/particles/periodic_copies.hpp>
#include <meniscus/data/text/cut_numbers.hpp>
#include <meniscus/data/text/errors.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace meniscus {
namespace {

class ParticleRoles : public TestFolder {
protected:
    Snapshot read(std::string_view bytes, const ReadChoices& choices = {}) const {
        return read_snapshot(write("state.csv", bytes), choices);
    }
    std::string error(std::string_view bytes, const ReadChoices& choices = {}) const {
        return error_of<InputError>([&] { read(bytes, choices); });
    }

    const std::string dualsphysics = "x,y,z,Idp,Type\n0,0,0,0,0\n1,0,0,1,1\n0,1,0,2,2\n"
                                     "0,0,1,3,3\n0,0,2,4,3\n";
};

TEST_F(ParticleRoles, TypesOfDualSPHysicsTellWalls) {
    const Snapshot snapshot = read(dualsphysics);
    EXPECT_EQ(snapshot.positions, (Positions{{0, 0, 1}, {0, 0, 2}}));
    EXPECT_EQ(snapshot.boundary, (Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(scalar_values(snapshot, "id"), (std::vector<double>{3, 4}));
    ASSERT_EQ(snapshot.notes.size(), 1U);
    expect_mentions(snapshot.notes[0], {"2 particles are fluid", "3 walls"});
    EXPECT_TRUE(read("x,y,Type,id\n0,0,3,1\n1,0,3,2\n").boundary.empty());
}

TEST_F(ParticleRoles, WallsAloneAreNoFluid) {
    const std::string walls = "x,y,z,Mk,Type\n0,0,0,1,0\n1,0,0,1,1\n";
    expect_mentions(error(walls), {"state.csv", "only walls", "--boundary", "--fluid"});
    ReadChoices choices;
    choices.is_boundary = true;
    EXPECT_EQ(read(walls, choices).size(), 2U);
}

TEST_F(ParticleRoles, TypesOfOthersAreSaidAndChosen) {
    const std::string table = "x,y,z,type\n0,0,0,1\n1,0,0,2\n0,1,0,1\n0,0,1,4\n";
    const Snapshot all = read(table);
    EXPECT_EQ(all.size(), 4U);
    ASSERT_EQ(all.notes.size(), 1U);
    expect_mentions(all.notes[0], {"type", "--walls type=1"});
    ReadChoices choices;
    choices.walls = {"type=2"};
    choices.ignored = {"Type=4"};
    const Snapshot chosen = read(table, choices);
    EXPECT_EQ(chosen.size(), 2U);
    EXPECT_EQ(chosen.boundary, (Positions{{1, 0, 0}}));
    choices = {};
    choices.fluid = {"type=4"};
    EXPECT_EQ(read(table, choices).positions, (Positions{{0, 0, 1}}));
}

TEST_F(ParticleRoles, WrongChoicesAreNamed) {
    ReadChoices choices;
    choices.fluid = {"Mk=1"};
    expect_mentions(error(dualsphysics, choices), {"'Mk=1'", "the file has id, Type"});
    choices.fluid = {"dam"};
    expect_mentions(error(dualsphysics, choices), {"'dam'", "Type=3"});
    choices.fluid = {"Type=water"};
    expect_mentions(error(dualsphysics, choices), {"'Type=water'", "a number"});
    choices.fluid = {"Type=9"};
    expect_mentions(error(dualsphysics, choices), {"fluid particles", "none"});
    choices.fluid = {"Type=3"};
    choices.walls = {"id=3"};
    expect_mentions(error(dualsphysics, choices), {"particle 3", "another option"});
}

TEST(KnownNames, VelocitiesComeUnderManyNames) {
    const auto read_as = [](std::vector<PointArray> arrays) {
        Snapshot snapshot;
        snapshot.positions.resize(2);
        snapshot.point_data = std::move(arrays);
        use_our_names(snapshot);
        const PointArray* velocity = find_array(snapshot, "velocity");
        return velocity == nullptr ? std::vector<double>() : as_doubles(*velocity);
    };
    const std::vector<double> both = {1, 2, 3, 4, 5, 6};
    for (const char* name : {"velocity", "Velocity", "Velocities", "Vel", "v", "V"})
        EXPECT_EQ(read_as({{name, 3, both}}), both) << name;
    using Reals = std::vector<double>;
    for (const std::string axes : {"vx vy vz", "u v w", "Vel_x Vel_y Vel_z", "vel:0 vel:1 vel:2"}) {
        const std::size_t first = axes.find(' ');
        const std::size_t second = axes.find(' ', first + 1);
        EXPECT_EQ(read_as({{axes.substr(0, first), 1, Reals{1, 4}},
                           {axes.substr(first + 1, second - first - 1), 1, Reals{2, 5}},
                           {axes.substr(second + 1), 1, Reals{3, 6}}}),
                  both)
            << axes;
    }
    EXPECT_EQ(read_as({{"vel", 2, Reals{1, 2, 3, 4}}}), (Reals{1, 2, 0, 3, 4, 0}));
    EXPECT_TRUE(read_as({{"v", 1, Reals{1, 2}}}).empty());
}

TEST(KnownNames, OthersAreRenamedOnceAndOnlyWhereTheyFit) {
    Snapshot snapshot;
    snapshot.positions.resize(1);
    for (const char* name : {"Rhop", "rho", "idp", "m", "p"})
        snapshot.point_data.push_back({name, 1, std::vector<double>{2}});
    use_our_names(snapshot);
    std::vector<std::string> names;
    for (const PointArray& array : snapshot.point_data)
        names.push_back(array.name);
    EXPECT_EQ(names, (std::vector<std::string>{"Rhop", "density", "id", "mass", "p"}));
    snapshot.point_data = {{"m", 1, std::vector<double>{-2}}};
    use_our_names(snapshot);
    EXPECT_EQ(snapshot.point_data[0].name, "m");
}

TEST(PeriodicCopies, LieBeyondSidesAndCorners) {
    Snapshot snapshot;
    snapshot.dimension = 2;
    snapshot.positions = {{0.1, 0.1, 0}, {0.5, 0.5, 0}};
    snapshot.boundary = {{0.5, 0.5, 0}};
    for (int run = 0; run < 2; ++run) { // a second run has no copies of copies
        add_periodic_copies(snapshot, periodic_box("1,1"), 0.2);
        EXPECT_EQ(snapshot.boundary,
                  (Positions{{0.5, 0.5, 0}, {1.1, 0.1, 0}, {0.1, 1.1, 0}, {1.1, 1.1, 0}}));
    }
    remove_periodic_copies(snapshot);
    EXPECT_EQ(snapshot.boundary.size(), 1U);
    snapshot.provenance["plane"] = "xz";
    add_periodic_copies(snapshot, periodic_box("z=-1:0.6"), 0.2);
    EXPECT_EQ(snapshot.boundary.size(), 3U); // 0.5 is near the side, wall and particle
}

TEST(PeriodicCopies, WrongBoxesAreNamed) {
    for (const char* text : {"", "1,2,3,4", "x=1", "w=0:1", "x=1:0", "a", "0", "x=0:nan", "x="})
        expect_mentions(error_of<InputError>([&] { periodic_box(text); }), {"--periodic", text});
    Snapshot snapshot;
    snapshot.positions = {{5, 0, 0}};
    expect_mentions(
        error_of<InputError>([&] { add_periodic_copies(snapshot, periodic_box("1"), 0.1); }),
        {"particle 0", "outside"});
    expect_mentions(
        error_of<InputError>([&] { add_periodic_copies(snapshot, periodic_box("9"), 10); }),
        {"support radius"});
}

TEST(NearestSpacing, TellsTheRadiusInSpacings) {
    Snapshot snapshot;
    for (int i = 0; i < 1000; ++i)
        snapshot.positions.push_back({0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100)});
    const std::vector<std::uint8_t> valid(1000, 1);
    EXPECT_NEAR(*nearest_spacing_ratio(snapshot, 0.2, valid), 2, 1e-9);
    EXPECT_EQ(doubtful_support_radius(snapshot, 0.2, valid), "");
    expect_mentions(doubtful_support_radius(snapshot, 0.05, valid), {"0.5", "1.6 to 5"});
    expect_mentions(doubtful_support_radius(snapshot, 1, valid), {"10", "particle radii"});
    snapshot.positions.assign(1000, {1, 1, 1});
    expect_mentions(doubtful_support_radius(snapshot, 1, valid), {"same place"});
}

TEST(CutNumbers, DigitsOfTheOthersTell) {
    using Texts = std::vector<std::string_view>;
    EXPECT_FALSE(may_be_cut("0.125", Texts{"0.250", "0.500"}));
    EXPECT_TRUE(may_be_cut("0.12", Texts{"0.250", "0.500"}));
    EXPECT_FALSE(may_be_cut("1.23457", Texts{"0.25", "0.123457", "2"}));
    EXPECT_TRUE(may_be_cut("1.2345", Texts{"0.25", "0.123457", "2"}));
    EXPECT_TRUE(may_be_cut("1.25", Texts{"0.25", "0.5", "2"}));
    EXPECT_TRUE(may_be_cut("12.3456", Texts{"1.23456", "2.34567"}));
    EXPECT_TRUE(may_be_cut("1.25", Texts{"1.25e-05", "0.51"}));
    EXPECT_FALSE(may_be_cut("1.25e-05", Texts{"1.25e-05", "2.51e+00"}));
    EXPECT_FALSE(may_be_cut("3", Texts{"3", "3"}));
    EXPECT_FALSE(may_be_cut("12", Texts{"10", "11"}));
    EXPECT_TRUE(may_be_cut("1", Texts{"10", "11"}));
    EXPECT_TRUE(may_be_cut("12", Texts{}));
}

} // namespace
} // namespace meniscus
