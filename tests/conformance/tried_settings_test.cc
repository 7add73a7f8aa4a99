// What `cylon advise` and `cylon trade` try where no engine is named: each setting where it can matter, and
// once.
#include "harness/study/settings.h"
#include "tests/conformance/fixture.h"

#include <gtest/gtest.h>

namespace cylon::conformance {
namespace {

// How often each id is tried with the first integrator that takes fixed steps.
std::map<std::string, int> tried(const std::string& scenario) {
  std::map<std::string, int> count;
  for (const study::Setting& setting :
       study::settings(shipped(scenario), process::default_engines(binary_dir), {}))
    if (setting.first_fixed) ++count[setting.engine.id];
  return count;
}

TEST(TriedSettings, AreThoseThatMatterToTheScene) {
  std::map<std::string, int> slides = tried("friction_at_30_degrees"), falls = tried("projectile"),
                             springs = tried("stiff_spring_1e6");
  for (std::map<std::string, int>* ids : {&slides, &falls, &springs}) {
    EXPECT_EQ((*ids)["bullet/path=as-expert"], 1);
    EXPECT_EQ((*ids)["ode/path=as-expert"], 1);
    EXPECT_FALSE(ids->contains("bullet-multibody/path=as-expert")) << "the same as bullet's";
    EXPECT_FALSE(ids->contains("ode-quick/path=as-expert")) << "the same as ode's";
  }
  for (const char* id : {"bullet/solver=dantzig", "bullet/solver=nncg", "ode/friction-direction=slip"}) {
    EXPECT_EQ(slides[id], 1) << id;
    EXPECT_EQ(falls[id] + springs[id], 0) << id;
  }
  // Of numbers each has a value to try.
  for (const char* id :
       {"bullet/ccd=0.9", "bullet/plane-queries=3", "bullet/breaking-threshold=0.1", "bullet/iterations=200",
        "bullet-multibody/iterations=200", "ode-quick/iterations=200"}) {
    EXPECT_EQ(slides[id], 1) << id;
    EXPECT_EQ(falls[id] + springs[id], 0) << id;
  }
  EXPECT_EQ(tried("double_pendulum_rods")["bullet/iterations=200"], 1) << "joints are swept as well";
  // ODE's stepper is a row of its own, and what a row does not take is not tried on it.
  EXPECT_EQ(slides["ode-quick"], 1);
  for (const char* id : {"ode/stepper=quick", "ode/iterations=200", "bullet-multibody/ccd=0.9"})
    EXPECT_FALSE(slides.contains(id)) << id;
  EXPECT_EQ(springs["ode/springs=stiff"], 1);
  EXPECT_EQ(slides["ode/springs=stiff"] + falls["ode/springs=stiff"], 0);
  EXPECT_FALSE(springs.contains("ode/springs=force")) << "as the row has it";
}

// The row of ODE turns bodies by finite rotations, where ODE's own are infinitesimal: the row was tried twice, and these never.
TEST(TriedSettings, AreOtherThanThoseOfTheRow) {
  std::map<std::string, int> spins = tried("free_symmetric_top");
  EXPECT_EQ(spins["ode"] + spins["ode/rotation=infinitesimal"] + spins["ode/gyro=off"], 3);
  EXPECT_FALSE(spins.contains("ode/rotation=finite"));
}

}  // namespace
}  // namespace cylon::conformance
