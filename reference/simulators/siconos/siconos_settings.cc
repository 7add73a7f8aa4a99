#include "reference/simulators/siconos/siconos_settings.h"

#include "reference/applied/forces.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;

constexpr const char* midpoint = "moreau-jean";
constexpr const char* implicit = "moreau-jean-implicit";

// ---- Options ----------------------------------------------------------------------------------------

std::vector<std::string> names_of_solvers() {
  std::vector<std::string> names;
  for (const siconos_border::FrictionSolver& one : siconos_border::friction_solvers())
    names.push_back(one.name);
  return names;
}

// Defaults: kernel/src/simulationTools/TimeStepping.hpp:78 and :81, numerics/src/LCP/lcp_lexicolemke.c,
// numerics/src/FrictionContact/fc3d_nsgs.c; siconos_tests reads them from Siconos.
std::vector<applied::Option> rows() {
  return {
      {.name = "newton-tolerance",
       .setting = "TimeStepping::setNewtonTolerance",
       .engine_default = 1e-6,
       .meaning = "residual of a step's equations below which Newton's iteration ends",
       .least = 0,
       .most = 1,
       .above = true},
      {.name = "newton-iterations",
       .setting = "TimeStepping::setNewtonMaxIteration",
       .engine_default = 50,
       .meaning = "iterations at most; a step that needs more is taken as it is, which a remark says",
       .least = 1,
       .most = 1e6,
       .whole = true},
      {.name = "solver",
       .setting = "FrictionContact(3, SICONOS_FRICTION_3D_...)",
       .words = names_of_solvers(),
       .engine_default = 0,
       .meaning = "of contacts with friction; without friction Lemke's method is exact"},
      {.name = "solver-tolerance",
       .setting = "SICONOS_DPARAM_TOL",
       .engine_default = 1e-4,
       .meaning =
           "residual below which that solver ends; the default is that of nsgs, other solvers have their own",
       .least = 0,
       .most = 1,
       .above = true},
      {.name = "solver-iterations",
       .setting = "SICONOS_IPARAM_MAX_ITER",
       .engine_default = 1000,
       .meaning = "iterations of that solver at most, of which other solvers than nsgs have their own "
                  "default; a step that "
                  "needs more is taken as it is, which a remark says",
       .least = 1,
       .most = 1e9,
       .whole = true},
  };
}

// ---- What holds on every path -----------------------------------------------------------------------

std::vector<Setting> of_the_scene() {
  return {
      {"TimeDiscretisation", "dt", "as modelled", "one step of the run is one step of Siconos"},
      {"relations", "distances of spheres and planes, by this adapter", "as modelled",
       "the kernel of Siconos has no shapes; that of its library of mechanics is Bullet's, with margins"},
      {"NewtonImpactNSL, NewtonImpactFrictionNSL", "of the pair", "as modelled",
       "Newton's restitution along the normal, none across it, and Coulomb's cone"},
      {"OneStepNSProblem", "LCP; FrictionContact where a pair has friction", "as modelled",
       "Lemke's method, and a solver on Coulomb's exact cone: nonsmooth Gauss-Seidel (nsgs) unless asked "
       "otherwise"},
      {"openblas_set_num_threads", "1", "the processors of the machine",
       "its threads wait for each other over matrices of a few rows"},
      {"springs, drag, thrust, drive, attraction, water, forces of a frame that turns or accelerates",
       "force of the state that (1 - theta) of the step leads to", "none", applied::why_applied},
  };
}

// What Siconos does all the same; in brackets the place in the sources of 4.4.0, below kernel/src/simulationTools/.
std::vector<std::string> unforceable() {
  return {
      "Impacts are not located: a contact acts in the step whose half brings bodies to touch, by its "
      "velocity before "
      "the step (MoreauJeanOSI.cpp, addInteractionInIndexSet).",
      "Penetration is not corrected: what a step lets in stays.",
      "The residual of friction solvers adds impulses in N s and velocities in m/s (fc3d_compute_error.c): "
      "one tolerance is coarse "
      "for light bodies and fine for heavy ones.",
      "All contacts of a step are solved together, with Newton's restitution.",
      "A step of which a solver or Newton's iteration fails is taken as it is, with a warning on standard "
      "output "
      "(TimeStepping.cpp, DefaultCheckSolverOutput); a remark says so here.",
      "The event-driven scheme (LsodarOSI) takes no relations of rigid bodies (LsodarOSI.cpp:376), so it is "
      "not "
      "offered.",
      "A step runs on one thread.",
  };
}

// ---- What the paths set, as a table -----------------------------------------------------------------

bool always(const SiconosKind&) { return true; }
bool touches(const SiconosKind& kind) { return kind.touches; }

constexpr applied::RuleFor<SiconosKind> rules[] = {
    {{"as-expert", "newton-tolerance", "1e-12", "everywhere",
      "the equations of a step are solved to rounding"},
     always},
    {{"as-expert", "solver-tolerance", "1e-12", "where something can touch", "and so are those of contacts"},
     touches},
    {{"as-expert", "solver-iterations", "100000", "where something can touch",
      "and so are those of contacts"},
     touches},
};

applied::Settings as_shipped() { return {"as-shipped", midpoint, siconos_options().defaults(), {}}; }

core::Path path(const char* name, std::string summary) {
  return applied::path(name, std::move(summary), as_shipped(), siconos_options(), applied::all(rules),
                       of_the_scene(), unforceable());
}

// Of the global error on this scene.
int order(const applied::Settings& run, const SiconosKind& kind) {
  return run.integrator == midpoint && !kind.touches && !kind.forced ? 2 : 1;
}

// The settings of the solver of friction, with what that solver has by itself.
std::vector<Setting> friction_settings(const applied::Settings& run, const SiconosKind& kind) {
  const siconos_border::FrictionSolver& solver =
      siconos_border::friction_solvers()[static_cast<std::size_t>(run.at("solver"))];
  const std::pair<const char*, std::string> rows[] = {
      {"solver", siconos_border::friction_solvers().front().name},
      {"solver-tolerance", fmt::format("{}", solver.tolerance)},
      {"solver-iterations", fmt::format("{}", solver.iterations)}};
  std::vector<Setting> settings;
  for (const auto& [option, own] : rows) {
    const auto found = run.reasons.find(option);
    if (found != run.reasons.end()) {
      settings.push_back(applied::shown(run, as_shipped(), siconos_options(), option, found->second));
      settings.back().engine_default = own;
      if (!kind.rough) settings.back().reason += "; it does nothing here, where no pair has friction";
    } else if (kind.rough && run.reasons.contains("solver")) {
      settings.push_back({siconos_options().row(option).setting, own, own, "that solver's own"});
    }
  }
  return settings;
}

}  // namespace

const applied::Options& siconos_options() {
  static const applied::Options options("siconos", rows());
  return options;
}

core::Engine siconos_engine(std::string version) {
  core::Engine engine{
      "siconos",
      std::move(version),
      "double",
      {path("as-shipped", "every setting as Siconos has it by itself"),
       path("as-expert", "one rule for all scenes; its settings say where they hold")},
      "always 'as-shipped'",
      {{midpoint, 2, "linear momentum; theta = 1/2; order 1 with contacts or forces that read velocities"},
       {implicit, 1, "linear momentum; theta = 1"}},
      siconos_options().offered()};
  engine.knows = {"collision_filters", "frame_acceleration", "body_gravity"};
  return engine;
}

applied::Settings siconos_settings(const core::Engine& engine, const core::Setup& setup,
                                   const SiconosKind& kind) {
  return applied::chosen(as_shipped(), siconos_options(), engine, setup, applied::holding(rules, kind));
}

siconos_border::Settings siconos_border_settings(const applied::Settings& run, double dt) {
  siconos_border::Settings settings;
  settings.dt = dt, settings.theta = run.integrator == midpoint ? 0.5 : 1;
  settings.newton_tolerance = run.at("newton-tolerance");
  settings.newton_iterations = static_cast<int>(run.at("newton-iterations"));
  settings.solver = static_cast<std::size_t>(run.at("solver"));
  if (run.reasons.contains("solver-tolerance")) settings.solver_tolerance = run.at("solver-tolerance");
  if (run.reasons.contains("solver-iterations"))
    settings.solver_iterations = static_cast<int>(run.at("solver-iterations"));
  return settings;
}

core::Terms siconos_terms(const applied::Settings& run, const SiconosKind& kind) {
  core::Terms terms{run.path, run.integrator, order(run, kind), "implicit", of_the_scene(), unforceable()};
  for (const auto& [option, reason] : run.reasons)
    if (!option.starts_with("solver"))
      terms.settings.push_back(applied::shown(run, as_shipped(), siconos_options(), option, reason));
  for (const Setting& one : friction_settings(run, kind)) terms.settings.push_back(one);
  return terms;
}

}  // namespace cylon::simulators
