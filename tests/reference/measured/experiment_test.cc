// Anyone's table with a few lines of TOML: units, axes, and what is refused.
#include "reference/measured/experiment.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

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
  EXPECT_EQ(e.runs[0].states[1].position, core::Vector3(101, 201, 301));
  EXPECT_EQ(e.runs[0].states[0].angular_velocity, core::Vector3(90, 180, -90));
}

// By hand: millimetres, degrees, z up, spin in body axes.  The quaternion (0.6, 0.8, 0, 0) turns by an angle with cosine
// -0.28 and sine 0.96 about x: body y goes to (0, -0.28, 0.96), z to (0, -0.96, -0.28).
TEST_F(Experiments, ConvertUnitsAndAxes) {
  const Experiment e =
      read_it(about + columns +
                  "[units]\nlength = \"mm\"\nangle = \"deg\"\nup = \"z\"\nangular_velocity = \"body\"\n"
                  "[uncertainty]\nnoise = 0.001\nfriction = 0.03\n",
              two_runs);
  const core::BodyState& s = e.runs[0].states[0];
  const auto near = [](const core::Vector3& a, const core::Vector3& b) { return (a - b).norm() < 1e-14; };
  EXPECT_TRUE(near(s.position, {0.1, 0.3, -0.2}));
  EXPECT_TRUE(near(s.velocity, {0.01, 0.03, -0.02}));
  const double r =
      std::numbers::pi / 2;  // in the world of the data: (1, -0.56 + 0.96, 1.92 + 0.28) right angles
  EXPECT_TRUE(near(s.angular_velocity, r * core::Vector3(1, 2.2, -0.4)));
  EXPECT_TRUE(near(s.orientation * core::Vector3::UnitY(), {0, 0.96, 0.28}));
  EXPECT_EQ(e.noise, 0.001);
  EXPECT_EQ(e.material.friction, 0.03);
  EXPECT_EQ(e.start.position, 0);
}

TEST_F(Experiments, ReadGzip) {
  put("e.toml", about + columns);
  const gzFile file = gzopen((folder_ / "t.csv").c_str(), "wb");
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

TEST_F(Experiments, RefuseWhatCannotBe) {
  const std::string row = "7,3,1,2,3,0.6,0.8,0,0,1,2,3,4,5,6\n", next = "7,4,1,2,3,0.6,0.8,0,0,1,2,3,4,5,6\n";
  const auto with = [&](std::string text, const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    return text;
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
      {"a column twice", about + columns, with(head, "x,y", "x,x") + row + next, "t.csv:1: column 3"},
      {"no rows", about + columns, head, "no rows"},
  };
  for (const auto& [what, description, table, says] : cases) {
    const std::string said = why(description, table);
    EXPECT_NE(said.find(says), std::string::npos) << what << ": " << said;
  }
}

}  // namespace
}  // namespace cylon::measured
