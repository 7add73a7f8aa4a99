#include "harness/hunt/course.h"

#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cylon::hunt {
namespace {

constexpr double falls = 0.75,
                 falls_in_the_end = 0.9;  // what is left of a fault; of an error of first order 1/2
constexpr double misjudged = 10;          // an engine's estimate of its error may be too small by this
constexpr double small = 0.05;            // of the scale: where an order shows
constexpr std::size_t in_a_row = 3;       // halvings that fall too little
constexpr double left_of_none = 0.5;      // after three halvings; of an error of first order 1/8
constexpr double beyond_any_order = 4;    // powers of two more than the order
constexpr double least_promise = 1e-9;    // of the scale: rounding, and the scale's own

constexpr std::pair<Kind, std::string_view> names[] = {
    {Kind::every_step, "at every step"},
    {Kind::own_promise, "more than the engine's own promise"},
    {Kind::coarse_step, "at the coarse step alone"},
    {Kind::fine_step, "at fine steps alone"},
    {Kind::slow, "until steps are far finer"},
    {Kind::erratic, "with no order"}};

}  // namespace

std::string_view name(Kind kind) { return names[static_cast<std::size_t>(kind)].second; }

std::optional<Kind> kind_from(std::string_view word) {
  for (const auto& [kind, name] : names)
    if (word == name) return kind;
  return std::nullopt;
}

double Course::held_to(const study::Promise& promise) {
  return misjudged * std::max(least_promise, misjudged * promise.tolerance);
}

bool Course::rises(const std::array<double, halvings>& measured, double allowed) {
  const double last = measured[halvings - 1], before = measured[halvings - 2];
  return !(measured[0] > 10 * allowed) && before > 10 * allowed && last > 10 * allowed &&
         last > falls_in_the_end * before;
}

double Course::least_part() const {
  return *std::min_element(measured_.begin(), measured_.begin() + static_cast<std::ptrdiff_t>(count_)) *
         relative_ / allowed_;
}

bool Course::may_be_saturated() const {
  return every_step_ && allowed_ > 0 && count_ == halvings && std::isfinite(measured_[halvings - 1]) &&
         least_part() > small;
}

bool Course::falls_at_last(double at_a_64th) const {
  constexpr double falls_twice = falls_in_the_end * falls_in_the_end;  // from dt/16
  return at_a_64th < falls_twice * measured_[halvings - 1];
}

void Course::not_promised(int order) {
  if (expected_.promise.adaptive || order < expected_.promise.order)
    expected_.smooth = own_promise_ = coarse_step_ = false;
}

void Course::add(double measured, double allowed, double truth_error) {
  measured_[count_++] = measured, allowed_ = allowed;
  every_step_ = every_step_ && keeps_every_step();
  own_promise_ = own_promise_ && keeps_own_promise(truth_error);
  coarse_step_ = coarse_step_ && keeps_coarse_step();
}

bool Course::keeps_every_step() const {
  const double now = measured_[count_ - 1];
  if (std::isnan(now)) return true;
  if (!(now > 10 * allowed_)) return false;
  return count_ == 1 || !(left() < (count_ < halvings ? falls : falls_in_the_end));
}

bool Course::keeps_own_promise(double truth_error) const {
  const double now = measured_[count_ - 1], scale = allowed_ / relative_;
  if (!expected_.smooth || !(scale > 0) || !std::isfinite(now)) return false;
  const study::Promise& promise = expected_.promise;
  if (promise.adaptive) return now > held_to(promise) * scale + 2 * truth_error;
  if (promise.order < 2) return false;
  if (count_ == 1) return now < small * scale && now > expected_.rounding * scale;
  const std::size_t last = halvings - in_a_row;
  return now > expected_.rounding * scale + 2 * truth_error &&
         (count_ - 1 < last || left() > std::exp2(0.5 - promise.order));
}

bool Course::keeps_coarse_step() const {
  const double now = measured_[count_ - 1];
  if (!expected_.smooth || !expected_.resolved || !std::isfinite(now)) return false;
  if (relative_ > 0 && now > allowed_ / relative_) return false;
  const bool shows = now > 10 * allowed_;
  if (count_ == 1) return shows;
  if (measured_[count_ - 2] <= allowed_) return now <= allowed_;  // gone before
  if (shows) return count_ == 2;
  return now <= allowed_ && left() < std::exp2(-expected_.promise.order - beyond_any_order);
}

bool Course::is_erratic() const {
  if (!may_be_erratic() || count_ < halvings) return false;
  const double at_last = std::max(measured_[halvings - 2], measured_[halvings - 1]);
  return at_last > 10 * allowed_ && at_last > left_of_none * std::max(measured_[0], measured_[1]);
}

std::optional<Kind> Course::fault() const {
  if (every_step_) return Kind::every_step;
  if (own_promise_) return Kind::own_promise;
  if (coarse_step_) return Kind::coarse_step;
  if (is_erratic()) return Kind::erratic;
  return std::nullopt;
}

// ---- Rates ------------------------------------------------------------------------------------------------

namespace {

using core::Body;

constexpr double most_turn = 3;  // [rad] in a step, of a spin that nothing turns: less than half a turn
constexpr double most_precession = 0.3;  // [rad] of any other
constexpr double most_rate = 0.3;        // of decays and oscillations, times the step

struct Rates {
  std::vector<double> squares, decays;  // of each body [1/s^2], [1/s]
  bool known = true;
};

// 1/m + r^2/I of what acts at an anchor.
double compliance(const Body& body, const core::Vector3& anchor) {
  if (body.locked) return 0;
  return 1 / body.mass + anchor.squaredNorm() / core::principal_axes(body.inertia).moments.minCoeff();
}

void add(const core::Scene& scene, const core::Force& force, Rates& rates) {
  const auto at = [](int body) { return static_cast<std::size_t>(body); };
  const auto mass_of = [&](int body) { return scene.bodies[at(body)].mass; };
  std::visit(core::Overloaded{[](const core::UniformGravity&) {},
                              [&](const core::Spring& s) {
                                const auto end = [&](int body, const core::Vector3& anchor) {
                                  if (body == core::world) return;
                                  const double c = compliance(scene.bodies[at(body)], anchor);
                                  rates.squares[at(body)] += 2 * s.stiffness * c,
                                      rates.decays[at(body)] += 2 * s.damping * c;
                                };
                                end(s.body, s.anchor), end(s.to, s.to_anchor);
                              },
                              [&](const core::Drag& d) {
                                const double least =
                                    core::principal_axes(scene.bodies[at(d.body)].inertia).moments.minCoeff();
                                rates.decays[at(d.body)] +=
                                    d.linear / mass_of(d.body) + d.angular / least + d.momentum;
                              },
                              [&](const core::Thrust& t) { rates.known = rates.known && t.mass_rate == 0; },
                              [&](const core::Drive& d) { rates.decays[at(d.body)] += d.frequency; },
                              [&](const core::Attraction&) { rates.known = false; },
                              [&](const core::Water&) { rates.known = false; },
                              [&](const core::PluginForce&) { rates.known = false; }},
             force);
}

// Joints carry up to the weight W of all that moves: a body that hangs by an arm r swings under it as a pendulum under the
// tension W, at the square rate (W/r) (1/m + r^2/I).
void add(const core::Scene& scene, const core::Joint& joint, Rates& rates) {
  double weight = 0;
  for (const Body& body : scene.bodies)
    if (!body.locked) weight += body.mass * core::gravity_of(scene, body).norm();
  for (const int end : {joint.body, joint.to}) {
    if (end == core::world) continue;
    const auto i = static_cast<std::size_t>(end);
    const Body& body = scene.bodies[i];
    const double arm = (joint.point - body.initial.position).norm();
    if (arm > 0) rates.squares[i] += weight / arm * compliance(body, core::Vector3(arm, 0, 0));
  }
}

}  // namespace

std::optional<bool> resolves(const Trial& trial) {
  const core::Scene& scene = trial.scene;
  if (scene.frame) return std::nullopt;
  Rates rates{std::vector<double>(scene.bodies.size()), std::vector<double>(scene.bodies.size()), true};
  for (const core::Force& force : scene.forces) add(scene, force, rates);
  for (const core::Joint& joint : scene.joints) add(scene, joint, rates);
  const auto acts = [](const core::JointCoordinate&) { return true; };
  if (!rates.known || core::any_coordinate(scene, acts)) return std::nullopt;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    if (body.locked) continue;
    const core::Vector3 moments = core::principal_axes(body.inertia).moments;
    const bool alone = scene.joints.empty() && rates.squares[i] == 0 && rates.decays[i] == 0;
    const bool round = moments.maxCoeff() <= moments.minCoeff() * (1 + 1e-9);
    const double turn = body.initial.angular_velocity.norm() * trial.step;
    if (turn > (alone && round ? most_turn : most_precession)) return false;
    if (std::sqrt(rates.squares[i]) * trial.step > most_rate || rates.decays[i] * trial.step > most_rate)
      return false;
  }
  return true;
}

}  // namespace cylon::hunt
