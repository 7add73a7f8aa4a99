// A ball of 1e308 kg has a momentum that is no double: its place in the grid of spheres was computed from NaN, and the in-house
// engine died by SIGSEGV.  Found by tests/fuzz/accepted.py, scene 19503.
#include "tests/harness/cli/fixture.h"

namespace cylon::cli {
namespace {

using MomentumBeyondDouble = CommandLine;

TEST_F(MomentumBeyondDouble, IsNoCrash) {
  write("heavy.toml", R"(duration = 0.1
step = 0.001
[[body]]
name = "ball"
mass = 1e308
position = [0.3, 0, 0]
velocity = [2, 0, 0]
shape = { type = "sphere", radius = 0.1 }
[[plane]]
name = "right"
normal = [-1, 0, 0]
offset = -1
[[material]]
between = ["ball", "*"]
restitution = 1
friction = 0
[[claim]]
conserves = "energy"
tolerance = { relative = 1e-3, reason = "none" }
)");
  const Ran ran = cylon("run heavy.toml --engine in-house --json -");
  EXPECT_EQ(ran.code, 1) << ran.err;
  EXPECT_EQ(ran.out.find("SIGSEGV"), std::string::npos) << ran.out;
  EXPECT_EQ(ran.out.find("\"status\":\"crash\""), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace cylon::cli
