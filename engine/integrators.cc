#include "engine/integrators.h"

#include "engine/free_rotation.h"

namespace cylon::engine {

namespace {

// The motion after a straight step h with constant rates: p + h v, K + h F, exp(h w) R, L + h torque.
void move(const Body& body, const Motion& from, Real h, const Rate& rate, Motion& to) {
  to.position = from.position + h * rate.velocity;
  to.momentum = from.momentum + h * rate.force;
  if (!body.turns) return;  // its orientation is the same in all stages
  to.orientation = turned(from.orientation, h * rate.angular_velocity);
  to.angular_momentum = from.angular_momentum + h * rate.torque;
}

// Explicit Euler, as the seed has it (eq. 57-64; R_{t+dt} = R(w_t dt) R_t by errata 12), p and R with the old
// velocities.
//   p' = p + h v,  K' = K + h F,  R' = exp(h w) R,  L' = L + h torque
// Order 1.  Energy grows: by 1 + (omega h)^2 a step on a spring (errata 13).
void explicit_euler(Dynamics& dynamics, Real time, Real h, std::vector<Motion>& motion, Workspace& work) {
  std::vector<Rate>& rate = work.rate[0];
  dynamics.rates(time, motion, rate);
  for (std::size_t i = 0; i < motion.size(); ++i) move(dynamics.bodies[i], motion[i], h, rate[i], motion[i]);
}

// Symplectic Euler: the momenta first, then p and R with the new velocities (errata 13).
//   K' = K + h F,  L' = L + h torque,  p' = p + h K'/m,  R' = the free rotation over h with L'
// Order 1.
void symplectic_euler(Dynamics& dynamics, Real time, Real h, std::vector<Motion>& motion, Workspace& work) {
  std::vector<Rate>& rate = work.rate[0];
  dynamics.rates(time, motion, rate);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    Motion& m = motion[i];
    const Body& body = dynamics.bodies[i];
    m.momentum += h * rate[i].force;
    m.position += h * velocity(body, m);
    if (!body.turns) continue;
    m.angular_momentum += h * rate[i].torque;
    m.orientation = free_rotation(body, m.orientation, m.angular_momentum, h, Splitting::lie);
  }
}

// Velocity Verlet: kick, drift, kick.
//   K_h = K + h/2 F(t),  L_h = L + h/2 torque(t)
//   p' = p + h K_h/m,    R' = the free body's rotation over h with L_h (free_rotation.h)
//   K' = K_h + h/2 F(t + h),  L' = L_h + h/2 torque(t + h)
// Where forces depend on velocities, those at t + h see the momenta predicted by K_h + h/2 F(t).
// Order 2.
void velocity_verlet(Dynamics& dynamics, Real time, Real h, std::vector<Motion>& motion, Workspace& work) {
  std::vector<Rate>& rate = work.rate[0];
  std::vector<Rate>& next = work.rate[1];
  dynamics.rates(time, motion, rate);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    Motion& m = motion[i];
    const Body& body = dynamics.bodies[i];
    m.momentum += h / 2 * rate[i].force;
    m.position += h * velocity(body, m);
    m.angular_momentum += h / 2 * rate[i].torque;
    if (body.turns)
      m.orientation = free_rotation(body, m.orientation, m.angular_momentum, h, Splitting::strang);
    work.stage[i] = m;
    work.stage[i].momentum += h / 2 * rate[i].force;
    work.stage[i].angular_momentum += h / 2 * rate[i].torque;
  }
  dynamics.rates(time + h, work.stage, next);
  for (std::size_t i = 0; i < motion.size(); ++i) {
    motion[i].momentum += h / 2 * next[i].force;
    motion[i].angular_momentum += h / 2 * next[i].torque;
  }
}

// Runge-Kutta 4, on the rotation group in the form of Munthe-Kaas: R = exp(u) R_0 with du/dt = dexp^-1_u w.
//   k1 = f(t, y)
//   k2 = f(t + h/2, y + h/2 k1),  k3 = f(t + h/2, y + h/2 k2),  k4 = f(t + h, y + h k3)
//   y' = y + h/6 (k1 + 2 k2 + 2 k3 + k4)
// with w_i in k_i replaced by dexp^-1_{u_i} w_i, u_i the turn that led to stage i.  H. Munthe-Kaas, High
// order Runge-Kutta methods on manifolds, Appl. Numer. Math. 29 (1999), section 3. Order 4.  Energy drifts by
// O(h^5) a step.
void rk4(Dynamics& dynamics, Real time, Real h, std::vector<Motion>& motion, Workspace& work) {
  auto& [k1, k2, k3, k4] = work.rate;
  const std::vector<Body>& bodies = dynamics.bodies;
  const auto stage = [&](Real dt, const std::vector<Rate>& from, std::vector<Rate>& to) {
    for (std::size_t i = 0; i < motion.size(); ++i) move(bodies[i], motion[i], dt, from[i], work.stage[i]);
    dynamics.rates(time + dt, work.stage, to);
    for (std::size_t i = 0; i < motion.size(); ++i) {
      if (bodies[i].turns)
        to[i].angular_velocity = inverse_dexp(dt * from[i].angular_velocity, to[i].angular_velocity);
    }
  };
  dynamics.rates(time, motion, k1);
  stage(h / 2, k1, k2);
  stage(h / 2, k2, k3);
  stage(h, k3, k4);

  const auto mean = [](const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) -> Vector3 {
    return (a + 2 * (b + c) + d) / 6;
  };
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const Rate k{
        mean(k1[i].velocity, k2[i].velocity, k3[i].velocity, k4[i].velocity),
        mean(k1[i].force, k2[i].force, k3[i].force, k4[i].force),
        mean(k1[i].angular_velocity, k2[i].angular_velocity, k3[i].angular_velocity, k4[i].angular_velocity),
        mean(k1[i].torque, k2[i].torque, k3[i].torque, k4[i].torque)};
    move(bodies[i], motion[i], h, k, motion[i]);
  }
}

constexpr Integrator table[] = {
    {"rk4", 4, "linear momentum to rounding; energy and angular momentum to O(h^4)", rk4},
    {"velocity-verlet", 2,
     "linear and angular momentum to rounding; energy bounded (symplectic) without damping, joints and "
     "impacts",
     velocity_verlet},
    {"symplectic-euler", 1,
     "linear and angular momentum to rounding; energy bounded (symplectic) without damping, joints and "
     "impacts",
     symplectic_euler},
    {"explicit-euler", 1, "linear momentum to rounding; energy grows", explicit_euler},
};

}  // namespace

Workspace::Workspace(const std::vector<Motion>& start) : stage(start) {
  for (auto& k : rate) k.resize(start.size());
}

std::span<const Integrator> integrators() { return table; }

const Integrator* find_integrator(std::string_view name) {
  for (const Integrator& row : table) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace cylon::engine
