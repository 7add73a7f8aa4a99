#include "reference/simulators/simbody/simbody_settings.h"

#include "reference/applied/forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;

// ---- Integrators ------------------------------------------------------------------------------------

constexpr const char* one_step = "nothing in particular; one step is one dt";
constexpr const char* own_steps =
    "nothing in particular; its own steps, whose local error the tolerance bounds";

// The first is Simbody's in 27 of its examples, more than any other.
constexpr SimbodyIntegrator integrators[] = {
    {"runge-kutta-merson", SimbodyMethod::merson, false, 4, one_step},
    {"runge-kutta-feldberg", SimbodyMethod::feldberg, false, 4,
     "nothing in particular; it goes on with its solution of order 4, though Simbody calls it of order 5"},
    {"runge-kutta-3", SimbodyMethod::rk3, false, 3, one_step},
    {"verlet", SimbodyMethod::verlet, false, 2, "nothing in particular; velocities by iteration"},
    {"semi-explicit-euler", SimbodyMethod::semi_explicit_euler, false, 1, "linear momentum"},
    {"semi-explicit-euler-2", SimbodyMethod::semi_explicit_euler_2, false, 1,
     "linear momentum; one step is two of half the size"},
    {"runge-kutta-merson-adaptive", SimbodyMethod::merson, true, 4, own_steps},
    {"runge-kutta-feldberg-adaptive", SimbodyMethod::feldberg, true, 4, own_steps},
    {"runge-kutta-3-adaptive", SimbodyMethod::rk3, true, 3, own_steps},
    {"verlet-adaptive", SimbodyMethod::verlet, true, 2, own_steps},
    {"semi-explicit-euler-2-adaptive", SimbodyMethod::semi_explicit_euler_2, true, 1, own_steps},
};

// ---- Options ----------------------------------------------------------------------------------------

// Defaults: simmath IntegratorRep.h:738 and :739, simmath/Integrator.h:328 to :384.
std::vector<applied::Option> rows() {
  return {
      {.name = "accuracy",
       .setting = "setAccuracy",
       .engine_default = 1e-3,
       .meaning =
           "bound on the local error of each step, relative to the scales of the state; at fixed steps of "
           "verlet's iteration, and of what is projected, alone",
       .least = 0,
       .most = 1,
       .above = true},
      {.name = "constraint-tolerance",
       .setting = "setConstraintTolerance",
       .engine_default = 1e-4,
       .meaning =
           "violation of constraints up to which a step is left as it is; a tenth of the accuracy where it "
           "is not set [m, rad]",
       .least = 0,
       .most = 1,
       .above = true},
      {.name = "project",
       .setting = "setProjectEveryStep",
       .words = {"where-needed", "every-step"},
       .engine_default = 0,
       .meaning = "whether steps that keep the constraints within their tolerance are projected too"},
      {.name = "norm",
       .setting = "setUseInfinityNorm",
       .words = {"rms", "infinity"},
       .engine_default = 0,
       .meaning = "of the errors of steps and constraints"},
      {.name = "interpolation",
       .setting = "setAllowInterpolation",
       .words = {"disable", "enable"},
       .engine_default = 1,
       .meaning =
           "with error control: samples within a step by its cubic, whose error nothing bounds; else a "
           "step ends at each sample"},
  };
}

// ---- What holds on every path -----------------------------------------------------------------------

std::vector<Setting> of_the_scene() {
  return {
      {"setFixedStepSize", "dt, without error control", "steps by error control",
       "one step of the run is one step of Simbody, to the same time"},
      {"joints", "a tree", "as modelled", "Free, Ball, Pin and Weld; what closes a loop is a constraint"},
      {"openblas_set_num_threads", "1", "the processors of the machine",
       "the last bits of loops and rods would depend on the machine"},
      {applied::applied_forces, "Force::Custom, at each evaluation of the acceleration", "none",
       "the laws of the scene, so that an integrator keeps its order; a mass that changes is constant during "
       "a "
       "step, and each step begins anew"},
  };
}

// What Simbody does all the same; in brackets the place in the headers, or in the sources of 3.7 below SimTKmath/.
std::vector<std::string> unforceable() {
  return {
      "Contacts are compliant, with a stiffness that no scene states; what may touch is refused "
      "(simbody/internal/ContactSurface.h:91).",
      "A start that violates a constraint is moved onto it before the first step "
      "(Integrators/src/Integrator.cpp:376).",
      "At a fixed step an iteration or a projection that fails is taken all the same, which a remark says "
      "(Integrators/src/AbstractIntegratorRep.cpp, adjustStepSize).",
      "A step whose estimated error is above 2^order times the accuracy is not projected onto the "
      "constraints "
      "(Integrators/src/AbstractIntegratorRep.cpp, attemptDAEStep).",
      "Constraints are kept to their tolerance, and not below (Integrators/src/IntegratorRep.h:739).",
      "Forces of joints are not told.",
      "A step runs on one thread.",
  };
}

// ---- What the paths set, as a table -----------------------------------------------------------------

bool always(const SimbodyKind&) { return true; }
bool loops(const SimbodyKind& kind) { return kind.loops; }

constexpr const char* everywhere = "everywhere";
constexpr const char* with_loops = "where a joint closes a loop or keeps a distance";

constexpr applied::RuleFor<SimbodyKind> rules[] = {
    {{"as-expert", "integrator", "runge-kutta-feldberg", everywhere,
      "the least error of its fixed steps below 1/100 s or so"},
     always},
    {{"as-expert", "constraint-tolerance", "1e-10", with_loops, "a loop must not open"}, loops},
    {{"as-expert", "project", "every-step", with_loops, "a loop must not open"}, loops},
    {{"as-expert", "interpolation", "disable", everywhere, "the error of a cubic is not controlled"}, always},
};

core::Path path(const char* name, std::string summary) {
  return applied::path(name, std::move(summary), simbody_as_shipped(), simbody_options(), applied::all(rules),
                       of_the_scene(), unforceable());
}

// The tolerance of a run with error control, which reports and the theory of errors read.
Setting tolerance_of(const applied::Settings& run) {
  return {"tolerance of a step", fmt::format("{:g}", run.at("accuracy")), "0.001",
          "bound on the local error of each step, relative to the scales of the state"};
}

}  // namespace

const SimbodyIntegrator& simbody_integrator(const std::string& name) {
  const auto found =
      std::ranges::find(integrators, name, [](const auto& one) { return std::string(one.name); });
  if (found == std::end(integrators)) throw std::logic_error(fmt::format("unknown integrator '{}'", name));
  return *found;
}

const applied::Options& simbody_options() {
  static const applied::Options options("simbody", rows());
  return options;
}

applied::Settings simbody_as_shipped() {
  return {"as-shipped", integrators[0].name, simbody_options().defaults(), {}};
}

core::Engine simbody_engine(std::string version) {
  core::Engine engine{"simbody",
                      std::move(version),
                      "double",
                      {path("as-shipped", "every setting as Simbody has it by itself"),
                       path("as-expert", "one rule for all scenes; its settings say where they hold")},
                      "always 'as-shipped'",
                      {},
                      simbody_options().offered()};
  for (const SimbodyIntegrator& one : integrators)
    engine.integrators.push_back({one.name, one.order, one.remark, one.adaptive});
  engine.knows = {"collision_filters",  "frame_acceleration", "body_gravity",     "slider_joints",
                  "cylindrical_joints", "planar_joints",      "universal_joints", "gimbal_joints",
                  "screw_joints",       "joint_forces",       "joint_targets"};
  return engine;
}

applied::Settings simbody_settings(const core::Engine& engine, const core::Setup& setup,
                                   const SimbodyKind& kind) {
  applied::Settings run =
      applied::chosen(simbody_as_shipped(), simbody_options(), engine, setup, applied::holding(rules, kind));
  const bool adaptive = simbody_integrator(run.integrator).adaptive;
  if (setup.tolerance > 0) {
    if (setup.options.contains("accuracy"))
      throw std::invalid_argument("simbody: a tolerance and option accuracy are the same; give one of them");
    if (!adaptive)
      throw std::invalid_argument(
          fmt::format("simbody: {} takes steps of dt and no tolerance", run.integrator));
    if (setup.tolerance > 1)
      throw std::invalid_argument(
          fmt::format("simbody: tolerance {} is not a number in (0, 1]", setup.tolerance));
    run.values["accuracy"] = setup.tolerance;
  }
  if (!adaptive && setup.options.contains("interpolation"))
    throw std::invalid_argument(
        fmt::format("simbody: option interpolation does nothing with {}, which ends a step at each sample",
                    run.integrator));
  if (!adaptive) run.reasons.erase("interpolation");
  return run;
}

core::Terms simbody_terms(const applied::Settings& run, const SimbodyKind& kind) {
  const SimbodyIntegrator& integrator = simbody_integrator(run.integrator);
  core::Terms terms{run.path,
                    run.integrator,
                    kind.changes ? 1 : integrator.order,
                    integrator.method == SimbodyMethod::verlet ? "implicit" : "explicit",
                    of_the_scene(),
                    unforceable()};
  if (integrator.adaptive) terms.settings.push_back(tolerance_of(run));
  for (const auto& [option, reason] : run.reasons)
    terms.settings.push_back(applied::shown(run, simbody_as_shipped(), simbody_options(), option, reason));
  return terms;
}

}  // namespace cylon::simulators
