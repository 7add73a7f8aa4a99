#include "reference/exact/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::exact {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr double step = 1e-8;
constexpr int times = 128;

// Every scene that differs from the given one in one number, by step times that number.
class Nudges {
 public:
  explicit Nudges(const core::Scene& scene) : scene_(scene) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) body(b);
    for (std::size_t f = 0; f < scene.forces.size(); ++f) {
      if (std::holds_alternative<core::UniformGravity>(scene.forces[f])) {
        vector([f](core::Scene & s) -> auto& {
          return std::get<core::UniformGravity>(s.forces[f]).acceleration;
        });
      } else if (std::holds_alternative<core::Spring>(scene.forces[f])) {
        const auto spring = [f](core::Scene & s) -> auto& { return std::get<core::Spring>(s.forces[f]); };
        vector([=](core::Scene & s) -> auto& { return spring(s).to_anchor; });
        number([=](core::Scene & s) -> auto& { return spring(s).stiffness; });
        number([=](core::Scene & s) -> auto& { return spring(s).rest_length; });
      }
    }
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      vector([j](core::Scene & s) -> auto& { return s.joints[j].point; });
    }
  }

  std::vector<core::Scene> scenes;

 private:
  template <class Access>
  void number(Access access) {
    core::Scene moved = scene_;
    double& x = access(moved);
    if (x == 0) return;
    x += step * x;
    scenes.push_back(std::move(moved));
  }

  template <class Access>
  void vector(Access access) {
    for (int i = 0; i < 3; ++i) number([=](core::Scene & s) -> auto& { return access(s)[i]; });
  }

  void body(std::size_t b) {
    vector([b](core::Scene & s) -> auto& { return s.bodies[b].initial.position; });
    vector([b](core::Scene & s) -> auto& { return s.bodies[b].initial.velocity; });
    vector([b](core::Scene & s) -> auto& { return s.bodies[b].initial.angular_velocity; });
    for (int i = 0; i < 4; ++i) {
      number([=](core::Scene & s) -> auto& { return s.bodies[b].initial.orientation.coeffs()[i]; });
    }
    number([b](core::Scene & s) -> auto& { return s.bodies[b].mass; });
    // A full tensor goes through an eigenvalue solver, whose error is one of the tensor as a whole.
    const core::Matrix3& inertia = scene_.bodies[b].inertia;
    for (int i = 0; i < 3; ++i) {
      for (int j = inertia.isDiagonal(0.0) ? i : 0; j <= i; ++j) {
        core::Scene moved = scene_;
        const double amount =
            step * (inertia.isDiagonal(0.0) ? inertia(i, j) : inertia.cwiseAbs().maxCoeff());
        moved.bodies[b].inertia(i, j) += amount;
        if (i != j) moved.bodies[b].inertia(j, i) += amount;
        if (amount != 0) scenes.push_back(std::move(moved));
      }
    }
  }

  const core::Scene& scene_;
};

double angle(const core::Quaternion& p, const core::Quaternion& q) {
  const double chord = std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4 * std::asin(std::min(1.0, chord / 2));
}

// Largest difference of two states, and of their sizes if `b` is nothing, over the bodies.
void raise(core::StateError& most, const core::State& a, const core::State& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    most.position = std::max(most.position, (a[i].position - b[i].position).norm());
    most.velocity = std::max(most.velocity, (a[i].velocity - b[i].velocity).norm());
    most.orientation = std::max(most.orientation, angle(a[i].orientation, b[i].orientation));
    most.angular_velocity =
        std::max(most.angular_velocity, (a[i].angular_velocity - b[i].angular_velocity).norm());
  }
}

void add(core::StateError& sum, double factor, const core::StateError& e) {
  sum.position += factor * e.position;
  sum.velocity += factor * e.velocity;
  sum.orientation += factor * e.orientation;
  sum.angular_velocity += factor * e.angular_velocity;
}

}  // namespace

core::StateError rounding_error(const core::Scene& scene, const Solve& solve, double horizon) {
  const auto exact = solve(scene);
  std::vector<core::State> states;
  for (int k = 0; k <= times; ++k) states.push_back(exact(horizon * k / times));

  core::StateError size;
  for (const core::State& state : states) raise(size, state, core::State(state.size()));
  size.orientation = 1;
  core::StateError error;
  add(error, 8 * eps, size);

  for (const core::Scene& nudged : Nudges(scene).scenes) {
    const auto moved = solve(nudged);
    core::StateError most;
    for (int k = 0; k <= times; ++k) {
      raise(most, moved(horizon * k / times), states[static_cast<std::size_t>(k)]);
    }
    add(error, 4 * eps / step, most);
  }
  return error;
}

}  // namespace cylon::exact
