// The stepper of a pile of bodies of any shape, and of jointed ones.
#pragma once

#include "engine/changing_masses.h"
#include "engine/constraint.h"
#include "engine/pile/body_contacts.h"
#include "engine/pile/bounce.h"
#include "engine/pile/crowd.h"
#include "engine/pile/groups.h"
#include "engine/pile/in_turn.h"
#include "engine/pile/islands.h"
#include "engine/pile/overlap.h"
#include "engine/pile/settings.h"
#include "engine/pile/threads.h"
#include "engine/stability.h"
#include "engine/stepper.h"

namespace cylon::engine::pile {

class BodyPile : public Stepper {
 public:
  BodyPile(const Model&, Time dt, const PileSettings&, std::int64_t first = 0);

  void step() override;
  void read(std::vector<Motion>& motions) const override { motions = motions_; }
  void read_turns(std::vector<Real>& turns) const override {
    model_.forces.read_turns(turns);
    turns.resize(laws_);
  }
  const std::vector<Impact>& impacts() const override { return impacts_; }
  std::vector<Diagnostic> diagnostics() const override;
  std::int64_t operations() const override {
    return work_ + direct_.operations() + in_turn_.operations() + overlaps_.operations() +
           crowd_.operations();
  }
  /// 2 as long as all steps are leaps in which nothing strikes and nothing is taken to first order, else 1.
  /// A rotor takes its rate of before from inertias that have turned since: of first order, where its body is not round.  So is
  /// a force that jumps.
  std::optional<int> order_so_far() const override { return is_ahead_ && smooth_ && !rotors_ ? 2 : 1; }

  /// Whether the last step has left everything at rest.
  bool is_at_rest() const;

  /// Largest violation of the contact and joint laws that a direct solution has left [m/s].
  double residual() const { return residual_; }

 private:
  static constexpr int awake = -1;  // of rest_
  Vector3 common_velocity() const;
  int parts_of_step() const;
  int parts_from(Time now);
  void find_limits(Time now);
  void advance_part(Time now, Time span, bool last);
  void find_contacts(Time now, Time span);
  bool leaps() const;
  void leap(Time now, Time span, bool last);
  void kick_ahead(Time now, Real lag, Real h);
  void set_bias(Real lag, Real h);
  void forget_parts_of_pairs();
  void load_ahead(Time now, Real lag);
  void mark_struck(Real h);
  Real speed_now(const Block&) const;
  void note_share(bool before);
  void drift_ahead(Real h);
  void leave_resting();
  void land(Time now, Real lag);
  void divide(Real span);
  bool bounces(const Group&, Real span) const;
  bool is_crowd(const Group&) const;
  void move_crowds(Time now, Time span);
  bool rests(const Group&) const;
  bool begins_at_rest(const Group&) const;
  bool stands(const Group&, Real span);
  bool comes_to_rest(const Group&, Real span) const;
  bool lay_to_rest(Real span);
  bool is_slow(const Group&, Real speed) const;
  bool is_on_edge(int body, const Group&) const;
  void meet(const Group&, Time now, Real h);
  static Model as_stepped(Model, Time dt);
  void soften(Block&, Time now, Real span, Real h) const;
  void note_rotors();
  Real gap_of_stop(const Block&) const;
  void look_at_stops();
  void note_impact(std::size_t block, Time now, Real gap, Real approach);
  void pass(Time now, Time span, bool direct);
  void measure_sweep();
  void substep(Time now, Time h, bool direct);
  void solve_directly(Time now);
  void solve_groups(Time now);
  bool takes(std::size_t body) const { return taken_.empty() || taken_[body] != 0; }
  bool takes(const Block&) const;
  static Vector3 resting_impulse(const Block&, Real span);
  void note_pressed();
  void note_pressed(const Block&, const Vector3& impulse, std::vector<Contact>&) const;
  void strike_in_turn(Time now, Real h, bool leaps);
  void note_at_once(Time now);
  static bool is_impact(const Block& block) { return block.impact || block.struck > 0; }
  void set_kinematics();
  void load(Time now);
  void kick(Real span, Time then);
  void set_targets(Time now, Real span, Real h);
  void note_impacts(Time now);
  void sweep(bool warm);
  void carry_impulses();
  void drift(Real h);
  Real slop(bool direct) const;  // [m]
  Real crowd_slop() const;
  Overlaps::Share share(bool direct) const;
  void correct_positions(Time now, bool direct);
  void correct_groups(Time now);
  void close_joints(Time now);
  void note_overlaps(Time now);
  void colour();

  Model model_;
  ChangingMasses masses_;
  Time dt_;
  PileSettings settings_;
  Threads threads_;
  std::vector<Motion> motions_;
  std::vector<Mover> movers_;
  BodyContacts found_;
  std::vector<Block> blocks_;
  std::vector<std::vector<std::pair<std::size_t, std::size_t>>> colours_;  // runs of blocks of one pair
  Bounce direct_;
  InTurn in_turn_;
  Overlaps overlaps_;
  Islands islands_;
  bool divided_ = false;       // solved group by group:
  std::vector<Group> groups_;  // these to rounding
  std::vector<Group> crowds_;  // these by sweeps, each by itself
  std::vector<Group> resting_;
  std::vector<int> rest_;                // per body: the blocks of its group when that came to rest
  std::vector<char> still_, displaced_;  // per body: it hardly moved after the last step; per group
  std::vector<char> stands_;             // per body, in the first step: its group was found to stand
  Group swept_;                          // these by sweeps with joints and all forces, as one
  Crowd crowd_;
  GroupLists lists_;
  std::vector<char> taken_;  // bodies that a pass advances; empty: all
  Rows closing_;             // of all joints, where the step has left the bodies
  std::vector<Motion> before_;
  std::vector<Kinematics> kinematics_;
  std::vector<Load> loads_;
  std::vector<Impact> impacts_;
  // Leaps: K and L in the middle of the part to come, and how fast they changed last; what is told with that part.
  struct Momenta {
    Vector3 momentum = Vector3::Zero(), angular_momentum = Vector3::Zero();
  };
  bool is_ahead_ = false;
  bool smooth_ = true;   // all parts so far were of second order
  int parts_ahead_ = 1;  // of the step to come
  Real share_ = 0;       // of what the last kick did: till its instant
  Real kick_ = 0;        // for how long it acted [s]
  std::vector<Momenta> ahead_, start_, rates_;
  std::vector<char> jumped_;  // bodies whose groups were struck in the last kick
  std::vector<Real> stops_;   // and when in the part to come they stop [s]
  std::vector<Impact> coming_;
  std::vector<Vector3>
      pressed_;  // impulse on `a` per block, over the parts of the step [N s]; while contacts are kept
  std::int64_t steps_;
  std::int64_t work_ = 0;  // operations beside those of what solves
  double residual_ = 0;
  // Speeds that the last solutions leave by their own error: no approach [m/s].
  Real unsure_ = 0, unsure_in_turn_ = 0;
  StepLimit limit_;
  int most_told_ = 1;      // of stiff_parts_
  bool changing_ = false;  // what a step can bear changes in time
  int stiff_parts_ = 1;    // of each step, for forces that are unstable in longer ones
  double swept_to_ = 0;    // largest change of a velocity that the last sweep of a step left, or made [m/s]
  int swept_times_ = 0;    // sweeps over the contacts in that step
  DiagnosticLog log_;
  Real gravity_ = 0;  // pressing_gravity() [m/s^2]
  Vector3 common_gravity_;
  bool other_forces_ = false, isolated_ = false;
  bool steady_ = true;     // a step is at most half of one in which forces do not overshoot
  std::size_t laws_ = 0;   // of the model that was given; rotors that stand by themselves come after them
  bool implicit_ = false;  // forces in joints are those of the end of a step
  bool rotors_ = false;
  bool spheres_ = false;  // all bodies are
  bool paired_ = false;   // a force acts between two bodies that move
};

}  // namespace cylon::engine::pile
