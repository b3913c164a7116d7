#include "test_folder.hpp"

#include <meniscus/data/formats/snapshot_files.hpp>
#include <meniscus/data/formats/snapshot_formats.hpp>
#include <meniscus/data/text/errors.hpp>

#include <clocale>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

class Csv : public TestFolder {
protected:
    Snapshot read(std::string_view bytes) const { return read_snapshot(write("state.csv", bytes)); }

    std::string message(std::string_view bytes) const {
        const fs::path file = write("state.csv", bytes);
        std::string text = error_of<InputError>([&] { csv_format().read(file); });
        expect_mentions(text, {"state.csv: line "});
        return text;
    }
};

std::vector<std::string> names(const Snapshot& snapshot) {
    std::vector<std::string> all;
    for (const PointArray& array : snapshot.point_data)
        all.push_back(array.name);
    return all;
}

ArrayValues integers(std::vector<std::int64_t> values) {
    return values;
}

ArrayValues reals(std::vector<double> values) {
    return values;
}

const ArrayValues& values(const Snapshot& snapshot, std::string_view name) {
    return find_array(snapshot, name)->values;
}

TEST_F(Csv, ReadsPlainColumns) {
    const Snapshot snapshot = read("x,y,z,id,mass,pressure\n"
                                   "0.5,1,-2e-3,7,1,12\n"
                                   "+3,.5,nan,9007199254740993,2,-1.5\n");
    EXPECT_EQ(snapshot.size(), 2U);
    EXPECT_EQ(snapshot.positions[0], (std::array<double, 3>{0.5, 1, -2e-3}));
    EXPECT_EQ(snapshot.positions[1][1], 0.5);
    EXPECT_TRUE(std::isnan(snapshot.positions[1][2]));
    EXPECT_EQ(snapshot.position_precision, Precision::float64);
    EXPECT_EQ(snapshot.dimension, 3);
    EXPECT_FALSE(snapshot.time);
    EXPECT_EQ(names(snapshot), (std::vector<std::string>{"id", "mass", "pressure"}));
    EXPECT_EQ(values(snapshot, "id"), integers({7, 9007199254740993}));
    EXPECT_EQ(values(snapshot, "mass"), reals({1, 2}));
    EXPECT_EQ(values(snapshot, "pressure"), reals({12, -1.5}));
}

TEST_F(Csv, ReadsWhatParaviewExports) {
    const std::string rows = "\"left, \"\"wall\"\"\",0,0.25,1,2,3,2.24,0.5,0.75,1\r\n"
                             "\"right\",1,0.5,4,5,6,8.8,1.5,1.75,2\r\n";
    const Snapshot with_colons =
        read("\"Block Name\",\"Point ID\",\"density\",\"velocity:0\",\"velocity:1\","
             "\"velocity:2\",\"velocity:Magnitude\",\"Points:0\",\"Points:1\",\"Points:2\"\r\n" +
             rows);
    const Snapshot with_underscores =
        read("Block Name,Point ID,density,velocity_0,velocity_1,velocity_2,velocity_Magnitude,"
             "Points_0,Points_1,Points_2\r\n" +
             rows);
    for (const Snapshot& snapshot : {with_colons, with_underscores}) {
        EXPECT_EQ(snapshot.positions, (Positions{{0.5, 0.75, 1}, {1.5, 1.75, 2}}));
        EXPECT_EQ(values(snapshot, "Point ID"), integers({0, 1}));
        EXPECT_EQ(values(snapshot, "density"), reals({0.25, 0.5}));
        EXPECT_EQ(values(snapshot, "velocity"), reals({1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(find_array(snapshot, "velocity")->components, 3);
    }
    EXPECT_EQ(names(with_colons),
              (std::vector<std::string>{"velocity", "Point ID", "density", "velocity:Magnitude"}));
}

TEST_F(Csv, ReadsWhatPartVtkSaves) {
    const std::string lines =
        "TimeStep [s];Np;Nbound;Nfixed;Nmoving;Nfloat;Nfluid\n0.25;5;3;3;0;0;2\n\n"
        "Pos.x [m];Pos.y [m];Pos.z [m];Idp;Vel.x [m/s];Vel.y [m/s];Vel.z [m/s];"
        "Rhop [kg/m^3];Mass [kg];Press [Pa];Type;Mk;\n"
        "1.0E+00;2.0E+00;3.0E+00;7;1;2;3;1.0E+03;8.0E-06;0.0E+00;3;1;\n"
        "1.5E+00;2.0E+00;3.5E+00;9;4;5;6;9.9E+02;8.0E-06;5.0E+01;3;1\n";
    std::string with_commas = lines;
    std::replace(with_commas.begin(), with_commas.end(), ';', ',');
    for (const std::string& bytes : {lines, with_commas}) {
        const Snapshot snapshot = read(bytes);
        EXPECT_EQ(snapshot.time, 0.25);
        EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 3}, {1.5, 2, 3.5}}));
        EXPECT_EQ(names(snapshot), (std::vector<std::string>{"velocity", "id", "density", "mass",
                                                             "Press [Pa]", "Type", "Mk"}));
        EXPECT_EQ(values(snapshot, "id"), integers({7, 9}));
        EXPECT_EQ(values(snapshot, "velocity"), reals({1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(values(snapshot, "density"), reals({1000, 990}));
        EXPECT_EQ(values(snapshot, "Mk"), integers({1, 1}));
    }
}

TEST_F(Csv, ReadsWhatPythonWrites) {
    // pandas: the index has no name; NumPy: the header is a comment; Excel: a byte order mark.
    const Snapshot pandas = read(",X,Y,Z,rho\n0,1,2,3,1e3\n1,4,5,6,1e3\n");
    const Snapshot numpy = read("# written by hand\n# X\tY\tZ\trho\n1\t2\t3\t1e3\n4\t5\t6\t1e3\n");
    const Snapshot excel = read("\xef\xbb\xbfX; Y ;Z;rho\r\n1; 2;3 ;1e3\r\n4;5;6;\"1e3\"\r\n \r\n");
    for (const Snapshot& snapshot : {pandas, numpy, excel}) {
        EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 3}, {4, 5, 6}}));
        EXPECT_EQ(names(snapshot), (std::vector<std::string>{"density"}));
    }
}

TEST_F(Csv, TwoDimensionsComeFromTheColumns) {
    const Snapshot flat = read("x,y,vx,vy\n1,2,5,6\n");
    EXPECT_EQ(flat.dimension, 2);
    EXPECT_EQ(flat.positions, (Positions{{1, 2, 0}}));
    EXPECT_EQ(values(flat, "velocity"), reals({5, 6, 0}));

    const Snapshot upright = read("Pos.x,Pos.z,Vel.x,Vel.y,Vel.z\n1,2,5,0.5,6\n");
    EXPECT_EQ(upright.dimension, 2);
    EXPECT_EQ(upright.positions, (Positions{{1, 2, 0}}));
    EXPECT_EQ(values(upright, "velocity"), reals({5, 6, 0.5}));

    EXPECT_EQ(read("x,y,z\n1,2,3\n2,5,3\n").dimension, 2);
    EXPECT_EQ(read("x,y,z\n1,2,3\n2,5,4\n").dimension, 3);
}

TEST_F(Csv, PositionsAreFoundUnderTheirNames) {
    const std::pair<const char*, std::array<double, 3>> headers[] = {
        {"x,y,z", {1, 2, 3}},
        {"Z,X,Y", {2, 3, 1}},
        {"pos_x,pos_y,pos_z", {1, 2, 3}},
        {"posz,posy,posx", {3, 2, 1}},
        {"Position:0,Position:1,mass", {1, 2, 0}},
        {"mass,Positions.X,Positions.Y", {2, 3, 0}},
        {"Points 0,Points 1,Points 2", {1, 2, 3}},
        {"coords_0,mass,coords_1", {1, 3, 0}},
        {"coordinates_y,id,coordinates_x", {3, 1, 0}},
        {"x (m),y (m),rho (kg/m3)", {1, 2, 0}},
        {"Z [m],X [m],Vel.x [m/s]", {2, 1, 0}},
    };
    for (const auto& [header, position] : headers)
        EXPECT_EQ(read(header + std::string("\n1,2,3\n")).positions, Positions{position}) << header;
}

TEST_F(Csv, PointsWinOverOtherColumnsOfPositions) {
    const Snapshot snapshot = read("x,y,z,Points:0,Points:1,Points:2\n1,2,3,4,5,6\n");
    EXPECT_EQ(snapshot.positions, (Positions{{4, 5, 6}}));
    EXPECT_EQ(values(snapshot, "x"), integers({1}));
}

TEST_F(Csv, AVelocityWithoutAllItsAxesStaysApart) {
    const Snapshot snapshot = read("x,y,z,vx,vy\n1,2,3,4,5\n");
    EXPECT_EQ(names(snapshot), (std::vector<std::string>{"vx", "vy"}));
}

TEST_F(Csv, IntegersStaySoUntilOneIsNot) {
    const Snapshot snapshot = read("x,y,a,b,c,d,density\n"
                                   "1,2,-5,5,5,9223372036854775807,1\n"
                                   "1,2,6,5.0,5e0,9223372036854775808,1\n");
    EXPECT_EQ(values(snapshot, "a"), integers({-5, 6}));
    EXPECT_EQ(values(snapshot, "b"), reals({5, 5}));
    EXPECT_EQ(values(snapshot, "c"), reals({5, 5}));
    EXPECT_EQ(values(snapshot, "d"), reals({0x1p63, 0x1p63}));
    EXPECT_EQ(values(snapshot, "density"), reals({1, 1}));
}

TEST_F(Csv, NumbersDoNotDependOnTheLocale) {
    const std::string old = std::setlocale(LC_ALL, nullptr);
    std::setlocale(LC_ALL, "de_DE.UTF-8"); // where it is installed
    const Snapshot snapshot = read("x,y\n0.5,1e-400\n-INF,-Nan\n");
    std::setlocale(LC_ALL, old.c_str());
    EXPECT_EQ(snapshot.positions[0], (std::array<double, 3>{0.5, 0, 0}));
    EXPECT_EQ(snapshot.positions[1][0], -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isnan(snapshot.positions[1][1]));
}

TEST_F(Csv, ReadsNoParticles) {
    EXPECT_EQ(read("x,y,z\n").size(), 0U);
    EXPECT_EQ(read("x,y,z,id,vx,vy,vz\r\n\r\n").point_data.size(), 2U);
}

TEST_F(Csv, WrongCellsAreNamed) {
    const std::string good = "x,y,density,name\n1,2,3,a\n";
    expect_mentions(message(good + "1,2\n"), {"line 3, column 'density'", "end of the line"});
    expect_mentions(message(good + "1,2,,a\n"), {"line 3, column 'density'", "empty cell"});
    expect_mentions(message(good + "1,2,3,a,5\n"), {"line 3", "4 cells", "'name'", "'5'"});
    expect_mentions(message(good + "1,2,3,a,\n"), {"line 3", "4 cells", "'name'"});
    expect_mentions(message(good + "1,2,abc,a\n"), {"line 3, column 'density'", "'abc'"});
    expect_mentions(message(good + "1,2,3 4,a\n"), {"line 3, column 'density'", "'3 4'"});
    expect_mentions(message(good + "1,2,1e999,a\n"), {"line 3, column 'density'", "'1e999'"});
    expect_mentions(message(good + "1,2,0x10,a\n"), {"line 3, column 'density'", "'0x10'"});
    expect_mentions(message(good + "1,2,3,7\n"), {"line 3, column 'name'", "text", "'7'"});
    expect_mentions(message(good + "1,2,\"3,a\n"), {"line 3, column 'density'", "quotes"});
    expect_mentions(message(good + "1,2,\"3\"4,a\n"), {"line 3, column 'density'", "quotes"});
    expect_mentions(message(good + "\n1,2,3,a\n"), {"line 3", "an empty line"});
    expect_mentions(message("x;y\n0,5;1\n"), {"line 2, column 'x'", "-0.5", "'0,5'"});
    expect_mentions(message("x,y,a\n1,2,3\n1,2,b\n"), {"line 3, column 'a'", "'b'"});
    expect_mentions(message("x,y,id\n1,2,first\n"), {"line 2, column 'id'", "'first'"});
    expect_mentions(message("x,y,z\na,2,3\n"), {"line 2, column 'x'", "'a'"});
    expect_mentions(message(std::string("x,y\n1,\0\n", 8)), {"line 2, column 'y'", "'\\x00'"});
}

TEST_F(Csv, OfColumnsThatMeanTheSameTheLikeliestCounts) {
    const Snapshot snapshot = read("x,y,Idp,id,rhop,rho\n1,2,3,4,5,6\n");
    EXPECT_EQ(values(snapshot, "id"), integers({4}));
    EXPECT_EQ(values(snapshot, "Idp"), integers({3}));
    EXPECT_EQ(values(snapshot, "density"), reals({6}));
    EXPECT_EQ(values(snapshot, "rhop"), integers({5}));
}

TEST_F(Csv, SpareColumnsWithEmptyCellsAreLeftOut) {
    for (const char* rows : {"1,2,,7\n4,5,6,8\n", "1,2,3,7\n4,5,,8\n"}) {
        const Snapshot snapshot = read(std::string("x,y,Type,Mk\n") + rows);
        EXPECT_EQ(names(snapshot), (std::vector<std::string>{"Mk"}));
        ASSERT_EQ(snapshot.notes.size(), 1U);
        expect_mentions(snapshot.notes[0], {"empty cells", "'Type'"});
    }
}

TEST_F(Csv, ALastLineWithoutItsBreakIsReadWhereNothingCanBeCut) {
    const std::string decimals = "x,y\n0.25,0.50\n0.50,0.75\n0.75,0.25\n";
    EXPECT_EQ(read(decimals + "1.25,0.25").size(), 4U);
    expect_mentions(message(decimals + "1.25,0.2"), {"line 5", "line break"});
    const std::string numbers = "x,y,id\n0.25,0.5,8\n0.5,0.75,9\n0.75,0.25,10\n";
    EXPECT_EQ(read(numbers + "1.25,0.25,11").size(), 4U);
    expect_mentions(message(numbers + "1.25,0.25,1"), {"line 5", "line break"});
}

TEST_F(Csv, ReadsWhatHoudiniWrites) {
    const Snapshot snapshot = read("P.x,P.y,P.z,v.x,v.y,v.z,id\n1,2,3,4,5,6,7\n");
    EXPECT_EQ(snapshot.positions, (Positions{{1, 2, 3}}));
    EXPECT_EQ(values(snapshot, "velocity"), reals({4, 5, 6}));
}

TEST_F(Csv, WrongHeadersAreNamed) {
    expect_mentions(message("x,y,a,b,a\n1,2,3,4,5\n"), {"line 1, column 'a'", "same name"});
    expect_mentions(message("x,y,x\n1,2,3\n"), {"line 1, column 'x'", "same name"});
    expect_mentions(message("x,y,velocity,vx,vy\n1,2,3,4,5\n"), {"column 'velocity'", "several"});
    expect_mentions(message("\n\ny,z,rho\n1,2,3\n"), {"line 3", "'y', 'z', 'rho'"});
    expect_mentions(message("a,b\n1,2\n"), {"line 2", "'x,y,z'"});
    expect_mentions(message("x [mm],y [mm]\n1,2\n"), {"column 'x [mm]'", "unit m,", "'mm'"});
    expect_mentions(message("x,y,vx [km/h],vy\n1,2,3,4\n"), {"'vx [km/h]'", "m/s"});
    expect_mentions(message("x,y,rho [g/cm^3]\n1,2,3\n"), {"'rho [g/cm^3]'", "kg/m^3"});
    expect_mentions(message("TimeStep\nlate\nx,y\n1,2\n"), {"time", "'late'"});
}

TEST_F(Csv, OtherTextsAreNoCsv) {
    for (const char* text :
         {"x\n1\n", "x y z\n1 2 3\n", "a,b,c\n1,2,3\n", "0,1,2\n0.5,1.5,2.5\n", "x,density\n1,2\n",
          "{\"x\": 1, \"y\": 2}\n", "Points x, y and z\n", "\"x,y\n1,2\n", "\n\n\n"}) {
        EXPECT_FALSE(csv_format().detect(write("text", text))) << text;
        expect_mentions(error_of<InputError>([&] { read(text); }), {"CSV with columns x, y"});
    }
    EXPECT_TRUE(csv_format().detect(write("text", std::string(19, '\n') + "x,y\n")));
    EXPECT_FALSE(csv_format().detect(write("text", std::string(20, '\n') + "x,y\n")));
}

TEST_F(Csv, TruncationIsNoticedWithinEveryLine) {
    const std::string whole = "TimeStep [s];Np\n0.25;2\n\nPos.x [m];Pos.y [m];Pos.z [m];\"Idp\";\n"
                              "1.5;2.5;3.5;17;\n4.5;5.5;6.5;18;\n";
    const std::size_t header_end = whole.find("Idp") + 6;
    std::size_t read_as_whole = 0;
    for (std::size_t length = 1; length <= whole.size(); ++length) {
        const fs::path file = write("state.csv", std::string_view(whole).substr(0, length));
        if (length >= header_end && whole[length - 1] == '\n') {
            EXPECT_EQ(read_snapshot(file).size(), read_as_whole++);
        } else {
            expect_mentions(error_of<InputError>([&] { read_snapshot(file); }), {"state.csv"});
            expect_mentions(error_of<InputError>([&] { csv_format().read(file); }),
                            {"state.csv: line "});
        }
    }
    EXPECT_EQ(read_as_whole, 3U);
}

TEST_F(Csv, HostileHeadersAndLinesEndSoon) {
    const std::string many = std::string(1 << 20, ',');
    expect_mentions(message("x,y" + many + "\n1,2\n"), {"line 1", "'x,y,z'"});
    expect_mentions(message("x,y\n1,2" + many + "\n"), {"line 2", "2 cells"});
    expect_mentions(message("x,y\n1,\"" + std::string(1 << 20, '"') + "\n"), {"line 2", "quotes"});
    expect_mentions(message("x,y\n1,2" + std::string(1 << 20, '0') + "e\n"), {"line 2", "'y'"});
    EXPECT_EQ(read("x,y\n1,2\n" + std::string(1 << 20, '\n')).size(), 1U);
}

} // namespace
} // namespace meniscus
