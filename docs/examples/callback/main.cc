// The in-house engine in a program of one's own: a look at each step, and kicks (docs/library.md#the-engine-in-your-program).
#include <harness/core/simulator.h>

#include <cstdio>

namespace core = cylon::core;

int main() {
  core::Scene scene;
  core::Body top;
  top.name = "top";
  top.mass = 1.5;
  top.inertia = core::Vector3(0.5, 0.7, 1.0).asDiagonal();
  top.initial.angular_velocity = {3, 1, -1};
  scene.bodies = {top};

  const auto engine = core::make_simulator();
  core::Setup setup;
  setup.dt = 0.01;
  if (const auto reason = engine->load_if_supported(scene, setup).unsupported) {
    std::fprintf(stderr, "%s\n", reason->c_str());
    return 1;
  }
  // Of each step: the state, and at t = 0.5 s a kick with spin.
  core::State state(scene.bodies.size());
  const core::Vector3 impulse(0.3, 0, 0), angular(0, 0.2, -0.1);
  core::Vector3 before = core::Vector3::Zero(), after = before;  // the spin angular momentum
  for (int step = 1; step <= 100; ++step) {
    engine->step();
    engine->read(state);
    const core::Matrix3 inertia = core::world_inertia(top, state[0].orientation);
    (step <= 50 ? before : after) = inertia * state[0].angular_velocity;
    if (step == 50)
      if (const auto reason = engine->kick(0, impulse, angular)) {
        std::fprintf(stderr, "%s\n", reason->c_str());
        return 1;
      }
  }
  const double off = (after - before - angular).norm() + (state[0].velocity - impulse / top.mass).norm();
  std::printf("x = %.17g m; momenta jumped by the kick to %.1e\n", state[0].position.x(), off);
  return off < 1e-12 ? 0 : 1;
}
