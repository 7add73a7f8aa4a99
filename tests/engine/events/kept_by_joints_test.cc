// A box that joints alone keep where it is, under a locked one that it touches.  What forces do there is rounding, by which
// speeds that were rounding too were divided: contacts changed without end, or the box was thrown 0.1 m off.
#include "engine/contact/response.h"
#include "engine/joint.h"
#include "engine/world.h"
#include "tests/engine/contact/contact_fixtures.h"
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

// Of a slider and a ball joint at one point; welded: a second body is fixed to it.
Model kept_box(bool welded, Real tilt) {
  Model model = without_plane({0, 1});
  model.forces.gravity = {0, -1, 0};
  const Quaternion turn = exponential({tilt, Real(0.3) * tilt, -tilt});
  const Vector3 half = Vector3::Constant(Real(0.05)), place = turn * Vector3(0, Real(-0.1), 0);
  add_box(model, 1, half, Vector3::Zero(), turn, Vector3::Zero(), Vector3::Zero(), true);
  add_box(model, welded ? Real(0.6) : Real(1), half, place, turn, Vector3::Zero(), Vector3::Zero());
  Joint slider{.type = joint_types::slider, .body = 1, .to_anchor = place};
  slider.axis = Vector3::UnitY(), slider.to_axis = turn * Vector3::UnitY(), slider.relative = turn;
  model.joints = {slider, {.type = joint_types::ball, .body = 1, .to_anchor = place}};
  if (!welded) return model;
  const Matrix3 inertia = Real(0.4) / 600 * Matrix3::Identity();
  add_body(model, make_body(Real(0.4), inertia), place, Vector3::Zero(), Vector3::Zero(), Vector3::Zero());
  model.motions.back().orientation = turn;
  model.joints.push_back({.type = joint_types::fixed, .body = 1, .to = 2});
  return model;
}

TEST(EventKeptByJoints, ForcesDoNothingAtAll) {
  for (const bool welded : {false, true}) {
    const Model model = kept_box(welded, Real(0.4));
    std::vector<Row> joints;
    for (const Joint& joint : model.joints) add_rows(joint, model.bodies, model.motions.data(), joints);
    TouchPoint touch;
    touch.body = 1, touch.other = 0;
    touch.normal = model.motions[1].orientation * -Vector3::UnitY();
    touch.position = model.motions[1].orientation * Vector3(Real(0.05), Real(-0.05), Real(0.03));
    const Response response({&touch, 1}, joints, model.bodies, model.motions.data());
    EXPECT_EQ(response.matrix().cwiseAbs().maxCoeff(), 0) << welded;
    const auto rows = static_cast<Eigen::Index>(response.rows().size());
    EXPECT_EQ(response.offset(VectorX::Constant(rows, Real(0.7))).cwiseAbs().maxCoeff(), 0) << welded;
  }
}

TEST(EventKeptByJoints, ATouchMovesNothing) {
  for (const bool welded : {false, true})
    for (const Real tilt : {Real(0), Real(0.4)}) {
      const Model model = kept_box(welded, tilt);
      Options options = with("auto", 2e-3);
      options.path = "events";
      ASSERT_EQ(unsupported(model, options), "");
      World world(model, options);
      for (int k = 0; k < 50; ++k) world.step();
      for (std::size_t i = 0; i < model.bodies.size(); ++i)
        EXPECT_LT((world.motions()[i].position - model.motions[i].position).norm(), 1e-14) << i << tilt;
      EXPECT_LT(world.operations(), 8'000'000) << welded << tilt;
    }
}

}  // namespace
}  // namespace cylon::engine
