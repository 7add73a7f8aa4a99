// Bullet's API, rigid bodies in double precision.
#include "harness/hunt/program/bullet_shapes.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
btDefaultCollisionConfiguration configuration;
btCollisionDispatcher dispatcher(&configuration);
btDbvtBroadphase* broadphase;
btSequentialImpulseConstraintSolver* solver;
btDiscreteDynamicsWorld* world;
std::vector<btRigidBody*> id;

btVector3 bt(const V& v) { return btVector3(v[0], v[1], v[2]); }
V of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btCollisionShape* sharp(btCollisionShape* shape) {
${shape_settings}  return shape;
}

btRigidBody* add_body(double mass, const V& I, const State& s, btCollisionShape* shape, bool touches) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, bt(I));
  info.m_startWorldTransform = btTransform(btQuaternion(s.q[1], s.q[2], s.q[3], s.q[0]), bt(s.x));
  auto* one = new btRigidBody(info);
${body_settings}  if (mass > 0) one->setLinearVelocity(bt(s.v)), one->setAngularVelocity(bt(s.w));
  touches ? world->addRigidBody(one) : world->addRigidBody(one, 0, 0);
  return one;
}

void build(int take) {
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(${restitution}); };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(${friction}); };
  broadphase = new btDbvtBroadphase, solver = new btSequentialImpulseConstraintSolver;
  world = new btDiscreteDynamicsWorld(&dispatcher, broadphase, solver, &configuration);
  world->setGravity(bt(gravity[take]));
  btContactSolverInfo& info = world->getSolverInfo();
  (void)info;
${world_settings}  id.clear();
${planes}${shapes}${joints}}

void push(int i, const V& F, const V& T) { id[i]->applyCentralForce(bt(F)), id[i]->applyTorque(bt(T)); }
void step() { world->stepSimulation(dt, 0); }

std::vector<State> states() {
  std::vector<State> all;
  for (btRigidBody* b : id) {
    const btQuaternion q = b->getWorldTransform().getRotation();
    all.push_back({of(b->getWorldTransform().getOrigin()), {q.w(), q.x(), q.y(), q.z()}, of(b->getLinearVelocity()), of(b->getAngularVelocity())});
  }
  return all;
}
)";

constexpr JointRow joints[] = {
    {JointType::ball,
     "  world->addConstraint(new btPoint2PointConstraint(*id[${a}], bt(${local_a})), true);\n",
     "  world->addConstraint(new btPoint2PointConstraint(*id[${a}], *id[${b}], bt(${local_a}), "
     "bt(${local_b})), true);\n"},
    {JointType::hinge,
     "  world->addConstraint(new btHingeConstraint(*id[${a}], bt(${local_a}), bt(${axis_a})), true);\n",
     "  world->addConstraint(new btHingeConstraint(*id[${a}], *id[${b}], bt(${local_a}), bt(${local_b}), "
     "bt(${axis_a}), "
     "bt(${axis_b})), true);\n"},
};

constexpr SettingRow settings[] = {
    {"stepSimulation", "(dt, 0)", Where::program, ""},
    {"combined restitution and friction", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"constraint solver", "sequential-impulse", Where::program, ""},
    {"activation state, canSleep", "off", Where::body, "  one->setActivationState(DISABLE_DEACTIVATION);\n"},
    {"contactProcessingThreshold", "", Where::body, "  one->setContactProcessingThreshold(${value});\n"},
    {"gyroscopic term", "none", Where::body, "  one->setFlags(0);\n"},
    {"gyroscopic term", "explicit", Where::body, "  one->setFlags(BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT);\n"},
    {"gyroscopic term", "implicit-world", Where::body,
     "  one->setFlags(BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD);\n"},
    {"setMargin", "", Where::shape, "  shape->setMargin(${value});\n"},
    {"gContactBreakingThreshold", "", Where::world, "  gContactBreakingThreshold = ${value};\n"},
    {"m_splitImpulse", "off", Where::world, "  info.m_splitImpulse = 0;\n"},
    {"m_*", "", Where::world, "  info.${name} = ${value};\n"},
};

}  // namespace

extern const Dialect bullet;
const Dialect bullet = {
    "bullet",
    "Bullet",
    &cpp,
    "apt-get install g++ pkg-config libbullet-dev",
    "c++ -std=c++20 ${file} -o fault $(pkg-config --cflags --libs bullet-float64) && ./fault",
    "#include <btBulletDynamicsCommon.h>\n",
    functions,
    "  id.push_back(add_body(body[${i}].m, body[${i}].I, start[take][${i}], ${shape}, true));\n",
    "  id.push_back(add_body(body[${i}].m, body[${i}].I, start[take][${i}], new btEmptyShape, false));\n",
    "  add_body(0, V{0, 0, 0}, {V{0, 0, 0}, V{1, 0, 0, 0}, V{0, 0, 0}, V{0, 0, 0}}, "
    "new btStaticPlaneShape(bt(${normal_vector}), ${offset}), true);\n",
    bullet_shapes,
    joints,
    settings};

}  // namespace cylon::hunt::program
