// Rapier's API in Node.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
await RAPIER.init();
const xyz = ([x, y, z]) => ({x, y, z}), wxyz = ([w, x, y, z]) => ({w, x, y, z}), of = ({x, y, z}) => [x, y, z];
let world, id;

function add_shape(shape, to) {
  world.createCollider(shape.setDensity(0).setRestitution(${restitution}).setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Min)
    .setFriction(${friction}).setFrictionCombineRule(RAPIER.CoefficientCombineRule.Min), to);
}

function build(take) {
  world = new RAPIER.World(xyz(gravity[take]));
  world.integrationParameters.dt = dt;
${world_settings}${planes}  id = body.map(({m, I}, i) => {
    const s = start[take][i];
    return world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setTranslation(...s.x).setRotation(wxyz(s.q)).setLinvel(...s.v)
      .setAngvel(xyz(s.w)).setAdditionalMassProperties(m, xyz([0, 0, 0]), xyz(I), wxyz([1, 0, 0, 0]))${body_settings});
  });
${shapes}  const ground = world.createRigidBody(RAPIER.RigidBodyDesc.fixed());
${joints}}

let pushed = false;
function push(i, F, T) { id[i].addForce(xyz(F), true), id[i].addTorque(xyz(T), true), pushed = true; }
function step() {
  world.step();
  if (pushed) for (const b of id) b.resetForces(true), b.resetTorques(true);  // else they stay
  pushed = false;
}

function states() {
  return id.map((b) => {
    const q = b.rotation();
    return {x: of(b.translation()), q: [q.w, q.x, q.y, q.z], v: of(b.linvel()), w: of(b.angvel())};
  });
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "RAPIER.ColliderDesc.ball(${radius})"},
    {"box", "RAPIER.ColliderDesc.cuboid(${x}, ${y}, ${z})"},
    {"capsule", "RAPIER.ColliderDesc.capsule(${length} / 2, ${radius})"},
    {"cylinder", "RAPIER.ColliderDesc.cylinder(${length} / 2, ${radius})"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  world.createImpulseJoint(RAPIER.JointData.spherical(xyz(${local_a}), xyz(${point_vector})), "
     "id[${a}], ground, true);\n",
     "  world.createImpulseJoint(RAPIER.JointData.spherical(xyz(${local_a}), xyz(${local_b})), id[${a}], "
     "id[${b}], "
     "true);\n"},
    {JointType::hinge,
     "  world.createImpulseJoint(RAPIER.JointData.revoluteWithAxes(xyz(${local_a}), xyz(${point_vector}), "
     "xyz(${axis_a}), "
     "xyz(${axis_vector})), id[${a}], ground, true);\n",
     "  world.createImpulseJoint(RAPIER.JointData.revoluteWithAxes(xyz(${local_a}), xyz(${local_b}), "
     "xyz(${axis_a}), "
     "xyz(${axis_b})), id[${a}], id[${b}], true);\n"},
};

constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"features of the Rust crate", "", Where::program, ""},  // the package has them
    {"mass, inertia", "", Where::program, ""},
    {"restitution, friction", "", Where::program, ""},
    {"forces of a step", "", Where::program, ""},
    {"collision filter", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"canSleep", "off", Where::body, ".setCanSleep(false)"},
    {"numSolverIterations", "", Where::world,
     "  world.integrationParameters.numSolverIterations = ${value};\n"},
    {"numInternalPgsIterations", "", Where::world,
     "  world.integrationParameters.numInternalPgsIterations = ${value};\n"},
    {"normalizedPredictionDistance", "", Where::world,
     "  world.integrationParameters.normalizedPredictionDistance = ${value};\n"},
    {"normalizedAllowedLinearError", "", Where::world,
     "  world.integrationParameters.normalizedAllowedLinearError = ${value};\n"},
    {"contact_natural_frequency", "", Where::world,
     "  world.integrationParameters.contact_natural_frequency = ${value};\n"},
};

constexpr Dialect of_build(std::string_view engine, std::string_view title, std::string_view install,
                           std::string_view head) {
  return {
      engine,
      title,
      &javascript,
      install,
      "node ${file}",
      head,
      functions,
      "  add_shape(${shape}, id[${i}]);\n",
      "",
      "  add_shape(new RAPIER.ColliderDesc(new RAPIER.HalfSpace({x: 0, y: 1, z: 0})), world.createRigidBody("
      "RAPIER.RigidBodyDesc.fixed().setTranslation(...${foot}).setRotation(wxyz(${turn_of_y}))));\n",
      shapes,
      joints,
      settings};
}

}  // namespace

extern const Dialect rapier, rapier_deterministic, rapier_simd;
const Dialect rapier = of_build("rapier", "Rapier", "npm install @dimforge/rapier3d-compat",
                                "import RAPIER from '@dimforge/rapier3d-compat';\n");
const Dialect rapier_deterministic =
    of_build("rapier-deterministic", "Rapier, deterministic build",
             "npm install @dimforge/rapier3d-deterministic-compat",
             "import RAPIER from '@dimforge/rapier3d-deterministic-compat';\n");
const Dialect rapier_simd =
    of_build("rapier-simd", "Rapier, SIMD build", "npm install @dimforge/rapier3d-simd-compat",
             "import RAPIER from '@dimforge/rapier3d-simd-compat';\n");

}  // namespace cylon::hunt::program
