// A running simulation: the islands of a scene, each with a method and a step of its own.
#pragma once

#include "engine/changing_masses.h"
#include "engine/islands/islands.h"
#include "engine/reactions.h"
#include "engine/run.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace cylon::engine {

/// An island is a part of the scene that nothing outside can act on: bodies that joints or forces tie
/// together, and bodies that may touch in the steps ahead (engine/islands/islands.h), with the planes and
/// locked bodies that they may ever touch.  Until it becomes one with another, each runs as it would alone, to
/// the last bit.  Islands whose bodies may meet become one, which begins anew from the state at that step; an island that is stepped parts
/// again where its parts cannot meet.  With Options::full or Options::account the scene is one island.
class World {
 public:
  /// Starts at t = 0.  Requires unsupported(model, options) to be empty, options.dt > 0, one motion and one
  /// shape per body.
  /// `names`: what bodies are called in the plan and in sentences.
  World(Model, const Options&, Names names = numbered);
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  /// Advances by exactly one step.
  void step();

  /// Advances by n steps, n >= 1: the bits of as many step(), for less, as nothing is read between them.
  /// impacts() are then those of the last.
  void advance(std::int64_t n);

  /// An impulse [N s] at the centre of mass of a body and an angular impulse [N m s] beside it, world axes, between two steps:
  /// momenta jump by these and by what joints answer, and islands of the body begin anew.  About an axis without inertia
  /// nothing turns; a locked body takes none.  Requires no_kick() to be empty.
  void kick(int body, const Vector3& impulse, const Vector3& angular_impulse);

  /// Why no body may be kicked, or "".
  std::string no_kick() const;

  Time time() const { return static_cast<Time>(steps_) * options_.dt; }

  /// Of all islands as they are now: what any of them needs, and path, integrator and order of the island
  /// with the least order.
  const Plan& plan() const { return plan_; }

  std::size_t island_count() const { return islands_.size(); }

  /// The bodies as given, with their masses now; velocity() and angular_velocity() of a motion that was read
  /// need them.
  const std::vector<Body>& bodies() const { return masses_.any() ? bodies_ : model_->bodies; }

  /// The motion now, of centres of mass.
  const std::vector<Motion>& motions() const { return whole() ? islands_[0].run->motions() : motions_; }

  /// The impacts of the last step, in order of time.
  const std::vector<Impact>& impacts() const { return impacts_; }

  /// Whether contacts() and reactions() are wanted of the steps to come; the motion is the same.
  void keep_contacts(bool keep);

  /// The contacts of the last step, if it was made with contacts kept.
  const std::vector<Contact>& contacts() const { return contacts_; }

  /// What the joints did in the last step, if it was made with contacts kept; else, and where contacts of it
  /// do not tell their impulses, nothing.
  std::optional<std::vector<Reaction>> reactions() const;

  /// The work done by each force since t = 0 [J], gravity first, in the order of Forces; null where not
  /// accounted.
  const Real* works() const { return whole() ? islands_[0].run->works() : nullptr; }

  /// Work done so far, by islands that have ended too (Stepper::operations()).
  std::int64_t operations() const;

  /// What a user must know of the run so far, of each island and of those that have ended; at most
  /// most_diagnostics, of which the last then says how many more there are.
  std::vector<Diagnostic> diagnostics() const;
  static constexpr std::size_t most_diagnostics = 100;

  /// The same in words.
  std::vector<std::string> remarks() const { return sentences(diagnostics(), names_); }

 private:
  struct Island {
    std::vector<std::size_t> clusters;  // none: the island is the whole model
    std::vector<int> bodies, planes;    // of the whole model, in the order of the run's
    std::vector<std::size_t> movable;   // places in `bodies` of those that are not locked
    std::vector<int> laws;              // on coordinates of joints, of the whole model
    std::unique_ptr<Run> run;
    bool flies = false;      // bodies that move by themselves, in one run
    std::vector<char> left;  // those that are in another island now; empty: none
  };

  std::vector<std::size_t> movable(const std::vector<int>& bodies) const;
  static bool is_whole(const Island& island) { return island.clusters.empty(); }
  bool whole() const { return is_whole(islands_.front()); }
  bool keeps_reactions() const { return keep_contacts_ && !model_->joints.empty(); }
  bool watches() const { return interactions_ && interactions_->may_meet(); }
  void divide();
  bool add_flight(const std::vector<std::size_t>& clusters);
  void add_island(std::vector<std::size_t> clusters, const std::vector<Motion>&,
                  const std::vector<Real>& turns, std::int64_t first);
  void take();
  void take(const Island&);
  void sort_impacts();

  void watch();
  void find_accelerations();
  void look(std::size_t cluster);
  void begin_anew(const std::vector<Motion>&);
  bool merge();
  bool part();
  void leave(std::size_t cluster);
  void end_run(Island&);
  void forget(const std::vector<std::size_t>& clusters);
  void drop_empty();

  void set_plan();
  void note(DiagnosticKind, std::int64_t first, const std::vector<std::size_t>& clusters,
            std::optional<double> limit = {}, std::optional<double> reached = {},
            const std::string& cause = {});
  void note_end(const Island&);
  void set_bodies(const std::vector<std::size_t>& clusters, IslandName&) const;
  void set_bodies(const Island&, IslandName&) const;
  std::string named(const Island&) const;

  std::shared_ptr<const Model> model_;
  Names names_;
  std::vector<Body> bodies_;  // with their masses now, where they change
  ChangingMasses masses_;
  Options options_;
  Plan plan_;
  std::optional<islands::Interactions> interactions_;
  std::vector<Island> islands_;
  std::vector<std::size_t> island_of_;     // per cluster
  std::vector<islands::Range> ranges_;     // per body
  std::vector<Real> accelerations_;        // per body, beside gravity [m/s^2]
  std::vector<std::size_t> looked_;        // clusters whose ranges are new
  std::vector<char> jumped_;               // per cluster: it left its range within the step
  std::vector<Diagnostic> notes_, ended_;  // of the division into islands; of those that have ended
  std::size_t more_notes_ = 0, more_ended_ = 0;
  std::vector<Motion> motions_, before_;
  std::vector<Real> turns_,
      turns_before_;  // of each law on a coordinate, what it is near to; with motions_, before_
  std::vector<std::size_t> movable_;  // bodies that are not locked
  std::vector<Impact> impacts_;
  std::vector<Contact> contacts_;
  std::int64_t steps_ = 0, spent_ = 0;  // spent_: operations of runs that have ended
  bool keep_contacts_ = false;
  std::vector<Motion> last_;  // at the start of the last step, where contacts are kept and joints hold
};

}  // namespace cylon::engine
