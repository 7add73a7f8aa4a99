// An engine that runs beside others in the viewer: its scene as it was last begun, its motion, its cost.
#pragma once

#include "harness/view/command.h"
#include "harness/view/lane_thread.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cylon::view {

class Lane {
 public:
  enum class Status { running, failed, unsupported };

  /// Nothing runs before begin_at().  `dt` [s]: of the spec.
  Lane(LaneSpec, double dt, process::EngineChoice, process::Limits);

  const LaneSpec& spec() const { return spec_; }
  double dt() const { return setup_.dt; }
  Status status() const { return status_; }
  const std::string& reason() const { return reason_; }
  bool running() const { return status_ == Status::running; }
  double time() const { return begun_at_ + static_cast<double>(steps_) * setup_.dt; }  ///< [s]
  const core::Scene& scene() const { return scene_; }  ///< As it was last begun, pulls included.
  const core::State& state() const { return state_; }
  const std::vector<core::Contact>& contacts() const { return contacts_; }
  std::int64_t steps() const { return steps_; }             ///< Since it was last begun.
  std::uint64_t beginnings() const { return beginnings_; }  ///< How often it was begun.

  /// CPU seconds per simulated second, lately; nothing before it has run.
  std::optional<double> cost() const { return cost_; }

  /// From the scene's initial state, at time t of the session, with the next start(); a lane that failed
  /// tries again.
  void begin_at(core::Scene, double t);

  /// Begins to load what begin_at() left, and to advance by n >= 0 steps; nothing where there is nothing to
  /// do.
  void start(std::int64_t n);
  /// Waits for it.  Whether it went on, or was begun.
  bool finish();

 private:
  LaneSpec spec_;
  core::Setup setup_;
  std::unique_ptr<LaneThread> thread_;
  Status status_ = Status::running;
  std::string reason_;
  core::Scene scene_;
  core::State state_;
  std::vector<core::Contact> contacts_;
  double begun_at_ = 0;
  std::int64_t steps_ = 0, asked_ = 0;
  std::uint64_t beginnings_ = 0;
  bool due_ = false;   // begun, and not loaded yet
  bool busy_ = false;  // between start() and finish()
  std::optional<double> cost_;
};

}  // namespace cylon::view
