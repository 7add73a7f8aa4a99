// Where impacts follow each other, the order of several at one instant is that of the bodies in the scene.  A run
// says so where that order counts, and nowhere else: there the reversed scene moves in the same way.
#include "engine/event_stepper.h"
#include "engine/run.h"
#include "tests/engine/ballistic/ballistic_fixture.h"

#include <functional>
#include <memory>

namespace cylon::engine {
namespace {

using ballistic_test::add_plane;
using ballistic_test::add_sphere;
using ballistic_test::spheres_of;

constexpr Time dt = 0.25;
constexpr int steps = 12;

struct Row {
  const char* name;
  bool counts;
  std::function<Model()> scene;
};

// A row of three, struck at one end: each impact is alone when it comes.
Model struck_row() {
  Model model = spheres_of({Real(0.5), 0});
  add_sphere(model, 1, Real(0.5), {-2, 0, 0}, {1, 0, 0});
  for (int i = 0; i < 3; ++i)
    add_sphere(model, static_cast<Real>(i + 2), Real(0.5), {static_cast<Real>(i), 0, 0}, Vector3::Zero());
  return model;
}

Model struck_from_both_sides() {
  Model model = spheres_of({Real(0.5), 0});
  add_sphere(model, 1, Real(0.5), {-2, 0, 0}, {1, 0, 0});
  add_sphere(model, 2, Real(0.5), {0, 0, 0}, Vector3::Zero());
  add_sphere(model, 5, Real(0.5), {Real(2.5), 0, 0}, {Real(-1.5), 0, 0});
  return model;
}

// The two that are struck touch each other.  cos 30 degrees to the left: they meet at once.
Model one_into_two(Impacts impacts) {
  Model model = spheres_of({Real(0.5), 0});
  model.impacts = impacts;
  add_sphere(model, 1, Real(0.5), {-1 - std::sqrt(Real(3)) / 2, 0, 0}, {2, 0, 0});
  add_sphere(model, 2, Real(0.5), {0, Real(0.5), 0}, Vector3::Zero());
  add_sphere(model, 3, Real(0.5), {0, Real(-0.5), 0}, Vector3::Zero());
  return model;
}

Model two_pairs() {
  Model model = spheres_of({Real(0.5), Real(0.3)});
  for (const Real away : {0, 10}) {
    add_sphere(model, 1, Real(0.5), {-2, 0, away}, {1, 0, 0});
    add_sphere(model, 2, Real(0.5), {0, 0, away}, {0, Real(0.125), 0});
  }
  return model;
}

Model into_corner(Real friction, const Vector3& wall) {
  Model model = spheres_of({Real(0.5), friction});
  add_plane(model, Vector3::UnitX(), 0);
  add_plane(model, wall, 0);
  // 1 from both along their normals, at the same speed
  const Matrix3 along =
      (Matrix3() << Vector3::UnitX(), wall.normalized(), Vector3::UnitY()).finished().transpose().inverse();
  add_sphere(model, 1, Real(0.5), along * Vector3(Real(1.5), Real(1.5), 3),
             along * Vector3(-1, -1, Real(0.25)));
  return model;
}

const std::vector<Row> rows = {
    {"struck row", false, struck_row},
    {"struck from both sides", true, struck_from_both_sides},
    {"one into two", true, [] { return one_into_two(Impacts::sequential); }},
    {"one into two, at once", false, [] { return one_into_two(Impacts::simultaneous); }},
    {"two pairs at one instant", false, two_pairs},
    {"smooth square corner", false, [] { return into_corner(0, Vector3::UnitZ()); }},
    {"rough square corner", true, [] { return into_corner(Real(0.25), Vector3::UnitZ()); }},
    {"smooth sharp corner", true,
     [] {
       return into_corner(0, {Real(0.6), 0, Real(0.8)});
     }},
};

Model reversed(Model model) {
  std::reverse(model.bodies.begin(), model.bodies.end());
  std::reverse(model.motions.begin(), model.motions.end());
  std::reverse(model.shapes.begin(), model.shapes.end());
  std::reverse(model.planes.begin(), model.planes.end());
  return model;
}

struct End {
  bool told = false;
  std::vector<Motion> motions;
};

bool tells_order(const std::vector<Diagnostic>& all) {
  return std::any_of(all.begin(), all.end(),
                     [](const Diagnostic& d) { return d.kind == DiagnosticKind::impacts_ordered; });
}

End in_closed_form(const Model& model) {
  Run run(std::make_shared<Model>(model), Options{.dt = dt}, 0);
  for (int i = 0; i < steps; ++i) run.step();
  return {tells_order(run.diagnostics()), run.motions()};
}

End by_events(const Model& model) {
  EventStepper stepper(model, *find_integrator("dop853"), dt, Real(1e-12));
  for (int i = 0; i < steps; ++i) stepper.step();
  End end{tells_order(stepper.diagnostics()), {}};
  stepper.read(end.motions);
  return end;
}

Real apart(const End& one, const End& reversed) {
  Real worst = 0;
  for (std::size_t i = 0; i < one.motions.size(); ++i) {
    const Motion &a = one.motions[i], &b = reversed.motions[one.motions.size() - 1 - i];
    worst = std::max({worst, (a.position - b.position).norm(), (a.momentum - b.momentum).norm()});
  }
  return worst;
}

TEST(OrderOfImpacts, IsToldWhereItCounts) {
  for (const Row& row : rows) {
    const Model model = row.scene();
    for (const auto path : {in_closed_form, by_events}) {
      SCOPED_TRACE(std::string(row.name) + (path == by_events ? ", by events" : ", in closed form"));
      const End one = path(model), other = path(reversed(model));
      EXPECT_EQ(one.told, row.counts);
      EXPECT_EQ(other.told, row.counts);
      if (row.counts)
        EXPECT_GT(apart(one, other), 1e-2);
      else
        EXPECT_LT(apart(one, other), 1e-9);
    }
  }
}

// What closed forms said is not forgotten when they hand over: here when a sphere slides across a slope.
TEST(OrderOfImpacts, IsToldAfterTheClosedFormHasEnded) {
  Model model = struck_from_both_sides();
  model.forces.gravity = {0, Real(-9.81), 0};
  model.materials = {{0, Real(0.2)}};
  add_plane(model, {1, 2, 0}, -8);
  add_sphere(model, 1, Real(0.5), {20, 0, 5}, {0, 0, 1});
  engine::Run run(std::make_shared<Model>(model), Options{.dt = dt}, 0);
  for (int i = 0; i < steps; ++i) run.step();
  const std::vector<Diagnostic> all = run.diagnostics();
  EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                          [](const Diagnostic& d) { return d.kind == DiagnosticKind::handed_over; }));
  EXPECT_TRUE(tells_order(all));
}

}  // namespace
}  // namespace cylon::engine
