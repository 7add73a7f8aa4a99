// The general system of differential equations: rigid bodies under forces, joints and lasting contacts.
#pragma once

#include "engine/balanced.h"
#include "engine/changing_masses.h"
#include "engine/constraint.h"
#include "engine/diagnostic.h"
#include "engine/model.h"
#include "engine/system.h"

#include <string>
#include <vector>

namespace cylon::engine {

/// What holds bodies besides joints: contacts that last.  Solves joints and contacts as one.
class Holder {
 public:
  virtual ~Holder() = default;

  /// Adds the forces of joints and contacts to the loads.
  virtual void hold(Time, const std::vector<Body>&, const Motion*, const Kinematics*, Load*) = 0;

  /// Moves positions, then velocities, back onto joints and contacts.
  virtual void project(const std::vector<Body>&, Motion*) = 0;
};

/// y = the work done by each force where it is accounted, then the angle of each joint of which the turns count
/// (CoordinateLaw::counts_turns()), then the clock where a mass changes, then one Motion per body.  Locked bodies after
/// the last one that can move are in no equation: size() leaves them out.
///   dp/dt = v - W x p,  dK/dt = F - W x K,  dq/dt = (w - W) q/2,  dL/dt = torque - W x L
/// (seed eq. 57-60, 72; W the angular velocity of the frame: momenta are those of the inertial frame in the
/// axes of the rotating one, which holds all fictitious forces), the forces of joints and contacts included.
class Bodies {
 public:
  /// `account`: integrate the work of each force, seed eq. 84.
  explicit Bodies(Model, bool account = false);

  std::size_t size() const { return extras_ + motion_size * count_; }
  /// How many bodies are in size().
  std::size_t count() const { return count_; }
  /// The state of the model's motions at `start`, the time of the clock then; of all bodies.
  std::vector<Real> initial(Time start = 0) const;

  void rates(Time, const Real* y, Real* rate);
  void kick(Time, Real h, Real* y);
  void drift(Real h, Real* y);
  void project(Real* y);
  /// The masses at the instant of a state, which velocities of its momenta need.
  void set_masses(const Real* y);
  /// The first time after t at which a force is not smooth; infinite: none.
  Time next_kink(Time t) const { return model_.forces.next_kink(t); }
  /// Forces are those of the smooth piece of time that begins at t, until the next call.
  void start_piece(Time t) { model_.forces.start_piece(t); }
  /// For error control: the largest size so far of each component's kind over all bodies.
  void scales(const Real* y, Real* scale, Real tolerance);

  /// What a user must know of the steps so far.
  std::vector<Diagnostic> diagnostics() const { return log_.all(); }

  /// Of the joints at the last rates() or projection: how near their conditions are to saying the same for bodies of these
  /// masses (Rows::weakest()), which light ones make them do.
  Real weakest() const { return rows_.weakest(); }
  /// The same for equal masses, at a state.
  Real weakest_alike(const Real* y);

  /// Whether joints are kept as constraints.
  bool constrained() const { return !model_.joints.empty(); }

  const Model& model() const { return model_; }
  Model& model() { return model_; }
  Motion* motions(Real* y) const { return reinterpret_cast<Motion*>(y + extras_); }
  const Motion* motions(const Real* y) const { return reinterpret_cast<const Motion*>(y + extras_); }
  /// Work done by each force since t = 0 [J], in the order of apply(); null where it is not accounted.
  const Real* works(const Real* y) const { return account_ ? y : nullptr; }

  /// Forces that switch on and off (the seed's water on a body): each is on or off until flip(), and wants to
  /// be flipped where switch_value() has changed its sign since; watch() sets them all to what the state
  /// says.
  std::size_t switch_count() const { return switches_.size(); }
  /// Whether a force may begin at some time that neither the state nor its derivatives tell before.
  bool may_be_reached() const { return !model_.forces.waters.empty() || !model_.forces.user_forces.empty(); }
  Real switch_value(std::size_t, Time, const Real* y) const;
  void flip(std::size_t);
  void watch(Time, const Real* y);
  /// Every force follows the state by itself again.
  void unwatch();

  /// Coordinates of joints that are angles are near those that y counts.
  void set_turns(const Real* y);
  /// Of each law of the model what its angle is near to in y.
  void read_turns(const Real* y, std::vector<Real>& turns) const;
  /// The most that a limited angle turns from one state to another [rad].
  Real most_turned(const Real* from, const Real* to) const;

  /// Who adds the forces of joints and contacts; null: the joints alone.
  void set_holder(Holder* holder) { holder_ = holder; }
  /// Forces without those of joints and contacts, and the kinematics that they were computed from.
  void load(Time, const Real* y);
  const std::vector<Load>& loads() const { return loads_; }
  const std::vector<Kinematics>& kinematics() const { return kinematics_; }

 private:
  void project(Motion*);
  void find_kinematics(const Motion*);
  std::vector<Real> turn_rates(const Real* y);
  void count_turns(Real* y) const;
  void find_loads(Time, const Motion*, Real* powers);
  void keep_what_moves();
  void add_momenta(Real factor, const std::vector<Load>&, Motion*) const;
  bool kick_by_series(Time t, Real h, Motion*);
  void move(Real h, Real* y);
  void free_drift(Real h, Real* y);
  void gather(const Motion*, bool rotors = false);
  Motion* open(Real* y);
  void close(const Motion*, Real* y);
  const Motion* upright(const Real* y, bool turned);
  void turn_frame(Real h, Motion*);

  struct Switch {
    std::size_t water, body;
  };

  Model model_;
  std::vector<Switch> switches_;
  bool account_ = false, reads_velocities_ = false, affine_ = true, rotors_ = false;
  std::size_t count_ = 0, extras_ = 0;  // extras_: Reals of y before the motions
  std::vector<std::size_t> turning_;    // the coordinate laws that count turns
  std::size_t angles_ = 0;              // where their angles begin in y
  ChangingMasses masses_;
  std::vector<Kinematics> kinematics_;
  std::vector<Motion> opened_, upright_, start_, probe_;  // of all bodies, those of locked ones for ever
  std::vector<Load> loads_, first_, before_;
  std::vector<Motion> kicked_;  // at the start of a kick
  std::vector<Real> powers_, change_;
  Real length_ = 0, speed_ = 0, turn_ = 0;  // the largest that scales() has seen, as are
  std::vector<Real> spin_;                  // |L| of each body
  Real arm_ = 0;                            // From a centre of mass to a joint, the longest [m].
  Real pull_ = 0;                           // The largest |F|/m that joints have had to take up [m/s^2].
  Balanced balanced_;
  Rows rows_, alike_;
  std::vector<Body> equals_;  // the bodies with equal masses
  Holder* holder_ = nullptr;
  DiagnosticLog log_;
  Time now_ = 0;  // of the last forces [s]
};

static_assert(Split<Bodies>);

}  // namespace cylon::engine
