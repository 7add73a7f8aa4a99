// What the viewer runs: a scene in several lanes side by side, time, speed, kicks, pulls and changes.  Pure:
// no sockets and no clock; the caller says how much time has passed.
#pragma once

#include "harness/process/engines.h"
#include "harness/scenario/scenario.h"
#include "harness/view/command.h"
#include "harness/view/lane.h"
#include "harness/view/recorder.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cylon::view {

struct EngineInfo {
  std::string id, version;
  std::vector<std::string> integrators;  ///< The first is the default.
};

/// What an engine says of itself.  Throws process::Failure where it does not answer.
EngineInfo ask(const process::EngineRow&, const process::Limits&);

struct SessionOptions {
  std::vector<process::EngineRow> rows;
  std::vector<EngineInfo> engines;  ///< That are known already; one of a lane is asked when it is made.
  LaneSpec lane;                    ///< The first.
  bool playing = true;
  double speed = 1;
  std::string recording;  ///< Shown to the page; "": nothing is kept.
  process::Limits limits{.run_seconds = 10};
};

/// Where somebody pulls: a spring to a point of the world, with half its critical damping along its line.
struct PullNow {
  int body = 0;
  core::Vector3 pin = core::Vector3::Zero();
};

class Session {
 public:
  /// Throws BadCommand where the first lane's engine, integrator or step is none.
  Session(scenario::Scenario, SessionOptions);

  /// Lets time pass: simulated time follows speed x seconds, and falls behind without haste where an engine
  /// is slower than that.  All lanes advance at once.  Returns whether anything moved.
  bool advance(double seconds);

  /// Throws BadCommand, and changes nothing but which engines are known, where it cannot be.
  void apply(const Command&);

  /// One more engine to choose from; nothing where it is known already.
  void offer(EngineInfo);

  const scenario::Scenario& scenario() const { return scenario_; }
  const SessionOptions& options() const { return options_; }
  const core::Scene& scene() const {
    return given_;
  }  ///< Parameters as they are now, the initial state as given.
  const std::vector<std::unique_ptr<Lane>>& lanes() const { return lanes_; }
  bool playing() const { return playing_; }
  double speed() const { return speed_; }
  double time() const;  ///< Of the first lane that runs [s].
  std::optional<PullNow> pull() const;

  /// Grows with every change of lanes, parameters and the like, of which the page must know.
  std::uint64_t changes() const { return changes_; }

  /// The motion of the first lane since the last interaction.
  const Recorder& recorder() const { return recorder_; }

 private:
  void obey(const Play&);
  void obey(const Pause&);
  void obey(const StepOnce&);
  void obey(const Reset&);
  void obey(const Speed&);
  void obey(const Kick&);
  void obey(const Pull&);
  void obey(const Release&);
  void obey(const Lanes&);
  void obey(const Set&);

  Lane* first_running() const;
  const EngineInfo& known(const process::EngineRow&);
  std::unique_ptr<Lane> make_lane(const LaneSpec&);
  void check_body(int body, const char* what) const;
  void check_resumable(const char* what) const;
  core::Scene with_pull() const;
  void begin_anew(Lane&, core::State, double t);
  void begin_all_anew();
  void load_due();
  double affordable() const;
  bool run(double target);

  scenario::Scenario scenario_;
  SessionOptions options_;
  core::Scene given_;
  std::vector<core::HeldJoint> joints_;
  std::vector<std::unique_ptr<Lane>> lanes_;
  std::optional<core::Spring> pull_;
  bool playing_, step_ = false;
  double speed_, target_ = 0;  // target_: the time that the lanes follow [s]
  std::uint64_t changes_ = 0;
  Recorder recorder_;
};

}  // namespace cylon::view
