// cannon-es' API in Node.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
const vec = (v) => new C.Vec3(...v), quat = ([w, x, y, z]) => new C.Quaternion(x, y, z, w), xyz = ({x, y, z}) => [x, y, z];
const friction = ${friction};
let world, id, mu = friction, maxForce = 1e6, spook = 1 / 60;

function build(take) {
  world = new C.World({gravity: vec(gravity[take])});
${world_settings}  const surface = new C.Material();
  const material = new C.ContactMaterial(surface, surface, {restitution: ${restitution}, friction: mu});
${shape_settings}  world.addContactMaterial(material);
  const plane = (foot, turn_of_z) => world.addBody(
    new C.Body({mass: 0, shape: new C.Plane(), material: surface, position: vec(foot), quaternion: quat(turn_of_z)}));
${planes}  id = body.map(({m, I}, i) => {
    const {x, q, v, w} = start[take][i];
    const made = new C.Body({mass: m, material: surface, position: vec(x), quaternion: quat(q), velocity: vec(v), angularVelocity: vec(w)${body_settings}});
    world.addBody(made);
    return made;
  });
${shapes}  body.forEach(({I}, i) => {  // a shape brings the inertia of its box
    id[i].inertia.copy(vec(I)), id[i].invInertia.copy(vec(I.map((one) => 1 / one))), id[i].updateInertiaWorld(true);
  });
${joints}}

function ground(point) {
  const made = new C.Body({mass: 0, position: vec(point)});
  world.addBody(made);
  return made;
}
function join(made) {
  made.collideConnected = false;
  if (spook !== 1 / 60) for (const equation of made.equations) equation.setSpookParams(1e7, 4, spook);
  world.addConstraint(made);
}

function push(i, F, T) { id[i].force.vadd(vec(F), id[i].force), id[i].torque.vadd(vec(T), id[i].torque); }
function step() { world.step(dt); }

function states() {
  return id.map(({position, quaternion: {x, y, z, w}, velocity, angularVelocity}) =>
    ({x: xyz(position), q: [w, x, y, z], v: xyz(velocity), w: xyz(angularVelocity)}));
}
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "new C.Sphere(${radius})"},
    {"box", "new C.Box(vec([${x}, ${y}, ${z}]))"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  join(new C.PointToPointConstraint(id[${a}], vec(${local_a}), ground(${point_vector}), vec([0, 0, "
     "0]), "
     "maxForce));\n",
     "  join(new C.PointToPointConstraint(id[${a}], vec(${local_a}), id[${b}], vec(${local_b}), "
     "maxForce));\n"},
    {JointType::hinge,
     "  join(new C.HingeConstraint(id[${a}], ground(${point_vector}), {pivotA: vec(${local_a}), pivotB: "
     "vec([0, 0, 0]), "
     "axisA: vec(${axis_a}), axisB: vec(${axis_vector}), maxForce}));\n",
     "  join(new C.HingeConstraint(id[${a}], id[${b}], {pivotA: vec(${local_a}), pivotB: vec(${local_b}), "
     "axisA: vec(${axis_a}), axisB: vec(${axis_b}), maxForce}));\n"},
};

constexpr SettingRow settings[] = {
    {"build", "", Where::program, ""},
    {"mass, inertia", "", Where::program, ""},
    {"restitution, friction", "", Where::program, ""},
    {"collision filter", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"gyroscopic torque", "", Where::program, ""},
    {"ContactMaterial.friction", "refused", Where::program, ""},
    {"ContactMaterial.friction", "times-dt", Where::world, "  mu = friction * dt;\n"},
    {"Body.linearDamping", "", Where::body, ", linearDamping: ${value}"},
    {"Body.angularDamping", "", Where::body, ", angularDamping: ${value}"},
    {"GSSolver.iterations", "", Where::world, "  world.solver.iterations = ${value};\n"},
    {"GSSolver.tolerance", "", Where::world, "  world.solver.tolerance = ${value};\n"},
    {"contactEquationStiffness", "", Where::shape, "  material.contactEquationStiffness = ${value};\n"},
    {"contactEquationRelaxation", "", Where::shape, "  material.contactEquationRelaxation = ${value};\n"},
    {"Constraint maxForce", "", Where::world, "  maxForce = ${value};\n"},
    {"Equation.setSpookParams", "dt", Where::world, "  spook = dt;\n"},
};

}  // namespace

extern const Dialect cannon;
const Dialect cannon = {"cannon-es",
                        "cannon-es",
                        &javascript,
                        "npm install cannon-es",
                        "node ${file}",
                        "import * as C from 'cannon-es';\n",
                        functions,
                        "  id[${i}].addShape(${shape});\n",
                        "",
                        "  plane(${foot}, ${turn_of_z});\n",
                        shapes,
                        joints,
                        settings};

}  // namespace cylon::hunt::program
