// ODE 0.16.2, slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.0222 m.
// apt-get install g++ pkg-config libode-dev && c++ -std=c++20 ode-slide-22b433.cc -o fault $(pkg-config --cflags --libs ode) && ./fault
#include <ode/ode.h>
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

const std::vector<Body> body = {{1.0, V{0.0028080066666666664, 0.0028080066666666664, 0.0028080066666666664}}};
const Path start = {{{V{0.0, 0.0649, 0.0}, V{1.0, 0.0, 0.0, 0.0}, V{1.0, 0.0, -2.0}, V{0.0, 0.0, 0.0}}}};
const std::vector<V> gravity = {V{0.0, -1.0, 0.0}};
const double dt = 0.1;
const int steps = 3, count = 1;

dWorldID world;
dSpaceID space;
dJointGroupID contacts;
std::vector<dBodyID> id;

void touch(void*, dGeomID a, dGeomID b) {
  dContact contact[8] = {};
  const int n = dCollide(a, b, 8, &contact[0].geom, sizeof(dContact));
  if (dGeomGetBody(a) && dGeomGetBody(b) && dAreConnected(dGeomGetBody(a), dGeomGetBody(b))) return;
  for (int i = 0; i < n; ++i) {
    contact[i].surface.mode = dContactApprox1 | dContactBounce;
    contact[i].surface.mu = 0.5;
    contact[i].surface.bounce = 0.0;
    dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
  }
}

void build(int take) {
  dInitODE2(0);
  world = dWorldCreate(), space = dHashSpaceCreate(nullptr), contacts = dJointGroupCreate(0);
  dWorldSetGravity(world, gravity[take][0], gravity[take][1], gravity[take][2]);
  dWorldSetERP(world, 0.2);
  dWorldSetCFM(world, 1e-10);
  dWorldSetContactSurfaceLayer(world, 0);
  id.clear();
  for (int i = 0; i < count; ++i) {
    const State& s = start[take][i];
    const V& I = body[i].I;
    dMass mass;
    dMassSetParameters(&mass, body[i].m, 0, 0, 0, I[0], I[1], I[2], 0, 0, 0);
    id.push_back(dBodyCreate(world));
    dBodySetMass(id[i], &mass);
    dBodySetPosition(id[i], s.x[0], s.x[1], s.x[2]);
    dBodySetQuaternion(id[i], &s.q[0]);
    dBodySetLinearVel(id[i], s.v[0], s.v[1], s.v[2]);
    dBodySetAngularVel(id[i], s.w[0], s.w[1], s.w[2]);
    dBodySetFiniteRotationMode(id[i], 1);
  }
  dGeomSetBody(dCreateBox(space, 2 * 0.0649, 2 * 0.0649, 2 * 0.0649), id[0]);
  dCreatePlane(space, 0.0, 1.0, 0.0, 0.0);
}

void push(int i, const V& F, const V& T) {
  dBodyAddForce(id[i], F[0], F[1], F[2]);
  dBodyAddTorque(id[i], T[0], T[1], T[2]);
}

void step() {
  dSpaceCollide(space, nullptr, touch);
  dWorldStep(world, dt);
  dJointGroupEmpty(contacts);
}

std::vector<State> states() {
  std::vector<State> all;
  for (dBodyID b : id)
    all.push_back({V(dBodyGetPosition(b), 3), V(dBodyGetQuaternion(b), 4), V(dBodyGetLinearVel(b), 3), V(dBodyGetAngularVel(b), 3)});
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
  auto slowed = 0.5 * norm(gravity[0]) / norm(v);
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
