// Every kind of diagnostic: provoked by a scene, with its time, its numbers and its island; and a scene beside it that
// does not provoke it.
#include "engine/diagnostic.h"

#include "engine/verified_stepper.h"
#include "tests/engine/diagnostic_scenes.h"
#include "tests/engine/joint_scenes.h"
#include "tests/paths.h"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <set>

namespace cylon::engine {
namespace {

using Diagnostics = std::vector<Diagnostic>;
using K = DiagnosticKind;

Diagnostics said(const Model& model, const Options& options, int steps) {
  EXPECT_EQ(unsupported(model, options), "");
  World world(model, options);
  for (int i = 0; i < steps; ++i) world.step();
  return world.diagnostics();
}

Diagnostics said(const Model& model, Time dt, int steps) { return said(model, with("auto", dt), steps); }

Diagnostics said_by_events(const Model& model, Time dt, int steps, const char* integrator = "dop853",
                           Real tolerance = Real(1e-13)) {
  EventStepper stepper(model, *find_integrator(integrator), dt, tolerance);
  for (int i = 0; i < steps; ++i) stepper.step();
  return stepper.diagnostics();
}

// A run whose two tolerances see an impact on different sides of the last sample: of step 3 of 3.
class Bouncing final : public Stepper {
 public:
  explicit Bouncing(Real tolerance) : late_(tolerance < Real(5e-12)) {}
  void step() override {
    if (++steps_ == 3) impacts_.push_back({0.03, 0});
  }
  void read(std::vector<Motion>& motions) const override {
    const Real speed = steps_ == 3 && late_ ? Real(1) : Real(-1);
    motions.assign(1, make_motion(body(), {1, 2, 3}, Quaternion::Identity(), {speed, 0, 0}, Vector3::Zero()));
  }
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  const std::vector<Impact>& impacts() const override { return impacts_; }
  std::int64_t operations() const override { return steps_; }
  static Body body() { return make_body(1, Matrix3::Identity()); }

 private:
  bool late_;
  int steps_ = 0;
  std::vector<Impact> impacts_;
};

Diagnostics of_impact_at_the_end() {
  VerifiedStepper stepper([](Real tolerance) { return std::make_unique<Bouncing>(tolerance); }, Real(1e-10),
                          0.01, {Bouncing::body()});
  for (int i = 0; i < 3; ++i) stepper.step();
  return stepper.diagnostics();
}

// A run by events that has to say something in its second step, of an acceleration or of none: what no scene known makes
// one say.  It shows that auto hands on what its finer run says, and that the words fit; not when EventStepper says it.
class Saying final : public Stepper {
 public:
  explicit Saying(K kind) : kind_(kind) {}
  void step() override {
    if (++steps_ != 2) return;
    const bool reaches = !row(kind_).unit.empty();
    log_.note(kind_, 0.015, {}, reaches ? std::optional(0.25) : std::nullopt);
  }
  void read(std::vector<Motion>& motions) const override {
    motions.assign(1, make_motion(Bouncing::body(), {1, 2, 3}, Quaternion::Identity(), Vector3::Zero(),
                                  Vector3::Zero()));
  }
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  std::vector<Diagnostic> diagnostics() const override { return log_.all(); }
  std::int64_t operations() const override { return steps_; }

 private:
  K kind_;
  int steps_ = 0;
  DiagnosticLog log_;
};

Diagnostics said_by_a_run_of_auto(K kind) {
  VerifiedStepper stepper([kind](Real) { return std::make_unique<Saying>(kind); }, Real(1e-10), 0.01,
                          {Bouncing::body()});
  stepper.step();
  EXPECT_TRUE(stepper.diagnostics().empty());
  for (int i = 0; i < 2; ++i) stepper.step();
  return stepper.diagnostics();
}

// A damper keeps the first angle, so that the axes of the gimbal meet.
Model through_parallel() {
  Model model = gimbal_towards_parallel(true, 3, 0, 0);
  model.forces.coordinate_laws[0].damping = 50;
  return model;
}

struct Provoked {
  K kind;
  double end;  ///< Of the run [s].
  std::function<Diagnostics()> by;
};

const std::vector<Provoked> provoked = {
    {K::not_divided, 0.001, [] { return said(many_balls(), 0.001, 1); }},
    {K::merged, 3.5,
     [] {
       return said(two_boxes(13, 4, {0, 0}, true), 0.005, 700);
     }},
    {K::parted, 5,
     [] {
       return said(two_boxes(Real(1.2), 6, {1, 0}, false), 0.005, 1000);
     }},
    {K::not_followed, 2, [] { return said(unlike_balls(), 0.005, 400); }},
    {K::handed_over, 0.03, [] { return said(overlapping_balls(), 0.01, 3); }},
    {K::path_not_taken, 0.02, [] { return said(free_top(), on("stepping", 0.01), 2); }},
    {K::tolerance_not_kept, 0.02,
     [] { return said(boxes_on_floor(1, 1), on("stepping", 0.01, Real(1e-6)), 2); }},
    {K::error_not_controlled, 0.02, [] { return said(boxes_on_floor(1, 1), on("stepping", 0.01), 2); }},
    {K::tolerance_missed, 5,
     [] {
       Options options = with("auto", 0.1);
       options.tolerance = Real(1e-17);
       return said(forced_bodies(), options, 50);
     }},
    {K::last_not_compared, 0.03, of_impact_at_the_end},
    {K::tolerance_unknown, 1,
     [] {
       Options options = with("auto", 0.01);
       options.path = "events";
       return said(jamming_rod(), options, 100);
     }},
    {K::rounding_exceeds, 3,
     [] {
       Options options = with("auto", 1. / 64);
       options.tolerance = Real(1e-13);
       return said(light_links(), options, 128);
     }},
    {K::integration_ended, 4, [] { return said(falling_together(), with("dop853", 0.1), 40); }},
    {K::switches_not_located, 30, [] { return said(at_the_surface(Real(0.01)), with("dop853", 10), 3); }},
    {K::series_not_ended, 1,
     [] { return said(with_drag(free_top(), Real(1e9)), with("velocity-verlet", 1), 1); }},
    {K::drift_open, 1, [] { return said(on_rod(30), with("velocity-verlet", 1), 1); }},
    {K::joints_open, 2, [] { return said(as_constraints(linked_bodies(true)), with("rk4", 1), 2); }},
    {K::contacts_open, 0.02, [] { return said(sliding_capsules(), by_events("dop853", 5e-3), 4); }},
    {K::forces_inexact, 0.03, [] { return said_by_a_run_of_auto(K::forces_inexact); }},
    {K::loads_undecided, 0.02,
     [] {
       Model model = floor({0, Real(0.3)});
       add_box(model, 1, Vector3::Constant(Real(0.5)), {0, Real(0.5), 0}, Quaternion::Identity(), {2, 0, 0},
               {0, 3, 0});
       return said(model, 0.01, 2);
     }},
    {K::impacts_inexact, 0.8,
     [] {
       return said_by_events(tetrahedron_on_box({2, 1, -1}, Impacts::sequential), 0.002, 400);
     }},
    {K::interval_missed, 0.6, [] { return said_by_events(thrown_rod(68), 0.01, 60); }},
    {K::meeting_not_searched, 0.02, [] { return said(sliding_capsules(), by_events("dop853", 5e-3), 4); }},
    {K::changes_not_searched, 0.6, [] { return said_by_events(thrown_rod(121), 0.01, 60); }},
    {K::impacts_ordered, 0.02,
     [] {
       Model model = without_plane({1, 0});
       for (const Real side : {Real(-1), Real(0), Real(1)})
         ball(model, {Real(1.01) * side, 0, 0}, {-side, 0, 0});
       return said(model, 0.01, 2);
     }},
    {K::impacts_unending, 0.01, [] { return said_by_events(row_of_balls(230), 0.01, 1); }},
    {K::frictionless, 1, [] { return said_by_events(jamming_rod(), 0.01, 100); }},
    {K::wedged, 0.03, [] { return said_by_a_run_of_auto(K::wedged); }},
    {K::crawled, 0.6, [] { return said_by_events(thrown_rod(65), 0.01, 60); }},
    {K::slip_turned_late, 0.6, [] { return said_by_events(thrown_rod(86), 0.01, 60); }},
    {K::plastic, 10,
     [] {
       Model model = floor({1, 0});
       ball(model, {0, Real(0.50001), 0});
       return said_by_events(model, 10, 1);
     }},
    {K::not_located, 0.02, [] { return said(sliding_capsules(), by_events("dop853", 5e-3), 4); }},
    {K::too_fast, 0.02,
     [] {
       Model model = floor({0, 0});
       box(model, {0, 5, 0}, {3000, 0, 0});
       return said(model, on("stepping", 0.01), 2);
     }},
    {K::contacts_unsolved, 1, [] { return said(random_pile(0), forced(on("stepping", 0.01)), 100); }},
    {K::contacts_swept, 0.03,
     [] {
       Model model = boxes_on_floor(200, 1);
       model.motions[0].momentum.x() = 1;  // at rest they would stand, solved to rounding
       return said(model, on("stepping", 0.01), 3);
     }},
    {K::overlaps_unsolved, 1, [] { return said(random_pile(8), forced(on("stepping", 0.01)), 100); }},
    {K::joints_drifted, 1, [] { return said(held_in_two_places(), on("stepping", 0.02), 50); }},
    {K::joint_forces_implicit, 0.02,
     [] { return said(with_rail_and_damper(ball_over_plane(5, 0), 1e4), on("stepping", 0.01), 2); }},
    {K::gimbal_passed, 1,
     [] { return said(gimbal_towards_parallel(true, 3, Real(0.2), Real(0.3)), with("rk4", 0.1), 10); }},
    {K::gimbal_parallel, 3, [] { return said(through_parallel(), with("auto", 0.1), 30); }},
    {K::stiff, 0.02, [] { return said(with_drag(ball_over_plane(5, 0), 210), on("stepping", 0.01), 2); }},
    {K::unstable, 0.02,
     [] { return said(with_drag(ball_over_plane(5, 0), Real(7e8)), on("stepping", 0.01), 2); }},
    {K::solved_at_once, 0.06, [] { return said(blow_among_many(Real(0.5)), on("stepping", 0.01), 6); }},
    {K::solved_in_turn, 0.02, [] { return said(at_once(row_of_balls(3)), on("stepping", 0.01), 2); }},
    {K::blows_swept, 0.3, [] { return said(ball_onto_many(), on("stepping", 0.01), 30); }},
    {K::approaching, 0.02, [] { return said(row_of_balls(100), on("stepping", 0.01), 2); }},
    {K::facets_unsettled, 1, [] { return said(random_pile(8), forced(on("stepping", 0.01)), 100); }},
    {K::points_left_out, 0.02,
     [] {
       return said(prism(12, {0, Real(0.5), 0}), on("stepping", 0.01), 2);
     }},
    {K::more, 0.02, [] { return said(boxes_on_floor(120, 30), on("stepping", 0.01), 2); }},
};

// What the adapter says, not the engine, and the tests that provoke it.
const std::set<K> of_the_adapter = {K::forced, K::deep_overlap, K::jointed_overlap};
constexpr const char* tests_of_the_adapter = "tests/conformance/diagnostics_test.cc";

TEST(Diagnostics, EveryKindIsProvoked) {
  std::set<K> all = of_the_adapter;
  for (const Provoked& c : provoked) EXPECT_TRUE(all.insert(c.kind).second) << row(c.kind).name;
  EXPECT_EQ(all.size(), static_cast<std::size_t>(K::count));

  std::ifstream file(std::filesystem::path(source_dir) / tests_of_the_adapter);
  const std::string tests(std::istreambuf_iterator<char>(file), {});
  for (const K kind : of_the_adapter)
    EXPECT_NE(tests.find('"' + std::string(row(kind).name) + '"'), std::string::npos) << row(kind).name;
}

class Provokes : public testing::TestWithParam<std::size_t> {};

TEST_P(Provokes, IsSaidWithItsTimeAndNumbers) {
  const Provoked& c = provoked[GetParam()];
  const DiagnosticRow& its = row(c.kind);
  const Diagnostics all = c.by();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Diagnostic& d) { return d.kind == c.kind; });
  ASSERT_NE(found, all.end());
  EXPECT_GE(found->since, 0);
  EXPECT_LE(found->since, c.end * (1 + 1e-12));
  EXPECT_GE(found->count, 1);
  EXPECT_EQ(found->limit.has_value(), !its.limit_unit.empty());
  EXPECT_EQ(found->reached.has_value(), !its.unit.empty());
  if (found->reached) {
    EXPECT_GE(*found->reached, 0);
    EXPECT_TRUE(*found->reached > 0 || c.kind == K::not_located);  // steps without contacts obey their laws
  }
  EXPECT_EQ(sentence(*found).find('{'), std::string::npos) << sentence(*found);
}

INSTANTIATE_TEST_SUITE_P(Diagnostics, Provokes, testing::Range<std::size_t>(0, provoked.size()),
                         [](const auto& row_of) {
                           std::string name(row(provoked[row_of.param].kind).name);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// The rows stand in the order of the kinds, each with a name of its own; a sentence has the numbers that the row has
// units for.
TEST(Diagnostics, TableIsWhole) {
  std::set<std::string_view> names;
  for (std::size_t k = 0; k < diagnostic_rows.size(); ++k) {
    const DiagnosticRow& r = diagnostic_rows[k];
    EXPECT_EQ(static_cast<std::size_t>(r.kind), k);
    EXPECT_TRUE(names.insert(r.name).second) << r.name;
    EXPECT_EQ(r.text.find("{limit}") != std::string_view::npos, !r.limit_unit.empty()) << r.name;
    EXPECT_EQ(r.text.find("{reached}") != std::string_view::npos, !r.unit.empty()) << r.name;
  }
}

// What keeps its tolerance and hits no cap says nothing.
TEST(Diagnostics, NothingIsSaidWhereAllIsKept) {
  Model rolling = floor({Real(0.5), Real(0.4)});
  ball(rolling, {0, Real(0.5), 0}, {3, 0, 1});
  Model sliding = floor({0, Real(0.2)});
  box(sliding, {0, Real(0.5), 0}, {3, 0, 0});
  for (const Model& model :
       {free_top(), heavy_top(), coupled_bodies(), forced_bodies(), ball_over_plane(Real(0.5), Real(0.7)),
        rolling, sliding, linked_bodies(false), as_constraints(linked_bodies(true))})
    for (const Diagnostic& d : said(model, 0.01, 30)) ADD_FAILURE() << sentence(d);
}

// Two islands, of which one misses its tolerance: two points that fall together, beside a spring that does not care.
TEST(Diagnostics, NamesTheIslandAndSinceWhen) {
  Model model = falling_together();
  for (const Real x : {Real(7), Real(9)})
    add_body(model, make_body(Real(0.7), Matrix3::Zero()), {x, Real(0.4), 0}, {0, 0, 0}, {0, Real(0.3), 0},
             {0, 0, 0});
  model.forces.springs.push_back({.body = 2, .to = 3, .stiffness = 3, .rest_length = Real(1.5)});
  const auto name = [](Thing, int i) { return std::string(1, static_cast<char>('a' + i)); };
  Options options = with("auto", 0.1);
  options.tolerance = Real(1e-9);
  World world(model, options, name);
  ASSERT_EQ(world.island_count(), 2u);
  for (int i = 0; i < 22; ++i) world.step();
  EXPECT_TRUE(world.diagnostics().empty());
  for (int i = 0; i < 8; ++i) world.step();
  std::set<K> kinds;
  for (const Diagnostic& d : world.diagnostics()) {
    kinds.insert(d.kind);
    EXPECT_EQ(d.island.bodies, (std::vector<int>{0, 1}));
    EXPECT_EQ(d.island.count, 2u);
    EXPECT_FALSE(d.island.whole);
    EXPECT_EQ(d.island.method, "integration by dop853");
    EXPECT_EQ(d.island.order, 8);
    EXPECT_EQ(sentence(d, name).substr(0, 6), "a, b: ");
    if (d.kind == K::integration_ended) {
      EXPECT_NEAR(static_cast<double>(d.since), meet_at, 1e-6);
    }
    if (d.kind == K::tolerance_missed) {
      EXPECT_NEAR(static_cast<double>(d.since), 2.3, 1e-12);  // the first sample after it
      EXPECT_EQ(d.limit, static_cast<double>(options.tolerance));
    }
  }
  EXPECT_EQ(kinds, (std::set<K>{K::tolerance_missed, K::integration_ended}));
}

// Islands that become one, and that part, take nothing back of what they took.
TEST(Islands, CountTheOperationsOfThoseThatEnded) {
  struct Row {
    K kind;
    Model model;
    int steps;
  };
  for (const Row& row : {Row{K::merged, two_boxes(13, 4, {0, 0}, true), 700},
                         Row{K::parted, two_boxes(Real(1.2), 6, {1, 0}, false), 1000}}) {
    World world(row.model, with("auto", 0.005));
    std::int64_t before = 0;
    for (int i = 0; i < row.steps; ++i) {
      world.step();
      ASSERT_GE(world.operations(), before) << i;
      before = world.operations();
    }
    const Diagnostics all = world.diagnostics();
    EXPECT_TRUE(std::ranges::any_of(all, [&](const Diagnostic& d) { return d.kind == row.kind; }));
  }
}

// An island that ends says until when, once for each matter.
TEST(Diagnostics, OfAnIslandThatEndedSayUntilWhen) {
  const Diagnostics all = said(two_boxes(Real(1.2), 6, {1, 0}, false), 0.005, 1000);
  int ended = 0;
  for (const Diagnostic& d : all) {
    if (!d.until) continue;
    ended += d.kind == K::error_not_controlled;
    EXPECT_LE(d.since, *d.until);
    EXPECT_EQ(d.island.method, "fixed steps with impulses");
    EXPECT_EQ(d.island.order, 1);
    EXPECT_EQ(sentence(d).rfind("until t = ", 0), 0u);
  }
  EXPECT_EQ(ended, 1);
}

TEST(Diagnostics, OfManyIslandsAreCounted) {
  const Diagnostics all = said(boxes_on_floor(120, 30), on("stepping", 0.01), 2);
  EXPECT_EQ(all.size(), World::most_diagnostics);
  EXPECT_EQ(all.back().kind, K::more);
  EXPECT_EQ(static_cast<std::size_t>(all.back().count) + all.size() - 1, 120u);
}

TEST(DiagnosticLog, KeepsTheFirstTimeTheWorstAndTheCount) {
  DiagnosticLog log;
  EXPECT_FALSE(log.has(K::too_fast));
  log.note(K::too_fast, 0.5, 16);
  log.note(K::contacts_unsolved, 0.25, {}, 1e-3);
  log.note(K::contacts_unsolved, 0.75, {}, 3e-3);
  log.note(K::contacts_unsolved, 1, {}, 2e-3);
  const Diagnostics all = log.all();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].kind, K::too_fast);
  EXPECT_EQ(all[1].since, 0.25);
  EXPECT_EQ(all[1].count, 3);
  EXPECT_EQ(all[1].reached, 3e-3);
  EXPECT_TRUE(log.has(K::too_fast));
}

// Names that look like places for numbers stay as they are.
TEST(Sentence, ReplacesNothingInNames) {
  Diagnostic d{.kind = K::not_followed, .since = 0.5, .cause = "'{since}' is {count}"};
  d.island.whole = false, d.island.bodies = {4}, d.island.count = 9;
  EXPECT_EQ(sentence(d, [](Thing, int) { return std::string("'{reached}'"); }),
            "'{reached}' and 8 more: from t = 0.5 s on in fixed steps, because '{since}' is {count}");
}

}  // namespace
}  // namespace cylon::engine
