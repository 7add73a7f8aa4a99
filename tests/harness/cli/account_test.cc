// `cylon simulate --account`: works of forces against their formulas, the balance, and who refuses.
#include "tests/harness/cli/fixture.h"

#include <cmath>
#include <map>

namespace cylon::cli {
namespace {

const std::string weight =
    "duration = 1\nstep = 0.01\ngravity = [0.3, -9.81, 0.7]\n"
    "[[body]]\nname = \"a\"\nmass = 2\nposition = [1, 0.2, -0.1]\nvelocity = [0, 0, 3]\n"
    "[[spring]]\nbody = \"a\"\npin = [0.1, 0.3, 0]\nstiffness = 50\n";
const std::string drag = "[[drag]]\nbody = \"a\"\nlinear = 0.4\n";

// The entries of a balance, in joules.
std::map<std::string, double> entries(const std::string& csv) {
  std::map<std::string, double> all;
  std::istringstream lines(csv);
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line);)
    all[line.substr(0, line.rfind(','))] = std::stod(line.substr(line.rfind(',') + 1));
  return all;
}

// Position and velocity of the one body in a line of states.
std::vector<double> numbers(const std::string& line) {
  std::vector<double> all;
  std::istringstream fields(line);
  for (std::string field; std::getline(fields, field, ',');)
    all.push_back(field == "a" ? 0 : std::stod(field));
  return all;  // t, body, x, y, z, qw, qx, qy, qz, vx, …
}

TEST_F(CommandLine, AccountWritesTheWorkOfEachForce) {
  write("weight.toml", weight + drag);
  const Ran ran = cylon("simulate weight.toml --at 0,1 --out states.csv --account works.csv");
  ASSERT_EQ(ran.code, 0) << ran.err;
  std::istringstream states(read("states.csv"));
  std::string header, first, last;
  std::getline(states, header), std::getline(states, first), std::getline(states, last);
  const std::vector<double> a = numbers(first), b = numbers(last);
  std::map<std::string, double> works = entries(read("works.csv"));
  ASSERT_EQ(works.size(), 6u) << read("works.csv");
  const double g[] = {0.3, -9.81, 0.7}, pin[] = {0.1, 0.3, 0};
  double fell = 0, tension = 0, kinetic = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t x = 2 + k, v = 9 + k;
    fell += 2 * g[k] * (b[x] - a[x]);
    tension -= 25 * (std::pow(b[x] - pin[k], 2) - std::pow(a[x] - pin[k], 2));
    kinetic += b[v] * b[v] - a[v] * a[v];  // m/2 = 1
  }
  EXPECT_NEAR(works["gravity"], fell, 1e-8);
  EXPECT_NEAR(works["a spring on 'a'"], tension, 1e-8);
  EXPECT_NEAR(works["kinetic energy gained"], kinetic, 1e-12);
  EXPECT_LT(works["drag on 'a'"], -0.5);
  EXPECT_NEAR(works["all forces"], kinetic, 1e-8);
  EXPECT_NEAR(works["gained without a force"], 0, 1e-8);
}

TEST_F(CommandLine, AccountRefusals) {
  write("weight.toml", weight);
  write("rocket.toml",
        weight + "[[thrust]]\nbody = \"a\"\nmass_rate = -0.1\nexhaust_velocity = [0, -3, 0]\n");
  write("frame.toml", weight + "[frame]\nangular_velocity = [0, 1, 0]\n");
  const struct {
    const char* arguments;
    const char* says;
  } rows[] = {{"weight.toml --account -", "stdout has the states"},
              {"rocket.toml --account works.csv", "a mass changes"},
              {"frame.toml --account works.csv", "the frame turns"},
              {"weight.toml --account works.csv --engine ode",
               "--account: engine 'ode' has no option 'account'; it is for the in-house engine alone"},
              {"weight.toml --account nowhere/works.csv", "nowhere"},
              {"cube_stack --account works.csv", "the work of each force"}};
  for (const auto& row : rows) {
    const Ran ran = cylon(std::string("simulate ") + row.arguments);
    EXPECT_EQ(ran.code, 2) << row.arguments << ran.err;
    EXPECT_NE(ran.err.find(row.says), std::string::npos) << row.arguments << "\n" << ran.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "works.csv")) << row.arguments;
  }
}

}  // namespace
}  // namespace cylon::cli
