#include "reference/simulators/dart/border/dart_world.h"

#include "reference/simulators/dart/border/dart_parts.h"

#include <dart/config.hpp>
#include <dart/constraint/BallJointConstraint.hpp>
#include <dart/constraint/ContactConstraint.hpp>
#include <dart/constraint/WeldJointConstraint.hpp>

#include <utility>

namespace cylon::simulators::dart_border {
namespace {

// They are DART's for the whole process, and are set anew for each world.
void set_softness(const Settings& settings) {
  using dart::constraint::ContactConstraint;
  using dart::constraint::DynamicJointConstraint;
  ContactConstraint::setErrorReductionParameter(settings.contact_erp);
  ContactConstraint::setMaxErrorReductionVelocity(settings.contact_correction);
  ContactConstraint::setConstraintForceMixing(settings.contact_cfm);
  DynamicJointConstraint::setErrorReductionParameter(settings.loop_erp);
  DynamicJointConstraint::setConstraintForceMixing(settings.loop_cfm);
}

}  // namespace

World::World(const std::vector<Body>& bodies, const std::vector<Shape>& shapes,
             const std::vector<Loop>& loops, const Settings& settings, Meets meets)
    : parts_(std::make_unique<Parts>()) {
  defaults();  // read before anything is set
  set_softness(settings);
  parts_->world->setTimeStep(settings.dt);
  parts_->world->setGravity(to_dart(settings.gravity));
  parts_->set_solver(settings);
  parts_->nodes.resize(bodies.size(), nullptr);
  for (std::size_t i = 0; i < bodies.size(); ++i) parts_->hang(bodies, i);
  for (const Shape& shape : shapes) parts_->put_on(shape);
  for (const Loop& loop : loops) parts_->close(loop);
  parts_->enter(std::move(meets));
}

World::~World() = default;

void World::push(std::size_t body, const Vector& force, const Vector& torque) {
  dart::dynamics::BodyNode* node = parts_->nodes[body];
  node->addExtForce(to_dart(force), Eigen::Vector3d::Zero(), false, true);
  node->addExtTorque(to_dart(torque), false);
}

void World::set_mass(std::size_t body, double mass) { parts_->nodes[body]->setMass(mass); }

void World::step() { parts_->world->step(); }

Motion World::motion(std::size_t body) const {
  const dart::dynamics::BodyNode* node = parts_->nodes[body];
  const Eigen::Isometry3d& pose = node->getWorldTransform();
  const Eigen::Quaterniond q(pose.linear());
  return {from_dart(pose.translation()),
          {q.w(), q.x(), q.y(), q.z()},
          from_dart(node->getLinearVelocity()),
          from_dart(node->getAngularVelocity())};
}

std::vector<Contact> World::contacts() const {
  std::vector<Contact> all;
  for (const dart::collision::Contact& contact : parts_->world->getLastCollisionResult().getContacts())
    all.push_back({parts_->shape_of(contact.collisionObject1), parts_->shape_of(contact.collisionObject2),
                   from_dart(contact.point), from_dart(contact.normal), from_dart(contact.force)});
  return all;
}

Unsolved World::unsolved() const { return *parts_->unsolved; }

double World::mass(std::size_t body) const { return parts_->nodes[body]->getMass(); }

std::array<double, 9> World::inertia(std::size_t body) const {
  const Eigen::Matrix3d i = parts_->nodes[body]->getInertia().getMoment();
  return {i(0, 0), i(0, 1), i(0, 2), i(1, 0), i(1, 1), i(1, 2), i(2, 0), i(2, 1), i(2, 2)};
}

std::size_t World::freedoms() const {
  std::size_t all = 0;
  for (std::size_t i = 0; i < parts_->world->getNumSkeletons(); ++i)
    all += parts_->world->getSkeleton(i)->getNumDofs();
  return all;
}

Settings World::defaults() {
  using dart::constraint::ContactConstraint;
  using dart::constraint::DynamicJointConstraint;
  const dart::constraint::PgsBoxedLcpSolver::Option sweeps;
  // Read once, before any world has set them.
  static const Settings own = [&] {
    Settings read;
    read.sweeps = sweeps.mMaxIteration;
    read.change = sweeps.mDeltaXThreshold, read.relative_change = sweeps.mRelativeDeltaXTolerance;
    read.contact_erp = ContactConstraint::getErrorReductionParameter();
    read.contact_correction = ContactConstraint::getMaxErrorReductionVelocity();
    read.contact_cfm = ContactConstraint::getConstraintForceMixing();
    read.loop_erp = DynamicJointConstraint::getErrorReductionParameter();
    read.loop_cfm = DynamicJointConstraint::getConstraintForceMixing();
    return read;
  }();
  return own;
}

const char* World::version() { return DART_VERSION; }

}  // namespace cylon::simulators::dart_border
