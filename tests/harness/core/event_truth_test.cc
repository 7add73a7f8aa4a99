// Events that are found in the shipped truths' states, against periods and angles that elliptic integrals
// give with 21 digits (characteristic numbers of the reference solutions in tests/data/truth and of their
// kin).
#include "harness/core/event_find.h"
#include "harness/core/measure.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <ostream>
#include <string>

namespace {

using namespace cylon;
using enum core::EventKind;
using enum core::EventQuantity;

struct Row {
  const char* scenario;
  core::EventKind kind;
  int index;
  core::EventQuantity quantity;
  double value;
};
void PrintTo(const Row& row, std::ostream* out) {
  *out << row.scenario << ' ' << core::name(row.kind) << ' ' << core::name(row.quantity);
}

const Row rows[] = {
    // 2 K/lambda between flips; a period is two.
    {"dzhanibekov", flip, 11, period, 2 * 5.02592913815747030419},
    {"heavy_top", nutation, 1, angle, std::acos(-0.493847243688319109295)},
    {"heavy_top", nutation, 17, period, 1.09860221852161742499},
    {"heavy_top", nutation, 17, rate, 3.73155256359215102494 / 1.09860221852161742499},
    {"heavy_top_loops", nutation, 41, period, 0.217626149317119287662},
    {"heavy_top_loops", nutation, 41, rate, 0.475010690741078967129 / 0.217626149317119287662},
    {"heavy_top_nutating", nutation, 41, period, 0.20794147001539549696},
    {"heavy_top_nutating", nutation, 41, rate, 0.428099435751045314114 / 0.20794147001539549696},
    {"heavy_top_sleeping_unstable", nutation, 3, period, 1.99464935048848503268},
    {"heavy_top_steady_fast", precession, 12, rate, 38.6254923661684110176},
    {"spring_orbit", apsis, 1, distance, 0.971418156414119577668},
    {"spring_orbit", apsis, 55, period, 0.707114895021978617535},
    {"physical_pendulum", swing, 9, period, 2.16273514739470891566},
    {"slide_to_roll", roll, 1, core::EventQuantity::time, 0.485413329450026697733},
    {"water_step_force", crossing, 1, core::EventQuantity::time, 0.430656105507511752448},
    {"water_step_force", crossing, 10, core::EventQuantity::time, 3.97691508507149963901},
    {"kepler", apsis, 3, period, 3.89354752893466777},
};

class TruthEvents : public testing::TestWithParam<Row> {};

core::Claim claim_of(const scenario::Scenario& scenario, const Row& row) {
  for (const core::Claim& claim : scenario.claims) {
    const core::Observable& q = claim.observable;
    if (q.quantity == core::Quantity::event && q.event == row.kind && q.index == row.index &&
        q.event_quantity == row.quantity)
      return claim;
  }
  throw std::out_of_range(std::string(row.scenario) + " makes no such claim");
}

TEST_P(TruthEvents, HaveTheKnownValuesWithinTheirBounds) {
  const Row& row = GetParam();
  const auto scenario =
      scenario::load(std::filesystem::path(source_dir) / "scenarios" / (std::string(row.scenario) + ".toml"));
  const core::Claim claim = claim_of(scenario, row);
  bool found = false;
  for (const core::Event& event : claim.truth->events) {
    if (event.kind != row.kind || event.index != row.index) continue;
    found = true;
    const double value = core::quantity(claim.truth->events, event, row.quantity).value();
    EXPECT_LE(std::abs(value - row.value), claim.truth_error + 1e-15 * std::abs(row.value))
        << value << " where " << row.value << " is known";
  }
  EXPECT_TRUE(found);
  EXPECT_GT(claim.truth_error, 0);
  EXPECT_LT(claim.truth_error, 1e-8 * std::abs(row.value)) << "a bound that says nothing";
}

INSTANTIATE_TEST_SUITE_P(Shipped, TruthEvents, testing::ValuesIn(rows), [](const auto& row) {
  const Row& r = row.param;
  return std::string(r.scenario) + "_" + std::string(core::name(r.kind)) + "_" + std::to_string(r.index) +
         "_" + std::string(core::name(r.quantity));
});

// Nothing is missed between the samples at which a truth is scanned: five times as many find the same.
TEST(TruthEventsFound, AreComplete) {
  for (const char* name : {"dzhanibekov", "heavy_top", "spring_orbit"}) {
    const auto scenario =
        scenario::load(std::filesystem::path(source_dir) / "scenarios" / (std::string(name) + ".toml"));
    for (const core::Claim& claim : scenario.claims) {
      if (claim.observable.quantity != core::Quantity::event) continue;
      core::Truth plain = *claim.truth;
      plain.events.clear();
      const auto once =
          core::with_events(claim.observable, scenario.scene, plain, scenario.duration / 5, 0.001);
      std::size_t early = 0;
      for (const core::Event& event : claim.truth->events)
        early += event.time <= scenario.duration / 5 ? 1 : 0;
      EXPECT_EQ(once.events.size(), early) << claim.label;
      EXPECT_GT(early, 0u) << claim.label;
    }
  }
}

// Events closer than 2048 a run were counted by what they look like at 2048 times.
TEST(TruthEvents, AreFoundHoweverFastTheyFollow) {
  const scenario::Scenario scenario = scenario::parse(
      "duration = 20\nstep = \"1/4000\"\n[[body]]\nname = \"b\"\nmass = 1\nposition = [0.4, 0, 0]\n"
      "velocity = [0, 150, 0]\n[[spring]]\nbody = \"b\"\npin = [0, 0, 0]\nstiffness = 1e6\nrest_length = 0\n"
      "[[claim]]\nfollows = \"spring_zero_length\"\nobservable = \"event\"\nevent = \"turn\"\nquantity = "
      "\"count\"\n"
      "tolerance = { absolute = 0, reason = \"none too many\" }\n",
      "fast.toml");
  // An ellipse about the pin, once around in 2 pi/sqrt(k/m), with two turns.
  const auto& events = scenario.claims[0].truth->events;
  EXPECT_EQ(static_cast<double>(events.size()), std::floor(20 * 1000 / std::numbers::pi));
  for (std::size_t i = 1; i < events.size(); ++i)
    ASSERT_NEAR(events[i].time - events[i - 1].time, std::numbers::pi / 1000, 1e-12) << i;
}

}  // namespace
