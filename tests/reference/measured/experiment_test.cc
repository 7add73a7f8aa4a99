// Anyone's table with a few lines of TOML: units, axes, and what is refused.
#include "reference/measured/experiment.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace cylon::measured {
namespace {

namespace fs = std::filesystem;

const std::string model =
    "duration = 1.0\nstep = 0.002\n[[body]]\nname = \"cube\"\nmass = 1\nposition = [0, 1, 0]\n"
    "shape = { type = \"box\", half_extents = [0.05, 0.05, 0.05] }\n";

const std::string columns =
    "[columns]\nrun = \"n\"\nframe = \"k\"\nposition = [\"x\", \"y\", \"z\"]\n"
    "orientation = [\"a\", \"b\", \"c\", \"d\"]\nvelocity = [\"u\", \"v\", \"w\"]\nangular_velocity = "
    "[\"p\", \"q\", \"r\"]\n";
const std::string about =
    "title = \"t\"\nsource = \"s\"\nlicence = \"l\"\ndata = \"t.csv\"\nmodel = \"cube.toml\"\nbody = "
    "\"cube\"\nrate = 100\n";
const std::string head = "n,k,x,y,z,a,b,c,d,u,v,w,p,q,r\n";

class Experiments : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              (std::string("cylon-measured-") +
               testing::UnitTest::GetInstance()->current_test_info()->name() + std::to_string(::getpid()));
    fs::create_directories(folder_);
    put("cube.toml", model);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  Experiment read_it(const std::string& description, const std::string& table) const {
    put("e.toml", description), put("t.csv", table);
    return read(folder_ / "e.toml");
  }
  std::string why(const std::string& description, const std::string& table) const {
    try {
      read_it(description, table);
    } catch (const core::InputError& error) {
      return error.what();
    }
    return "taken";
  }

  fs::path folder_;
};

const std::string two_runs = head +
                             "7,3,100,200,300,0.6,0.8,0,0,10,20,30,90,180,-90\n"
                             "7,4,101,201,301,0.6,0.8,0,0,10,20,30,90,180,-90\n"
                             "2,0,1,2,3,1,0,0,0,0,0,0,0,0,0\r\n"
                             "2,1,1,2,3,1,0,0,0,0,0,0,0,0,0\n";

TEST_F(Experiments, KeepRunsInTheOrderOfTheTable) {
  const Experiment e = read_it(about + columns, two_runs);
  ASSERT_EQ(e.runs.size(), 2u);
  EXPECT_EQ(e.runs[0].name, "7");
  EXPECT_EQ(e.runs[1].name, "2");
  EXPECT_EQ(e.longest(), 2u);
  EXPECT_EQ(e.runs[0].states[1][0].position, core::Vector3(101, 201, 301));
  EXPECT_EQ(e.runs[0].states[0][0].angular_velocity, core::Vector3(90, 180, -90));
}

// A million columns took hours: each name was looked for among all others.
TEST_F(Experiments, RefuseTablesOfManyColumns) {
  const auto wide = [](std::size_t count) {
    std::string table;
    for (std::size_t i = 1; i < count; ++i) table += "c" + std::to_string(i) + ",";
    return table + "c\n1\n";
  };
  EXPECT_NE(why(about + columns, wide(1'000'000)).find("t.csv:1: 1000000 columns, at most 4096"),
            std::string::npos);
  EXPECT_NE(why(about + columns, wide(4096)).find("t.csv:2: 1 values, and 4096 columns"), std::string::npos);
  EXPECT_NE(why(about + columns, head + std::string(5'000'000, ',')).find("t.csv:2: 5000001 columns"),
            std::string::npos);
  EXPECT_NE(why(about + columns, "a,b,a\n1,2,3\n").find("column 3 has no name of its own: 'a'"),
            std::string::npos);
}

// By hand: millimetres, degrees, z up, spin in body axes.  The quaternion (0.6, 0.8, 0, 0) turns by an angle with cosine
// -0.28 and sine 0.96 about x: body y goes to (0, -0.28, 0.96), z to (0, -0.96, -0.28).
TEST_F(Experiments, ConvertUnitsAndAxes) {
  const Experiment e =
      read_it(about + columns +
                  "[units]\nlength = \"mm\"\nangle = \"deg\"\nup = \"z\"\nangular_velocity = \"body\"\n"
                  "[uncertainty]\nnoise = 0.001\nfriction = 0.03\n",
              two_runs);
  const core::BodyState& s = e.runs[0].states[0][0];
  const auto near = [](const core::Vector3& a, const core::Vector3& b) { return (a - b).norm() < 1e-14; };
  EXPECT_TRUE(near(s.position, {0.1, 0.3, -0.2}));
  EXPECT_TRUE(near(s.velocity, {0.01, 0.03, -0.02}));
  const double r =
      std::numbers::pi / 2;  // in the world of the data: (1, -0.56 + 0.96, 1.92 + 0.28) right angles
  EXPECT_TRUE(near(s.angular_velocity, r * core::Vector3(1, 2.2, -0.4)));
  EXPECT_TRUE(near(s.orientation * core::Vector3::UnitY(), {0, 0.96, 0.28}));
  EXPECT_EQ(e.noise, 0.001);
  EXPECT_EQ(e.material.friction, 0.03);
  EXPECT_TRUE(e.start.isZero(0));
}

TEST_F(Experiments, ReadWhatIsFittedAndCorrelatedErrors) {
  const Experiment e =
      read_it(about + columns +
                  "[uncertainty]\nposition = 0.2\nvelocity = 0.5\nangle_noise = 0.01\n"
                  "[[uncertainty.correlation]]\nbetween = [\"velocity y\", \"position x\"]\nvalue = 0.6\n"
                  "[fit]\nhorizon = 0.05\ndegrees = 4\n"
                  "[[parameter]]\nname = \"mu\"\nkind = \"friction\"\nlow = 0.1\nstart = 0.2\nhigh = 0.3\n"
                  "[[parameter]]\nname = \"J\"\nkind = \"inertia\"\nbody = \"cube\"\nlow = 0.5\nstart = "
                  "1\nhigh = 2\n",
              two_runs);
  const Eigen::MatrixXd covariance = e.start * e.start.transpose();
  EXPECT_NEAR(covariance(0, 0), 0.04, 1e-16);
  EXPECT_NEAR(covariance(7, 7), 0.25, 1e-16);
  EXPECT_NEAR(covariance(0, 7), 0.6 * 0.2 * 0.5, 1e-16);
  EXPECT_EQ(covariance(0, 6), 0);
  EXPECT_EQ(covariance(3, 3), 0);
  EXPECT_EQ(e.fit.horizon, 0.05);
  EXPECT_EQ(e.fit.degrees, 4);
  ASSERT_EQ(e.parameters.size(), 2u);
  EXPECT_EQ(e.parameters[0].name, "mu");
  EXPECT_EQ(e.parameters[1].body, "cube");
  EXPECT_NE(e.hash, read_it(about + columns, two_runs).hash);
}

// Two arms that hang down in the scene, seen at every second frame, in degrees from the horizontal.
TEST_F(Experiments, ReadAChain) {
  put("arms.toml",
      "duration = 1.0\nstep = 0.01\n[[body]]\nname = \"a\"\nmass = 1\nposition = [0, -1, 0]\n"
      "[[body]]\nname = \"b\"\nmass = 1\nposition = [0, -3, 0]\n"
      "[[joint]]\ntype = \"hinge\"\nbody = \"a\"\npoint = [0, 0, 0]\naxis = [0, 0, 1]\n"
      "[[joint]]\ntype = \"hinge\"\nbody = \"b\"\nto = \"a\"\npoint = [0, -2, 0]\naxis = [0, 0, 1]\n");
  const Experiment e = read_it(
      "title = \"t\"\nsource = \"s\"\nlicence = \"l\"\ndata = \"t.csv\"\nmodel = \"arms.toml\"\nbodies = "
      "[\"a\", "
      "\"b\"]\nrate = 100\nevery = 2\n[columns]\nrun = \"n\"\nangles = [\"p\", \"q\"]\nrates = [\"u\", "
      "\"v\"]\n"
      "[units]\nangle = \"deg\"\nzero = -90\n[uncertainty]\nangle = 0.1\nrate = 0.3\n",
      "n,p,q,u,v\n1,-90,0,0,90\n1,7,7,7,7\n1,0,-90,90,0\n2,-90,-90,0,0\n2,7,7,7,7\n2,-90,-90,0,0\n");
  EXPECT_EQ(e.coordinates, Coordinates::chain);
  EXPECT_EQ(e.rate, 50);
  ASSERT_EQ(e.runs[0].states.size(), 2u);
  const auto near = [](const core::Vector3& a, const core::Vector3& b) { return (a - b).norm() < 1e-14; };
  EXPECT_TRUE(near(e.runs[0].states[0][1].position, {1, -2, 0}));
  EXPECT_TRUE(near(e.runs[0].states[0][1].velocity, {0, std::numbers::pi / 2, 0}));
  EXPECT_TRUE(near(e.runs[0].states[1][1].position, {2, -1, 0}));
  EXPECT_TRUE(near(e.runs[0].states[1][0].velocity, {0, std::numbers::pi / 2, 0}));
  EXPECT_EQ(e.start.rows(), 4);
  EXPECT_EQ(e.start(1, 1), 0.1);
  EXPECT_EQ(e.start(2, 2), 0.3);
}

TEST_F(Experiments, ReadGzip) {
  put("e.toml", about + columns);
  gzFile file = gzopen((folder_ / "t.csv").c_str(), "wb");
  gzwrite(file, two_runs.data(), static_cast<unsigned>(two_runs.size()));
  gzclose(file);
  EXPECT_EQ(read(folder_ / "e.toml").runs.size(), 2u);
  fs::resize_file(folder_ / "t.csv", fs::file_size(folder_ / "t.csv") - 9);
  try {
    read(folder_ / "e.toml");
    FAIL() << "half a file is taken";
  } catch (const core::InputError& error) {
    EXPECT_NE(std::string(error.what()).find("is no whole gzip file"), std::string::npos) << error.what();
  }
}

struct Form {
  const char* name;
  std::string table;
  std::vector<std::string> runs = {"7", "2"};
};

class TableForms : public Experiments, public testing::WithParamInterface<Form> {};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

// As other programs write tables; what nobody reads may be anything.
TEST_P(TableForms, AreRead) {
  const Experiment e = read_it(about + columns, GetParam().table), plain = read_it(about + columns, two_runs);
  ASSERT_EQ(e.runs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(e.runs[i].name, GetParam().runs[i]);
    EXPECT_EQ(e.runs[i].hash, plain.runs[i].hash);
    EXPECT_EQ(e.runs[i].states[1][0].position, plain.runs[i].states[1][0].position);
  }
}

const std::string no_return = replaced(two_runs, "\r", "");
const std::string quoted = [] {
  std::string text = "\"" + replaced(replaced(no_return, ",", "\",\""), "\n", "\"\n\"");
  text.pop_back();
  return text;
}();

INSTANTIATE_TEST_SUITE_P(
    Tables, TableForms,
    testing::Values(
        Form{"Mark", "\xef\xbb\xbf" + two_runs}, Form{"Returns", replaced(no_return, "\n", "\r\n")},
        Form{"EmptyEnd", two_runs + "\n  \n"}, Form{"Comments", "# mine\n#\n" + two_runs},
        Form{"Semicolons", replaced(two_runs, ",", ";")}, Form{"Tabs", replaced(two_runs, ",", "\t")},
        Form{"Quotes", quoted},
        Form{"Words",
             replaced(replaced(no_return, "\n7", "\ntoss a"), "\n2,", "\n\"2 b\","),
             {"toss a", "2 b"}},
        Form{"Notes",
             replaced(replaced(no_return, "\n", ",\"good, or not\"\n"), "r,\"good, or not\"", "r,note")},
        Form{"NumbersNobodyReads", replaced(replaced(no_return, "\n", ",nan\n"), "r,nan", "r,spare")}),
    [](const auto& form) { return std::string(form.param.name); });

// A run is known again by its numbers, not by what stands beside it.
TEST_F(Experiments, KnowARunAgain) {
  const Experiment e = read_it(about + columns, two_runs),
                   other =
                       read_it(replaced(about, "\"t\"", "\"another title\"") + columns +
                                   "[uncertainty]\nnoise = 0.1\n",
                               two_runs + "9,0,1,2,3,1,0,0,0,0,0,0,0,0,0\n9,1,1,2,3,1,0,0,0,0,0,0,0,0,0\n"),
                   changed = read_it(about + columns, replaced(two_runs, "301", "301.001"));
  EXPECT_NE(e.hash, other.hash);
  EXPECT_EQ(e.runs[0].hash, other.runs[0].hash);
  EXPECT_EQ(e.runs[1].hash, other.runs[1].hash);
  EXPECT_NE(e.runs[0].hash, changed.runs[0].hash);
  EXPECT_EQ(e.runs[1].hash, changed.runs[1].hash);
}

// A turn of 0.02 rad about an axis in the components of left-handed axes, which obey the same formulas as those of right-handed ones:
// the spin still turns the body from frame to frame, the place is mirrored, and a point of the body goes with it.
TEST_F(Experiments, MirrorLeftHandedAxes) {
  const core::Vector3 spin(1.2, -0.7, 1.45);
  const Eigen::AngleAxisd by(spin.norm() * 0.01, spin.normalized());
  const core::Quaternion q0(0.6, 0, 0.8, 0), q1 = core::Quaternion(by) * q0;
  const auto row = [&](int k, const core::Quaternion& q) {
    return fmt::format("7,{},1,2,3,{},{},{},{},4,5,6,{},{},{}\n", k, q.w(), q.x(), q.y(), q.z(), spin.x(),
                       spin.y(), spin.z());
  };
  const Experiment e =
      read_it(about + columns + "[units]\nhand = \"left\"\n", head + row(0, q0) + row(1, q1));
  const core::BodyState &a = e.runs[0].states[0][0], &b = e.runs[0].states[1][0];
  EXPECT_EQ(a.position, core::Vector3(-1, 2, 3));
  EXPECT_EQ(a.velocity, core::Vector3(-4, 5, 6));
  const Eigen::AngleAxisd turn(b.orientation * a.orientation.conjugate());
  EXPECT_LT((turn.angle() * turn.axis() - 0.01 * a.angular_velocity).norm(), 1e-12);
  // A point (1, 2, 3) of the body lies at (-1, 2, 3) in the mirrored one.
  const core::Vector3 seen = q1 * core::Vector3(1, 2, 3);
  EXPECT_LT((b.orientation * core::Vector3(-1, 2, 3) - core::Vector3(-seen.x(), seen.y(), seen.z())).norm(),
            1e-12);
}

TEST_F(Experiments, RefuseWhatCannotBe) {
  const std::string row = "7,3,1,2,3,0.6,0.8,0,0,1,2,3,4,5,6\n", next = "7,4,1,2,3,0.6,0.8,0,0,1,2,3,4,5,6\n";
  const auto with = [&](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  const auto uncertain = [](const std::string& one, const std::string& other, const std::string& value) {
    return "[uncertainty]\nposition = 0.1\n[[uncertainty.correlation]]\nbetween = [\"" + one + "\", \"" +
           other + "\"]\nvalue = " + value + "\n";
  };
  const auto parameter = [](const std::string& kind, const std::string& low, const std::string& start,
                            const std::string& high) {
    return "[[parameter]]\nname = \"p\"\nkind = \"" + kind + "\"\nlow = " + low + "\nstart = " + start +
           "\nhigh = " + high + "\n";
  };
  const struct {
    const char* what;
    std::string description, table, says;
  } cases[] = {
      {"an unknown key", about + columns + "[units]\nlenght = \"mm\"\n", head + row + next, "lenght"},
      {"an unknown unit", about + columns + "[units]\nlength = \"inch\"\n", head + row + next, "length"},
      {"a column that is not there", about + with(columns, "\"y\"", "\"py\""), head + row + next,
       "no column 'py'"},
      {"two columns of a position", about + with(columns, "\"y\", ", ""), head + row + next,
       "position needs 3 columns"},
      {"no such body", with(about, "\"cube\"", "\"cub\"") + columns, head + row + next, "no body 'cub'"},
      {"no such table", with(about, "t.csv", "u.csv") + columns, head + row + next, "u.csv: is no file"},
      {"a rate between steps", with(about, "rate = 100", "rate = 148") + columns, head + row + next,
       "no whole number of the scene's steps"},
      {"a word for a number", about + columns, head + with(row, "0.8", "x") + next, "t.csv:2: b = 'x'"},
      {"not a number", about + columns, head + row + with(next, "0.8", "nan"), "t.csv:3: b = 'nan'"},
      {"a number too much", about + columns, head + row + "1," + next, "t.csv:3: 16 values, and 15 columns"},
      {"no unit quaternion", about + columns, head + row + with(next, "0.8", "0.9"),
       "t.csv:3: the quaternion has the length"},
      {"a frame that is missing", about + columns, head + row + with(next, "7,4", "7,5"),
       "t.csv:3: frame 5 of run 7"},
      {"one frame", about + columns, head + row, "run 7 has fewer than two frames"},
      {"a run in two pieces", about + columns,
       head + row + next + with(row, "7,3", "8,0") + with(row, "7,3", "7,5"), "t.csv:5: run 7 goes on"},
      {"a column twice", about + columns, with(head, "x,y", "x,x") + row + next, "t.csv:1: column 4"},
      {"one column for two", about + with(columns, "\"y\"", "\"x\""), head + row + next,
       "position has 'x' twice"},
      {"an empty line between rows", about + columns, head + row + "\n" + next, "t.csv:3: an empty line"},
      {"a time of another rate", about + with(columns, "frame = \"k\"", "time = \"k\""), head + row + next,
       "t.csv:3: run 7 is at 4 s, where 100 frames a second make it 3.01 s"},
      {"axes of no hand", about + columns + "[units]\nhand = \"lift\"\n", head + row + next, "hand"},
      {"a nameless run", about + columns, head + with(row, "7,", ",") + next, "t.csv:2: the name of a run"},
      {"no rows", about + columns, head, "no rows"},
      {"columns of a chain", about + columns + "angles = [\"x\"]\n", head + row + next,
       "angles is of a chain"},
      {"bodies of no hinge", with(about, "body = \"cube\"", "bodies = [\"cube\"]") + columns,
       head + row + next, "'cube' is the body of no hinge"},
      {"neither body nor bodies", with(about, "body = \"cube\"\n", "") + columns, head + row + next,
       "either body or bodies"},
      {"a coordinate that is none", about + columns + uncertain("position x", "velocity q", "0.5"),
       head + row + next, "no coordinate 'velocity q', did you mean 'velocity x'"},
      {"a coordinate with itself", about + columns + uncertain("position x", "position x", "0.5"),
       head + row + next, "a coordinate with itself"},
      {"a correlation above 1", about + columns + uncertain("position x", "velocity x", "1.5"),
       head + row + next, "not positive definite"},
      {"a kind that is none", about + columns + parameter("frictoin", "0", "0.1", "1"), head + row + next,
       "frictoin"},
      {"an empty range", about + columns + parameter("friction", "0.2", "0.2", "0.2"), head + row + next,
       "0.2 is not above low = 0.2"},
      {"a start outside", about + columns + parameter("friction", "0.2", "0.1", "0.3"), head + row + next,
       "0.1 is outside [0.2, 0.3]"},
      {"a restitution above 1", about + columns + parameter("restitution", "0", "0.1", "1.2"),
       head + row + next, "1.2 is above 1, the most of restitution"},
      {"no inertia", about + columns + parameter("inertia", "0", "0.1", "1.2"), head + row + next,
       "the least of inertia"},
      {"one name twice",
       about + columns + parameter("friction", "0", "0.1", "1") + parameter("friction", "0", "0.1", "1"),
       head + row + next, "two parameters are named 'p'"},
      {"a loss of a hinge that is not there", about + columns + parameter("hinge_damping", "0", "0.1", "1"),
       head + row + next, "hinge_damping: 'cube' has no hinge"},
      {"an arm that ends nowhere", about + columns + parameter("arm", "0.5", "1", "2"), head + row + next,
       "arm: no other hinge follows that of 'cube'"},
      {"too short a window", about + columns + "[fit]\nhorizon = 0.019\n", head + row + next,
       "three frames or more"},
  };
  for (const auto& [what, description, table, says] : cases) {
    const std::string said = why(description, table);
    EXPECT_NE(said.find(says), std::string::npos) << what << ": " << said;
  }
}

}  // namespace
}  // namespace cylon::measured
