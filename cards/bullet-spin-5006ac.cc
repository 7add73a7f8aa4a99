// Bullet 3.24, spin at the coarse step alone: 1 body, sphere.
// What should happen: a ball that no torque turns turns evenly.
// It prints 0.0125 rad.
// apt-get install g++ pkg-config libbullet-dev && c++ -std=c++20 bullet-spin-5006ac.cc -o fault $(pkg-config --cflags --libs bullet-float64) && ./fault
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
V quaternion(double w, const V& v) { return {w, v[0], v[1], v[2]}; }
V product(const V& p, const V& q) { return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2], p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3], p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1]}; }

struct State { V x, q, v, w; };  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
struct Body { double m; V I; };  // mass [kg], moments about the axes of the body [kg m^2]
using Path = std::vector<std::vector<State>>;
Path record(const std::vector<State>& s) { return {s}; }
void append(Path& path, const std::vector<State>& s) { path.push_back(s); }

const std::vector<Body> body = {{1.0, V{0.032718399999999995, 0.032718399999999995, 0.032718399999999995}}};
const Path start = {{{V{0.0, 0.0, 0.0}, V{1.0, 0.0, 0.0, 0.0}, V{0.0, 0.0, 0.0}, V{-20.0, 0.0, 80.0}}}};
const std::vector<V> gravity = {V{0.0, 0.0, 0.0}};
const double dt = 0.01;
const int steps = 3, count = 1;

btDefaultCollisionConfiguration configuration;
btCollisionDispatcher dispatcher(&configuration);
btDbvtBroadphase* broadphase;
btSequentialImpulseConstraintSolver* solver;
btDiscreteDynamicsWorld* world;
std::vector<btRigidBody*> id;

btVector3 bt(const V& v) { return btVector3(v[0], v[1], v[2]); }
V of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btCollisionShape* sharp(btCollisionShape* shape) {
  shape->setMargin(0);
  return shape;
}

btRigidBody* add_body(double mass, const V& I, const State& s, btCollisionShape* shape, bool touches) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, bt(I));
  info.m_startWorldTransform = btTransform(btQuaternion(s.q[1], s.q[2], s.q[3], s.q[0]), bt(s.x));
  auto* one = new btRigidBody(info);
  one->setActivationState(DISABLE_DEACTIVATION);
  if (mass > 0) one->setLinearVelocity(bt(s.v)), one->setAngularVelocity(bt(s.w));
  touches ? world->addRigidBody(one) : world->addRigidBody(one, 0, 0);
  return one;
}

void build(int take) {
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0.0); };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0.0); };
  broadphase = new btDbvtBroadphase, solver = new btSequentialImpulseConstraintSolver;
  world = new btDiscreteDynamicsWorld(&dispatcher, broadphase, solver, &configuration);
  world->setGravity(bt(gravity[take]));
  btContactSolverInfo& info = world->getSolverInfo();
  (void)info;
  id.clear();
  id.push_back(add_body(body[0].m, body[0].I, start[take][0], new btEmptyShape, false));
}

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

auto run(const auto& take) {
  build(take);
  auto path = record(states());
  for (auto k = 1; k <= steps; ++k) {
    step();
    append(path, states());
  }
  return path;
}

auto evenly_turned(const auto& q, const auto& w, const auto& t) {
  auto rate = max(norm(w), 1e-300);
  return product(quaternion(cos(0.5 * rate * t), mul(sin(0.5 * rate * t) / rate, w)), q);
}
auto worst_of(const auto& path) {
  auto worst = 0.0;
  for (auto k = 0; k <= steps; ++k)
    for (auto i = 0; i < count; ++i) {
      auto must = evenly_turned(start[0][i].q, start[0][i].w, k * dt);
      auto apart = min(norm(sub(path[k][i].q, must)), norm(add(path[k][i].q, must)));
      worst = max(worst, 4 * asin(min(1.0, apart / 2)));
    }
  return worst;
}

int main() {
  auto path = run(0);
  auto worst = worst_of(path);
  std::printf("%.9g rad\n", worst);
}
