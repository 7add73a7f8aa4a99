#include "reference/simulators/dart/dart_settings.h"

#include "reference/applied/forces.h"
#include "reference/simulators/dart/dart_scene.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;

constexpr const char* scheme = "semi-implicit-euler";

// ---- Options ----------------------------------------------------------------------------------------

// Defaults: constraint/ContactConstraint.cpp:43 to :47, DynamicJointConstraint.cpp:40 to :43,
// PgsBoxedLcpSolver.hpp:54; dart_tests reads them from DART.
std::vector<applied::Option> rows() {
  return {
      {.name = "solver",
       .setting = "BoxedLcpSolver",
       .words = {"dantzig", "dantzig-alone", "pgs"},
       .engine_default = 0,
       .meaning =
           "dantzig: Dantzig's method, and sweeps where it gives up; pgs: projected Gauss-Seidel sweeps"},
      {.name = "sweeps",
       .setting = "PgsBoxedLcpSolver::Option::mMaxIteration",
       .engine_default = 30,
       .meaning = "sweeps at most; with solver=dantzig of those that Dantzig's method leaves",
       .least = 1,
       .most = 1e6,
       .whole = true},
      {.name = "sweep-change",
       .setting = "PgsBoxedLcpSolver::Option::mRelativeDeltaXTolerance",
       .engine_default = 1e-3,
       .meaning = "relative change of each impulse below which sweeps end",
       .least = 0,
       .most = 1},
      {.name = "contact-erp",
       .setting = "ContactConstraint::setErrorReductionParameter",
       .engine_default = 0.01,
       .meaning = "share of the depth that a step takes back, up to contact-correction",
       .least = 0,
       .most = 1},
      {.name = "contact-correction",
       .setting = "ContactConstraint::setMaxErrorReductionVelocity",
       .engine_default = 1e-3,
       .meaning = "speed at most of that [m/s]",
       .least = 0,
       .most = 1e6},
      {.name = "contact-cfm",
       .setting = "ContactConstraint::setConstraintForceMixing",
       .engine_default = 1e-5,
       .meaning = "softness of contacts, relative to the inverse mass at the contact",
       .least = 1e-9,
       .most = 1},
      {.name = "loop-erp",
       .setting = "DynamicJointConstraint::setErrorReductionParameter",
       .engine_default = 0.01,
       .meaning = "share of the gap of a closed loop that a step takes back",
       .least = 0,
       .most = 1},
      {.name = "loop-cfm",
       .setting = "DynamicJointConstraint::setConstraintForceMixing",
       .engine_default = 1e-9,
       .meaning = "softness of closed loops, relative to the inverse mass there",
       .least = 1e-9,
       .most = 1},
  };
}

// ---- What holds on every path -----------------------------------------------------------------------

std::vector<Setting> of_the_scene() {
  return {
      {"setTimeStep", "dt", "0.001", "one step of the run is one step of DART"},
      {"CollisionDetector", "dart", "fcl, all shapes as meshes",
       "exact spheres and boxes; what fcl has of a plane is a mesh without thickness, through which bodies "
       "fall"},
      {"planes", fmt::format("boxes {:g} m wide and {:g} m deep", 2 * dart_plane_reach, dart_plane_depth),
       "none in this detector", "its spheres and boxes are all there is"},
      {"restitution, friction", "of the pair", "0, product; 1, smaller",
       "a surface has one shape for each material of the scene in which it takes part"},
      {"CollisionFilter", "of the scene", "no neighbours in a skeleton, no pairs within one",
       "groups and masks; bodies that a joint ties do not touch, all others do"},
      {"maxNumContacts", "no bound", "1000", "no contact is left out"},
      {"joints", "a tree", "as modelled",
       "FreeJoint, BallJoint, RevoluteJoint, WeldJoint; what closes a loop is a constraint"},
      {applied::applied_forces, applied::as_applied, "none", applied::why_applied},
  };
}

// What DART does all the same; in brackets the place in the sources of 6.12.1, below dart/.
std::vector<std::string> unforceable() {
  return {
      "The gyroscopic torque is explicit.",
      "A bounce slower than 0.1 m/s after it is none, one faster than 100 m/s is 100 m/s "
      "(constraint/ContactConstraint.cpp:52 and :53).",
      "Friction is a pyramid whose axes follow from the normal and the world's z, with mu times the normal "
      "force along each: up to sqrt(2) of Coulomb's in between (constraint/ContactConstraint.cpp, "
      "getInformation). That normal force is the one before friction acts, which may be another at a single "
      "point (external/odelcpsolver/lcp.cpp, dSolveLCP).",
      "Restitution is Newton's, of all contacts of a step at once.",
      "A contact within 3e-12 m of another of the step is left out, whosever that is "
      "(collision/dart/DARTCollisionDetector.cpp:359).",
      "Two boxes have four contacts at most (collision/dart/DARTCollide.cpp:947).",
      "Spheres whose centres are within 1 mm have no contact (collision/dart/DARTCollide.cpp:1342).",
      "Contacts are detected at one instant, so an impact acts up to one step late; there is no continuous "
      "collision detection.",
      "All pairs of shapes are looked at in each step (collision/dart/DARTCollisionDetector.cpp:114).",
      "A state that is not finite ends the process by an assertion (dynamics/BodyNode.cpp:1624).",
      fmt::format(
          "There is no plane but a box: it ends {:g} m from the foot of the normal through the origin. A "
          "step that has a body past its edge says so.",
          dart_plane_reach),
      "Forces of joints are not told.",
      "A step runs on one thread.",
  };
}

// ---- What the paths set, as a table -----------------------------------------------------------------

bool touches(const DartKind& kind) { return kind.touches; }
bool loops(const DartKind& kind) { return kind.loops; }

constexpr applied::RuleFor<DartKind> rules[] = {
    {{"as-expert", "contact-cfm", "1e-9", "where something can touch", "contacts are rigid"}, touches},
    {{"as-expert", "loop-erp", "0.8", "where a joint closes a loop", "a loop must not open"}, loops},
};

applied::Settings as_shipped() { return {"as-shipped", scheme, dart_options().defaults(), {}}; }

core::Path path(const char* name, std::string summary) {
  return applied::path(name, std::move(summary), as_shipped(), dart_options(), applied::all(rules),
                       of_the_scene(), unforceable());
}

}  // namespace

const applied::Options& dart_options() {
  static const applied::Options options("dart", rows());
  return options;
}

core::Engine dart_engine(std::string version) {
  core::Engine engine{"dart",
                      std::move(version),
                      "double",
                      {path("as-shipped", "every option as DART has it by itself"),
                       path("as-expert", "one rule for all scenes; its settings say where they hold")},
                      "always 'as-shipped'",
                      {{scheme, 1, "linear momentum"}},
                      dart_options().offered()};
  engine.knows = {"collision_filters",  "frame_acceleration", "body_gravity",     "slider_joints",
                  "cylindrical_joints", "planar_joints",      "universal_joints", "gimbal_joints",
                  "screw_joints",       "joint_forces",       "joint_targets",    "joint_limits",
                  "joint_friction"};
  return engine;
}

applied::Settings dart_settings(const core::Engine& engine, const core::Setup& setup, const DartKind& kind) {
  applied::Settings run =
      applied::chosen(as_shipped(), dart_options(), engine, setup, applied::holding(rules, kind));
  const auto alone = static_cast<double>(dart_border::Solver::dantzig_alone);
  if (run.at("solver") == alone)
    for (const char* of_sweeps : {"sweeps", "sweep-change"})
      if (setup.options.contains(of_sweeps))
        throw std::invalid_argument(
            fmt::format("dart: option {} does nothing with solver=dantzig-alone", of_sweeps));
  return run;
}

dart_border::Settings dart_border_settings(const applied::Settings& run, double dt,
                                           const core::Vector3& gravity) {
  dart_border::Settings settings;
  settings.dt = dt, settings.gravity = to_dart(gravity);
  settings.solver = static_cast<dart_border::Solver>(static_cast<int>(run.at("solver")));
  settings.sweeps = static_cast<int>(run.at("sweeps"));
  settings.relative_change = run.at("sweep-change");
  settings.contact_erp = run.at("contact-erp");
  settings.contact_correction = run.at("contact-correction");
  settings.contact_cfm = run.at("contact-cfm");
  settings.loop_erp = run.at("loop-erp");
  settings.loop_cfm = run.at("loop-cfm");
  return settings;
}

core::Terms dart_terms(const applied::Settings& run) {
  core::Terms terms{run.path, run.integrator, 1, "explicit", of_the_scene(), unforceable()};
  for (const auto& [option, reason] : run.reasons)
    terms.settings.push_back(applied::shown(run, as_shipped(), dart_options(), option, reason));
  return terms;
}

}  // namespace cylon::simulators
