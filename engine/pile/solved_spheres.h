// The stepper of a pile of spheres that may be solved to rounding: of few, and of ones that stand.
#pragma once

#include "engine/pile/body_pile.h"
#include "engine/pile/sphere_pile.h"

#include <memory>
#include <optional>

namespace cylon::engine::pile {

/// As SpherePile, which locates impacts within a step, while spheres only fly and strike.  The first step in which one lies
/// on something is made again as BodyPile, which solves what lasts to rounding, and so are all steps after it, if there
/// are no more than PileSettings::few_spheres or if that is the first step and all that begins at rest stays so.
/// Else it stays SpherePile, which sweeps.
class SolvedSpheres final : public Stepper {
 public:
  /// Requires applies().
  SolvedSpheres(const Model&, Time dt, const PileSettings&, std::int64_t first = 0);

  /// Whether a pile of spheres may be solved: its model is only_spheres() and not isolated(), where nothing lies on
  /// anything, and has few spheres, or all are at rest and not too many.
  static bool applies(const Model&, const PileSettings&);

  void step() override;
  void read(std::vector<Motion>& motions) const override { now().read(motions); }
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  const std::vector<Impact>& impacts() const override { return now().impacts(); }
  const std::vector<Contact>& contacts() const override { return now().contacts(); }
  void keep_contacts(bool keep) override;
  std::int64_t operations() const override { return work_ + now().operations(); }
  std::vector<Diagnostic> diagnostics() const override;
  std::optional<int> order_so_far() const override;

 private:
  const Stepper& now() const { return bodies_ ? static_cast<const Stepper&>(*bodies_) : *spheres_; }
  void solve();

  Model model_;  // with the motions before the last step
  Time dt_;
  PileSettings settings_;
  std::int64_t steps_;
  bool few_;
  bool open_ = true;                     // whether it may yet become BodyPile
  std::unique_ptr<SpherePile> spheres_;  // until `bodies_` is there
  std::unique_ptr<BodyPile> bodies_;
  DiagnosticLog told_;   // of the steps of spheres
  bool struck_ = false;  // in one of these
  std::int64_t work_ = 0;
};

}  // namespace cylon::engine::pile
