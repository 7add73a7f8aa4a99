// The template that `cylon new` writes.
#include "harness/scenario/scenario.h"

#include <algorithm>

namespace cylon::scenario {

std::string template_toml(const std::string& name) {
  std::string title = name;
  std::erase_if(
      title, [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' ' || c == 127; });
  return "title    = \"" + title + R"("
story    = "A ball is thrown and flies without resistance."
tags     = ["flight"]
duration = 1.0            # s, a whole number of steps
step     = 0.001          # s, nominal; also "1/60"
gravity  = [0, -9.81, 0]  # m/s^2, y is up; absent: none

[[body]]
name     = "ball"
mass     = 1.0            # kg
position = [0, 1, 0]      # m, of the centre of mass
velocity = [3, 4, 0.5]    # m/s
shape    = { type = "sphere", radius = 0.1 }  # m; its inertia follows from it

# A floor to bounce on, and what the pair does where it touches:
# [[plane]]
# name   = "floor"
# normal = [0, 1, 0]
# offset = 0.0            # m: solid where normal . x < offset
#
# [[material]]
# between     = ["ball", "floor"]
# restitution = 0.8       # 0 ... 1
# friction    = 0.0       # Coulomb's coefficient

[[claim]]                 # an exact solution, which takes its parameters from the scene
follows    = "projectile"
observable = "position"   # position velocity orientation axis angular_velocity linear_momentum angular_momentum
tolerance  = { absolute = 1e-9, reason = "rounding: a parabola is exact for every integrator of second order" }

[[claim]]                 # or a quantity that must keep its value
conserves  = "energy"
tolerance  = { relative = 1e-9, reason = "rounding: the same" }
)";
}

}  // namespace cylon::scenario
