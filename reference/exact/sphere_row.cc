// Smooth spheres in rows: centres on parallel lines, velocities that differ along the lines alone, so that
// every impact is central and nothing leaves its line.  Along a line, V the centre's velocity of a pair:
//
//     impact of a pair       x_b - x_a = r_a + r_b while w = u_b - u_a < 0
//     w' = -e w,   u_a' = V - m_b w'/(m_a + m_b),   u_b' = V + m_a w'/(m_a + m_b)
//
// one after another, earliest first; spheres that touch hand a blow on pair by pair (impacts "sequential").
// Gravity moves all alike.  Spheres whose groups keep them apart go through each other; all other pairs keep
// their order.  Domain: spheres, no plane, no friction, steady spins; a list of impacts that ends
// before the horizon, whose order no rounding decides.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/pieces.h"
#include "reference/exact/solutions.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace cylon::exact {
namespace {

constexpr auto name = "sphere_row";
constexpr std::size_t most_impacts = 20000;
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Wide slowest = 1e-16L;  // approaches slower than this share of the fastest ball are roundings

struct Ball {
  int body;
  Wide radius, mass, x, u, since;  // at x at the time `since`
  Flight across;                   // what the motion along the line leaves
  Track track;

  Wide at(Wide t) const { return x + u * (t - since); }
};

struct Impact {
  Wide time;
  int a, b;
  Wide kick_a, kick_b;
};

struct Rows {
  Course course;
  std::vector<Impact> impacts;
};

std::size_t index_of(int body) { return static_cast<std::size_t>(body); }

// The direction of the rows: of the largest difference of velocities; of the centres where nothing moves.
WideVector direction(const core::Scene& scene) {
  WideVector most = WideVector::Zero();
  for (const core::Body& body : scene.bodies) {
    const WideVector w = widen(body.initial.velocity) - widen(scene.bodies[0].initial.velocity);
    if (w.squaredNorm() > most.squaredNorm()) most = w;
  }
  if (most.isZero(0) && scene.bodies.size() > 1) {
    most = widen(scene.bodies[1].initial.position) - widen(scene.bodies[0].initial.position);
  }
  return most.isZero(0) ? WideVector(WideVector::UnitX()) : WideVector(most.normalized());
}

WideVector beside(const WideVector& d, const WideVector& x) { return x - d.dot(x) * d; }

Wide offset_between(const core::Scene& scene, const WideVector& d, int i, int j) {
  return beside(d, widen(scene.bodies[index_of(j)].initial.position) -
                       widen(scene.bodies[index_of(i)].initial.position))
      .norm();
}

double reach(const core::Scene& scene, int i, int j) {
  return colliding_radius(name, scene, i) + colliding_radius(name, scene, j);
}

// The spheres of each row from low x to high.
std::vector<std::vector<int>> rows_of(const core::Scene& scene, const WideVector& d) {
  std::vector<std::vector<int>> rows;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const auto row = std::ranges::find_if(rows, [&](const std::vector<int>& r) {
      return offset_between(scene, d, r[0], i) < reach(scene, r[0], i) / 2;
    });
    (row == rows.end() ? rows.emplace_back() : *row).push_back(i);
  }
  for (std::vector<int>& row : rows) {
    std::ranges::sort(row, {},
                      [&](int i) { return d.dot(widen(scene.bodies[index_of(i)].initial.position)); });
  }
  return rows;
}

Ball ball(const core::Scene& scene, const WideVector& d, int i) {
  const core::Body& body = scene.bodies[index_of(i)];
  Flight across(body.initial, common_gravity(scene));
  const Wide x = d.dot(across.position), u = d.dot(across.velocity);
  across.position -= x * d;
  across.velocity -= u * d;
  return {i, colliding_radius(name, scene, i), body.mass, x, u, 0, across, {}};
}

class Row {
 public:
  Row(const core::Scene& scene, const WideVector& d, const std::vector<int>& bodies) : scene_(scene), d_(d) {
    for (int i : bodies) balls_.push_back(ball(scene, d, i));
    for (Ball& b : balls_) go(b);
    find_pairs();
  }

  void run(Wide horizon, Rows& rows) {
    for (std::size_t count = 0;; ++count) {
      const auto [time, k] = next();
      if (!(time <= horizon * beyond)) break;
      if (count > most_impacts) refuse(name, "more than 20000 impacts of a row before the horizon");
      now_ = time;
      strike(k, rows);
    }
    for (Ball& b : balls_) rows.course.tracks[index_of(b.body)] = std::move(b.track);
  }

 private:
  struct Next {
    Wide time;
    std::size_t pair;
  };
  struct Couple {
    std::size_t low, high;  // of balls_, in the order along the line
    int hits = 0;
  };

  // Neighbours, between which all others are held; where groups keep pairs apart, every pair that meets.
  void find_pairs() {
    const core::ContactRules may_touch(scene_);
    const bool filtered = core::states_filters(scene_);
    for (std::size_t low = 0; low < balls_.size(); ++low) {
      const std::size_t end = filtered ? balls_.size() : std::min(low + 2, balls_.size());
      for (std::size_t high = low + 1; high < end; ++high)
        if (may_touch.bodies(balls_[low].body, balls_[high].body)) couples_.push_back({low, high});
    }
  }

  Next next() const {
    Next first = {std::numeric_limits<Wide>::infinity(), 0};
    Wide fastest = 0;
    for (const Ball& b : balls_) fastest = std::max(fastest, std::abs(b.u));
    for (std::size_t k = 0; k < couples_.size(); ++k) {
      const Ball &a = balls_[couples_[k].low], &b = balls_[couples_[k].high];
      const Wide closing = a.u - b.u, gap = b.at(now_) - a.at(now_) - (a.radius + b.radius);
      if (closing <= slowest * fastest) continue;
      const Wide time = now_ + std::max<Wide>(0, gap) / closing;
      if (time < first.time) first = {time, k};
    }
    return first;
  }

  void strike(std::size_t k, Rows& rows) {
    Ball &a = balls_[couples_[k].low], &b = balls_[couples_[k].high];
    const core::Pair pair = {std::min(a.body, b.body), std::max(a.body, b.body), -1};
    const auto material = core::material_of(scene_, pair);
    const Wide e = material ? material->restitution : 0, sum = a.mass + b.mass;
    const Wide after = e * (a.u - b.u), centre = (a.mass * a.u + b.mass * b.u) / sum;
    const bool swap = e == 1 && a.mass == b.mass;
    const Wide u_a = swap ? b.u : centre - b.mass / sum * after;
    const Wide u_b = swap ? a.u : centre + a.mass / sum * after;
    rows.impacts.push_back({now_, a.body, b.body, std::abs(u_a - a.u), std::abs(u_b - b.u)});
    const Wide middle = (a.at(now_) + a.radius + b.at(now_) - b.radius) / 2;
    a.x = middle - a.radius, a.u = u_a, a.since = now_;
    b.x = middle + b.radius, b.u = u_b, b.since = now_;
    go(a), go(b);
    if (after == 0) return;
    rows.course.events.push_back({.kind = core::EventKind::bounce,
                                  .pair = pair,
                                  .index = ++couples_[k].hits,
                                  .time = static_cast<double>(now_),
                                  .speed = static_cast<double>(after),
                                  .height = 0});
  }

  void go(Ball& b) {
    b.track.add(now_, [d = d_, across = b.across, x = b.x, u = b.u, start = now_](Wide s) {
      WideState state = across.at(start + s);
      state.position += (x + u * s) * d;
      state.velocity += u * d;
      return state;
    });
  }

  const core::Scene& scene_;
  const WideVector d_;
  std::vector<Ball> balls_;
  std::vector<Couple> couples_;
  Wide now_ = 0;
};

Rows solve(const core::Scene& scene, double horizon) {
  Rows rows;
  rows.course.tracks.resize(scene.bodies.size());
  const WideVector d = direction(scene);
  for (const std::vector<int>& row : rows_of(scene, d)) Row(scene, d, row).run(horizon, rows);
  return rows;
}

// What a row that is a little crooked makes of itself: an offset o turns the normal of an impact by o/R, and
// the kick with it.  The offsets are those of the scene with a rounding more where they are not zero.
void add_spread(const core::Scene& scene, const Rows& rows, double horizon, core::StateError& error) {
  struct Spread {
    Wide offset = 0, rate = 0, since = 0;
    Wide at(Wide t) const { return offset + rate * (t - since); }
  };
  const WideVector d = direction(scene);
  std::vector<Spread> spread(scene.bodies.size());
  for (const std::vector<int>& row : rows_of(scene, d)) {
    const core::BodyState& first = scene.bodies[index_of(row[0])].initial;
    for (int i : row) {
      const core::BodyState& s = scene.bodies[index_of(i)].initial;
      const Wide offset = offset_between(scene, d, row[0], i),
                 rate = beside(d, widen(s.velocity) - widen(first.velocity)).norm();
      if (offset > 1e-12L * colliding_radius(name, scene, i)) {
        refuse(name, named(scene, i) + " is not in line with " + named(scene, row[0]));
      }
      if (rate > 1e-12L * widen(s.velocity - first.velocity).norm()) {
        refuse(name, named(scene, i) + " does not move along the line");
      }
      spread[index_of(i)] = {offset == 0 ? 0 : offset + 4 * eps * s.position.norm(),
                             rate == 0 ? 0 : rate + 4 * eps * s.velocity.norm(), 0};
    }
  }
  // Rows keep apart: neither do they move across their lines against each other.
  const core::Vector3 whole = scene.bodies[0].initial.velocity;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const core::Vector3 against = scene.bodies[index_of(i)].initial.velocity - whole;
    if (beside(d, widen(against)).norm() > 1e-12L * widen(against).norm())
      refuse(name, named(scene, i) + " does not move along the lines of the others");
  }
  for (const Impact& hit : rows.impacts) {
    Spread &a = spread[index_of(hit.a)], &b = spread[index_of(hit.b)];
    const Wide turn = (a.at(hit.time) + b.at(hit.time)) / reach(scene, hit.a, hit.b);
    a = {a.at(hit.time), a.rate + hit.kick_a * turn, hit.time};
    b = {b.at(hit.time), b.rate + hit.kick_b * turn, hit.time};
  }
  double position = 0, velocity = 0;
  for (const Spread& s : spread) {
    position = std::max(position, static_cast<double>(s.at(std::max<Wide>(s.since, horizon))));
    velocity = std::max(velocity, static_cast<double>(s.rate));
  }
  error.position += position;
  error.velocity += velocity;
}

void check_starts_apart(const core::Scene& scene, const WideVector& d) {
  const core::ContactRules may_touch(scene);
  const int count = static_cast<int>(scene.bodies.size());
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < j; ++i) {
      if (!may_touch.bodies(i, j)) continue;
      const core::Vector3 apart =
          scene.bodies[index_of(j)].initial.position - scene.bodies[index_of(i)].initial.position;
      const double both = reach(scene, i, j);
      if (apart.norm() < both * (1 - 1e-12)) {
        refuse(name, named(scene, i) + " and " + named(scene, j) + " overlap at the start");
      }
      const Wide offset = offset_between(scene, d, i, j);
      if (offset > 1e-12L * both && offset < (1 + 1e-12L) * both) {
        refuse(name, named(scene, j) + " is not in line with " + named(scene, i));
      }
      if (offset < both) check_smooth(name, scene, {i, j, -1});
    }
  }
}

// Several impacts of one body at one instant.
void check_sequential(const core::Scene& scene, const std::vector<Impact>& impacts, double horizon) {
  if (scene.impacts == core::Impacts::sequential) return;
  for (std::size_t k = 1; k < impacts.size(); ++k) {
    const Impact &x = impacts[k - 1], &y = impacts[k];
    if (y.time - x.time <= 1e-12 * horizon && (x.a == y.a || x.a == y.b || x.b == y.a || x.b == y.b)) {
      refuse(name, "impacts at one instant are to be simultaneous, but it knows them one after another");
    }
  }
}

}  // namespace

core::Truth sphere_row(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  if (!scene.planes.empty()) refuse(name, "the scene has plane '" + scene.planes[0].name + "'");
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    colliding_radius(name, scene, i);
    check_steady_spin(name, scene, i, horizon);
  }
  check_starts_apart(scene, direction(scene));
  const Rows rows = solve(scene, horizon);
  check_sequential(scene, rows.impacts, horizon);
  core::Truth truth = truth_of(
      name, scene, [horizon](const core::Scene& s) { return solve(s, horizon).course; }, horizon,
      "Newton's restitution between central spheres, impact by impact");
  add_spread(scene, rows, horizon, truth.error);
  return truth;
}

}  // namespace cylon::exact
