// From globs, suites and steps to a list of cells.
#pragma once

#include "harness/cli/brought.h"
#include "harness/cli/context.h"
#include "harness/scenario/suite.h"
#include "harness/study/cell.h"

#include <memory>
#include <string>
#include <vector>

namespace cylon::cli {

/// What a user asks for.
struct Request {
  std::vector<std::string>
      patterns;  ///< SCENARIO[/ENGINE] globs; "a:b:-c" joins and excludes. None: the suite.
  std::vector<std::string> engines;  ///< Globs over the suite's engines and the registry, or ids of variants.
  std::vector<std::string> steps;    ///< None: the suite's, else each scenario's nominal step.
  std::vector<std::string> integrators;  ///< Globs over each engine's integrators. None: its default.
  Brought brought;                       ///< Engines and plug-ins of the user's own.
  std::string suite;                     ///< "": conformance.
  bool metamorphic = false;              ///< The relations of mechanics in place of the claims.
  bool theory = false;                   ///< The claims by theory in place of the scenario's own.
  double tolerance_scale = 1;            ///< Multiplies every tolerance, >= 0.
  int copies = 0;                        ///< Runs that start one ulp apart.
  bool force = false;                    ///< Run what an engine would refuse, where it can express it.

  bool operator==(const Request&) const = default;
};

struct Selection {
  scenario::Suite suite;                                       ///< The one asked for by name, or by default.
  std::vector<std::unique_ptr<scenario::Scenario>> scenarios;  ///< Cells point here.
  std::vector<study::Cell> cells;  ///< Scenario by scenario, engine by engine, step by step; none twice.
};

/// The suite of that name; of none `conformance`, or where that is not there one of all scenarios and engines.  Throws
/// core::InputError for an unknown name.
scenario::Suite find_suite(const Context&, const std::vector<process::EngineRow>&, const std::string& name);

/// Throws core::InputError for an unknown suite, scenario, engine or integrator, with the nearest name, and
/// for a step that is none; a glob that matches nothing selects nothing.  The scenarios are prepared.
Selection select(const Context&, const Request&);

/// The same before truths are solved: for those who leave some of the cells to others.
Selection select_unprepared(const Context&, const Request&);

/// Prepares the scenarios of the cells that are left, and drops the others.  Throws core::InputError where an engine calls its
/// path, integrator or an option impossible.
void prepare(Selection&);

}  // namespace cylon::cli
