#include "engine/pile/solved_spheres.h"

#include "engine/pile/islands.h"

#include <algorithm>
#include <utility>

namespace cylon::engine::pile {
namespace {

bool is_few(const Model& model, const PileSettings& settings) {
  return static_cast<int>(model.bodies.size()) <= settings.few_spheres;
}

}  // namespace

bool SolvedSpheres::applies(const Model& model, const PileSettings& settings) {
  if (!only_spheres(model) || isolated(model)) return false;
  if (is_few(model, settings)) return true;
  return static_cast<int>(model.bodies.size()) <= settings.standing_spheres &&
         std::all_of(model.motions.begin(), model.motions.end(), [](const Motion& motion) {
           return motion.momentum.isZero(0) && motion.angular_momentum.isZero(0);
         });
}

SolvedSpheres::SolvedSpheres(const Model& model, Time dt, const PileSettings& settings, std::int64_t first)
    : model_(model),
      dt_(dt),
      settings_(settings),
      steps_(first),
      few_(is_few(model, settings)),
      spheres_(std::make_unique<SpherePile>(model, dt, settings, first)) {}

void SolvedSpheres::step() {
  if (bodies_) {
    bodies_->step();
  } else if (!open_) {
    spheres_->step();
  } else {
    spheres_->read(model_.motions);
    told_ = spheres_->log();
    spheres_->step();
    if (spheres_->presses()) solve();
    struck_ = struck_ || (!bodies_ && spheres_->struck());
    open_ = few_ && !bodies_;
    if (!open_) model_ = {};
  }
  ++steps_;
}

// The last step again.
void SolvedSpheres::solve() {
  auto bodies = std::make_unique<BodyPile>(model_, dt_, settings_, steps_);
  bodies->keep_contacts(keep_);
  bodies->step();
  work_ += bodies->operations();
  if (!few_ && !bodies->is_at_rest()) return;
  work_ = spheres_->operations();
  bodies_ = std::move(bodies);
  spheres_.reset();
}

void SolvedSpheres::keep_contacts(bool keep) {
  Stepper::keep_contacts(keep);
  if (spheres_) spheres_->keep_contacts(keep);
  if (bodies_) bodies_->keep_contacts(keep);
}

std::vector<Diagnostic> SolvedSpheres::diagnostics() const {
  if (!bodies_) return spheres_->diagnostics();
  DiagnosticLog log = told_;
  for (const Diagnostic& more : bodies_->diagnostics()) log.take(more);
  return log.all();
}

std::optional<int> SolvedSpheres::order_so_far() const {
  if (!bodies_ || struck_) return std::nullopt;
  return bodies_->order_so_far();
}

}  // namespace cylon::engine::pile
