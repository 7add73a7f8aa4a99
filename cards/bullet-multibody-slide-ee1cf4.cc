// Bullet's btMultiBody 3.24, slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.00238 m.
// apt-get install g++ pkg-config libbullet-dev && c++ -std=c++20 bullet-multibody-slide-ee1cf4.cc -o fault $(pkg-config --cflags --libs bullet-float64) && ./fault
#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <valarray>
#include <vector>

using std::abs, std::asin, std::ceil, std::cos, std::max, std::min, std::sin, std::sqrt;
using V = std::valarray<double>;  // vectors (x, y, z) in world axes, quaternions (w, x, y, z) from body to world axes
V add(const V& a, const V& b) { return a + b; }
V sub(const V& a, const V& b) { return a - b; }
V mul(double s, const V& a) { return s * a; }
double dot(const V& a, const V& b) { return (a * b).sum(); }
double norm(const V& a) { return sqrt(dot(a, a)); }

struct State { V x, q, v, w; };  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
struct Body { double m; V I; };  // mass [kg], moments about the axes of the body [kg m^2]
using Path = std::vector<std::vector<State>>;
Path record(const std::vector<State>& s) { return {s}; }
void append(Path& path, const std::vector<State>& s) { path.push_back(s); }

const std::vector<Body> body = {{1.0, V{0.03475366666666666, 0.10941666666666666, 0.08215366666666667}}};
const Path start = {{{V{0.0, 0.106, 0.0}, V{1.0, 0.0, 0.0, 0.0}, V{1.0, 0.0, 1.0}, V{0.0, 0.0, 0.0}}}};
const std::vector<V> gravity = {V{0.0, -1.0, 0.0}};
const double dt = 0.01;
const int steps = 12, count = 1;

btDefaultCollisionConfiguration configuration;
btCollisionDispatcher dispatcher(&configuration);
btMultiBodyDynamicsWorld* world;
std::vector<btMultiBody*> id;

btVector3 bt(const V& v) { return btVector3(v[0], v[1], v[2]); }
V of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btCollisionShape* sharp(btCollisionShape* shape) {
  shape->setMargin(0);
  return shape;
}

void add_body(const Body& part, const State& s, btCollisionShape* shape) {
  auto* one = new btMultiBody(0, part.m, bt(part.I), false, false);
  one->finalizeMultiDof();
  one->setBaseWorldTransform(btTransform(btQuaternion(s.q[1], s.q[2], s.q[3], s.q[0]), bt(s.x)));
  one->setBaseVel(bt(s.v)), one->setBaseOmega(bt(s.w));
  auto* collider = new btMultiBodyLinkCollider(one, -1);
  collider->setActivationState(DISABLE_DEACTIVATION);
  one->setLinearDamping(0), one->setAngularDamping(0);
  one->setMaxCoordinateVelocity(BT_LARGE_FLOAT);
  if (shape) {
    collider->setCollisionShape(shape);
    collider->setWorldTransform(one->getBaseWorldTransform());
    one->setBaseCollider(collider);
    world->addCollisionObject(collider, btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }
  world->addMultiBody(one);
  id.push_back(one);
}

void build(int take) {
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0.0); };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(1.0); };
  world = new btMultiBodyDynamicsWorld(&dispatcher, new btDbvtBroadphase, new btMultiBodyConstraintSolver, &configuration);
  world->setGravity(bt(gravity[take]));
  btContactSolverInfo& info = world->getSolverInfo();
  (void)info;
  id.clear();
  world->addRigidBody(new btRigidBody(0, nullptr, new btStaticPlaneShape(bt(V{0.0, 1.0, 0.0}), 0.0)));
  add_body(body[0], start[take][0], sharp(new btBoxShape(btVector3(0.485, 0.106, 0.305))));
}

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

auto run(const auto& take) {
  build(take);
  auto path = record(states());
  for (auto k = 1; k <= steps; ++k) {
    step();
    append(path, states());
  }
  return path;
}

auto worst_of(const auto& path) {
  auto v = start[0][0].v;
  auto slowed = 1.0 * norm(gravity[0]) / norm(v);
  auto worst = 0.0;
  for (auto k = 0; k <= steps; ++k) {
    auto t = min(k * dt, 1 / slowed);
    auto must = add(start[0][0].x, mul(t - 0.5 * slowed * t * t, v));
    worst = max(worst, norm(sub(path[k][0].x, must)));
  }
  return worst;
}

int main() {
  auto path = run(0);
  auto worst = worst_of(path);
  std::printf("%.9g m\n", worst);
}
