// A small system of any shapes, followed event by event: smooth motion by an integrator, and between the
// smooth pieces impacts, ends of slip, onsets of slip and partings, each located in time.
#pragma once

#include "engine/bodies.h"
#include "engine/contact/candidate.h"
#include "engine/contact/contact_force.h"
#include "engine/contact/facets.h"
#include "engine/contact/impact.h"
#include "engine/contact/neighbours.h"
#include "engine/contact/passage.h"
#include "engine/contact/seams.h"
#include "engine/integrators/advance.h"
#include "engine/integrators/dop853.h"
#include "engine/operations.h"
#include "engine/reduce.h"
#include "engine/stepper.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace cylon::engine {

/// A point that is held by a lasting contact.  Of a general pair it stays on its facets.
struct HeldPoint {
  std::size_t candidate = 0;
  Holding holding;
  std::optional<FacetPair> facets;
  Real slow = 0;  ///< Slip that was slower counted as none [m/s; a coordinate: its unit/s].
};

/// Bodies with scales of error control that nothing at rest makes zero: lengths at least the reach of the
/// shapes, speeds at least what gravity gives in a step and a hundredth of the reach in a step.
class ScaledBodies {
 public:
  ScaledBodies(Bodies& bodies, Real reach, Real least_speed);
  std::size_t size() const { return bodies_.size(); }
  void rates(Time t, const Real* y, Real* rate) { bodies_.rates(t, y, rate); }
  void kick(Time t, Real h, Real* y) { bodies_.kick(t, h, y); }
  void drift(Real h, Real* y) { bodies_.drift(h, y); }
  void project(Real* y) { bodies_.project(y); }
  void set_masses(const Real* y) { bodies_.set_masses(y); }
  void scales(const Real* y, Real* scale) const;
  /// The least length that errors of places are measured by [m].
  Real length() const { return least_length_; }

 private:
  Bodies& bodies_;
  Real reach_, least_speed_;
  Real least_length_;  // reach_, or what is farthest from the origin of all that is locked [m]
};

class EventStepper final : public Stepper, private Holder {
 public:
  /// Operations that a run may spend beside those of each step.
  static constexpr std::int64_t first_operations = 24'000'000;

  /// `tolerance`: per step, for adaptive integrators.  Splittings move what is free; while a contact lasts
  /// the Runge-Kutta integrator rk8 does, for friction belongs to neither of their parts.  `reserve`: what is left of
  /// first_operations, where several runs share them; else the run has its own.
  EventStepper(const Model&, const Integrator&, Time dt, Real tolerance, bool account = false, Time start = 0,
               std::shared_ptr<std::int64_t> reserve = {});
  EventStepper(Reduced, const Integrator&, Time dt, Real tolerance, bool account, Time start,
               std::shared_ptr<std::int64_t> reserve);
  EventStepper(const EventStepper&) = delete;
  EventStepper& operator=(const EventStepper&) = delete;
  ~EventStepper() override = default;

  void step() override;
  void read(std::vector<Motion>&) const override;
  void read_turns(std::vector<Real>& turns) const override { system_.read_turns(y_.data(), turns); }
  const std::vector<Impact>& impacts() const override { return impacts_; }
  bool struck() const override { return struck_; }
  const Real* works() const override { return account_ ? system_.works(y_.data()) : nullptr; }
  std::vector<Diagnostic> diagnostics() const override;
  std::int64_t operations() const override;
  /// Whether it left the laws of contact for a time.
  bool gave_up() const override;
  bool ran_out() const override { return ran_out_; }

  /// What is held now.
  const std::vector<HeldPoint>& held() const { return held_; }

 private:
  // Slower than this, in ulps of the speeds around, is not moving; and of what forces give in a step, at rest.
  static constexpr Real slow_ulps = sizeof(Real) == 8 ? 1024 : 64, rest_ulps = slow_ulps / 4;
  static constexpr Real most_turn = 2;   ///< Of a limited angle in a piece [rad]: less than half a turn.
  static constexpr Time no_time = 1e-9;  ///< An event after less than this part of a step took no time.

  struct Spot {
    TouchPoint touch;
    HeldPoint held;
    bool returns = false;  ///< It was lifted by less than rounding, and comes back.
  };

  void hold(Time, const std::vector<Body>&, const Motion*, const Kinematics*, Load*) override;
  void project(const std::vector<Body>&, Motion*) override;

  Time go_on(Time from, Time span, bool& event);
  Time piece(Time from, Time span);
  void fixed_step(Time from, Time span);
  void part(Time from, Real s);
  bool at_rest(Time);
  void turn_slips();
  std::optional<Real> contact_time(Time from, Real span);
  std::optional<Real> limit_time(const Candidate&, Time from, Real span);
  Time smooth_span(Time from, Time span);
  std::optional<Real> meeting_time(const Candidate&, bool held, Time from, Real span, const Motion* end);
  std::optional<Real> change_time(Time from, Real span, const ContactForces& before);
  void resolve(Time now);
  std::vector<Spot> spots(Real ahead = 0);
  void pass_kink(Time from);
  Real stride(Time from, Time span);
  void close_gaps();
  bool crawls(Time now);
  void hurry(Time now);
  void give_up(Time now, Time end);
  std::int64_t solution(std::size_t points) const;
  bool is_spent();
  void strike_spots(Time now, std::vector<Spot>&);
  void hold_spots(Time now, const std::vector<Spot>&);
  ContactForces find_holds(const std::vector<Spot>&, const std::vector<Real>& slow,
                           std::vector<std::size_t>& which);
  Real left_slip(std::size_t candidate) const;
  Real end_of_slip(const HeldPoint&, Real speed) const;
  Real rest_speed(std::size_t candidate) const;
  void note_pulls(const std::vector<Spot>&);
  void stop_what_rests(Motion*) const;
  bool inside_surface(const TouchPoint&) const;
  bool nothing_moves(const ContactForces&) const;
  bool loosen(Time now);
  void finish_plastically(Time now);
  void wedge(Time now);
  void tell(const Spot&, const Vector3& impulse);
  void note_held();
  std::vector<ContactForce> held_forces(Time now);
  void note_lasting(Time now, const std::vector<ContactForce>& begun);
  int idle_limit() const;
  void copy(const std::vector<Real>& from, std::vector<Real>& to) const;
  Motion* motions() { return system_.motions(y_.data()); }
  const Motion* motions() const { return system_.motions(y_.data()); }
  int given(int body) const { return body == fixed_world ? body : readings_[index(body)].body; }
  Real widest_margin(const Motion*, Real ahead) const;
  TouchPoint touch_of(const HeldPoint&, const Motion*) const;
  ContactForces support(Time, const Real* y);
  ContactForces support_within(Time from, Real s);
  std::vector<Row> conditions(const Motion*) const;
  std::vector<Row> joint_rows(const Motion*) const;
  std::vector<Real> rotor_rates() const;
  void turn_rotors(const std::vector<Real>& rates);
  Real scale_of(const Candidate&, const Motion*) const;
  Real touch_margin(const Candidate&, const Motion*) const;
  Real room_of(const HeldPoint&, const Motion*) const;
  bool only_held_touches(const Candidate&, const Motion* begin, const Motion* end);
  bool holds(std::size_t candidate) const;

  Bodies system_;
  std::vector<Reading> readings_;
  std::vector<Candidate> candidates_;
  Neighbours neighbours_;
  std::vector<Real> reaches_;  // of the shapes [m]
  Real outermost_ = 0;         // of the locked bodies, with their shapes, from the origin [m]
  Seams seams_;
  Real gravity_;            // the strongest [m/s^2]
  std::size_t joint_rows_;  // of all joints and their rotors
  bool account_, adaptive_, splits_;
  Time dt_, start_time_;
  std::int64_t steps_ = 0;
  std::vector<Real> y_, start_, end_, before_,
      rate_;  // states have the locked bodies too, which no step copies
  Advance<Bodies> fixed_, lasting_;
  ScaledBodies scaled_;
  Dop853<ScaledBodies> controlled_, probe_;  // along the motion; over parts of its last step
  Passage passage_;
  std::vector<HeldPoint> held_;
  std::vector<Motion> scratch_;
  std::vector<Impact> impacts_;
  bool struck_ = false;         // velocities jumped in the last step
  Time kink_ = 0;               // of the forces, the next [s]
  Real slow_slip_ = 0;          // slip slower than this does not turn as fast as it should [m/s]
  Real haste_ = 1;              // slow_slip_ in units of the least that it may be
  Real rest_speed_ = 0;         // what sticks on all points and is slower than this does not move [m/s]
  Real left_slip_ = 0;          // slip that the last event left over [m/s; a coordinate: its unit/s],
  std::size_t ended_ = 0;       // and of which candidate it was
  int idle_ = 0;                // events in a row that took no time
  int rough_ = 0;               // pieces in a row that error control could not take
  bool jumps_ = false;          // the last one of what touches
  bool fresh_ = true;           // the state or what is held has changed since controlled_'s last step
  bool by_rows_ = false;        // the last piece was a fixed step
  int rounds_ = 0;              // events and pieces since marked_
  Time marked_ = 0;             // [s]
  Time stride_ = 0;             // the next stride of this step [s]
  bool ran_out_ = false;        // operations came to an end before a step did
  bool lost_ = false;           // the last step ended in strides: what touches is not known
  bool instant_ = false;        // all events of this instant are resolved
  bool plastic_ = false;        // for the rest of this step
  std::vector<char> loose_;     // per candidate: without friction for the rest of this step
  std::vector<char> restless_;  // per candidate: what changed in the idle changes
  std::vector<Real> pulls_;     // per candidate that is a coordinate: pull_of() when it touched last
  std::vector<Real> stills_;    // per body that a coordinate holds: slower than this it does not move [m/s]
  bool resting_ = false;        // nothing moves, and no force depends on time
  DiagnosticLog log_;
  Time now_ = 0;           // of the last contact forces [s]
  std::int64_t work_ = 0;  // operations beside those of integrators and passage
  Allowance allowance_;
  std::vector<TouchPoint> touches_;
  std::vector<Holding> holdings_;
  Rows rows_;
};

}  // namespace cylon::engine
