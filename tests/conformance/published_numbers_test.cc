// Numbers of an earlier, independent measurement of Bullet, ODE, MuJoCo, Simbody, DART, Siconos and engines in Node
// are reproduced, from the adapters, the exact solutions and the measures of this repository:
// tests/data/published/{engines_s1_s8, bullet_ode_s9_s12, mujoco_s1_s11, simbody_s1_s8, dart_s1_s12, siconos_s2, wasm_s1_s12,
// wasm_s10_s11}.json.
//
// A row that says `why` differs from what was printed.  `printed_of` names the setting or the sampling whose
// digits were printed in its place: the test asserts that those digits come out, and that the row's own still
// differ, so that no explanation outlives its discrepancy.  `not_reproduced` says that nothing gives them.
// `rounding` bounds what the rounding of another linear algebra library moves a value by, where that shows.
#include "tests/conformance/fixture.h"

#include "harness/cli/commands/published.h"
#include "harness/core/observable.h"
#include "harness/process/client.h"
#include "harness/process/session.h"
#include "harness/scenario/input.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <ostream>
#include <vector>

namespace cylon::conformance {
namespace {

using core::Vector3;
using nlohmann::json;

struct Number {
  std::string scenario, observable, body, reduction;
  bool along_x = false;          // that component alone
  std::optional<Vector3> along;  // the error along this direction at the end, with its sign
  bool share = false;            // of the truth along it
  double sample = 0;             // [s]; 0: every step
  std::string engine, dt, stated, why;
  std::string remark;                    // which the run makes, a part of it
  std::map<std::string, Vector3> start;  // of bodies, in place of the scenario's [m]
  double duration = 0;                   // [s]; 0: the scenario's
  std::string printed_engine;            // of `printed_of`, or the row's own
  double printed_sample = 0;
  bool not_reproduced = false;
  double rounding = 0;  // 0: every printed digit
  std::string name;     // of the test
};
void PrintTo(const Number& n, std::ostream* out) {
  *out << n.observable << " of " << n.scenario << " on " << n.engine << " at " << n.dt;
}

constexpr const char* of_all = "engines_s1_s8.json";
constexpr const char* of_contacts = "bullet_ode_s9_s12.json";
constexpr const char* of_mujoco = "mujoco_s1_s11.json";
constexpr const char* of_simbody = "simbody_s1_s8.json";
constexpr const char* of_dart = "dart_s1_s12.json";
constexpr const char* of_siconos = "siconos_s2.json";
constexpr const char* of_wasm = "wasm_s1_s12.json";
constexpr const char* of_wasm_contacts = "wasm_s10_s11.json";

Vector3 vector(const json& at) {
  return {at.at(0).get<double>(), at.at(1).get<double>(), at.at(2).get<double>()};
}

std::vector<Number> published(const std::string& name) {
  std::ifstream file(source("tests/data/published/" + name));
  const json data = json::parse(file);
  std::vector<Number> numbers;
  for (const json& table : data.at("tables"))
    for (const json& row : table.at("rows")) {
      Number n{.scenario = table.at("scenario"),
               .observable = table.at("observable"),
               .body = table.value("body", ""),
               .reduction = table.at("measure"),
               .along_x = table.value("component", "") == "x",
               .share = table.value("share", false),
               .sample = table.at("sample"),
               .engine = row.at("engine"),
               .dt = row.at("dt"),
               .stated = row.at("stated"),
               .why = row.value("why", ""),
               .remark = row.value("remark", ""),
               .not_reproduced = row.value("not_reproduced", false),
               .rounding = row.value("rounding", 0.0)};
      const json start = table.value("start", json::object());
      for (const auto& [body, at] : start.items()) n.start[body] = vector(at);
      if (table.contains("along")) n.along = vector(table.at("along"));
      n.duration = table.value("duration", 0.0);
      const json printed = row.value("printed_of", json::object());
      n.printed_engine = printed.value("engine", n.engine);
      n.printed_sample = printed.value("sample", n.sample);
      n.name = std::to_string(numbers.size()) + "_" + n.scenario + "_" + n.engine + "_" + n.dt;
      std::replace_if(
          n.name.begin(), n.name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); },
          '_');
      numbers.push_back(n);
    }
  return numbers;
}

core::Quantity quantity(const std::string& word) {
  for (const auto q : {core::Quantity::position, core::Quantity::velocity, core::Quantity::orientation,
                       core::Quantity::axis})
    if (core::name(q) == word) return q;
  throw std::invalid_argument("no observable '" + word + "' here");
}

// A claim on the quantity: that it follows the scenario's truth or, where there is none, that it is conserved.
core::Claim claim_of(const scenario::Scenario& scenario, const Number& n, double sample) {
  const bool end = n.reduction == "end";
  const auto kept = std::ranges::find_if(scenario.claims, [&](const core::Claim& claim) {
    return !claim.truth && claim.observable.quantity == quantity(n.observable);
  });
  if (kept != scenario.claims.end()) {
    core::Claim claim = *kept;
    claim.reduction = core::Reduction::max, claim.sample = sample;
    return claim;
  }
  return follows(scenario, quantity(n.observable), end ? core::Reduction::end : core::Reduction::max,
                 end ? scenario.duration : sample);
}

// A scenario of the measurement that is not shipped stands beside its numbers.
scenario::Scenario scenario_of(const std::string& name) {
  const std::filesystem::path own = source("tests/data/published/" + name + ".toml");
  return std::filesystem::exists(own) ? scenario::load(own) : shipped(name);
}

// Of a scene with one body, at the end.
double measured_along(const scenario::Scenario& scenario, const core::Claim& claim, const Number& n,
                      const std::string& engine_id) {
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = scenario::parse_step(n.dt);
  request.steps = request.every = std::llround(scenario.duration / request.setup.dt);
  const process::RunOutcome outcome = process::run(engine(engine_id), request, {});
  if (!outcome.recording) throw std::runtime_error(engine_id + ": " + outcome.reason);
  const core::State due =
      claim.truth ? claim.truth->state(scenario.duration) : core::initial_state(scenario.scene);
  const auto value = [&](const core::State& state) {
    return n.along->dot(n.observable == "velocity" ? state[0].velocity : state[0].position);
  };
  const double error = value(outcome.recording->states.back()) - value(due);
  return n.share ? error / value(due) : error;
}

double measured(const Number& n, const std::string& engine_id, double sample) {
  scenario::Scenario scenario = scenario_of(n.scenario);
  if (n.duration > 0) scenario.duration = n.duration;
  for (core::Body& body : scenario.scene.bodies)
    if (n.start.contains(body.name)) body.initial.position = n.start.at(body.name);
  core::Claim claim = claim_of(scenario, n, sample);
  if (n.along) return measured_along(scenario, claim, n, engine_id);
  if (n.along_x) claim.observable.component = core::Component::x;
  for (std::size_t i = 0; i < scenario.scene.bodies.size(); ++i)
    if (scenario.scene.bodies[i].name == n.body) claim.observable.body = static_cast<int>(i);
  scenario.claims = {claim};
  const results::Verdict row = verdict(scenario, engine_id, scenario::parse_step(n.dt));
  if (n.remark.empty())
    EXPECT_TRUE(row.detail.empty()) << row.detail;
  else
    EXPECT_NE(row.detail.find(n.remark), std::string::npos) << row.detail;
  return row.measured;
}

// One worker for each engine: a process of Node starts for longer than most runs take.
class Published : public testing::TestWithParam<Number> {
 public:
  static void SetUpTestSuite() { kept_.emplace(); }
  static void TearDownTestSuite() { kept_.reset(); }

 private:
  static inline std::optional<process::KeptWorkers> kept_;
};

TEST_P(Published, NumbersAreReproduced) {
  const Number& n = GetParam();
  if (const auto reason = process::missing(engine(n.engine).row)) GTEST_SKIP() << *reason;
  const double value = measured(n, n.engine, n.sample);
  RecordProperty("here", fmt::format("{:.5g}", value));
  if (n.rounding > 0) {
    EXPECT_NEAR(value, std::stod(n.stated), n.rounding);
    return;
  }
  if (n.why.empty()) {
    EXPECT_TRUE(cli::same_digits(value, n.stated)) << value << " here, " << n.stated << " stated";
    return;
  }
  EXPECT_FALSE(cli::same_digits(value, n.stated))
      << "agrees by now; the explanation is out of date: " << n.why;
  const bool another = n.printed_engine != n.engine || n.printed_sample != n.sample;
  ASSERT_NE(another, n.not_reproduced) << "either other digits were printed, or none give them: " << n.why;
  if (n.not_reproduced) return;
  const double printed = measured(n, n.printed_engine, n.printed_sample);
  EXPECT_TRUE(cli::same_digits(printed, n.stated))
      << printed << " on " << n.printed_engine << ", " << n.stated << " stated: " << n.why;
}

TEST(PublishedNumbers, FewAreNotReproduced) {
  const auto expect = [](const char* file, std::size_t all, std::ptrdiff_t not_reproduced) {
    const auto numbers = published(file);
    EXPECT_EQ(numbers.size(), all) << file;
    EXPECT_EQ(std::ranges::count_if(numbers, [](const Number& n) { return n.not_reproduced; }),
              not_reproduced)
        << file;
  };
  expect(of_all, 75, 2);
  expect(of_mujoco, 30, 6);
  expect(of_simbody, 16, 0);
  expect(of_dart, 39, 1);
  expect(of_siconos, 3, 1);
  expect(of_wasm, 258, 26);
  expect(of_contacts, 68, 18);
  expect(of_wasm_contacts, 56, 23);
}

std::string number_name(const testing::TestParamInfo<Number>& number) { return number.param.name; }
INSTANTIATE_TEST_SUITE_P(EnginesOnS1ToS8, Published, testing::ValuesIn(published(of_all)), number_name);
INSTANTIATE_TEST_SUITE_P(BulletAndOdeOnS9ToS12, Published, testing::ValuesIn(published(of_contacts)),
                         number_name);
INSTANTIATE_TEST_SUITE_P(MujocoOnS1ToS11, Published, testing::ValuesIn(published(of_mujoco)), number_name);
INSTANTIATE_TEST_SUITE_P(SimbodyOnS1ToS8, Published, testing::ValuesIn(published(of_simbody)), number_name);
INSTANTIATE_TEST_SUITE_P(DartOnS1ToS12, Published, testing::ValuesIn(published(of_dart)), number_name);
INSTANTIATE_TEST_SUITE_P(SiconosOnS2, Published, testing::ValuesIn(published(of_siconos)), number_name);
INSTANTIATE_TEST_SUITE_P(WasmOnS1ToS12, Published, testing::ValuesIn(published(of_wasm)), number_name);
INSTANTIATE_TEST_SUITE_P(WasmOnS10AndS11, Published, testing::ValuesIn(published(of_wasm_contacts)),
                         number_name);

}  // namespace
}  // namespace cylon::conformance
