// Asks an engine a scene: every oracle, at halved steps as far as they tell a fault from truncation.
//
// Nor is chaos a fault: where two runs that begin one millionth apart end more than a ten-thousandth apart, no oracle
// speaks that compares trajectories.
#pragma once

#include "harness/hunt/course.h"
#include "harness/process/client.h"

#include <string>
#include <vector>

namespace cylon::hunt {

struct Fault {
  std::string oracle;  ///< Name; of a relation "relation mirror"; of a run that does not end "crash".
  std::string says;    ///< What must hold.
  std::string why;     ///< Why so much is allowed.
  Kind kind = Kind::every_step;
  std::array<double, halvings> measured = {};  ///< At dt, dt/2, …
  std::size_t steps = 0;                       ///< How many of these there are.
  double allowed = 0;
  std::string unit;
  std::string claim;     ///< TOML; empty: no claim of a scenario asks it.
  std::string detail;    ///< What an engine that did not end said.
  bool by_time = false;  ///< A run was stopped by the clock: another machine may see none.
};

/// What is looked for: everything, or one oracle's fault of one kind.
struct Only {
  std::string oracle;  ///< "": every one.
  Kind kind = Kind::every_step;
};

/// A run of one step.  Throws what process::run throws.
process::RunOutcome first_step(const Trial&, const process::EngineChoice&, const process::Limits&);

/// Whether the engine refuses the scene.
bool refuses(const Trial&, const process::EngineChoice&, const process::Limits&);

struct Examined {
  std::vector<Fault> faults;
  bool refused = false;  ///< By the engine, or it starts from another state: no oracle was asked.
};

/// Throws what process::run throws.
Examined examine(const Trial&, const process::EngineChoice&, const process::Limits&, const Only& only = {});

}  // namespace cylon::hunt
