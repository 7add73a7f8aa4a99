// Smooth spheres over one plane.  Along the normal, with G = -g.n, the gap h and its rate u:
//
//     t_1 = (u0 + sqrt(u0^2 + 2 G h0))/G,  U = sqrt(u0^2 + 2 G h0)            the first impact and its speed
//     t_n = t_1 + (2 U/G) (e + e^2 + … + e^(n-1)),  u_n = e^n U               after it (Zeno's sum)
//     apex n: t_n + u_n/G, height u_n^2/(2G);  from t_1 + (2 U/G) e/(1 - e) on the sphere rests
//
// Along the plane the motion is uniform, or falls where the plane is inclined.  Domain: spheres that start
// outside, gravity into the plane, no friction, steady spins, too far apart sideways to meet or in groups that do not.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/solutions.h"

#include <algorithm>
#include <limits>

namespace cylon::exact {
namespace {

constexpr auto name = "bouncing_sphere";
constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Wide shortest_flight = 1e-9L;  // [s]; no events are listed after it, on the way to rest

// The gap of one sphere.
struct Bounces {
  Wide pull = 1, gap = 0, rate = 0, restitution = 0;  // G, h0, u0, e
  Wide impact = 0, first = 0, rest = 0;               // U, t_1, and the time from which the sphere rests

  Bounces(Wide pull_, Wide gap_, Wide rate_, Wide restitution_)
      : pull(pull_), gap(gap_), rate(rate_), restitution(restitution_) {
    impact = std::sqrt(rate * rate + 2 * pull * gap);
    first = rate > 0 ? (rate + impact) / pull : gap == 0 ? 0 : 2 * gap / (impact - rate);
    rest = restitution < 1 ? first + 2 * impact / pull * restitution / (1 - restitution)
                           : std::numeric_limits<Wide>::infinity();
    if (impact == 0) rest = 0;
  }

  // e^n U; n = 0 is the impact itself.
  Wide speed(long n) const { return impact * std::pow(restitution, static_cast<Wide>(n)); }

  Wide time(long n) const {
    const Wide loss = 1 - restitution, terms = static_cast<Wide>(n - 1);
    const Wide sum = loss == 0 ? terms : -restitution * std::expm1(terms * std::log1p(-loss)) / loss;
    return first + 2 * impact / pull * (n == 1 ? 0 : sum);
  }

  // Bounces up to t < rest, for t >= first: t_n <= t solved for n, then put right by one.
  long count(Wide t) const {
    const Wide loss = 1 - restitution, flights = (t - first) * pull / (2 * impact);
    const Wide n = loss == 0 ? flights : std::log1p(-flights * loss / restitution) / std::log1p(-loss);
    long guess = std::max(1L, 1 + static_cast<long>(std::floor(n)));
    while (guess > 1 && time(guess) > t) --guess;
    while (time(guess + 1) <= t && time(guess + 1) > time(guess)) ++guess;  // the sum saturates near rest
    return guess;
  }

  struct GapState {
    Wide gap, rate;
  };

  GapState at(Wide t) const {
    if (t >= rest) return {0, 0};
    if (t < first) return {gap + rate * t - pull * t * t / 2, rate - pull * t};
    const long n = count(t);
    const Wide s = t - time(n), u = speed(n);
    return {std::max<Wide>(0, u * s - pull * s * s / 2), u - pull * s};
  }
};

struct Sphere {
  Flight flight;  // gravity along the plane alone
  WideVector normal;
  Bounces bounces;

  WideState at(Wide t) const {
    WideState s = flight.at(t);
    const auto [gap, rate] = bounces.at(t);
    s.position += (gap - bounces.gap - bounces.rate * t) * normal;
    s.velocity += (rate - bounces.rate) * normal;
    return s;
  }
};

void list_events(const Bounces& b, const core::Pair& pair, double horizon, std::vector<core::Event>& events) {
  const auto apex = [&](int index, Wide start, Wide low, Wide u) {
    const Wide t = start + u / b.pull;
    if (t > horizon) return;
    events.push_back({.kind = core::EventKind::apex,
                      .pair = pair,
                      .index = index,
                      .time = static_cast<double>(t),
                      .speed = 0,
                      .height = static_cast<double>(low + u * u / (2 * b.pull))});
  };
  constexpr std::size_t most_events = 1'000'000;
  if (b.rate > 0) apex(0, 0, b.gap, b.rate);
  for (int n = 1; b.impact > 0; ++n) {
    const Wide t = b.time(n), u = b.speed(n);
    if (t > horizon || 2 * u / b.pull < shortest_flight) break;
    if (events.size() > most_events) refuse(name, "more than 1000000 events before the horizon");
    events.push_back({.kind = core::EventKind::bounce,
                      .pair = pair,
                      .index = n,
                      .time = static_cast<double>(t),
                      .speed = static_cast<double>(u),
                      .height = 0});
    apex(n, t, 0, u);
  }
}

// Roundings: of h0 by dh = eps (|p| + |offset| + r) move t_1 by dh/U and every later flight, 2 e^n U/G long,
// by a share G dh/U^2; of e^n by a share n eps, n weighted by e^n at most 1/(1 - e).  Velocities hold away
// from the impacts by `time`.
core::StateError bound(const Bounces& b, const core::Body& body, const core::Plane& plane, double radius,
                       const core::Vector3& g, double horizon) {
  const double dh = 8 * eps * (body.initial.position.norm() + std::abs(plane.offset) + radius);
  const double pull = static_cast<double>(b.pull), impact = static_cast<double>(b.impact);
  const double flights = impact > 0 ? 1 + horizon * pull / (2 * impact) : 1;
  const double loss = 1 - static_cast<double>(b.restitution);
  const double bounces = loss * flights < 1 ? flights : 1 / loss;
  const double fast = body.initial.velocity.norm() + impact + g.norm() * horizon;
  const double spin = body.initial.angular_velocity.norm();
  core::StateError error;
  if (impact > 0)
    error.time = 8 * eps * (2 + bounces) * horizon + dh * (1 / impact + horizon * pull / (impact * impact));
  error.position = dh + impact * error.time + 8 * eps * fast * horizon;
  error.velocity = 2 * pull * error.time + 8 * eps * fast * (1 + bounces);
  error.orientation = 8 * eps * (1 + spin * horizon);
  error.angular_velocity = 8 * eps * spin;
  return error;
}

// Two spheres keep off each other when their paths along the plane do: gravity moves both alike, so the
// distance is that of two points in uniform motion.
void check_apart(const core::Scene& scene, const core::Vector3& normal, int i, int j, double horizon) {
  const core::BodyState& a = scene.bodies[static_cast<std::size_t>(i)].initial;
  const core::BodyState& b = scene.bodies[static_cast<std::size_t>(j)].initial;
  const auto along = [&](const core::Vector3& x) -> core::Vector3 { return x - normal * normal.dot(x); };
  const core::Vector3 d = along(b.position - a.position), w = along(b.velocity - a.velocity);
  const double closest = w.isZero(0.0) ? 0 : std::clamp(-d.dot(w) / w.squaredNorm(), 0.0, horizon);
  if ((d + w * closest).norm() <= colliding_radius(name, scene, i) + colliding_radius(name, scene, j)) {
    refuse(name, named(scene, i) + " may touch " + named(scene, j));
  }
}

// The one plane that a sphere touches.
int plane_of(const core::Scene& scene, const core::ContactRules& may_touch, int body) {
  if (scene.planes.empty()) refuse(name, "the scene must have one plane, or one for each body");
  int found = -1;
  for (int p = 0; p < static_cast<int>(scene.planes.size()); ++p) {
    if (!may_touch.body_and_plane(body, p)) continue;
    if (found >= 0) refuse(name, named(scene, body) + " touches more than one plane");
    found = p;
  }
  if (found < 0) check_meets(name, scene, may_touch, {body, core::world, 0});
  return found;
}

}  // namespace

core::Truth bouncing_sphere(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  const core::Vector3 g = common_gravity(scene);
  const core::ContactRules may_touch(scene);
  core::Truth truth;
  std::vector<Sphere> spheres;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    const core::Body& body = scene.bodies[static_cast<std::size_t>(i)];
    const double r = colliding_radius(name, scene, i);
    check_steady_spin(name, scene, i, horizon);
    const core::Pair pair = {i, core::world, plane_of(scene, may_touch, i)};
    const core::Plane& plane = scene.planes[static_cast<std::size_t>(pair.plane)];
    const WideVector normal = widen(plane.normal).normalized();
    const Wide pull = -normal.dot(widen(g));
    if (!(pull > 0)) refuse(name, "gravity does not point into plane '" + plane.name + "'");
    for (int j = 0; j < i; ++j) {
      if (!may_touch.bodies(j, i)) continue;
      if (plane_of(scene, may_touch, j) != pair.plane)
        refuse(name, named(scene, j) + " may touch " + named(scene, i) + ", which bounces on another plane");
      check_apart(scene, plane.normal, j, i, horizon);
    }
    const auto material = core::material_of(scene, pair);
    if (!material) refuse(name, "no material is given for " + named(scene, i) + " and the plane");
    if (material->friction != 0) refuse(name, "friction of " + named(scene, i) + " is not zero");
    Wide gap = normal.dot(widen(body.initial.position)) - Wide(plane.offset) - Wide(r);
    if (gap < -1e-12L * r) refuse(name, named(scene, i) + " starts inside the plane");
    gap = std::max<Wide>(0, gap);
    Flight along(body.initial, g);
    along.acceleration += pull * normal;
    spheres.push_back({along, normal, Bounces(pull, gap, normal.dot(along.velocity), material->restitution)});
    list_events(spheres.back().bounces, pair, horizon, truth.events);
    if (material->restitution > 0)  // its bounces have no end
      truth.events_until = std::min(truth.events_until, static_cast<double>(spheres.back().bounces.rest));
    const core::StateError e = bound(spheres.back().bounces, body, plane, r, g, horizon);
    truth.error = {.position = std::max(truth.error.position, e.position),
                   .velocity = std::max(truth.error.velocity, e.velocity),
                   .orientation = std::max(truth.error.orientation, e.orientation),
                   .angular_velocity = std::max(truth.error.angular_velocity, e.angular_velocity),
                   .time = std::max(truth.error.time, e.time)};
  }
  std::stable_sort(truth.events.begin(), truth.events.end(),
                   [](const core::Event& a, const core::Event& b) { return a.time < b.time; });
  truth.state = together(std::move(spheres));
  truth.source = "Newton's restitution between parabolas; the geometric sum of the flights";
  truth.horizon = horizon;
  return truth;
}

}  // namespace cylon::exact
