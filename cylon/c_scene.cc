#include "cylon/c_scene.h"

#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <variant>

namespace cylon::worker {
namespace {

using core::Scene;
using core::Vector3;

static_assert(static_cast<int>(core::JointType::ball) == CYLON_BALL);
static_assert(static_cast<int>(core::JointType::hinge) == CYLON_HINGE);
static_assert(static_cast<int>(core::JointType::distance) == CYLON_DISTANCE);
static_assert(static_cast<int>(core::JointType::fixed) == CYLON_FIXED);
static_assert(core::joint_kinds.size() == 12);  // of the others engine.h says nothing: other_joint
static_assert(core::world == CYLON_WORLD);

constexpr std::size_t most_pairs = 1'000'000;  // 40 MB

// ---- What a scene has ----------------------------------------------------------------------------

template <class Kind>
bool has(const Scene& scene) {
  return std::ranges::any_of(scene.forces,
                             [](const core::Force& f) { return std::holds_alternative<Kind>(f); });
}

bool may_touch(const Scene& scene) {
  return core::any_touching_pair(scene, [](const core::Pair&) { return true; });
}

bool may_turn(const Scene& scene) {
  const auto spins = [](const core::Body& b) { return !b.locked && !b.initial.angular_velocity.isZero(0); };
  const auto off_centre = [](const core::Force& force) {
    const auto* spring = std::get_if<core::Spring>(&force);
    return spring &&
           (!spring->anchor.isZero(0) || (spring->to != core::world && !spring->to_anchor.isZero(0)));
  };
  const auto beside = [](const core::Joint& joint) { return !core::kind_of(joint.type).joins_centres(); };
  return std::ranges::any_of(scene.bodies, spins) || std::ranges::any_of(scene.forces, off_centre) ||
         std::ranges::any_of(scene.joints, beside) || may_touch(scene);
}

bool other_joint(const Scene& scene) {
  return std::ranges::any_of(
      scene.joints, [](const core::Joint& joint) { return static_cast<int>(joint.type) > CYLON_FIXED; });
}
bool along_joint(const Scene& scene) { return std::ranges::any_of(scene.joints, core::acted_on); }

struct Part {
  std::uint32_t flag;  // 0: no structure has it
  const char* what;
  bool (*is_in)(const Scene&);
};
const Part parts[] = {
    {0, "joints other than ball, hinge, distance and fixed", other_joint},
    {0, "forces, limits or friction of joints", along_joint},
    {CYLON_CONTACTS, "contacts", may_touch},
    {CYLON_SPRINGS, "springs", has<core::Spring>},
    {CYLON_DRAGS, "drag", has<core::Drag>},
    {CYLON_DRIVES, "drives", has<core::Drive>},
    {CYLON_ATTRACTIONS, "attractions", has<core::Attraction>},
    {CYLON_JOINTS, "joints", [](const Scene& scene) { return !scene.joints.empty(); }},
    {CYLON_ROTATION, "rotation", may_turn},
    {0, "thrust", has<core::Thrust>},
    {0, "water", has<core::Water>},
    {0, "forces of plug-ins", has<core::PluginForce>},
    {0, "frame that is not inertial", [](const Scene& scene) { return scene.frame.has_value(); }},
};

// ---- Shapes --------------------------------------------------------------------------------------

struct Sized {
  cylon_shape shape;
  Vector3 size;
};
std::optional<Sized> sized(const core::Shape& shape) {
  return std::visit(core::Overloaded{[](std::monostate) -> std::optional<Sized> {
                                       return Sized{CYLON_NO_SHAPE, Vector3::Zero()};
                                     },
                                     [](const core::Sphere& s) -> std::optional<Sized> {
                                       return Sized{CYLON_SPHERE, {s.radius, 0, 0}};
                                     },
                                     [](const core::Box& s) -> std::optional<Sized> {
                                       return Sized{CYLON_BOX, s.half_extents};
                                     },
                                     [](const core::Capsule& s) -> std::optional<Sized> {
                                       return Sized{CYLON_CAPSULE, {s.radius, s.length, 0}};
                                     },
                                     [](const core::Cylinder& s) -> std::optional<Sized> {
                                       return Sized{CYLON_CYLINDER, {s.radius, s.length, 0}};
                                     },
                                     [](const core::Cone& s) -> std::optional<Sized> {
                                       return Sized{CYLON_CONE, {s.radius, s.length, 0}};
                                     },
                                     [](const auto&) -> std::optional<Sized> { return std::nullopt; }},
                    shape);
}

std::optional<std::string> not_listed(const Scene& scene) {
  std::size_t count = 0;
  bool bare = false;
  const core::Body* shapeless = nullptr;
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    bare = !core::material_of(scene, pair);
    for (const int i : {pair.body, pair.other})
      if (i != core::world && !shapeless && !sized(scene.bodies[static_cast<std::size_t>(i)].shape))
        shapeless = &scene.bodies[static_cast<std::size_t>(i)];
    return ++count > most_pairs || shapeless || bare;
  });
  if (shapeless) return fmt::format("cylon/engine.h has no such shape as that of '{}'", shapeless->name);
  if (bare) return "a pair may touch, and the scene states no material for it";
  if (count > most_pairs) return fmt::format("more than {} pairs may touch", most_pairs);
  return std::nullopt;
}

// ---- Structures ----------------------------------------------------------------------------------

void put(const Vector3& v, double* to) { std::copy_n(v.data(), 3, to); }

cylon_body body_of(const Scene& scene, const core::Body& body, bool touches) {
  cylon_body made{};
  made.name = body.name.c_str();
  made.mass = body.mass;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(made.inertia) = body.inertia;
  put(core::gravity_of(scene, body), made.gravity);
  const core::BodyState& start = body.initial;
  put(start.position, made.initial.position);
  const double q[] = {start.orientation.w(), start.orientation.x(), start.orientation.y(),
                      start.orientation.z()};
  std::copy_n(q, 4, made.initial.orientation);
  put(start.velocity, made.initial.velocity);
  put(start.angular_velocity, made.initial.angular_velocity);
  made.locked = body.locked;
  if (!touches) return made;
  const Sized found = sized(body.shape).value();
  made.shape = found.shape;
  put(found.size, made.size);
  return made;
}

}  // namespace

std::optional<std::string> not_taken(const Scene& scene, std::uint32_t takes) {
  for (const Part& part : parts) {
    if ((takes & part.flag) || !part.is_in(scene)) continue;
    return part.flag ? fmt::format("the engine does not take {}", part.what)
                     : fmt::format("cylon/engine.h has no {}", part.what);
  }
  return not_listed(scene);
}

CScene::CScene(const Scene& scene) : simultaneous_(scene.impacts == core::Impacts::simultaneous) {
  std::vector<bool> touches(scene.bodies.size());
  for (const core::Pair& pair : core::touching_pairs(scene)) {
    const core::Material material = core::material_of(scene, pair).value();
    pairs_.push_back({pair.body, pair.other, pair.plane, material.restitution, material.friction});
    for (const int i : {pair.body, pair.other})
      if (i != core::world) touches[static_cast<std::size_t>(i)] = true;
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    bodies_.push_back(body_of(scene, scene.bodies[i], touches[i]));
  for (const core::Force& force : scene.forces) std::visit([this](const auto& f) { add(f); }, force);
  for (const core::Joint& joint : scene.joints) {
    cylon_joint made{static_cast<cylon_joint_kind>(joint.type), joint.body, joint.to, {}, {}, joint.length};
    put(joint.point, made.point);
    put(joint.axis, made.axis);
    joints_.push_back(made);
  }
  for (const core::Plane& plane : scene.planes) {
    cylon_plane made{plane.name.c_str(), {}, plane.offset};
    put(plane.normal, made.normal);
    planes_.push_back(made);
  }
}

void CScene::add(const core::Spring& spring) {
  cylon_spring made{spring.body, spring.to, {}, {}, spring.stiffness, spring.rest_length, spring.damping};
  put(spring.anchor, made.anchor);
  put(spring.to_anchor, made.to_anchor);
  springs_.push_back(made);
}

void CScene::add(const core::Drag& drag) {
  drags_.push_back({drag.body, drag.linear, drag.angular, drag.momentum});
}

void CScene::add(const core::Drive& drive) {
  cylon_drive made{drive.body, {}, drive.frequency};
  put(drive.force, made.force);
  drives_.push_back(made);
}

void CScene::add(const core::Attraction& pull) {
  attractions_.push_back({pull.body, pull.to, pull.strength});
}

cylon_scene CScene::view() const {
  return {.bodies = bodies_.size(),
          .springs = springs_.size(),
          .drags = drags_.size(),
          .drives = drives_.size(),
          .attractions = attractions_.size(),
          .joints = joints_.size(),
          .planes = planes_.size(),
          .pairs = pairs_.size(),
          .body = bodies_.data(),
          .spring = springs_.data(),
          .drag = drags_.data(),
          .drive = drives_.data(),
          .attraction = attractions_.data(),
          .joint = joints_.data(),
          .plane = planes_.data(),
          .pair = pairs_.data(),
          .simultaneous_impacts = simultaneous_};
}

}  // namespace cylon::worker
