// The ballistic stepper: a queue with the next event of every body, and what each event does.
#pragma once

#include "engine/ballistic/ballistic.h"
#include "engine/ballistic/cells.h"
#include "engine/ballistic/cluster.h"
#include "engine/ballistic/crowd.h"
#include "engine/ballistic/tournament.h"

#include <cstdint>

namespace cylon::engine::ballistic {

class Course final : public Ballistic {
 public:
  Course(const Model&, Time dt);

  void step() override;
  void read(std::vector<Motion>&) const override;
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  const std::vector<Impact>& impacts() const override { return impacts_; }
  std::vector<Diagnostic> diagnostics() const override { return log_.all(); }
  const std::optional<Handover>& handover() const override { return handover_; }
  std::int64_t operations() const override;

 private:
  // The next thing that happens to a body: with a partner (>= 0), to its slip, or at a plane.
  struct Next {
    Time time;
    int partner = nothing;
    unsigned changes = 0;  // of the partner when this was foreseen: else it is no longer true
  };
  static constexpr int nothing = -1, slip_ends = -2, first_plane = -3;  // plane k: first_plane - k

  struct Crossing {
    Time time;
    std::uint8_t axis = 0;
    std::int8_t step = 0;
  };

  struct Burst {  // impacts of a body at one instant
    Time time = -1;
    std::size_t impacts = 0;
    // Of the latest:
    Vector3 velocity = Vector3::Zero();  // before it
    Vector3 normal = Vector3::Zero();
    bool rough = false;
  };

  // Foreseeing: predict.cc
  void foresee_all();
  void foresee(std::size_t body);
  void foresee_crossing(std::size_t body);
  void consider(std::size_t body, std::size_t other);
  void join_crowd(std::size_t body, std::size_t other);
  void consider_crowd(std::size_t body);
  void consider(std::size_t body, Time time, int partner, unsigned changes);
  void enqueue(std::size_t body);
  void cross(std::size_t body);
  void renew_cells();

  // Events: course.cc
  void settle_at_start();
  void run_until(Time);
  void meet_plane(std::size_t body, std::size_t plane);
  void meet(std::size_t a, std::size_t b);
  void end_slip(std::size_t body);
  void renewed(std::size_t body);

  // Several contacts at one instant: at_once.cc
  bool strike_all(std::size_t a, std::size_t b);
  int join(std::size_t body);
  void gather(std::size_t body);
  void gather_plane(std::size_t body, std::size_t plane);
  void gather_pair(std::size_t body, std::size_t other);

  // What an event does to a body: after_event.cc
  Side side(std::size_t body) const;
  void take(std::size_t body, const Side&, Real speed);  // speed: of all that went into the new velocity
  void rest_on(std::size_t body, std::size_t plane, bool slips);
  void fly(std::size_t body);
  bool collapses(Real separation, Real restitution, Real pressing) const;
  bool hit_without_end(std::size_t body, const Vector3& normal, const Material&);
  void look_at_order(std::size_t body, int other, const Vector3& normal, const Material&);
  void record(std::size_t body, int other, int plane, Real approach, Real separation, bool alone);
  void note_impact(const Impact&, bool alone);
  void note_lasting();
  void hand_over(const std::string& reason);
  void read_at(Time, std::vector<Motion>&) const;

  bool may_touch(std::size_t a, std::size_t b) const {
    return model_.filters.empty() || may_meet(model_.filters[a], model_.filters[b]);
  }
  bool may_touch_plane(std::size_t body, std::size_t plane) const {
    return model_.plane_surfaces[plane] != no_surface &&
           model_.may_touch_plane(static_cast<int>(body), static_cast<int>(plane));
  }
  Time shortest() const;
  bool is_now(Time) const;
  const Material& material(std::size_t a, std::size_t b) const {
    return model_.material(surfaces_[a], surfaces_[b]);
  }
  const Material& plane_material(std::size_t body, std::size_t plane) const {
    return model_.material(surfaces_[body], model_.plane_surfaces[plane]);
  }

  Model model_;
  Time dt_, now_ = 0;
  std::int64_t steps_ = 0, events_ = 0;
  bool starting_ = true;
  const bool weightless_;  // no gravity: nothing ever presses, and all accelerations are zero

  std::vector<int> surfaces_;
  std::vector<char> collides_;
  std::vector<Flight> flights_;
  std::vector<Turning> turnings_;
  std::vector<Time> slip_ends_;
  std::vector<Next> next_;
  std::vector<Crossing> crossings_;
  std::vector<Burst> bursts_;
  std::vector<int> last_partner_;
  std::size_t crossed_ = 0;
  bool gridded_ = false;
  Cells cells_;
  Tournament queue_;
  Crowd crowd_;  // of the body at hand

  std::vector<Touch> touches_;  // of the cluster at hand
  std::vector<Side> sides_;
  std::vector<std::size_t> members_;
  std::vector<int> place_in_cluster_;

  std::vector<Impact> impacts_;
  DiagnosticLog log_;
  Time ordered_ = -1;  // the latest instant at which the order of impacts counted
  std::optional<Handover> handover_;
};

}  // namespace cylon::engine::ballistic
