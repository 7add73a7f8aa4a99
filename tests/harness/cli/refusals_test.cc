// Extremes that are no scene: engines take them as a static body, as NaN for ever, or abort.  Here each is
// refused before any engine sees it, with the place, the key and the value, and exit code 2.
#include "tests/harness/cli/fixture.h"

#include <vector>

namespace cylon::cli {
namespace {

struct Refused {
  const char* name;
  std::string text;
  std::vector<std::string> says;  // "bad.toml:line:column", the key, the value
};

// Lines 1 and 2; a body on 3 to 6, its mass on 5 and its shape on 6.
std::string scene(const std::string& step, const std::string& mass, const std::string& more) {
  return "duration = 1\nstep = " + step + "\n[[body]]\nname = \"ball\"\nmass = " + mass +
         "\nshape = { type = \"sphere\", radius = 0.5 }\n" + more;
}
std::string body(const std::string& line) { return scene("0.01", "1", line + "\n"); }
std::string mass(const std::string& value) { return scene("0.01", value, ""); }
std::string step(const std::string& value) { return scene(value, "1", ""); }

const std::string second = "position = [0, 2, 0]\n[[body]]\nname = \"other\"\nmass = 1\n";

std::vector<Refused> table() {
  return {
      {"mass zero", mass("0"), {"bad.toml:5:8", "mass = 0", "> 0 kg"}},
      {"mass negative", mass("-1"), {"bad.toml:5:8", "mass = -1", "> 0 kg"}},
      {"mass NaN", mass("nan"), {"bad.toml:5:8", "mass = nan", "finite"}},
      {"mass infinite", mass("inf"), {"bad.toml:5:8", "mass = inf", "finite"}},
      {"step zero", step("0"), {"bad.toml:2:8", "step = 0", "> 0 s"}},
      {"step backwards", step("-0.01"), {"bad.toml:2:8", "step = -0.01", "> 0 s"}},
      {"step NaN", step("nan"), {"bad.toml:2:8", "step = nan"}},
      {"velocity NaN", body("velocity = [0, nan, 0]"), {"bad.toml:7:16", "velocity = nan", "finite"}},
      {"velocity infinite", body("velocity = [inf, 0, 0]"), {"bad.toml:7:13", "velocity = inf", "finite"}},
      {"spin NaN",
       body("angular_velocity = [0, 0, nan]"),
       {"bad.toml:7:27", "angular_velocity = nan", "finite"}},
      {"quaternion zero", body("orientation = [0, 0, 0, 0]"), {"bad.toml:7:15", "orientation", "norm 0"}},
      {"no such body by the triangle inequality",
       body("inertia = [1, 1, 5]"),
       {"bad.toml:7:11", "inertia", "1, 1, 5", "must be <= 2"}},
      {"inertia negative", body("inertia = [1, -1, 1]"), {"bad.toml:7:", "inertia", "-1"}},
      {"radius zero",
       "duration = 1\nstep = 0.01\n[[body]]\nname = \"b\"\nmass = 1\nshape = { type = \"sphere\", radius = 0 "
       "}\n",
       {"bad.toml:6:37", "radius = 0", "> 0 m"}},
      {"two spheres in one place",
       body(second + "position = [0, 2, 0]\nshape = { type = \"sphere\", radius = 0.5 }\n"
                     "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 0\nfriction = 0"),
       {"bad.toml:11:12", "'ball' and 'other' overlap by 1 m"}},
      {"three and a half metres below the floor",
       body("position = [0, -3, 0]\n[[plane]]\nname = \"floor\"\nnormal = [0, 1, 0]\noffset = 0\n"
            "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 0\nfriction = 0"),
       {"bad.toml:7:12", "'ball' reaches 3.5 m into plane 'floor'"}},
      {"more spheres than fit",
       "duration = 1\nstep = 0.01\n[[cloud]]\nname = \"a\"\nmass = 1\ncount = 2000\nlow = [0,0,0]\n"
       "high = [1,1,1]\nshape = { type = \"sphere\", radius = 0.5 }\n",
       {"bad.toml:6:9", "count = 2000", "only "}},
      {"restitution that feeds energy",
       body("[[plane]]\nname = \"floor\"\nnormal = [0, 1, 0]\noffset = -5\n"
            "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1.01\nfriction = 0"),
       {"bad.toml:13:15", "restitution = 1.01"}},
      {"friction that drives",
       body("[[plane]]\nname = \"floor\"\nnormal = [0, 1, 0]\noffset = -5\n"
            "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 0\nfriction = -0.1"),
       {"bad.toml:14:12", "friction = -0.1"}},
  };
}

using Refusals = CommandLine;

TEST_F(Refusals, ImpossibleExtremesNeverReachAnEngine) {
  for (const Refused& row : table()) {
    SCOPED_TRACE(row.name);
    write("bad.toml", row.text);
    const Ran ran = cylon("validate bad.toml");
    EXPECT_EQ(ran.code, 2) << ran.out;
    for (const std::string& words : row.says)
      EXPECT_NE(ran.err.find(words), std::string::npos) << words << "\n" << ran.err;
  }
}

// The same scenes with possible values load: what is refused is the value.
TEST_F(Refusals, TheNeighboursOfImpossibleValuesLoad) {
  for (const std::string& text :
       {mass("1e-30"), step("1e-7"), body("velocity = [0, 1e300, 0]"), body("inertia = [1, 1, 2]"),
        body("inertia = [1e-12, 1, 1]"), body("orientation = [0, 0, 0, -1]")}) {
    write("good.toml", text);
    const Ran ran = cylon("validate good.toml");
    EXPECT_EQ(ran.code, 0) << text << ran.err;
  }
}

// A ball falls 4.9 m in a second; a tenth of that is the most that tells its fall from rest.
TEST_F(Refusals, AToleranceAsWideAsTheMotionIsWarnedOf) {
  const auto falls = [](const char* absolute) {
    return "gravity = [0, -9.81, 0]\n" + body("position = [0, 9, 0]") +
           "[[claim]]\nfollows = \"projectile\"\nobservable = \"position\"\ntolerance = { absolute = " +
           absolute + ", reason = \"as it comes\" }\n";
  };
  write("wide.toml", falls("0.5"));
  const Ran wide = cylon("validate wide.toml");
  EXPECT_EQ(wide.code, 0) << wide.err;
  EXPECT_NE(wide.err.find("allows 0.5 m, more than a tenth of the range of the motion; that is 0.49"),
            std::string::npos)
      << wide.err;
  write("telling.toml", falls("0.48"));
  EXPECT_EQ(cylon("validate telling.toml").err, "");
}

}  // namespace
}  // namespace cylon::cli
