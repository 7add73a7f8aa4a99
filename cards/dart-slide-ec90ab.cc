// DART 6.12.1, slide: 1 body, box, friction, gravity, plane.
// What should happen: a box that slides is braked by the coefficient of friction times its weight.
// It prints 0.0222 m.
// apt-get install g++ libdart-dev && c++ -std=c++20 dart-slide-ec90ab.cc -o fault -isystem /usr/include/eigen3 -ldart && ./fault
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/BoxedLcpConstraintSolver.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>
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
V cross(const V& a, const V& b) { return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}; }
double dot(const V& a, const V& b) { return (a * b).sum(); }
double norm(const V& a) { return sqrt(dot(a, a)); }
V turn(const V& q, const V& v) { V u = {q[1], q[2], q[3]}, t = mul(2, cross(u, v)); return v + q[0] * t + cross(u, t); }
V back(const V& q, const V& v) { return turn({q[0], -q[1], -q[2], -q[3]}, v); }

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

using namespace dart::dynamics;
using Eigen::Isometry3d, Eigen::Vector3d;
dart::simulation::WorldPtr world;
std::vector<BodyNodePtr> id;

Vector3d vec(const V& v) { return {v[0], v[1], v[2]}; }
V of(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }
Isometry3d pose(const V& x, const V& q) {
  Isometry3d all = Isometry3d::Identity();
  all.translation() = vec(x), all.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  return all;
}

// By a joint whose frame has the axes of the world and this place at the start.
template <class Joint>
Joint* hang(int take, int i, int to, const V& point) {
  const State& s = start[take][i];
  const std::string name = std::to_string(i);
  typename Joint::Properties named;
  named.mName = name;
  const SkeletonPtr tree = to < 0 ? Skeleton::create(name) : id[to]->getSkeleton();
  const auto [joint, node] = tree->createJointAndBodyNodePair<Joint>(to < 0 ? nullptr : id[to].get(), named, BodyNode::AspectProperties(name));
  node->setInertia(Inertia(body[i].m, Vector3d::Zero(), vec(body[i].I).asDiagonal()));
  id.push_back(node);
  if constexpr (std::is_same_v<Joint, FreeJoint>) {
    joint->setTransform(pose(s.x, s.q));
    joint->setVelocities((Eigen::VectorXd(6) << vec(back(s.q, s.w)), vec(back(s.q, s.v))).finished());
  } else {
    const Isometry3d place = pose(point, {1, 0, 0, 0});
    joint->setTransformFromParentBodyNode(to < 0 ? place : pose(start[take][to].x, start[take][to].q).inverse() * place);
    joint->setTransformFromChildBodyNode(pose(s.x, s.q).inverse() * place);
  }
  return joint;
}

ShapeNode* touch(BodyNode* node, const ShapePtr& shape) {
  ShapeNode* one = node->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
  one->getDynamicsAspect()->setRestitutionCoeff(std::sqrt(0.0));  // DART multiplies those of a pair
  one->getDynamicsAspect()->setFrictionCoeff(0.5);
  return one;
}

void build(int take) {
  world = dart::simulation::World::create();
  world->setTimeStep(dt);
  world->setGravity(vec(gravity[take]));
  auto* solver = dynamic_cast<dart::constraint::BoxedLcpConstraintSolver*>(world->getConstraintSolver());
  solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  solver->getCollisionOption().maxNumContacts = 1000000;
  id.clear();
  hang<FreeJoint>(take, 0, -1, start[take][0].x);
  touch(id[0], std::make_shared<BoxShape>(Vector3d(2 * 0.0649, 2 * 0.0649, 2 * 0.0649)));
  for (const BodyNodePtr& node : id) {
    if (node->getParentBodyNode()) continue;
    node->getSkeleton()->enableSelfCollisionCheck();
    world->addSkeleton(node->getSkeleton());
  }
  {
    const auto ground = Skeleton::create("plane " + std::to_string(world->getNumSkeletons()));
    ground->setMobile(false);
    const auto [joint, node] = ground->createJointAndBodyNodePair<WeldJoint>();
    joint->setTransformFromParentBodyNode(pose(V{0.0, 0.0, 0.0}, V{1.0, 0.0, 0.0, 0.0}));
    touch(node, std::make_shared<BoxShape>(Vector3d(2000, 100, 2000)))->setRelativeTranslation(Vector3d(0, -50, 0));
    world->addSkeleton(ground);
  }
}

void push(int i, const V& F, const V& T) { id[i]->addExtForce(vec(F), Vector3d::Zero(), false, true), id[i]->addExtTorque(vec(T), false); }
void step() { world->step(); }

std::vector<State> states() {
  std::vector<State> all;
  for (const BodyNodePtr& node : id) {
    const Eigen::Quaterniond q(node->getWorldTransform().linear());
    all.push_back({of(node->getWorldTransform().translation()), {q.w(), q.x(), q.y(), q.z()}, of(node->getLinearVelocity()), of(node->getAngularVelocity())});
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
