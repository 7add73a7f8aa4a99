// The commands of the viewer's page (reports/web/src/shared/live.ts), read and checked.
#pragma once

#include "harness/core/scene.h"

#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cylon::view {

/// A command that cannot be obeyed.  what() is a sentence that names the key and the value; the page shows
/// it.
struct BadCommand : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An engine, an integrator and a step that run beside others.
struct LaneSpec {
  std::string engine;      ///< Id, with a variant after '/'.
  std::string integrator;  ///< "": the engine's default.
  std::string dt_text;     ///< "1/240"
  bool operator==(const LaneSpec&) const = default;
};

struct Play {};
struct Pause {};
struct StepOnce {};
struct Reset {};
struct Speed {
  double value = 1;  ///< Simulated seconds per second, 0.01 … 100.
};
struct Kick {
  int body = 0;
  core::Vector3 impulse = core::Vector3::Zero();          ///< At the centre of mass, world axes [N s].
  core::Vector3 angular_impulse = core::Vector3::Zero();  ///< Beside it, world axes [N m s].
};
struct Pull {
  int body = 0;
  core::Vector3 anchor = core::Vector3::Zero();  ///< Body axes [m].
  core::Vector3 pin = core::Vector3::Zero();     ///< World [m].
  double stiffness = 0;                          ///< [N/m], > 0.
};
struct Release {};
struct Lanes {
  std::vector<LaneSpec> lanes;  ///< 1 … most_lanes.
};
struct Set {
  std::string key;  ///< harness/view/parameters.h
  std::variant<double, core::Vector3> value;
};

using Command = std::variant<Play, Pause, StepOnce, Reset, Speed, Kick, Pull, Release, Lanes, Set>;

inline constexpr std::size_t most_lanes = 4;

/// Numbers are finite and at most 1e9 in size: more is a slip of the hand.  Throws BadCommand for anything
/// else than a command as live.ts has it; whether a body or an engine of that name exists is the session's
/// affair.
Command parse_command(std::string_view json);

}  // namespace cylon::view
