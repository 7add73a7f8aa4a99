#include "engine/parted_steps.h"

#include "engine/contact/contact_force.h"
#include "engine/geometry/pose.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine {

namespace {

// A step of more would not end.
constexpr double most_parts = 1e6;

// [m]; infinite where nothing is.
Real least_size(const Model& model) {
  Real least = std::numeric_limits<Real>::infinity();
  const auto take = [&](Real size) {
    if (size > 0) least = std::min(least, size);
  };
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (!model.bodies[i].locked && !model.surfaces.empty() && model.surfaces[i] != no_surface)
      take(bounding_radius(model.shapes[i]));
  for (const CoordinateLaw& law : model.forces.coordinate_laws)
    if (law.is_limited() || law.friction > 0) take(gyration(model.bodies[index(law.at.body)]));
  return least;
}

std::int64_t steps_before(Time start, Time dt) {
  return static_cast<std::int64_t>(std::floor(start / dt * (1 + 4e-16)));
}

}  // namespace

std::int64_t parts_of_step(const Model& model, Time dt) {
  const Real g = model.strongest_gravity(), size = least_size(model);
  if (!(g > 0) || !std::isfinite(size)) return 1;
  const double step = static_cast<double>(dt), longest = static_cast<double>(std::sqrt(size / g)) / 4;
  if (step <= longest) return 1;
  return static_cast<std::int64_t>(std::min(std::ceil(4 * step / longest), most_parts));
}

PartedSteps::PartedSteps(std::unique_ptr<Stepper> run, std::int64_t parts, Time dt, Time start)
    : run_(std::move(run)),
      parts_(parts),
      part_(steps_before(start, dt / static_cast<Time>(parts))),
      step_(steps_before(start, dt)) {}

void PartedSteps::step() {
  impacts_.clear(), contacts_.clear();
  ++step_;
  for (; part_ < step_ * parts_; ++part_) {
    run_->step();
    impacts_.insert(impacts_.end(), run_->impacts().begin(), run_->impacts().end());
    if (keep_) add_contacts();
  }
}

// Impulses of what lasts through all parts add up; what else pressed is told part by part.
void PartedSteps::add_contacts() {
  const std::vector<Contact>& more = run_->contacts();
  const bool same =
      impacts_.empty() && std::ranges::equal(contacts_, more, [](const Contact& a, const Contact& b) {
        return a.body == b.body && a.other == b.other && a.plane == b.plane && a.impulse && b.impulse &&
               a.friction && b.friction;
      });
  if (!same) {
    contacts_.insert(contacts_.end(), more.begin(), more.end());
    return;
  }
  for (std::size_t i = 0; i < more.size(); ++i) {
    Contact& sum = contacts_[i];
    sum.point = more[i].point, sum.normal = more[i].normal;
    *sum.impulse += *more[i].impulse;
    *sum.friction += *more[i].friction;
  }
}

}  // namespace cylon::engine
