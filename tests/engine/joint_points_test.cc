// A hinge can be named at any point of its axis, a fixed joint at any point, and each from either body.  Which it was changed
// the motion: islands took the distance to the named point for the room that a body has, so that parts became one at another
// time; and where more points press than loads are decided for, fixed steps shared the loads with lever arms of the named
// point, so that feet slipped at another time.
#include "engine/joint_points.h"

#include "engine/islands/clusters.h"
#include "tests/engine/joint_scenes.h"
#include "tests/engine/pile/pile_fixtures.h"

namespace cylon::engine {
namespace {

Quaternion orientation(const Model& model, int body) {
  return body == fixed_world ? Quaternion(Quaternion::Identity()) : model.motions[index(body)].orientation;
}

Vector3 place(const Model& model, int body, const Vector3& anchor) {
  if (body == fixed_world) return anchor;
  return model.motions[index(body)].position + orientation(model, body) * anchor;
}

// The same joint named elsewhere: by `along` along its axis, and by `aside` where it lets nothing turn [m].
Joint named_elsewhere(Joint joint, const Model& model, Real along, const Vector3& aside) {
  const Quaternion body = orientation(model, joint.body), to = orientation(model, joint.to);
  const Vector3 way = joint.type.turn == Joint::Turn::never ? aside : Vector3(along * (to * joint.to_axis));
  joint.anchor += body.conjugate() * way, joint.to_anchor += to.conjugate() * way;
  return joint;
}

// And from its other body.
Joint named_from_other(Joint joint) {
  std::swap(joint.body, joint.to), std::swap(joint.anchor, joint.to_anchor);
  std::swap(joint.axis, joint.to_axis);
  joint.relative = joint.relative.conjugate();
  return joint;
}

const Vector3 aside(Real(0.7), Real(-0.4), Real(1.3));

TEST(JointPoints, AreThoseOfTheBodiesAlone) {
  for (const Joint::Type& type : {joint_types::hinge, joint_types::fixed, joint_types::slider,
                                  joint_types::cylindrical, joint_types::planar, joint_types::rectangular})
    for (const bool to_world : {false, true}) {
      const JointScene scene = joint_scene(type, to_world);
      const Joint one = at_centres(scene.joint(), scene.model);
      const Joint other =
          at_centres(named_elsewhere(scene.joint(), scene.model, Real(-2.6), aside), scene.model);
      EXPECT_LT((one.anchor - other.anchor).norm() + (one.to_anchor - other.to_anchor).norm(), 64 * eps)
          << joint_types::label(type) << to_world;
      // It is the same joint: what its points are apart stays.
      const auto apart = [&](const Joint& j) -> Vector3 {
        return place(scene.model, j.body, j.anchor) - place(scene.model, j.to, j.to_anchor);
      };
      EXPECT_LT((apart(one) - apart(scene.joint())).norm(), 64 * eps) << joint_types::label(type);
      if (to_world || type.place != Joint::Place::together) continue;
      const Joint turned = at_centres(named_from_other(scene.joint()), scene.model);
      EXPECT_LT((turned.anchor - one.to_anchor).norm() + (turned.to_anchor - one.anchor).norm(), 64 * eps)
          << joint_types::label(type);
    }
}

// A chain of hinges from the world: what it can reach.
TEST(JointPoints, BoundsOfIslandsDoNotDependOnThem) {
  const auto chain = [](bool elsewhere) {
    Model model = pile_model(0, 1, false);
    for (int k = 0; k < 3; ++k)
      add_box(model, 1 + Real(0.4) * static_cast<Real>(k), Vector3(Real(0.2), Real(0.05), Real(0.1)),
              Vector3(Real(0.3) + Real(0.5) * static_cast<Real>(k), Real(1.1), Real(0.2)));
    for (int k = 0; k < 3; ++k) {
      const Vector3 at(Real(0.05) + Real(0.5) * static_cast<Real>(k), Real(1.1), Real(0.2));
      Joint hinge{.type = joint_types::hinge, .body = k, .anchor = at - model.motions[index(k)].position};
      if (k > 0) hinge.to = k - 1;
      hinge.to_anchor = k > 0 ? Vector3(at - model.motions[index(k - 1)].position) : at;
      hinge.axis = hinge.to_axis = Vector3(Real(0.6), 0, Real(0.8));
      if (elsewhere) hinge = named_elsewhere(hinge, model, Real(1.7), aside);
      if (elsewhere && k > 0) hinge = named_from_other(hinge);
      model.joints.push_back(hinge);
    }
    return islands::find_bounds(model);
  };
  const auto one = chain(false), other = chain(true);
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_TRUE(one[i] && other[i]);
    EXPECT_LT((one[i]->centre - other[i]->centre).norm(), 64 * eps) << i;
    EXPECT_NEAR(one[i]->radius, other[i]->radius, 64 * eps) << i;
  }
}

// A bar lies on the floor, on a rail of the world; a second stands on its end and presses the floor too; a heavy third on top
// falls and tilts it.  It slips when its share of the load, which nothing decides, is low enough.
TEST(JointPoints, StepsDoNotDependOnThem) {
  const auto end = [](bool elsewhere) {
    Model model = pile_model(0, 1);
    const auto bar = [&](Real mass, Real length, const Vector3& at, bool stands) {
      const Real own = mass * Real(0.005), across = mass * length * length / 12;
      const Matrix3 inertia = Vector3(across, own, across).asDiagonal();
      add_body(model, make_body(mass, inertia), Capsule{Real(0.1), length / 2}, at, Vector3::Zero(),
               Vector3::Zero(),
               Quaternion(Eigen::AngleAxis<Real>(stands ? Real(0) : Real(std::acos(0.)), Vector3::UnitZ())));
    };
    bar(20, Real(0.5), {Real(-0.75), Real(0.1), 0}, false);
    bar(20, Real(0.5), {Real(-0.3), Real(0.35), 0}, true);
    bar(26, Real(0.7), {Real(-0.65), Real(0.8), 0}, false);
    const auto joint = [&](const Joint::Type& type, int body, int to, const Vector3& at,
                           const Vector3& axis) {
      Joint j{.type = type, .body = body, .to = to};
      const auto own = [&](int of, const Vector3& x) -> Vector3 {
        return orientation(model, of).conjugate() *
               (of == fixed_world ? x : Vector3(x - model.motions[index(of)].position));
      };
      j.anchor = own(body, at), j.to_anchor = own(to, at);
      j.axis = orientation(model, body).conjugate() * axis,
      j.to_axis = orientation(model, to).conjugate() * axis;
      j.relative = orientation(model, to).conjugate() * orientation(model, body);
      if (elsewhere) j = named_elsewhere(j, model, Real(0.17), Real(0.3) * aside);
      if (elsewhere && to != fixed_world) j = named_from_other(j);
      model.joints.push_back(j);
    };
    joint(joint_types::slider, 0, fixed_world, {-1, Real(0.1), 0}, Vector3::UnitY());
    joint(joint_types::hinge, 1, 0, {Real(-0.3), Real(0.1), 0}, Vector3::UnitZ());
    joint(joint_types::hinge, 2, 1, {Real(-0.3), Real(0.8), 0}, Vector3::UnitZ());
    model.apart = {{0, 1}, {1, 2}};
    return after(*make_pile(model, 2e-3), 200);
  };
  const auto one = end(false), other = end(true);
  EXPECT_LT(one[2].position.y(), Real(0.6));  // it falls
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_LT((one[i].position - other[i].position).norm(), std::max(Real(1e-9), 1024 * eps)) << i;
}

}  // namespace
}  // namespace cylon::engine
