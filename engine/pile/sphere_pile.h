// The stepper of a pile of spheres.
#pragma once

#include "engine/pile/settings.h"
#include "engine/pile/sphere_contacts.h"
#include "engine/stepper.h"

namespace cylon::engine::pile {

class SpherePile : public Stepper {
 public:
  /// Requires only_spheres(model).
  SpherePile(const Model&, Time dt, const PileSettings&, std::int64_t first = 0);

  void step() override;
  void read(std::vector<Motion>& motions) const override { spheres_.read(model_.bodies, motions); }
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  const std::vector<Impact>& impacts() const override { return impacts_; }
  std::vector<Diagnostic> diagnostics() const override;
  std::int64_t operations() const override { return work_; }

  /// Whether a contact pressed in the last part of the last step, impacts apart.
  bool presses() const;

  /// What diagnostics() tells but for the sweeps of the last step.
  const DiagnosticLog& log() const { return log_; }

  /// Pairs within reach of each other in the last step.
  std::size_t pairs() const { return found_.pairs(); }

 private:
  void order_bodies();
  void set_kick();
  Vector3 common_velocity() const;
  int parts_of_step() const;
  void advance_part(Time now, Time span);
  void advance_alone(Time span);
  void drift(Real h, bool again);
  void drift_alone(Real h);
  void set_smooth(Real h);
  void turn(Time span);
  void add_pressed();
  void note_pressed();
  void note_order();
  void note_blows(Time now, Time span);
  void note_sweep(DiagnosticLog&) const;
  Real unmet() const;

  Model model_;
  Time dt_;
  PileSettings settings_;
  Threads threads_;
  Spheres spheres_;
  SphereContacts found_;
  SphereImpacts impacts_found_;
  std::vector<Impact> impacts_;
  struct Pressed {
    Real normal = 0;
    Vector3 friction = Vector3::Zero();  // on the first sphere
  };
  std::vector<Pressed>
      pressed_;  // per row of impulses, over the parts of the step [N s]; while contacts are kept
  std::int64_t first_, steps_;
  std::int64_t work_ = 0;            // spheres and contacts, over all sweeps
  Real smallest_ = 0, largest_ = 0;  // radius
  DiagnosticLog log_;
  Time part_ = 0;  // of the last part of a step [s]
  using Row = Real __attribute__((vector_size(4 * sizeof(Real))));
  struct Smooth {
    Row normal;
    Real most;  // [m/s]
  };
  std::vector<Smooth> smooth_;  // of each sphere
  bool alone_ = false;
  Real gravity_ = 0;  // pressing_gravity() [m/s^2]
};

}  // namespace cylon::engine::pile
