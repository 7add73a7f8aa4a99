// DART's API of 6.12.  Joints are those of its trees; a box stands for a plane.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
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
  one->getDynamicsAspect()->setRestitutionCoeff(std::sqrt(${restitution}));  // DART multiplies those of a pair
  one->getDynamicsAspect()->setFrictionCoeff(${friction});
  return one;
}

void build(int take) {
  world = dart::simulation::World::create();
  world->setTimeStep(dt);
  world->setGravity(vec(gravity[take]));
  auto* solver = dynamic_cast<dart::constraint::BoxedLcpConstraintSolver*>(world->getConstraintSolver());
  solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  solver->getCollisionOption().maxNumContacts = 1000000;
${world_settings}  id.clear();
${joints}${shapes}  for (const BodyNodePtr& node : id) {
    if (node->getParentBodyNode()) continue;
    node->getSkeleton()->enableSelfCollisionCheck();
    world->addSkeleton(node->getSkeleton());
  }
${planes}}

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
)";

constexpr ShapeRow shapes[] = {
    {"sphere", "std::make_shared<SphereShape>(${radius})"},
    {"box", "std::make_shared<BoxShape>(Vector3d(2 * ${x}, 2 * ${y}, 2 * ${z}))"},
};

constexpr JointRow joints[] = {
    {JointType::ball,
     "  hang<BallJoint>(take, ${a}, -1, ${point_vector})->setVelocities(vec(start[take][${a}].w));\n",
     "  hang<BallJoint>(take, ${a}, ${b}, ${point_vector})->setVelocities(vec(sub(start[take][${a}].w, "
     "start[take][${b}].w)));\n"},
    {JointType::hinge,
     "  auto* ${joint} = hang<RevoluteJoint>(take, ${a}, -1, ${point_vector});\n"
     "  ${joint}->setAxis(vec(${axis_vector}));\n"
     "  ${joint}->setVelocity(0, dot(${axis_vector}, start[take][${a}].w));\n",
     "  auto* ${joint} = hang<RevoluteJoint>(take, ${a}, ${b}, ${point_vector});\n"
     "  ${joint}->setAxis(vec(${axis_vector}));\n"
     "  ${joint}->setVelocity(0, dot(${axis_vector}, sub(start[take][${a}].w, start[take][${b}].w)));\n"},
    {JointType::fixed, "  hang<WeldJoint>(take, ${a}, -1, ${point_vector});\n",
     "  hang<WeldJoint>(take, ${a}, ${b}, ${point_vector});\n"},
};

constexpr SettingRow settings[] = {
    {"setTimeStep", "dt", Where::program, ""},
    {"CollisionDetector", "dart", Where::program, ""},
    {"planes", "boxes 2000 m wide and 100 m deep", Where::program, ""},
    {"restitution, friction", "of the pair", Where::program, ""},
    {"CollisionFilter", "of the scene", Where::program, ""},
    {"maxNumContacts", "no bound", Where::program, ""},
    {"joints", "a tree", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"BoxedLcpSolver", "dantzig-alone", Where::world, "  solver->setSecondaryBoxedLcpSolver(nullptr);\n"},
    {"BoxedLcpSolver", "pgs", Where::world,
     "  solver->setBoxedLcpSolver(std::make_shared<dart::constraint::PgsBoxedLcpSolver>());\n"
     "  solver->setSecondaryBoxedLcpSolver(nullptr);\n"},
    {"DynamicJointConstraint::*", "", Where::program, ""},  // of loops, which no row says
    {"ContactConstraint::*", "", Where::world, "  dart::constraint::${name}(${value});\n"},
};

}  // namespace

extern const Dialect dart;
const Dialect dart = {"dart",
                      "DART",
                      &cpp,
                      "apt-get install g++ libdart-dev",
                      "c++ -std=c++20 ${file} -o fault -isystem /usr/include/eigen3 -ldart && ./fault",
                      "#include <dart/collision/dart/DARTCollisionDetector.hpp>\n"
                      "#include <dart/constraint/BoxedLcpConstraintSolver.hpp>\n"
                      "#include <dart/constraint/ContactConstraint.hpp>\n"
                      "#include <dart/constraint/PgsBoxedLcpSolver.hpp>\n"
                      "#include <dart/dynamics/BallJoint.hpp>\n"
                      "#include <dart/dynamics/BoxShape.hpp>\n"
                      "#include <dart/dynamics/FreeJoint.hpp>\n"
                      "#include <dart/dynamics/RevoluteJoint.hpp>\n"
                      "#include <dart/dynamics/SphereShape.hpp>\n"
                      "#include <dart/dynamics/WeldJoint.hpp>\n"
                      "#include <dart/simulation/World.hpp>\n",
                      functions,
                      "  touch(id[${i}], ${shape});\n",
                      "",
                      R"(  {
    const auto ground = Skeleton::create("plane " + std::to_string(world->getNumSkeletons()));
    ground->setMobile(false);
    const auto [joint, node] = ground->createJointAndBodyNodePair<WeldJoint>();
    joint->setTransformFromParentBodyNode(pose(${foot}, ${turn_of_y}));
    touch(node, std::make_shared<BoxShape>(Vector3d(2000, 100, 2000)))->setRelativeTranslation(Vector3d(0, -50, 0));
    world->addSkeleton(ground);
  }
)",
                      shapes,
                      joints,
                      settings,
                      "  hang<FreeJoint>(take, ${a}, -1, start[take][${a}].x);\n"};

}  // namespace cylon::hunt::program
