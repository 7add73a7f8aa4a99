// Two bodies that attract each other, F = strength m_a m_b/d^2 (Kepler).  d from the first to the second
// moves as about a fixed centre of mu = strength (m_a + m_b), or strength m of a locked body; by universal
// variables, for every conic (Stiefel & Scheifele; dt = r ds, beta = 2 mu/r0 - v0^2, eta = d0.v0):
//
//     t = r0 G1 + eta G2 + mu G3,   r = r0 G0 + eta G1 + mu G2
//     d = (1 - mu G2/r0) d0 + (t - mu G3) d0',   d' = -mu G1/(r r0) d0 + (1 - mu G2/r) d0'
//     G0 = cos(w s), G1 = sin(w s)/w, G2 = (1 - cos(w s))/beta, G3 = (s - G1)/beta,  w^2 = beta, any sign
//
// Kepler's equation is monotone, dt/ds = r > 0: Newton's method in a bracket goes on until the bracket or the
// step is at its last digit, and what it leaves is a shift of time by that much.
// Domain: two bodies, one attraction between them, not both locked; gravity (none if one is locked); not
// aimed at each other, spins steady, no contact or joint.
#include "reference/exact/domain.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/steady_spin.h"

#include <numbers>

namespace cylon::exact {
namespace {

constexpr auto name = "kepler";

// G0 … G3 of s.
struct Universal {
  Wide g0, g1, g2, g3;

  Universal(Wide beta, Wide s) {
    const Wide z = beta * s * s;
    if (std::abs(z) < 1) {  // c_n = sum (-z)^k/(n + 2 k)!, without 1 - cos and s - sin
      Wide c2 = 0, c3 = 0, term2 = 0.5L, term3 = 1.0L / 6;
      for (int k = 1; k <= 12; ++k) {
        c2 += term2, c3 += term3;
        term2 *= -z / static_cast<Wide>((2 * k + 1) * (2 * k + 2));
        term3 *= -z / static_cast<Wide>((2 * k + 2) * (2 * k + 3));
      }
      g2 = s * s * c2, g3 = s * s * s * c3;
      g1 = s - beta * g3, g0 = 1 - beta * g2;
      return;
    }
    const Wide w = std::sqrt(std::abs(beta)), half = beta > 0 ? std::sin(w * s / 2) : std::sinh(w * s / 2);
    g0 = beta > 0 ? std::cos(w * s) : std::cosh(w * s);
    g1 = (beta > 0 ? std::sin(w * s) : std::sinh(w * s)) / w;
    g2 = 2 * half * half / std::abs(beta);
    g3 = (s - g1) / beta;
  }
};

class Conic {
 public:
  Conic(const WideVector& d, const WideVector& v, Wide mu)
      : d_(d), v_(v), mu_(mu), r_(d.norm()), eta_(d.dot(v)), beta_(2 * mu / r_ - v.squaredNorm()) {
    if (beta_ > 0) {
      turn_ = 2 * std::numbers::pi_v<Wide> / std::sqrt(beta_);
      period_ = turn_ * mu / beta_;
    }
  }

  /// Position and velocity of the second body seen from the first.
  std::pair<WideVector, WideVector> at(Wide t) const {
    const Wide laps = beta_ > 0 ? std::floor(t / period_) : 0;
    t -= laps * period_;
    const Wide s = solve(t);
    const Universal g(beta_, s);
    const Wide r = r_ * g.g0 + eta_ * g.g1 + mu_ * g.g2;
    return {(1 - mu_ * g.g2 / r_) * d_ + (r_ * g.g1 + eta_ * g.g2) * v_,
            -mu_ * g.g1 / (r * r_) * d_ + (1 - mu_ * g.g2 / r) * v_};
  }

 private:
  // The root of r0 G1 + eta G2 + mu G3 = t, t >= 0.
  Wide solve(Wide t) const {
    const auto excess = [&](const Universal& g) { return r_ * g.g1 + eta_ * g.g2 + mu_ * g.g3 - t; };
    Wide low = 0, high = beta_ > 0 ? turn_ : t / r_;
    while (beta_ <= 0 && excess(Universal(beta_, high)) < 0) high *= 2;
    Wide s = beta_ > 0 ? turn_ * (t / period_) : std::min(high, t / r_);
    for (int i = 0; i < 200; ++i) {
      const Universal g(beta_, s);
      const Wide f = excess(g), r = r_ * g.g0 + eta_ * g.g1 + mu_ * g.g2;
      if (f == 0) return s;
      (f > 0 ? high : low) = s;
      Wide next = s - f / r;
      if (!(low <= next && next <= high)) next = low + (high - low) / 2;
      if (next == s || std::abs(next - s) <= 1e-19L * s) return next;
      s = next;
    }
    return s;
  }

  WideVector d_, v_;
  Wide mu_, r_, eta_, beta_, turn_ = 0, period_ = 0;
};

struct Pair {
  const core::Attraction* force = nullptr;
  std::size_t a = 0, b = 0;
};

Pair pair_of(const core::Scene& scene) {
  Pair pair;
  for (const core::Force& force : scene.forces) {
    const auto* attraction = std::get_if<core::Attraction>(&force);
    if (!attraction) continue;
    if (pair.force) refuse(name, "the scene has two attractions");
    pair = {attraction, static_cast<std::size_t>(attraction->body), static_cast<std::size_t>(attraction->to)};
  }
  if (!pair.force) refuse(name, "the scene has no attraction");
  return pair;
}

// The first body takes the share -m_b/M of the relative motion, the second m_a/M; a locked one none of it.
class TwoBodies {
 public:
  explicit TwoBodies(const core::Scene& scene)
      : pair_(pair_of(scene)), gravity_(widen(common_gravity(scene))), conic_(make(scene, pair_)) {
    const core::Body &a = scene.bodies[pair_.a], &b = scene.bodies[pair_.b];
    const Wide total = Wide(a.mass) + Wide(b.mass);
    share_a_ = a.locked ? 0 : b.locked ? 1 : b.mass / total;
    share_b_ = 1 - share_a_;
    centre_ = share_b_ * widen(a.initial.position) + share_a_ * widen(b.initial.position);
    drift_ = share_b_ * velocity_of(a) + share_a_ * velocity_of(b);
    for (std::size_t i = 0; i < 2; ++i) spins_.emplace_back(scene, i);
    for (std::size_t i = 0; i < 2; ++i) locked_[i] = scene.bodies[i].locked;
    if (locked_[0] || locked_[1]) gravity_.setZero();
  }

  core::State at(double time) const {
    const Wide t = time;
    const auto [d, v] = conic_.at(t);
    const WideVector centre = centre_ + t * (drift_ + t * gravity_ / 2), drift = drift_ + t * gravity_;
    core::State state(2);
    const auto set = [&, &d = d, &v = v](std::size_t i,
                                         Wide share) {  // clang 14 captures no binding by itself
      WideState s;
      s.position = centre + share * d;
      s.velocity = drift + share * v;
      spins_[i].turn(s, locked_[i] ? 0 : t);
      if (locked_[i]) s.velocity.setZero(), s.angular_velocity.setZero();
      state[i] = narrow(s);
    };
    set(pair_.a, -share_a_);
    set(pair_.b, share_b_);
    return state;
  }

 private:
  static WideVector velocity_of(const core::Body& body) {
    return body.locked ? WideVector(0, 0, 0) : widen(body.initial.velocity);
  }

  static Conic make(const core::Scene& scene, const Pair& pair) {
    const core::Body &a = scene.bodies[pair.a], &b = scene.bodies[pair.b];
    const Wide mass = (b.locked ? 0 : Wide(a.mass)) + (a.locked ? 0 : Wide(b.mass));
    const Wide source = a.locked ? a.mass : b.locked ? b.mass : mass;
    return Conic(widen(b.initial.position) - widen(a.initial.position), velocity_of(b) - velocity_of(a),
                 Wide(pair.force->strength) * source);
  }

  Pair pair_;
  WideVector gravity_, centre_, drift_;
  Wide share_a_ = 0, share_b_ = 0;
  Conic conic_;
  std::vector<SteadySpin> spins_;
  bool locked_[2] = {false, false};
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  return [bodies = TwoBodies(scene)](double t) { return bodies.at(t); };
}

void check_pair(const core::Scene& scene, double horizon) {
  if (scene.bodies.size() != 2) refuse(name, "the scene must have two bodies");
  const Pair pair = pair_of(scene);
  const core::Body &a = scene.bodies[pair.a], &b = scene.bodies[pair.b];
  if (a.locked && b.locked) refuse(name, "both bodies are locked");
  if ((a.locked || b.locked) && !common_gravity(scene).isZero(0.0)) {
    refuse(name, "the scene has gravity and a locked body");
  }
  if (!(pair.force->strength > 0)) refuse(name, "the attraction has no strength");
  for (int i : {0, 1}) {
    if (!scene.bodies[static_cast<std::size_t>(i)].locked) check_steady_spin(name, scene, i, horizon);
  }
  const core::Vector3 zero(0, 0, 0),
      d = b.initial.position - a.initial.position,
      v = (b.locked ? zero : b.initial.velocity) - (a.locked ? zero : a.initial.velocity);
  // Passes the centre at r = l^2/(mu (1 + e)) >= l^2/(2 mu + r v^2): a thousandth of a thousandth of r0.
  if (d.cross(v).squaredNorm() <=
      1e-12 * d.norm() * (2 * pair.force->strength * (a.mass + b.mass) + d.norm() * v.squaredNorm())) {
    refuse(name, named(scene, static_cast<int>(pair.b)) + " moves through " +
                     named(scene, static_cast<int>(pair.a)) + " or too near it");
  }
}

}  // namespace

core::Truth kepler(const core::Scene& scene, double horizon) {
  core::Scene unlocked = scene;
  for (core::Body& body : unlocked.bodies) body.locked = false;
  check_bodies(name, unlocked, horizon);
  check_forces(name, scene, {"gravity", "attraction"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  check_pair(scene, horizon);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source =
              "Stiefel & Scheifele, Linear and Regular Celestial Mechanics, section 11: universal variables",
          .horizon = horizon};
}

}  // namespace cylon::exact
