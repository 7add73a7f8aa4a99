// The picture that is known of these engines: Bullet and ODE are of first order everywhere, the in-house
// integrators of the order that each declares, and neither Bullet nor ODE follows Dzhanibekov's nut.
#include "tests/harness/cli/fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace cylon::cli {
namespace {

class Picture : public CommandLine {
 protected:
  nlohmann::json series(const std::string& arguments) const {
    const Ran ran = cylon("trade " + arguments + " --rounds 0 --json t.json");
    EXPECT_EQ(ran.code, 0) << ran.err;
    return nlohmann::json::parse(read("t.json"))["tables"][0]["series"];
  }
  static double best(const nlohmann::json& series) {
    double least = HUGE_VAL;
    for (const auto& point : series["points"])
      if (point["errors"].contains("trajectory"))
        least = std::min(least, point["errors"]["trajectory"].get<double>());
    return least;
  }
};

// The last halvings of a ladder: the terms of the next order still move the slope by some hundredths;
// the eighth-order integrator is better than it declares before its floor.
TEST_F(Picture, EveryEngineHasTheOrderThatItDeclares) {
  int fixed = 0;
  for (const auto& s : series("spring_orbit --work 65536 --engine in-house --engine bullet --engine ode")) {
    if (s["adaptive"]) {
      EXPECT_LT(best(s), 1e-9) << s["integrator"];
      continue;
    }
    if (s["integrator"] == "runge-kutta-4") continue;   // Bullet's is of its path multibody alone
    if (s["integrator"] == "explicit-euler") continue;  // it leaves the orbit at any step of this ladder
    ++fixed;
    const double declared = s["declared_order"], observed = s["observed_order"];
    EXPECT_GT(observed, declared - 0.1) << s["engine"] << s["integrator"];
    if (declared == 8) continue;
    EXPECT_LT(observed, declared + 0.2) << s["engine"] << s["integrator"];
  }
  EXPECT_EQ(fixed, 13);  // eleven of ours, one of each other
}

// Where in its step an impact falls moves the error at each step by some parts in ten.
TEST_F(Picture, BulletAndOdeBounceInFirstOrderAndExplicitEulerToo) {
  for (const auto& s : series("bouncing_sphere --engine in-house --integrator explicit-euler "
                              "--integrator semi-implicit-euler --engine bullet --engine ode"))
    EXPECT_NEAR(s["observed_order"].get<double>(), 1, 0.2) << s["engine"];
}

TEST_F(Picture, NeitherBulletNorOdeReproducesDzhanibekov) {
  for (const auto& s :
       series("dzhanibekov --work 65536 --engine in-house --integrator bm4 --integrator semi-implicit-euler "
              "--engine bullet --engine bullet/gyro=none --engine ode")) {
    if (s["engine"] == "in-house") {
      EXPECT_LT(best(s), 1e-6);
    } else {
      EXPECT_GT(best(s), 0.3) << s["engine"];  // rad, the largest over the minute
    }
  }
}

}  // namespace
}  // namespace cylon::cli
