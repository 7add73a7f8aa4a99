// Model only what a scene requires: which stages a model needs, and why.
#pragma once

#include "engine/integrators/integrator.h"
#include "engine/methods.h"
#include "engine/model.h"
#include "engine/resolution.h"

#include <string>
#include <vector>

namespace cylon::engine {

/// What a run is asked to be.
struct Options {
  std::string integrator = "auto";  ///< A row of integrators(), or auto.
  Time dt = 0;                      ///< Step, and grid of the samples [s], > 0.
  Real tolerance = 0;  ///< Of the scales of the motion; auto: bound on the global error; dop853: on the error
                       ///< of each step; 0: default_tolerance.
  std::string path;    ///< "events" or "stepping"; "": by the plan's rule.
  int sweeps = 0;      ///< stepping: sweeps over the contacts in a step; 0: PileSettings' own.
  int threads =
      1;  ///< Of piles in steps and of many free bodies, with the same bits; 0: as many as the machine has.
  bool sleeping = true;      ///< stepping: what has come to rest keeps its place (PileSettings::rest).
  bool constraints = false;  ///< Keep all joints as constraints, in no reduced coordinates.
  bool full = false;         ///< Run every stage, needed or not.
  bool account = false;      ///< Integrate the work of each force.
  bool force = false;        ///< Run a model that the numbers are too coarse for (engine/resolution.h).
};

/// What auto promises where nobody asks: 1e-10 in double, 1e-4 in float.
Real default_tolerance();

/// How a model is carried through time.
enum class Path {
  exact,      ///< Every body moves freely: closed form from t = 0.
  free,       ///< Many bodies that move freely, by fixed steps of a splitting.
  modes,      ///< Points on springs that pull linearly: normal modes, closed form from t = 0.
  points,     ///< Points that nothing turns.
  bodies,     ///< Rigid bodies without contacts.
  ballistic,  ///< Spheres in free flight, event by event.
  events,     ///< Contacts located in time, smooth motion between.
  stepping    ///< Contacts by impulses over fixed steps.
};

/// In words: "closed form", "integration", "events", "fixed steps with impulses".
const char* name_of(Path);

/// One thing that an engine can do, and whether this model needs it.
struct Stage {
  std::string name;
  bool in = false;
  std::string reason;
};

struct Plan {
  Path path = Path::bodies;
  bool verified = false;  ///< Error-controlled, by two runs that must agree.
  const Integrator* integrator =
      nullptr;    ///< Null where the motion is in closed form or the path has its own.
  int order = 0;  ///< Of the integrator, for this model's forces.
  std::vector<Stage> stages;
};

/// In words, the rule by which `path` follows from the model.
extern const char* const path_rule;

/// Why the options do not fit the model, or the engine's numbers do not, or "".
std::string unsupported(const Model&, const Options&, const Names& = numbered);

/// Requires unsupported() to be empty.  `also`: what the path must support besides.
Plan make_plan(const Model&, const Options&, Features also = {});

}  // namespace cylon::engine
