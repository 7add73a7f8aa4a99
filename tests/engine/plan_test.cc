// The plan contains the stages that a model needs, with reasons; more stages do not change the motion.
#include "engine/plan.h"
#include "engine/trees.h"

#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"
#include "tests/engine/rail_and_wheel.h"

#include <functional>
#include <map>

namespace cylon::engine {
namespace {

const Stage& stage(const Plan& plan, std::string_view name) {
  for (const Stage& s : plan.stages) {
    if (s.name == name) return s;
  }
  ADD_FAILURE() << "no stage " << name;
  return plan.stages.front();
}

Options automatic() { return {.dt = 0.01}; }

Model point(const Vector3& spin = Vector3::Zero()) {
  Model model;
  const Matrix3 inertia = spin.isZero(0) ? Matrix3(Matrix3::Zero()) : general_inertia(0.2, 0.3, 0.4);
  add_body(model, make_body(1.3, inertia), {0.3, 0.9, -0.2}, {0.1, 0.2, 0.3}, {0.4, 1, 0.2}, spin);
  return model;
}

struct Case {
  const char* name;
  std::function<Model()> model;
  Path path;
  std::vector<const char*> in;  // besides degrees of freedom and integration or closed form
};

const std::vector<const char*> optional_stages = {"rotation",
                                                  "gravity",
                                                  "springs",
                                                  "drag",
                                                  "thrust",
                                                  "drive",
                                                  "attraction",
                                                  "water",
                                                  "springs, dampers and motors in joints",
                                                  "variable mass",
                                                  "turning frame",
                                                  "forces of the frame",
                                                  "reduced coordinates",
                                                  "joint constraints",
                                                  "broad phase",
                                                  "detection",
                                                  "limits of joints",
                                                  "dry friction in joints",
                                                  "impacts",
                                                  "friction",
                                                  "contact solving",
                                                  "event location"};

std::vector<Case> cases() {
  const auto added = [](Model m, const std::function<void(Model&)>& change) {
    change(m);
    return m;
  };
  const auto two_boxes = [](bool locked) {
    Model m;
    add_body(m, make_body(2, Matrix3::Identity(), locked), {0.1, 0.3, -0.2}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
             Box{{0.5, 0.3, 0.4}});
    add_body(m, make_body(1, Matrix3::Identity()), {0.2, 0.9, -0.1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
             Box{{0.2, 0.25, 0.3}});
    m.forces.gravity = {0, -9.81, 0};
    make_touchable(m, 0, 0.4);
    return m;
  };
  return {
      {"box on a locked box",
       [=] { return two_boxes(true); },
       Path::events,
       {"rotation", "gravity", "detection", "impacts", "friction", "contact solving", "event location"}},
      {"box on box",
       [=] { return two_boxes(false); },
       Path::stepping,
       {"rotation", "gravity", "broad phase", "detection", "impacts", "friction", "contact solving"}},
      {"free point", [] { return point(); }, Path::exact, {}},
      {"falling point",
       [=] { return added(point(), [](Model& m) {
               m.forces.gravity = {0, -9.81, 0};
             }); },
       Path::exact,
       {"gravity"}},
      {"free top", [] { return free_top(); }, Path::exact, {"rotation"}},
      {"point on a spring",
       [=] {
         return added(point(), [](Model& m) { m.forces.springs.push_back({.body = 0, .stiffness = 3}); });
       },
       Path::modes,
       {"springs"}},
      {"spring with a rest length that turns",
       [=] {
         return added(point(), [](Model& m) {
           m.forces.springs.push_back({.body = 0, .stiffness = 3, .rest_length = 0.4});
         });
       },
       Path::points,
       {"springs"}},
      {"point with a drive",
       [=] { return added(point(), [](Model& m) {
               m.forces.drives.push_back({0, {1, 2, 3}, 4});
             }); },
       Path::modes,
       {"drive"}},
      {"dragged point",
       [=] { return added(point(), [](Model& m) {
               m.forces.drags.push_back({0, 0.3, 0, 0});
             }); },
       Path::bodies,
       {"drag"}},
      {"off-centre spring", [] { return coupled_bodies(); }, Path::bodies, {"rotation", "springs"}},
      {"every force",
       [] { return forced_bodies(); },
       Path::bodies,
       {"rotation", "gravity", "springs", "drag", "drive"}},
      {"rocket",
       [=] {
         return added(point(), [](Model& m) {
           m.bodies[0].mass_rate = -0.1;
           m.forces.thrusts.push_back(
               {.body = 0, .mass_rate = -0.1, .relative = true, .exchanged = {0, -9, 0}});
         });
       },
       Path::bodies,
       {"thrust", "variable mass"}},
      {"heavy top", [] { return heavy_top(); }, Path::bodies, {"rotation", "gravity", "reduced coordinates"}},
      {"joint between free bodies",
       [] { return linked_bodies(false); },
       Path::bodies,
       {"rotation", "reduced coordinates"}},
      {"double pendulum",
       [] { return linked_bodies(true); },
       Path::bodies,
       {"rotation", "gravity", "reduced coordinates"}},
      {"turning frame",
       [=] { return added(free_top(), [](Model& m) {
               m.frame = RotatingFrame{{0.1, 0.2, 0.3}};
             }); },
       Path::bodies,
       {"rotation", "turning frame"}},
      {"frame that turns and accelerates",
       [=] {
         return added(free_top(), [](Model& m) {
           m.forces.frame_forces = {{.acceleration = {1, 2, 3}, .angular_velocity = {0.1, 0.2, 0.3}}};
         });
       },
       Path::bodies,
       {"rotation", "forces of the frame"}},
      {"ball over a plane",
       [] { return ball_over_plane(0.5, 0.5); },
       Path::ballistic,
       {"rotation", "gravity", "detection", "impacts", "contact solving", "event location"}},
      {"rough ball",
       [=] { return added(ball_over_plane(0.5, 0.5), [](Model& m) { make_touchable(m, 0.5, 0.3); }); },
       Path::ballistic,
       {"rotation", "gravity", "detection", "impacts", "friction", "contact solving", "event location"}},
      {"ball on a spring over a plane",
       [=] {
         return added(ball_over_plane(0.5, 0.5),
                      [](Model& m) { m.forces.springs.push_back({.body = 0, .stiffness = 3}); });
       },
       Path::events,
       {"rotation", "gravity", "springs", "detection", "impacts", "contact solving", "event location"}},
      {"body on a rail with a stop and dry friction",
       [] {
         Model m = body_on_rail(1);
         CoordinateLaw law;
         law.at = along_rail(), law.upper = 1, law.friction = 0.2;
         m.forces.coordinate_laws.push_back(law);
         return m;
       },
       Path::events,
       {"rotation", "reduced coordinates", "limits of joints", "dry friction in joints", "event location"}},
      {"many boxes on a plane",
       [] {
         Model m;
         for (int i = 0; i < 12; ++i) {
           add_body(m, make_body(1, Matrix3::Identity()), {1.5 * i, 0.4, 0.3}, {0, 0, 0}, {0, 0, 0},
                    {0, 0, 0}, Box{{0.5, 0.4, 0.3}});
         }
         m.planes.push_back({});
         m.forces.gravity = {0, -9.81, 0};
         make_touchable(m, 0, 0.4);
         return m;
       },
       Path::stepping,
       {"rotation", "gravity", "broad phase", "detection", "impacts", "friction", "contact solving"}},
  };
}

TEST(Plan, EachStageHasReason) {
  for (const Case& c : cases()) {
    const Plan plan = make_plan(c.model(), automatic());
    EXPECT_EQ(plan.path, c.path) << c.name;
    for (const char* name : optional_stages) {
      const bool expected = std::find_if(c.in.begin(), c.in.end(), [&](const char* n) {
                              return std::string_view(n) == name;
                            }) != c.in.end();
      EXPECT_EQ(stage(plan, name).in, expected) << c.name << ": " << name;
    }
    for (const Stage& s : plan.stages) EXPECT_FALSE(s.reason.empty() && s.in) << c.name << ": " << s.name;
    for (const Stage& s : plan.stages) EXPECT_FALSE(s.reason.empty()) << c.name << ": " << s.name;
    const bool closed = c.path == Path::exact || c.path == Path::modes || c.path == Path::ballistic;
    EXPECT_EQ(stage(plan, "closed form").in, closed) << c.name;
    EXPECT_EQ(stage(plan, "integration").in, !closed && c.path != Path::stepping) << c.name;
    EXPECT_EQ(stage(plan, "error control").in, plan.verified) << c.name;
  }
}

// 6 n - m; points have 3, locked bodies none.
TEST(Plan, CountsDegreesOfFreedom) {
  const auto freedom = [](const Model& model) {
    return std::stoi(stage(make_plan(model, automatic()), "degrees of freedom").reason);
  };
  EXPECT_EQ(freedom(point()), 3);
  EXPECT_EQ(freedom(free_top()), 6);
  EXPECT_EQ(freedom(coupled_bodies()), 12);
  EXPECT_EQ(freedom(heavy_top()), 3);
  EXPECT_EQ(freedom(linked_bodies(true)), 6);
  EXPECT_EQ(freedom(linked_bodies(false)), 9);
  const std::vector<std::pair<Joint::Type, int>> left = {
      {joint_types::ball, 9}, {joint_types::hinge, 7}, {joint_types::distance, 11}, {joint_types::fixed, 6}};
  for (const auto& [type, expected] : left) {
    Model model = linked_bodies(false);
    model.joints[0].type = type;
    EXPECT_EQ(freedom(model), expected);
  }
  Model rock = free_top();
  add_body(rock, make_body(1, Matrix3::Identity(), true), {5, 5, 5}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(freedom(rock), 6);
  EXPECT_NE(stage(make_plan(rock, automatic()), "degrees of freedom").reason.find("locked: 1"),
            std::string::npos);
}

// Four hinges with parallel axes have 20 rows; they used to leave 18 - 20 = -2 degrees of freedom.
TEST(Plan, CountsIndependentRowsOfJoints) {
  Model linkage;
  const Vector3 ends[] = {
      {0, 0, 0}, {Real(0.3), 1, 0}, {Real(1.7), Real(1.2), 0}, {Real(1.4), Real(-0.1), 0}};
  for (std::size_t i = 0; i < 3; ++i)
    add_body(linkage, make_body(1, Matrix3::Identity()), (ends[i] + ends[i + 1]) / 2, {0, 0, 0}, {0, 0, 0},
             {0, 0, 0});
  for (int k = 0; k < 4; ++k) {
    const Vector3 end = ends[static_cast<std::size_t>(k)];
    const auto place = [&](int body) {
      return body == fixed_world ? Vector3(Vector3::Zero())
                                 : linkage.motions[static_cast<std::size_t>(body)].position;
    };
    const int body = std::min(k, 2), to = k == 0 || k == 3 ? fixed_world : k - 1;
    linkage.joints.push_back({.type = joint_types::hinge,
                              .body = body,
                              .anchor = end - place(body),
                              .to = to,
                              .to_anchor = end - place(to),
                              .axis = Vector3::UnitZ(),
                              .to_axis = Vector3::UnitZ()});
  }
  const std::string reason = stage(make_plan(linkage, automatic()), "degrees of freedom").reason;
  EXPECT_EQ(std::stoi(reason), 1) << reason;
  EXPECT_NE(reason.find("3 conditions of joints follow from the others"), std::string::npos) << reason;
  // An axis that is not parallel to the others holds all of it.
  const Vector3 tilted = Vector3(Real(0.1), 0, 1).normalized();
  linkage.joints[3].axis = linkage.joints[3].to_axis = tilted;
  EXPECT_EQ(std::stoi(stage(make_plan(linkage, automatic()), "degrees of freedom").reason), 0);
}

// A chosen integrator is never replaced by a closed form: it is what is looked at.
TEST(Plan, UsesChosenIntegrator) {
  for (const Case& c : cases()) {
    if (c.path == Path::stepping) continue;
    const Plan plan = make_plan(c.model(), with("velocity-verlet", 0.01));
    ASSERT_NE(plan.integrator, nullptr) << c.name;
    EXPECT_EQ(plan.integrator->name, "velocity-verlet");
    EXPECT_FALSE(plan.verified);
  }
}

// What is left out changes nothing: everything on gives the same motion, to the rounding of sums in other
// order.
TEST(Plan, FullModelGivesSameMotion) {
  for (const Case& c : cases()) {
    if (c.path == Path::stepping || c.path == Path::ballistic) continue;
    for (const char* integrator : {"rk4", "rk8", "velocity-verlet", "yoshida6"}) {
      const Model model = c.model();
      Options lean = with(integrator, 0.01), full = lean;
      full.full = true;
      if (!unsupported(model, full).empty()) continue;  // contacts in a turning frame
      const Real apart = distance(run(model, lean, 100).motions, run(model, full, 100).motions);
      // A Runge-Kutta integrator integrates a top's spin in full and has it in closed form in the lean plan, and trees in
      // other coordinates.
      const Integrator& row = *find_integrator(integrator);
      const bool top = std::string_view(c.name).find("top") != std::string_view::npos;
      const bool truncates = (top && row.kind == Kind::runge_kutta) || Trees::applies(model, lean, row);
      EXPECT_LT(apart, truncates ? 1e-2 : 1e-11) << c.name << ' ' << integrator;
    }
  }
}

TEST(Unsupported, GivesReason) {
  const auto reason = [](const Model& model, const Options& options) { return unsupported(model, options); };
  EXPECT_NE(reason(free_top(), with("leapfrog", 0.01)).find("leapfrog"), std::string::npos);
  Options wrong = automatic();
  wrong.path = "magic";
  EXPECT_NE(reason(free_top(), wrong).find("magic"), std::string::npos);
  EXPECT_NE(reason(linked_bodies(false), with("bm4", 0.01)).find("bm4"), std::string::npos);
  EXPECT_EQ(reason(heavy_top(), with("bm4", 0.01)), "");  // its joint is reduced
  EXPECT_EQ(reason(linked_bodies(false), automatic()), "");
  Options stepping = with("rk4", 0.01);
  stepping.path = "stepping";
  EXPECT_NE(reason(ball_over_plane(1, 0.5), stepping).find("stepping"), std::string::npos);
}

}  // namespace
}  // namespace cylon::engine
