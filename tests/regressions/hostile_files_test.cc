// Small files that hung the reader, filled the memory or overflowed the stack.  Each is refused now with exit
// code 2 and the place of what asks too much, within a limit on memory and CPU time that kills the program
// where it works on.
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace cylon::cli {
namespace {

struct Hostile {
  std::string name;
  std::string text;
  std::string says;
  std::string other = {};  // content of other.json, other.obj
};

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

const std::string head = "duration = 1\nstep = 0.01\n";
const std::string ball = "[[body]]\nname = \"ball\"\nmass = 1\n";
const std::string claim = "[[claim]]\nconserves = \"energy\"\ntolerance = { absolute = 1, reason = \"r\" }\n";
const std::string material = "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";
const std::string spheres = "shape = { type = \"sphere\", radius = 1 }\n";

std::string follows(const std::string& truth) {
  return "[[claim]]\nfollows = \"" + truth +
         "\"\nobservable = \"position\"\ntolerance = { absolute = 1, reason = \"r\" }\n";
}
std::string lattice(const std::string& count, const std::string& more) {
  return "[[lattice]]\nname = \"g\"\nmass = 1\ncount = " + count + "\nspacing = [3, 3, 3]\n" + more;
}

std::vector<Hostile> table() {
  const std::string dots = repeated("a.", 31000) + "a";
  const std::string deep = std::string(500'000, '[') + std::string(500'000, ']');
  const std::string recorded = head + ball +
                               "[[claim]]\nfollows = { file = \"other.json\" }\nobservable = \"position\"\n"
                               "tolerance = { absolute = 1, reason = \"r\" }\n";
  const std::string mesh = head + ball +
                           "inertia = [1, 1, 1]\nshape = { type = \"mesh\", file = \"other.obj\" }\n" +
                           material + claim;
  std::string points;
  for (int i = 0; i < 1000; ++i)
    points += (i ? ", [" : "[") + std::to_string(i * 7919 % 1000) + ", " + std::to_string(i * 104729 % 997) +
              ", " + std::to_string(i * 1299709 % 991) + "]";
  return {
      {"keys with 31000 dots", dots + " = 1\n", "bad.toml:1:66: a key is nested more than 32 deep"},
      {"a table with 31000 dots", head + ball + "[" + dots + "]\n", "bad.toml:6:67: a key is nested"},
      {"arrays in arrays", head + "x = " + std::string(100'000, '[') + "\n",
       "bad.toml:3:37: values are nested"},
      {"a rod that a fast ball sets spinning",
       head +
           "[[body]]\nname = \"s\"\nmass = 1\nposition = [-1.3, 0.6, 0]\nvelocity = [3e5, 0, 0]\n"
           "shape = { type = \"sphere\", radius = 0.2 }\n"
           "[[body]]\nname = \"rod\"\nmass = 2\nshape = { type = \"box\", half_extents = [0.1, 1, 0.1] }\n" +
           material + follows("rod_offcentre_hit"),
       "whether the two touch again before the horizon takes too long to see"},
      {"an unknown key of a megabyte", head + std::string(1 << 20, 'k') + " = 1\n",
       "bad.toml:3:1: unknown key 'kkk"},
      {"deep JSON as a schema", recorded, "bad.toml:7:", "{\"schema\": " + deep + "}"},
      {"deep JSON that nobody reads", recorded, "nested more than 64 deep", "{\"x\": " + deep + "}"},
      {"an elastic ball for ten years",
       "duration = 1e9\nstep = 1\ngravity = [0, -9.81, 0]\n" + ball + "position = [0, 2, 0]\n" + spheres +
           "[[plane]]\nname = \"floor\"\n" + material + follows("bouncing_sphere"),
       "more than 1000000 events before the horizon"},
      {"copies of 1000 bodies",
       head + lattice("[1000, 1, 1]", "") +
           [] {
             std::string springs;
             for (int i = 0; i < 1000; ++i)
               springs +=
                   "[[spring]]\nbody = \"g[" + std::to_string(i) + "]\"\npin = [0, 9, 0]\nstiffness = 2\n";
             return springs;
           }() +
           follows("spring_zero_length"),
       "too many bodies for that"},
      {"a million bodies under a truth",
       "gravity = [0, -1, 0]\n" + head + lattice("[1000, 1000, 1]", "") + follows("projectile"),
       "serve scenes of at most 2000 bodies"},
      {"a million hulls of 1000 points",
       head + lattice("[1000, 1000, 1]", "shape = { type = \"hull\", vertices = [" + points + "] }\n") +
           material + claim,
       "have more than 5000000 points together"},
      {"a typo of 3000 letters among a million names",
       head + lattice("[1000, 1000, 1]", "") + "[[drag]]\nbody = \"" + std::string(3000, 'z') +
           "\"\nlinear = 1\n",
       "bad.toml:9:8: body = 'zzz"},
      {"a hundred thousand locked spheres in one place",
       head + "[[lattice]]\nname = \"g\"\nlocked = true\ncount = [1000, 100, 1]\nspacing = [0, 0, 0]\n" +
           spheres + ball + spheres + material + claim,
       "overlap by 2 m at the start"},
      {"a mesh whose faces name no vertex", mesh, "bad.toml:7:", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 900000\n"},
      {"a cloud that flies off the numbers",
       head +
           "[[cloud]]\nname = \"c\"\nmass = 1\ncount = 3\nvelocity = [1.7e308, 0, 0]\nspeed = 1.7e308\n"
           "low = [0, 0, 0]\nhigh = [1, 1, 1]\n" +
           claim,
       "is not finite"},
      {"crowded clouds, each of which is read in a second",
       head +
           [] {
             std::string clouds;
             for (int i = 0; i < 60; ++i)
               clouds += "[[cloud]]\nname = \"c" + std::to_string(i) +
                         "\"\nmass = 1\ncount = 2100\nseed = " + std::to_string(i) + "\nlow = [0, 0, " +
                         std::to_string(30 * i) + "]\nhigh = [30, 30, " + std::to_string(30 * i + 29) +
                         "]\n" + spheres;
             return clouds;
           }() +
           material + claim,
       "the search for free places takes too long"},
      {"a lattice that flies off the numbers",
       head + "[[lattice]]\nname = \"c\"\nmass = 1\ncount = [10, 1, 1]\nspacing = [1e308, 0, 0]\n" + claim,
       "is not finite"},
      {"two thousand claims",
       head + ball +
           [] {
             std::string claims;
             for (int i = 0; i < 2000; ++i)
               claims += "[[claim]]\nconserves = \"energy\"\nuntil = 0." + std::to_string(1000 + i) +
                         "\ntolerance = { absolute = 1, reason = \"r\" }\n";
             return claims;
           }(),
       "at most 1000 claims"},
      {"recorded data with a fault", recorded, "bad.toml:7:20: other.json", "{"},
  };
}

using HostileFiles = CommandLine;

TEST_F(HostileFiles, AreRefusedInTimeAndMemory) {
  for (const Hostile& file : table()) {
    SCOPED_TRACE(file.name);
    write("bad.toml", file.text);
    write("other.json", file.other);
    write("other.obj", file.other);
    const Ran ran = shell("ulimit -v 4000000 -t 60; exec cylon validate bad.toml");
    EXPECT_EQ(ran.code, 2) << ran.out << ran.err.substr(0, 1000);
    EXPECT_NE(ran.err.find(file.says), std::string::npos) << file.says << "\n" << ran.err.substr(0, 1000);
    EXPECT_LT(ran.err.size(), 4000u);
  }
}

// The grid that looks for overlaps sees those that there are, at any place and for any ratio of the radii.
TEST_F(HostileFiles, AMillionSpheresInOnePlaneAreRead) {
  write("good.toml",
        head + "[[lattice]]\nname = \"g\"\nmass = 1\ncount = [1, 1000, 1000]\nspacing = [0, 3, 3]\n" +
            spheres + material + claim);
  EXPECT_EQ(shell("ulimit -v 4000000 -t 60; exec cylon validate good.toml").code, 0);
  for (const auto& [radius, x, overlaps] :
       std::vector<std::tuple<double, double, bool>>{{0.001, 1.0005, true},
                                                     {0.001, 1.0015, false},
                                                     {500, 500.9, true},
                                                     {500, 501.1, false},
                                                     {1, -1.9, true},
                                                     {1, -2.1, false},
                                                     {1e9, 1e9, true},
                                                     // Out there a whole number plus one is the same number.
                                                     {0.001, 1e20, false},
                                                     {0.001, -1e300, false},
                                                     {1, 1e300, false}}) {
    write("two.toml", fmt::format("{}{}{}[[body]]\nname = \"other\"\nmass = 1\nposition = [{}, 0, 0]\n"
                                  "shape = {{ type = \"sphere\", radius = {} }}\n{}{}",
                                  head, ball, spheres, x, radius, material, claim));
    EXPECT_EQ(shell("ulimit -t 60; exec cylon validate two.toml").code, overlaps ? 2 : 0)
        << radius << " " << x;
  }
}

}  // namespace
}  // namespace cylon::cli
