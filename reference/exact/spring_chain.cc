// Bodies in a line, or in any network, joined by springs between their centres and to pins: linear, so a sum
// of normal modes.  With y_i = sqrt(m_i) (x_i - x_i(0)), f the forces at t = 0, v_n the modes' shapes:
//
//     y = sum_n v_n [ (v_n.f/sqrt(m)) (1 - cos w_n t)/w_n^2 + (v_n.y'(0)) sin(w_n t)/w_n ]
//
// A network that nothing ties to the world falls as one, the modes on top.  Springs without rest length act
// on each coordinate alike; with a rest length the equations are linear only on a line, which must be
// parallel to a coordinate axis (no other line stays exact in doubles), and only while no spring's ends can
// meet: length at equilibrium > sum of the amplitudes.
//
// The bound is proven in the norm of y.  Let every number be off by e = 4 eps, T the horizon, 2 H the energy
// of the modes, s the stretches at t = 0, S = |sqrt(k) s| + |sqrt(k) L| + |sqrt(k) pin|, w_1 and w_N the
// slowest and the fastest mode, R the residual of the computed modes; by Duhamel's formula, with |cos| <= 1
// and |sin(w t)/w| <= min(T, 1/w) = c:
//
//     |dy|  <= e [(2 T + 3 c) sqrt(2 H) + 2 c S + min(T^2/2, 2/w_1^2) |sqrt(m) g| + |sqrt(m) x(0)|
//               + c |sqrt(m) v(0)|] + R T min(T/2, c) |y|
//     |dy'| <= e [(2 w_N T + 3) sqrt(2 H) + S + c |sqrt(m) g| + w_N |sqrt(m) x(0)| + |sqrt(m) v(0)|] + R T
//     |y|
#include "reference/exact/chain_modes.h"
#include "reference/exact/domain.h"
#include "reference/exact/solutions.h"
#include "reference/exact/steady_spin.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace cylon::exact {
namespace {

constexpr auto name = "spring_chain";
constexpr double eps = std::numeric_limits<double>::epsilon();

template <class Use>
void each_spring(const core::Scene& scene, Use use) {
  for (const core::Force& force : scene.forces) {
    if (const auto* spring = std::get_if<core::Spring>(&force)) use(*spring);
  }
}

// Where the spring ends at t = 0.
core::Vector3 far_end(const core::Scene& scene, const core::Spring& spring) {
  return spring.to == core::world ? spring.to_anchor
                                  : scene.bodies[static_cast<std::size_t>(spring.to)].initial.position;
}

Wide length_on(const core::Scene& scene, const core::Spring& spring, int axis) {
  return Wide(far_end(scene, spring)[axis]) -
         Wide(scene.bodies[static_cast<std::size_t>(spring.body)].initial.position[axis]);
}

// The only axis on which springs have a length, where there is a rest length.
std::optional<int> line_of(const core::Scene& scene) {
  std::optional<int> line;
  each_spring(scene, [&](const core::Spring& spring) {
    if (spring.rest_length == 0) return;
    for (int axis = 0; axis < 3; ++axis) {
      if (length_on(scene, spring, axis) != 0) line = axis;
    }
  });
  return line;
}

// Motion along one coordinate.
struct Coordinate {
  WideColumn force, speed;                                          // v_n.f/sqrt(m), v_n.y'(0) of each mode
  Wide fall = 0, drift = 0;                                         // of a free network's centre of mass
  Wide stretches = 0, rests = 0, pins = 0, places = 0, speeds = 0;  // squares of the norms in the bound
};

class Chain {
 public:
  explicit Chain(const core::Scene& scene) : modes_(scene), line_(line_of(scene)) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) spins_.emplace_back(scene, i);
    start_ = core::initial_state(scene);
    fall_ = common_gravity(scene);
    for (int axis = 0; axis < 3; ++axis) coordinates_[axis] = coordinate(scene, axis);
  }

  core::State at(double time) const {
    const Wide t = time;
    const Eigen::Index n = modes_.frequencies.size();
    std::vector<WideState> states(start_.size());
    for (std::size_t i = 0; i < states.size(); ++i) {
      states[i].position = widen(start_[i].position), states[i].velocity.setZero();
      spins_[i].turn(states[i], t);
    }
    WideColumn place(n), speed(n);
    for (int axis = 0; axis < 3; ++axis) {
      const Coordinate& c = coordinates_[axis];
      for (Eigen::Index k = 0; k < n; ++k) {
        const Wide w = modes_.frequencies[k], sine = std::sin(w * t), half = std::sin(w * t / 2);
        const Wide slide = w > 0 ? sine / w : t, push = w > 0 ? 2 * half * half / (w * w) : t * t / 2;
        place[k] = c.force[k] * push + c.speed[k] * slide;
        speed[k] = c.force[k] * slide + c.speed[k] * std::cos(w * t);
      }
      const WideColumn y = modes_.shapes * place, dy = modes_.shapes * speed;
      for (std::size_t i = 0; i < states.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        states[i].position[axis] += y[row] / modes_.root_mass[row] + t * (c.drift + t * c.fall / 2);
        states[i].velocity[axis] += dy[row] / modes_.root_mass[row] + c.drift + t * c.fall;
      }
    }
    core::State result;
    for (const WideState& s : states) result.push_back(narrow(s));
    return result;
  }

  // Refuses a spring whose ends might meet.
  void check_lengths(const core::Scene& scene) const {
    if (!line_) return;
    each_spring(scene, [&](const core::Spring& spring) {
      if (spring.rest_length == 0) return;
      const Coordinate& c = coordinates_[*line_];
      Wide length = length_on(scene, spring, *line_), swing = 0;
      const Wide sign = length < 0 ? -1 : 1;
      for (Eigen::Index k = modes_.free ? 1 : 0; k < modes_.frequencies.size(); ++k) {
        const Wide w = modes_.frequencies[k], offset = c.force[k] / (w * w);
        Wide share = -modes_.shapes(spring.body, k) / modes_.root_mass[spring.body];
        if (spring.to != core::world) share += modes_.shapes(spring.to, k) / modes_.root_mass[spring.to];
        length += share * offset;
        swing += std::abs(share) * std::hypot(offset, c.speed[k] / w);
      }
      if (!(sign * length > swing)) {
        refuse(name, "the ends of the spring of " + named(scene, spring.body) + " may meet");
      }
    });
  }

  core::StateError error(double horizon) const {
    const Wide time = horizon, slow = modes_.slowest(), fast = modes_.fastest(), e = 4 * eps;
    const Wide light = modes_.root_mass.minCoeff(), heavy = modes_.root_mass.norm();
    const Wide c = std::min(time, 1 / slow), hang = std::min(time * time / 2, 2 / (slow * slow));
    Wide energy = 0, size = 0, stretches = 0, rests = 0, pins = 0, places = 0, speeds = 0;
    core::Vector3 moved(0, 0, 0), drifted(0, 0, 0), furthest(0, 0, 0);
    for (int axis = 0; axis < 3; ++axis) {
      const Coordinate& x = coordinates_[axis];
      stretches += x.stretches, rests += x.rests, pins += x.pins, places += x.places, speeds += x.speeds;
      for (Eigen::Index k = modes_.free ? 1 : 0; k < modes_.frequencies.size(); ++k) {
        const Wide w = modes_.frequencies[k], q = x.force[k] / (w * w);
        energy += w * w * q * q + x.speed[k] * x.speed[k];
        size += 4 * q * q + x.speed[k] * x.speed[k] / (w * w);
      }
      moved[axis] = static_cast<double>(std::abs(x.drift) * time + std::abs(x.fall) * time * time / 2);
      drifted[axis] = static_cast<double>(std::abs(x.drift) + std::abs(x.fall) * time);
      for (const core::BodyState& s : start_)
        furthest[axis] = std::max(furthest[axis], std::abs(s.position[axis]));
    }
    const Wide y = std::sqrt(size), swing = std::sqrt(energy), place = std::sqrt(places),
               speed = std::sqrt(speeds);
    const Wide springs = std::sqrt(stretches) + std::sqrt(rests) + std::sqrt(pins);
    const Wide weight = modes_.free ? 0 : heavy * Wide(fall_.norm());
    const Wide shift =
        e * ((2 * time + 3 * c) * swing + 2 * c * springs + hang * weight + place + c * speed) +
        modes_.residual * time * std::min(time / 2, c) * y;
    const Wide kick = e * ((2 * fast * time + 3) * swing + springs + c * weight + fast * place + speed) +
                      modes_.residual * time * y;
    const auto share = [light](Wide norm) { return static_cast<double>(norm / light); };
    core::StateError result;
    result.position = share(shift) + 8 * eps * (furthest.norm() + share(y)) + 12 * eps * moved.norm();
    result.velocity = share(kick) + 8 * eps * share(swing) + 12 * eps * drifted.norm();
    for (const SteadySpin& spin : spins_) {
      const double rate = static_cast<double>(spin.angular_velocity.norm());
      result.orientation = std::max(result.orientation, eps * (16 + 12 * rate * horizon));
      result.angular_velocity = std::max(result.angular_velocity, 16 * eps * rate);
    }
    return result;
  }

 private:
  Coordinate coordinate(const core::Scene& scene, int axis) const {
    const auto n = static_cast<Eigen::Index>(scene.bodies.size());
    WideColumn force = WideColumn::Zero(n), speed(n);
    Coordinate c;
    const bool sprung = !line_ || *line_ == axis;
    each_spring(scene, [&](const core::Spring& spring) {
      if (!sprung) return;
      const Wide d = length_on(scene, spring, axis), k = spring.stiffness;
      const Wide stretch = d - (d < 0 ? -1 : 1) * Wide(spring.rest_length);
      force[spring.body] += k * stretch;
      if (spring.to != core::world) force[spring.to] -= k * stretch;
      if (spring.to == core::world) c.pins += k * Wide(spring.to_anchor[axis]) * Wide(spring.to_anchor[axis]);
      c.stretches += k * stretch * stretch;
      c.rests += k * Wide(spring.rest_length) * Wide(spring.rest_length);
    });
    Wide momentum = 0, mass = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      const core::BodyState& s = scene.bodies[static_cast<std::size_t>(i)].initial;
      const Wide m = modes_.root_mass[i] * modes_.root_mass[i];
      speed[i] = s.velocity[axis], momentum += m * speed[i], mass += m;
      c.places += m * Wide(s.position[axis]) * Wide(s.position[axis]);
      c.speeds += m * speed[i] * speed[i];
    }
    // What all do alike: a free network, and motion across the line.
    if (modes_.free || !sprung) {
      c.drift = momentum / mass, c.fall = fall_[axis];
      speed.array() -= c.drift;
    } else {
      force += Wide(fall_[axis]) * modes_.root_mass.cwiseProduct(modes_.root_mass);
    }
    c.force = modes_.shapes.transpose() * force.cwiseQuotient(modes_.root_mass);
    c.speed = modes_.shapes.transpose() * speed.cwiseProduct(modes_.root_mass);
    if (modes_.free) c.force[0] = c.speed[0] = 0;
    return c;
  }

  ChainModes modes_;
  std::optional<int> line_;
  std::vector<SteadySpin> spins_;
  core::State start_;
  core::Vector3 fall_;
  Coordinate coordinates_[3];
};

void check_springs_between_centres(const core::Scene& scene) {
  each_spring(scene, [&](const core::Spring& spring) {
    const std::string of = "the spring of " + named(scene, spring.body);
    if (!spring.anchor.isZero(0.0) || (spring.to != core::world && !spring.to_anchor.isZero(0.0))) {
      refuse(name, of + " is not anchored at the centre of mass");
    }
    if (spring.damping != 0) refuse(name, of + " is damped");
    if (!(spring.stiffness > 0)) refuse(name, of + " has no stiffness");
    if (spring.rest_length != 0 &&
        (far_end(scene, spring) - scene.bodies[static_cast<std::size_t>(spring.body)].initial.position)
            .isZero(0.0)) {
      refuse(name, of + " starts without length");
    }
  });
  switch (network(scene)) {
    case Network::several:
      refuse(name, "the springs leave the bodies in several pieces");
    case Network::free:
      if (scene.bodies.size() < 2) refuse(name, "the springs leave the bodies in several pieces");
      break;
    case Network::tied:
      break;
  }
}

// With rest lengths, nothing may happen across the line.
void check_line(const core::Scene& scene) {
  const std::optional<int> line = line_of(scene);
  if (!line) return;
  const bool free = network(scene) == Network::free;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == *line) continue;
    each_spring(scene, [&](const core::Spring& spring) {
      if (length_on(scene, spring, axis) != 0) {
        refuse(name, "the spring of " + named(scene, spring.body) +
                         " has a rest length and is not exactly parallel to the axis of the others");
      }
    });
    const double common = free ? scene.bodies[0].initial.velocity[axis] : 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (scene.bodies[i].initial.velocity[axis] != common) {
        refuse(name, named(scene, static_cast<int>(i)) + " moves across the chain");
      }
    }
    if (!free && common_gravity(scene)[axis] != 0) refuse(name, "gravity acts across the chain");
  }
}

}  // namespace

core::Truth spring_chain(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "spring"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_steady_spin(name, scene, i, horizon);
  check_springs_between_centres(scene);
  check_line(scene);
  const Chain chain(scene);
  chain.check_lengths(scene);
  return {
      .state = [chain](double t) { return chain.at(t); },
      .error = chain.error(horizon),
      .source = "Landau & Lifshitz, Mechanics, section 23: normal modes of small oscillations, here exact",
      .horizon = horizon};
}

}  // namespace cylon::exact
