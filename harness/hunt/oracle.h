// What must hold of every scene, whatever the right motion is, as rows of one table.  None of it is the word of another
// engine.  How an error may depend on the step is in course.h; who asks is examine.h.
#pragma once

#include "harness/core/recording.h"
#include "harness/core/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cylon::hunt {

/// What an oracle reads from a recording.
struct Reading {
  double measured = 0;
  double scale = 1;  ///< What it is large or small against.
  std::string unit;  ///< Of both.
};

struct Oracle {
  std::string_view name;  ///< "energy"
  std::string_view says;  ///< What must hold, one sentence.
  double relative;        ///< Of the scale, allowed; ten times that is a fault.
  std::string_view why;   ///< Why that much, one clause.
  /// Why it says nothing about this scene, or nothing when it does.  What the reader refuses is left out, too.
  std::optional<std::string> (*undefined_in)(const core::Scene&);
  /// TOML of a claim without its tolerance; empty: `read` is asked.
  std::string_view claim = {};
  /// Of a run; nothing where the engine does not tell what it takes.
  std::optional<Reading> (*read)(const core::Scene&, const core::Recording&) = nullptr;
  bool of_trajectories = false;  ///< Compares trajectories: needs a motion that is not sensitive.
  bool of_contacts = false;      ///< Reads the contacts of the last step.
  /// Of first order in the step itself: no promise of the engine's order speaks of it.
  bool of_steps = false;
  /// Nothing below a bound counts: where losses outweigh what truncation adds, it falls to 0 at once, as of no order.
  bool one_sided = false;
  bool of_angle = false;  ///< Its scale is a radian.
  /// Whether a step makes no error of it in this scene, however large the step; nothing: never.
  bool (*stepless_in)(const core::Scene&) = nullptr;
};

/// The claim with its tolerance, as TOML; empty for an oracle that reads a recording itself.
std::string claim_of(const Oracle&);

/// Beside these the relations of mechanics (study/relations.h) are asked, and that runs end, with numbers.
std::span<const Oracle> oracles();

/// Whether some pair of the scene may touch.
bool may_touch(const core::Scene&);

/// Whether the motion has no instant at which a velocity or a force jumps: nothing touches, no joint has stops or dry
/// friction.
bool is_smooth(const core::Scene&);

}  // namespace cylon::hunt
