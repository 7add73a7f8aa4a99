// Bullet 3.24, rebound at fine steps alone: 1 body, gravity, plane, restitution, sphere.
// What should happen: a ball leaves a plane with the coefficient of restitution times its speed of approach.
// It prints 0.913 m^2/s^2.
// apt-get install g++ pkg-config libbullet-dev && c++ -std=c++20 bullet-path-as-shipped-rebound-35edf1.cc -o fault $(pkg-config --cflags --libs bullet-float64) && ./fault
#include <btBulletDynamicsCommon.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <valarray>
#include <vector>

using std::abs, std::asin, std::ceil, std::cos, std::max, std::min, std::sin, std::sqrt;
using V = std::valarray<double>;  // vectors (x, y, z) in world axes, quaternions (w, x, y, z) from body to world axes
double dot(const V& a, const V& b) { return (a * b).sum(); }
double square(double x) { return x * x; }

struct State { V x, q, v, w; };  // centre of mass [m], turn, velocity [m/s], spin [rad/s]
struct Body { double m; V I; };  // mass [kg], moments about the axes of the body [kg m^2]
using Path = std::vector<std::vector<State>>;
Path record(const std::vector<State>& s) { return {s}; }
void append(Path& path, const std::vector<State>& s) { path.push_back(s); }

const std::vector<Body> body = {{1.0, V{0.06889, 0.06889, 0.06889}}};
const Path start = {{{V{0.0, 0.574, 0.0}, V{1.0, 0.0, 0.0, 0.0}, V{0.0, -3.9, 0.0}, V{0.0, 0.0, 0.0}}}};
const std::vector<V> gravity = {V{0.0, -10.0, 0.0}};
const double dt = 0.01;
const int steps = 7, count = 1;

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
  gCalculateCombinedRestitutionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0.9); };
  gCalculateCombinedFrictionCallback = [](const btCollisionObject*, const btCollisionObject*) { return btScalar(0.0); };
  broadphase = new btDbvtBroadphase, solver = new btSequentialImpulseConstraintSolver;
  world = new btDiscreteDynamicsWorld(&dispatcher, broadphase, solver, &configuration);
  world->setGravity(bt(gravity[take]));
  btContactSolverInfo& info = world->getSolverInfo();
  (void)info;
  id.clear();
  add_body(0, V{0, 0, 0}, {V{0, 0, 0}, V{1, 0, 0, 0}, V{0, 0, 0}, V{0, 0, 0}}, new btStaticPlaneShape(bt(V{0.0, 1.0, 0.0}), 0.0), true);
  id.push_back(add_body(body[0].m, body[0].I, start[take][0], new btSphereShape(0.415), true));
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

auto energy(const auto& s, const auto& n, const auto& g) { return 0.5 * square(dot(n, s.v)) + g * (dot(n, s.x) - 0.415); }
auto worst_of(const auto& path) {
  auto n = V{0.0, 1.0, 0.0};
  auto g = -dot(gravity[0], n);
  auto before = energy(path[0][0], n, g);
  auto blow = (dot(n, start[0][0].v) + sqrt(2 * before)) / g;
  auto k = ceil((blow + 3 * dt) / dt);
  return abs(energy(path[k][0], n, g) - 0.9 * 0.9 * before);
}

int main() {
  auto path = run(0);
  auto worst = worst_of(path);
  std::printf("%.9g m^2/s^2\n", worst);
}
