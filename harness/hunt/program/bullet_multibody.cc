// Bullet's API, bodies of reduced coordinates (btMultiBody) in double precision; without joints.
#include "harness/hunt/program/bullet_shapes.h"

namespace cylon::hunt::program {
namespace {

using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
btDefaultCollisionConfiguration configuration;
btCollisionDispatcher dispatcher(&configuration);
btMultiBodyDynamicsWorld* world;
std::vector<btMultiBody*> id;

btVector3 bt(const V& v) { return btVector3(v[0], v[1], v[2]); }
V of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btCollisionShape* sharp(btCollisionShape* shape) {
${shape_settings}  return shape;
}

void add_body(const Body& part, const State& s, btCollisionShape* shape) {
  auto* one = new btMultiBody(0, part.m, bt(part.I), false, false);
  one->finalizeMultiDof();
  one->setBaseWorldTransform(btTransform(btQuaternion(s.q[1], s.q[2], s.q[3], s.q[0]), bt(s.x)));
  one->setBaseVel(bt(s.v)), one->setBaseOmega(bt(s.w));
  auto* collider = new btMultiBodyLinkCollider(one, -1);
${body_settings}  if (shape) {
    collider->setCollisionShape(shape);
    collider->setWorldTransform(one->getBaseWorldTransform());
    one->setBaseCollider(collider);
    world->addCollisionObject(collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }
  world->addMultiBody(one);
  id.push_back(one);
}

void build(int take) {
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(${restitution}); };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(${friction}); };
  world = new btMultiBodyDynamicsWorld(&dispatcher, new btDbvtBroadphase, new btMultiBodyConstraintSolver, &configuration);
  world->setGravity(bt(gravity[take]));
  btContactSolverInfo& info = world->getSolverInfo();
  (void)info;
${world_settings}  id.clear();
${planes}${shapes}${joints}}

void push(int i, const V& F, const V& T) { id[i]->addBaseForce(bt(F)), id[i]->addBaseTorque(bt(T)); }
void step() { world->stepSimulation(dt, 0); }

std::vector<State> states() {
  std::vector<State> all;
  for (btMultiBody* b : id) {
    const btQuaternion q = b->getWorldToBaseRot().inverse();
    all.push_back({of(b->getBasePos()), {q.w(), q.x(), q.y(), q.z()}, of(b->getBaseVel()), of(b->getBaseOmega())});
  }
  return all;
}
)";

constexpr SettingRow settings[] = {
    {"stepSimulation", "(dt, 0)", Where::program, ""},
    {"combined restitution and friction", "", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"constraint solver", "sequential-impulse", Where::program, ""},
    {"activation state, canSleep", "off", Where::body,
     "  collider->setActivationState(DISABLE_DEACTIVATION);\n"},
    {"contactProcessingThreshold", "", Where::body, "  collider->setContactProcessingThreshold(${value});\n"},
    {"setLinearDamping, setAngularDamping", "", Where::body,
     "  one->setLinearDamping(${value}), one->setAngularDamping(${value});\n"},
    {"setMaxCoordinateVelocity", "no limit", Where::body,
     "  one->setMaxCoordinateVelocity(BT_LARGE_FLOAT);\n"},
    {"setMaxAppliedImpulse*", "", Where::program, ""},
    {"gyroscopic term", "none", Where::body, "  one->setUseGyroTerm(false);\n"},
    {"gyroscopic term", "explicit", Where::program, ""},
    {"setMargin", "", Where::shape, "  shape->setMargin(${value});\n"},
    {"gContactBreakingThreshold", "", Where::world, "  gContactBreakingThreshold = ${value};\n"},
    {"m_splitImpulse", "off", Where::world, "  info.m_splitImpulse = 0;\n"},
    {"m_*", "", Where::world, "  info.${name} = ${value};\n"},
};

}  // namespace

extern const Dialect bullet_multibody;
const Dialect bullet_multibody = {
    "bullet-multibody",
    "Bullet's btMultiBody",
    &cpp,
    "apt-get install g++ pkg-config libbullet-dev",
    "c++ -std=c++20 ${file} -o fault $(pkg-config --cflags --libs bullet-float64) && ./fault",
    "#include <BulletDynamics/Featherstone/btMultiBody.h>\n"
    "#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>\n"
    "#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>\n"
    "#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>\n"
    "#include <btBulletDynamicsCommon.h>\n",
    functions,
    "  add_body(body[${i}], start[take][${i}], ${shape});\n",
    "  add_body(body[${i}], start[take][${i}], nullptr);\n",
    "  world->addRigidBody(new btRigidBody(0, nullptr, new btStaticPlaneShape(bt(${normal_vector}), "
    "${offset})));\n",
    bullet_shapes,
    {},
    settings};

}  // namespace cylon::hunt::program
