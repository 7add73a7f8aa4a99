// Impacts one after another in fixed steps: as event by event, in scenes in which it counts whether they come at once.
#include "engine/event_stepper.h"
#include "engine/pile/body_pile.h"
#include "tests/engine/joint_types.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <functional>

namespace cylon::engine {
namespace {

const Vector3 half(Real(0.2), Real(0.2), Real(0.2));

struct Scene {
  const char* name;
  bool ordered;  // the order of the impacts counts
  Time duration;
  std::function<Model()> model;
};

// At once the floor bears what the upper one gives, and that leaves with less.
Model flat_on_one_that_rests(Real friction) {
  Model model = pile_model(Real(0.5), friction);
  add_box(model, 1, half, {0, Real(0.2), 0});
  add_box(model, Real(0.3), half, {Real(0.03), Real(0.8), Real(-0.02)}, {Real(0.1), -2, Real(0.2)});
  return model;
}

// Beside each other, on a plate.
Model two_on_one_that_rests() {
  Model model = pile_model(Real(0.5), 0);
  add_box(model, 2, {1, Real(0.1), Real(0.3)}, {0, Real(0.1), 0});
  for (const Real side : {Real(-0.7), Real(0.6)})
    add_box(model, Real(0.4), half, {side, Real(0.6), 0}, {0, -2, 0});
  return model;
}

Model row(Real restitution) {
  Model model = pile_model(restitution, 0);
  add_box(model, 2, half, {-1, Real(0.2), 0}, {3, 0, 0});
  for (int i = 0; i < 3; ++i)
    add_box(model, static_cast<Real>(i + 1), half, {Real(0.4) * static_cast<Real>(i), Real(0.2), 0});
  return model;
}

Model from_both_sides() {
  Model model = pile_model(Real(0.5), 0);
  add_box(model, 1, half, {Real(-0.9), Real(0.2), 0}, {2, 0, 0});
  add_box(model, 2, half, {0, Real(0.2), 0});
  add_box(model, 4, half, {Real(0.8), Real(0.2), 0}, {Real(-1.6), 0, 0});
  return model;
}

Model into_corner(Real friction) {
  Model model = pile_model(Real(0.5), friction);
  model.forces.gravity.setZero();
  model.planes.push_back({Vector3(Real(0.8), Real(0.6), 0), 0}), model.plane_surfaces.push_back(0);
  // 0.3 from both
  add_ball(model, 1, Real(0.2), {Real(0.25), Real(0.5), 0}, {Real(-0.5), -1, Real(0.4)}, {1, 2, 3});
  add_box(model, 1, half, {50, 50, 0});  // so that it is no pile of spheres
  return model;
}

// A weight lands on a plate that a slider holds at its lower stop.
Model on_a_stop(Real armature) {
  Model model = pile_model(Real(0.4), 0, false);
  add_box(model, 1, {Real(0.5), Real(0.05), Real(0.5)}, {0, Real(-0.05), 0});
  add_box(model, Real(0.6), half, {0, Real(0.5), 0}, {0, -2, 0});
  Joint slider{.type = joint_types::slider, .body = 0, .to_anchor = {0, Real(-0.05), 0}};
  slider.axis = slider.to_axis = Vector3::UnitY();
  model.joints.push_back(slider);
  CoordinateLaw law;
  law.at.kind = Coordinate::Kind::displacement;
  law.at.to_anchor = slider.to_anchor, law.at.axis = Vector3::UnitY();
  law.lower = 0, law.restitution = Real(0.3), law.armature = armature;
  model.forces.coordinate_laws.push_back(law);
  return model;
}

// Nothing holds them: two on a ball joint, struck at one end, a third at the other.
Model free_on_a_joint() {
  Model model = pile_model(Real(0.6), Real(0.3), false);
  model.forces.gravity.setZero();
  add_box(model, 1, half, {0, 0, 0});
  add_box(model, Real(1.5), half, {Real(0.5), Real(0.02), Real(0.01)});
  add_box(model, 2, half, {Real(0.9), Real(0.05), Real(-0.02)});
  add_box(model, Real(0.7), Real(0.5) * half, {Real(-0.45), Real(0.05), Real(0.02)}, {2, Real(0.1), 0});
  model.joints.push_back({.type = joint_types::ball,
                          .body = 0,
                          .anchor = {Real(0.25), Real(0.01), 0},
                          .to = 1,
                          .to_anchor = {Real(-0.25), Real(-0.01), Real(-0.01)}});
  model.apart = {{0, 1}};
  return model;
}

Model onto_one_that_burns() {
  Model model = flat_on_one_that_rests(Real(0.4));
  model.bodies[0].mass_rate = -4;
  model.forces.drags.push_back({1, Real(1.5), 0, 0});
  return model;
}

// An arm of 100 m lies on its stop; the rate at which a ball drives it there was compared with a speed, and the stop gave
// nothing back.
Model long_arm_on_its_stop() {
  Model model = pile_model(Real(0.5), 0, false);
  add_box(model, 1000, {50, Real(0.5), Real(0.5)}, {50, 0, 0});
  add_ball(model, 30, Real(0.5), {60, 0, Real(1.1)}, {0, 0, Real(-1.5)});
  Joint hinge{.type = joint_types::hinge, .body = 0, .anchor = {-50, 0, 0}};
  hinge.axis = hinge.to_axis = Vector3::UnitY();
  model.joints.push_back(hinge);
  CoordinateLaw law;
  law.at.kind = Coordinate::Kind::angle, law.at.anchor = hinge.anchor, law.at.axis = Vector3::UnitY();
  law.at.zero = law.at.mark = Vector3::UnitX();
  law.upper = 0, law.restitution = Real(0.5);
  model.forces.coordinate_laws.push_back(law);
  return model;
}

const std::vector<Scene> scenes = {
    {"flat on one that rests", false, 0.12, [] { return flat_on_one_that_rests(0); }},
    {"flat on one that rests, rough", false, 0.12, [] { return flat_on_one_that_rests(Real(0.4)); }},
    {"a row", false, 0.3, [] { return row(Real(0.5)); }},
    {"an elastic row", false, 0.3, [] { return row(1); }},
    {"from both sides", true, 0.37, from_both_sides},
    {"a smooth corner", true, 0.5, [] { return into_corner(0); }},
    {"a rough corner", true, 0.5, [] { return into_corner(Real(0.3)); }},
    {"on a stop", false, 0.2, [] { return on_a_stop(0); }},
    {"on a stop, with a rotor", false, 0.2, [] { return on_a_stop(Real(0.5)); }},
    {"free, on a joint", false, 0.23, free_on_a_joint},
    {"onto one that burns, with drag", false, 0.12, onto_one_that_burns},
    {"two on one that rests", true, 0.13, two_on_one_that_rests},
    {"a long arm on its stop", false, 0.2, long_arm_on_its_stop},
};

bool tells(const Stepper& stepper, DiagnosticKind kind) {
  for (const Diagnostic& d : stepper.diagnostics())
    if (d.kind == kind) return true;
  return false;
}

struct End {
  std::vector<Motion> motions;
  bool ordered = false, at_once = false;
};

End end_of(Stepper& stepper, int steps) {
  End end{after(stepper, steps), {}, {}};
  end.ordered = tells(stepper, DiagnosticKind::impacts_ordered);
  end.at_once = tells(stepper, DiagnosticKind::solved_at_once);
  return end;
}

End by_events(const Model& model, Time duration) {
  EventStepper stepper(model, *find_integrator("dop853"), duration / 10, Real(1e-11));
  return end_of(stepper, 10);
}

End in_steps(const Model& model, Time duration, int steps) {
  pile::BodyPile stepper(model, duration / steps, {});
  return end_of(stepper, steps);
}

// Velocities [m/s], and what turns at 0.2 m.
Real apart(const Model& model, const End& one, const End& other) {
  Real most = 0;
  for (std::size_t i = 0; i < one.motions.size(); ++i) {
    const Motion &a = one.motions[i], &b = other.motions[i];
    most = std::max(
        {most, (a.momentum - b.momentum).norm() / model.bodies[i].mass,
         Real(0.2) * (angular_velocity(model.bodies[i], a) - angular_velocity(model.bodies[i], b)).norm(),
         (a.position - b.position).norm()});
  }
  return most;
}

TEST(ImpactsInTurn, AreThoseOfEventsInFixedSteps) {
  for (const Scene& scene : scenes) {
    SCOPED_TRACE(scene.name);
    Model model = scene.model();
    const End events = by_events(model, scene.duration);
    EXPECT_EQ(events.ordered, scene.ordered);
    for (const int steps : {400, 4000}) {
      const Time h = scene.duration / steps;
      const End end = in_steps(model, scene.duration, steps);
      EXPECT_LT(apart(model, events, end), 10 * g * h) << steps;
      EXPECT_EQ(end.ordered, scene.ordered) << steps;
      EXPECT_FALSE(end.at_once) << steps;
    }
    model.impacts = Impacts::simultaneous;
    const End at_once = in_steps(model, scene.duration, 4000);
    EXPECT_GT(apart(model, events, at_once), 0.02);
    EXPECT_LT(apart(model, by_events(model, scene.duration), at_once), 10 * g * scene.duration / 4000);
  }
}

}  // namespace
}  // namespace cylon::engine
