// A cork in the seed's water, mode "step": below the surface of its cell,
//
//     h(t) = level + wave/2 (sin(speed t + i) + sin(i j/2)),  i = trunc((x + 5)/0.25),  j = trunc((z +
//     5)/0.25)
//
// act a lift b and a drag -gamma v, above it weight alone: pieces of linear_motion.h's equation, joined where
// F = y - h = 0.  A piece ends at the first zero of F.  No zero is passed over: with |F''| <= A on the piece,
// F keeps its sign for at least
//
//     tau = (f' + sqrt(f'^2 + 2 A |F|))/A,  f' the rate at which |F| grows,
//
// and these steps approach the first zero from one side, where Newton's method finishes.  A cork that only
// grazes the surface has no such zero and is refused.
// Domain: bodies that start at rest sideways above or below the table's cells, without spin; gravity vertical
// or none; one water of mode "step"; at most 100000 crossings.
#include "reference/exact/domain.h"
#include "reference/exact/exponential.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

#include <algorithm>

namespace cylon::exact {
namespace {

constexpr auto name = "water_step_force";

struct Height {
  Wide y, rate;
};

// Between two crossings: y'' = a - b y' from the state at `start`.
struct Piece {
  Wide start, y, rate, push, drag;

  Height at(Wide t) const {
    const Wide past = t - start;
    const Wide slide = exponential_difference(0, -drag, past).real();
    return {y + rate * slide + push * exponential_difference(0, 0, -drag, past).real(),
            rate * std::exp(-drag * past) + push * slide};
  }

  // |y''| <= |a - b y'|, which decays.
  Wide hardest() const { return std::abs(push - drag * rate); }
};

class Cork {
 public:
  Cork(const core::Scene& scene, std::size_t index, double horizon) {
    const core::Body& body = scene.bodies[index];
    start_ = {widen(body.initial.position), WideVector::Zero(), WideVector::Zero(),
              widen(body.initial.orientation)};
    for (const core::Force& force : scene.forces) {
      if (const auto* water = std::get_if<core::Water>(&force)) water_ = *water;
    }
    const auto cell = [](double x) { return std::trunc((x + 5) / 0.25); };
    const Wide i = cell(body.initial.position.x()), j = cell(body.initial.position.z());
    phase_ = i;
    level_ = Wide(water_.level) + Wide(water_.wave) / 2 * std::sin(i * j / 2);
    fall_ = common_gravity(scene).y();
    lift_ = Wide(water_.buoyancy) / body.mass, drag_ = Wide(water_.drag) / body.mass;
    Height here = {start_.position.y(), body.initial.velocity.y()};
    Wide t = 0;
    Height above = over(here, 0);
    bool under = above.y < 0 || (above.y == 0 && above.rate < 0);
    while (pieces_.size() < most && !grazes_) {
      pieces_.push_back({t, here.y, here.rate, fall_ + (under ? lift_ : 0), under ? drag_ : 0});
      t = next_crossing(t, under ? -1 : 1, horizon);
      if (t >= horizon) return;
      here = pieces_.back().at(t);
      under = !under;
    }
  }

  bool grazes() const { return grazes_; }
  bool ends() const { return pieces_.size() < most; }

  WideState at(Wide t) const {
    const auto after = std::upper_bound(pieces_.begin() + 1, pieces_.end(), t,
                                        [](Wide time, const Piece& piece) { return time < piece.start; });
    const Height h = (after - 1)->at(t);
    WideState s = start_;
    s.position.y() = h.y;
    s.velocity.y() = h.rate;
    return s;
  }

 private:
  static constexpr std::size_t most = 100000;
  // Crossings slower than this are not told from a touch [m/s]: F is rounding within its square.
  static constexpr Wide slowest = 1e-6L;

  Height over(const Height& h, Wide t) const {
    const Wide half = Wide(water_.wave) / 2, angle = Wide(water_.speed) * t + phase_;
    return {h.y - level_ - half * std::sin(angle), h.rate - half * Wide(water_.speed) * std::cos(angle)};
  }

  // After t, while side F > 0; the horizon or more where there is none up to it.
  Wide next_crossing(Wide t, Wide side, Wide horizon) {
    const Piece& piece = pieces_.back();
    const Wide speed = water_.speed, bend = piece.hardest() + std::abs(Wide(water_.wave)) / 2 * speed * speed;
    // At a crossing F is rounding; what it is worth there is its rate.
    Height f = over(piece.at(t), t);
    Wide distance = piece.start > 0 ? 0 : std::max<Wide>(0, side * f.y);
    const Wide scale =
        1e-17L * (std::abs(level_) + std::abs(Wide(water_.wave)) + std::abs(piece.y) + std::abs(piece.rate));
    for (int i = 0; i < 1000; ++i) {
      const Wide grows = side * f.rate;
      const Wide root = std::sqrt(grows * grows + 2 * bend * distance);
      if (bend == 0 && grows >= 0) return horizon;
      // (grows + root)/bend, without cancelling where it shrinks.
      const Wide safe = grows > 0 ? (grows + root) / bend : 2 * distance / (root - grows);
      if (!(root > slowest)) break;
      t += safe;
      if (t >= horizon) return t;
      f = over(piece.at(t), t);
      distance = std::max<Wide>(0, side * f.y);
      if (distance <= scale && side * f.rate < -slowest) return t - f.y / f.rate;
    }
    grazes_ = true;
    return horizon;
  }

  WideState start_;
  core::Water water_;
  Wide phase_ = 0, level_ = 0, fall_ = 0, lift_ = 0, drag_ = 0;
  std::vector<Piece> pieces_;
  bool grazes_ = false;
};

std::function<core::State(double)> solve(const core::Scene& scene, double horizon) {
  std::vector<Cork> corks;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) corks.emplace_back(scene, i, horizon);
  return together(std::move(corks));
}

void check_corks(const core::Scene& scene, double horizon) {
  int waters = 0;
  for (const core::Force& force : scene.forces) {
    const auto* water = std::get_if<core::Water>(&force);
    if (!water) continue;
    if (++waters > 1) refuse(name, "the scene has two waters");
    if (water->mode != "step") refuse(name, "the water is not of mode 'step'");
  }
  if (waters == 0) refuse(name, "the scene has no water");
  const core::Vector3 g = common_gravity(scene);
  if (g.x() != 0 || g.z() != 0) refuse(name, "gravity is not vertical");
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::BodyState& s = scene.bodies[i].initial;
    const std::string of = named(scene, static_cast<int>(i));
    if (s.velocity.x() != 0 || s.velocity.z() != 0) refuse(name, of + " moves sideways");
    if (!s.angular_velocity.isZero(0.0)) refuse(name, of + " turns");
    if (!(std::abs(s.position.x()) < 5 && std::abs(s.position.z()) < 5))
      refuse(name, of + " is off the water");
    const Cork cork(scene, i, horizon);
    if (cork.grazes()) refuse(name, of + " grazes the surface");
    if (!cork.ends()) refuse(name, of + " crosses the surface more than 100000 times");
  }
}

}  // namespace

core::Truth water_step_force(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "water"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  check_corks(scene, horizon);
  return {.state = solve(scene, horizon),
          .error = rounding_error(
              scene, [horizon](const core::Scene& s) { return solve(s, horizon); }, horizon),
          .source = "free fall and linear drag by turns, joined at the crossings of the surface",
          .horizon = horizon};
}

}  // namespace cylon::exact
