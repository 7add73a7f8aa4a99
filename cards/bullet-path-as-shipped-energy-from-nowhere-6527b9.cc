// Bullet 3.24, energy from nowhere at fine steps alone: 2 bodies, restitution, sphere.
// What should happen: the energy never rises: blows, friction, dampers and drag give none.
// It prints 1.64 J.
// apt-get install g++ pkg-config libbullet-dev && c++ -std=c++20 bullet-path-as-shipped-energy-from-nowhere-6527b9.cc -o fault $(pkg-config --cflags --libs bullet-float64) && ./fault
#include <btBulletDynamicsCommon.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <valarray>
#include <vector>

using std::abs, std::asin, std::cos, std::max, std::min, std::sqrt;
using V = std::valarray<double>;  // vectors (x, y, z) in world axes, quaternions (w, x, y, z) from body to world axes
V mul(double s, const V& a) { return s * a; }
V each(const V& a, const V& b) { return a * b; }
V cross(const V& a, const V& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
double dot(const V& a, const V& b) { return (a * b).sum(); }
V turn(const V& q, const V& v) { V u = {q[1], q[2], q[3]}, t = mul(2, cross(u, v)); return v + q[0] * t + cross(u, t); }
V back(const V& q, const V& v) { return turn({q[0], -q[1], -q[2], -q[3]}, v); }

struct State { V x, q, v, w; };  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
struct Body { double m; V I; };  // mass [kg], moments about the axes of the body [kg m^2]
using Path = std::vector<std::vector<State>>;
Path record(const std::vector<State>& s) { return {s}; }
void append(Path& path, const std::vector<State>& s) { path.push_back(s); }

const std::vector<Body> body = {{1.0, V{0.03721, 0.03721, 0.03721}}, {1.0, V{0.03721, 0.03721, 0.03721}}};
const Path start = {{{V{0.0, 0.0, 0.0}, V{1.0, 0.0, 0.0, 0.0}, V{0.0, 0.0, 0.0}, V{0.0, 0.0, 0.0}}, {V{1.13, 0.08, 0.08}, V{1.0, 0.0, 0.0, 0.0}, V{-5.2, 0.0, 0.0}, V{0.0, 0.0, 0.0}}}};
const std::vector<V> gravity = {V{0.0, 0.0, 0.0}};
const double dt = 0.005;
const int steps = 28, count = 2;

btDefaultCollisionConfiguration configuration;
btCollisionDispatcher dispatcher(&configuration);
btDbvtBroadphase* broadphase;
btSequentialImpulseConstraintSolver* solver;
btDiscreteDynamicsWorld* world;
std::vector<btRigidBody*> id;

btVector3 bt(const V& v) { return btVector3(v[0], v[1], v[2]); }
V of(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btCollisionShape* sharp(btCollisionShape* shape) {
  return shape;
}

btRigidBody* add_body(double mass, const V& I, const State& s, btCollisionShape* shape, bool touches) {
  btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape, bt(I));
  info.m_startWorldTransform = btTransform(btQuaternion(s.q[1], s.q[2], s.q[3], s.q[0]), bt(s.x));
  auto* one = new btRigidBody(info);
  if (mass > 0) one->setLinearVelocity(bt(s.v)), one->setAngularVelocity(bt(s.w));
  touches ? world->addRigidBody(one) : world->addRigidBody(one, 0, 0);
  return one;
}

void build(int take) {
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(1.0); };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0.0); };
  broadphase = new btDbvtBroadphase, solver = new btSequentialImpulseConstraintSolver;
  world = new btDiscreteDynamicsWorld(&dispatcher, broadphase, solver, &configuration);
  world->setGravity(bt(gravity[take]));
  btContactSolverInfo& info = world->getSolverInfo();
  (void)info;
  id.clear();
  id.push_back(add_body(body[0].m, body[0].I, start[take][0], new btSphereShape(0.305), true));
  id.push_back(add_body(body[1].m, body[1].I, start[take][1], new btSphereShape(0.305), true));
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

auto value(const auto& s) {
  auto E = 0.0;
  for (auto i = 0; i < count; ++i) {
    auto w = back(s[i].q, s[i].w);
    E += 0.5 * body[i].m * dot(s[i].v, s[i].v) + 0.5 * dot(w, each(body[i].I, w)) - body[i].m * dot(gravity[0], s[i].x);
  }
  return E;
}

int main() {
  auto path = run(0);
  auto least = value(path[0]);
  auto worst = 0.0;
  for (auto k = 1; k <= steps; ++k) {
    worst = max(worst, value(path[k]) - least);
    least = min(least, max(value(path[k - 1]), value(path[k])));
  }
  std::printf("%.9g J\n", worst);
}
