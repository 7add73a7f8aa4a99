// Numbers of an earlier, independent measurement of Bullet, ODE, MuJoCo, Simbody, DART, Siconos and engines in Node
// are reproduced, from the adapters, the exact solutions and the measures of this repository:
// tests/data/published/{engines_s1_s8, bullet_ode_s9_s12, mujoco_s1_s11, simbody_s1_s8, dart_s1_s12, siconos_s2, wasm_s1_s12,
// wasm_s10_s11, wasm_variants, wasm_ammo, engines_words}.json.
//
// A row that says `why` differs from what was printed.  `printed_of` names the setting or the sampling whose
// digits were printed in its place: the test asserts that those digits come out, and that the row's own still
// differ, so that no explanation outlives its discrepancy.  `not_reproduced` says that nothing gives them, and `here` what
// comes out instead; of a row with `digits` as many as that come out.  `status` says how a run ends that has no end.
// `rounding` bounds what rounding moves a value by: that of another linear algebra library or order of a sum, or a tie.
#include "tests/conformance/fixture.h"

#include "harness/cli/commands/published.h"
#include "harness/core/measure.h"
#include "harness/core/observable.h"
#include "harness/process/client.h"
#include "harness/process/session.h"
#include "harness/scenario/input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <vector>

namespace cylon::conformance {
namespace {

using core::Vector3;
using nlohmann::json;

// What was printed in place of a number: which word, by a bound on it.
struct Words {
  double bound = 0;
  std::string below, above;

  const std::string& of(double value) const { return value < bound ? below : above; }
};

struct Number {
  std::string scenario, observable, body, reduction;
  bool along_x = false;               // that component alone
  std::optional<Vector3> along;       // the error along this direction at the end, with its sign
  std::optional<Vector3> along_body;  // a direction that turns with the body
  bool share = false;                 // of the truth along it
  double scale = 1;                   // from the SI unit to the printed one
  int index = 1;                      // of an event
  Words words;
  double sample = 0;  // [s]; 0: every step
  std::string engine, dt, stated, why;
  std::string remark;                    // which the run makes, a part of it
  std::map<std::string, Vector3> start;  // of bodies, in place of the scenario's [m]
  std::string last;                      // of the bodies, in place of its own turn
  double duration = 0;                   // [s]; 0: the scenario's
  std::string printed_engine;            // of `printed_of`, or the row's own
  double printed_sample = 0;
  bool not_reproduced = false;
  std::string here;     // what comes out where another number was printed
  std::string status;   // how the run ends where it does not reach its end
  int digits = 0;       // of the printed ones that come out; 0: all
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
constexpr const char* of_wasm_variants = "wasm_variants.json";
constexpr const char* of_ammo = "wasm_ammo.json";
constexpr const char* of_words = "engines_words.json";

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
               .scale = table.value("scale", 1.0),
               .index = table.value("index", 1),
               .sample = table.at("sample"),
               .engine = row.at("engine"),
               .dt = row.at("dt"),
               .stated = row.at("stated"),
               .why = row.value("why", ""),
               .remark = row.value("remark", ""),
               .not_reproduced = row.value("not_reproduced", false),
               .here = row.value("here", ""),
               .status = row.value("status", ""),
               .digits = row.value("digits", 0),
               .rounding = row.value("rounding", 0.0)};
      const json start = table.value("start", json::object());
      for (const auto& [body, at] : start.items()) n.start[body] = vector(at);
      if (table.contains("along")) n.along = vector(table.at("along"));
      if (table.contains("along_body")) n.along_body = vector(table.at("along_body"));
      if (const json words = table.value("words", json()); !words.is_null())
        n.words = {words.at("bound"), words.at("below"), words.at("above")};
      n.last = table.value("last", "");
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

// 600 000 steps: such numbers are for ./test slow.
bool is_long(const Number& n) {
  return n.dt == "1/10000" && (n.scenario == "dzhanibekov" || n.scenario == "spring_zero_length");
}

std::vector<Number> short_ones(const std::string& file) {
  std::vector<Number> numbers = published(file);
  std::erase_if(numbers, is_long);
  return numbers;
}

core::Quantity quantity(const std::string& word) {
  for (int i = 0; i <= static_cast<int>(core::Quantity::event); ++i)
    if (const auto q = static_cast<core::Quantity>(i); core::name(q) == word) return q;
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

scenario::Scenario scenario_of(const Number& n) {
  scenario::Scenario scenario = scenario_of(n.scenario);
  if (n.duration > 0) scenario.duration = n.duration;
  for (core::Body& body : scenario.scene.bodies)
    if (n.start.contains(body.name)) body.initial.position = n.start.at(body.name);
  std::stable_partition(scenario.scene.bodies.begin(), scenario.scene.bodies.end(),
                        [&](const core::Body& body) { return body.name != n.last; });
  return scenario;
}

std::optional<int> body_of(const core::Scene& scene, const std::string& name) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].name == name) return static_cast<int>(i);
  return std::nullopt;
}

constexpr std::size_t most_states = 50'001;  // of a run that is kept

// One run for all numbers that are read from it.
const process::RunOutcome& run_of(const scenario::Scenario& scenario, const Number& n,
                                  const std::string& engine_id, double sample) {
  static std::map<std::string, process::RunOutcome> kept;
  static const std::set<std::string> of_the_end = {"end", "value", "change", "relative_change", "distance"};
  const bool end =
      sample == 0 && n.observable != "slip" && n.observable != "apex" && of_the_end.contains(n.reduction);
  const std::string key =
      fmt::format("{} {} {} {} {} {} {} {}", n.scenario, scenario.duration, engine_id, n.dt, sample, end,
                  scenario.scene.bodies.back().initial.position.x(), n.last);
  if (const auto known = kept.find(key); known != kept.end()) return known->second;
  std::erase_if(kept, [](const auto& run) {
    return run.second.recording && run.second.recording->states.size() > most_states;
  });
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = scenario::parse_step(n.dt);
  request.steps = core::whole_steps(scenario.duration, request.setup.dt);
  request.every = end ? request.steps : sample > 0 ? core::whole_steps(sample, request.setup.dt) : 1;
  return kept.emplace(key, process::run(engine(engine_id), request)).first->second;
}

// Along a direction, or as it is: a scalar stands in x.
double along(const Number& n, const core::State& state, const Eigen::Vector4d& value,
             std::optional<int> body) {
  if (n.along) return n.along->dot(value.head<3>());
  if (n.along_body)
    return (state[static_cast<std::size_t>(body.value_or(0))].orientation * *n.along_body)
        .dot(value.head<3>());
  return value.x();
}

// Angle by which a centre goes round the vertical, whole turns counted [rad].
double azimuth(const core::Recording& recording) {
  double sum = 0;
  for (std::size_t i = 1; i < recording.states.size(); ++i) {
    const Vector3 &from = recording.states[i - 1][0].position, &to = recording.states[i][0].position;
    sum += std::atan2(from.z() * to.x() - from.x() * to.z(), from.x() * to.x() + from.z() * to.z());
  }
  return sum;
}

// When the point of a ball that touches the floor slides by less than 1 cm/s for the first time [s].
double end_of_slip(const scenario::Scenario& scenario, const core::Recording& recording) {
  const double radius = scenario.scene.bodies[0].initial.position.y();
  for (std::size_t i = 0; i < recording.states.size(); ++i) {
    const auto& ball = recording.states[i][0];
    const Vector3 slip = ball.velocity + ball.angular_velocity.cross(Vector3(0, -radius, 0));
    if (std::hypot(slip.x(), slip.z()) < 0.01) return recording.time(i);
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// The highest of the sampled heights between bounces, less the height at rest.
double apex(const scenario::Scenario& scenario, const core::Recording& recording, int index) {
  const double radius = std::get<core::Sphere>(scenario.scene.bodies[0].shape).radius;
  const auto height = [&](std::size_t i) { return recording.states[i][0].position.y(); };
  int found = 0;
  for (std::size_t i = 1; i + 1 < recording.states.size(); ++i)
    if (height(i) > height(i - 1) && height(i) >= height(i + 1) && ++found == index)
      return height(i) - radius;
  return std::numeric_limits<double>::quiet_NaN();
}

// Of what the states are, without a truth.
std::optional<double> of_states(const scenario::Scenario& scenario, const Number& n,
                                const core::Recording& recording) {
  if (n.observable == "azimuth") return azimuth(recording);
  if (n.observable == "slip") return end_of_slip(scenario, recording);
  if (n.observable == "apex") return apex(scenario, recording, n.index);
  core::Observable observable{.quantity = quantity(n.observable), .body = body_of(scenario.scene, n.body)};
  const core::State start = core::initial_state(scenario.scene);
  const auto at = [&](const core::State& state) {
    core::Values values;
    core::evaluate(observable, scenario.scene, state, values);
    return values.at(0);
  };
  const auto number = [&](const core::State& state) { return along(n, state, at(state), observable.body); };
  const core::State& end = recording.states.back();
  if (n.reduction == "value") return number(end);
  if (n.reduction == "change") return number(end) - number(start);
  if (n.reduction == "relative_change") return (number(end) - number(start)) / number(start);
  if (n.reduction == "distance") return (at(end) - at(start)).norm();
  if (n.reduction == "largest" || n.reduction == "largest_relative_distance") {
    const bool itself = n.reduction == "largest";
    const Eigen::Vector4d from = itself ? Eigen::Vector4d::Zero() : at(start);
    double largest = 0;
    for (const core::State& state : recording.states) largest = std::max(largest, (at(state) - from).norm());
    return itself ? largest : largest / from.norm();
  }
  if (n.reduction == "sign_changes") {
    int changes = 0;
    for (std::size_t i = 1; i < recording.states.size(); ++i)
      changes += number(recording.states[i - 1]) * number(recording.states[i]) < 0;
    return changes;
  }
  return std::nullopt;
}

double along_truth(const scenario::Scenario& scenario, const core::Claim& claim, const Number& n,
                   const core::Recording& recording) {
  const core::State due =
      claim.truth ? claim.truth->state(scenario.duration) : core::initial_state(scenario.scene);
  const auto value = [&](const core::State& state) {
    return n.along->dot(n.observable == "velocity" ? state[0].velocity : state[0].position);
  };
  const double error = value(recording.states.back()) - value(due);
  return n.share ? error / value(due) : error;
}

double measured(const Number& n, const std::string& engine_id, double sample) {
  scenario::Scenario scenario = scenario_of(n);
  const process::RunOutcome& outcome = run_of(scenario, n, engine_id, sample);
  if (!n.status.empty()) {
    EXPECT_EQ(results::name(outcome.status), n.status) << outcome.reason;
    EXPECT_NE(outcome.reason.find(n.here), std::string::npos) << outcome.reason;
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (!outcome.recording) throw std::runtime_error(engine_id + ": " + outcome.reason);
  const std::string remarks = fmt::format("{}", fmt::join(outcome.recording->remarks, "; "));
  EXPECT_EQ(remarks.empty(), n.remark.empty()) << remarks;
  EXPECT_NE(remarks.find(n.remark), std::string::npos) << remarks;
  if (core::first_bad_step(*outcome.recording)) return std::numeric_limits<double>::quiet_NaN();
  if (const auto value = of_states(scenario, n, *outcome.recording)) return *value * n.scale;
  core::Claim claim = claim_of(scenario, n, sample);
  if (n.along) return along_truth(scenario, claim, n, *outcome.recording);
  if (n.along_x) claim.observable.component = core::Component::x;
  claim.observable.body = body_of(scenario.scene, n.body);
  return core::measure(claim, scenario.scene, std::span(&*outcome.recording, 1), scenario.duration).value;
}

// One worker for each engine: a process of Node starts for longer than most runs take.
class Published : public testing::TestWithParam<Number> {
 public:
  static void SetUpTestSuite() { kept_.emplace(); }
  static void TearDownTestSuite() { kept_.reset(); }

 private:
  static inline std::optional<process::KeptWorkers> kept_;
};

bool agrees(const Number& n, double value, const std::string& text) {
  if (!n.words.below.empty()) return n.words.of(value) == text;
  if (text == "not finite") return !std::isfinite(value);
  return cli::same_digits(value, text);
}

// Whether the value is the printed one to so many digits.
bool near(double value, const std::string& stated, int digits) {
  const double due = std::stod(stated);
  return std::abs(value - due) <= 0.5 * std::pow(10, std::floor(std::log10(std::abs(due))) + 1 - digits);
}

TEST_P(Published, NumbersAreReproduced) {
  const Number& n = GetParam();
  if (const auto reason = process::missing(engine(n.engine).row)) GTEST_SKIP() << *reason;
  const double value = measured(n, n.engine, n.sample);
  RecordProperty("here", fmt::format("{:.5g}", value));
  if (!n.status.empty()) return;
  if (n.rounding > 0) {
    EXPECT_NEAR(value, std::stod(n.stated), n.rounding);
    return;
  }
  if (n.why.empty()) {
    EXPECT_TRUE(agrees(n, value, n.stated)) << value << " here, " << n.stated << " stated";
    return;
  }
  EXPECT_FALSE(agrees(n, value, n.stated)) << "agrees by now; the explanation is out of date: " << n.why;
  if (!n.here.empty()) {
    EXPECT_TRUE(agrees(n, value, n.here)) << value << " here, not " << n.here << ": " << n.why;
  }
  if (n.digits > 0) {
    EXPECT_TRUE(near(value, n.stated, n.digits)) << value << " here, " << n.stated << " stated";
    return;
  }
  const bool another = n.printed_engine != n.engine || n.printed_sample != n.sample;
  ASSERT_NE(another, n.not_reproduced) << "either other digits were printed, or none give them: " << n.why;
  ASSERT_NE(n.not_reproduced, n.here.empty()) << "what comes out here: " << n.why;
  if (n.not_reproduced) return;
  const double printed = measured(n, n.printed_engine, n.printed_sample);
  EXPECT_TRUE(agrees(n, printed, n.stated))
      << printed << " on " << n.printed_engine << ", " << n.stated << " stated: " << n.why;
}

TEST(PublishedNumbers, FewAreNotReproduced) {
  const auto expect = [](const char* file, std::size_t all, std::ptrdiff_t not_reproduced,
                         std::ptrdiff_t not_run) {
    const auto numbers = published(file);
    EXPECT_EQ(numbers.size(), all) << file;
    EXPECT_EQ(std::ranges::count_if(numbers, [](const Number& n) { return n.not_reproduced; }),
              not_reproduced)
        << file;
    EXPECT_EQ(std::ranges::count_if(numbers, [](const Number& n) { return !n.status.empty(); }), not_run)
        << file;
  };
  expect(of_all, 75, 2, 0);
  expect(of_mujoco, 30, 6, 0);
  expect(of_simbody, 16, 0, 0);
  expect(of_dart, 39, 1, 0);
  expect(of_siconos, 3, 1, 0);
  expect(of_wasm, 900, 29, 60);
  expect(of_contacts, 68, 18, 0);
  expect(of_wasm_contacts, 84, 28, 0);
  expect(of_wasm_variants, 31, 1, 0);
  expect(of_ammo, 169, 26, 0);
  expect(of_words, 62, 3, 10);
}

std::string number_name(const testing::TestParamInfo<Number>& number) { return number.param.name; }

std::vector<Number> long_ones() {
  std::vector<Number> all;
  for (const char* file : {of_all, of_contacts, of_mujoco, of_simbody, of_dart, of_siconos, of_wasm,
                           of_wasm_contacts, of_wasm_variants, of_ammo, of_words})
    for (Number n : published(file))
      if (is_long(n)) {
        n.name = std::to_string(all.size()) + "_of_" + n.name;
        all.push_back(std::move(n));
      }
  return all;
}

INSTANTIATE_TEST_SUITE_P(EnginesOnS1ToS8, Published, testing::ValuesIn(short_ones(of_all)), number_name);
INSTANTIATE_TEST_SUITE_P(BulletAndOdeOnS9ToS12, Published, testing::ValuesIn(short_ones(of_contacts)),
                         number_name);
INSTANTIATE_TEST_SUITE_P(MujocoOnS1ToS11, Published, testing::ValuesIn(short_ones(of_mujoco)), number_name);
INSTANTIATE_TEST_SUITE_P(SimbodyOnS1ToS8, Published, testing::ValuesIn(short_ones(of_simbody)), number_name);
INSTANTIATE_TEST_SUITE_P(DartOnS1ToS12, Published, testing::ValuesIn(short_ones(of_dart)), number_name);
INSTANTIATE_TEST_SUITE_P(SiconosOnS2, Published, testing::ValuesIn(short_ones(of_siconos)), number_name);
INSTANTIATE_TEST_SUITE_P(WasmOnS1ToS12, Published, testing::ValuesIn(short_ones(of_wasm)), number_name);
INSTANTIATE_TEST_SUITE_P(WasmOnS10AndS11, Published, testing::ValuesIn(short_ones(of_wasm_contacts)),
                         number_name);
INSTANTIATE_TEST_SUITE_P(WasmVariants, Published, testing::ValuesIn(short_ones(of_wasm_variants)),
                         number_name);
INSTANTIATE_TEST_SUITE_P(WasmAmmo, Published, testing::ValuesIn(short_ones(of_ammo)), number_name);
INSTANTIATE_TEST_SUITE_P(EnginesInWords, Published, testing::ValuesIn(short_ones(of_words)), number_name);
INSTANTIATE_TEST_SUITE_P(LongRuns, Published, testing::ValuesIn(long_ones()), number_name);

}  // namespace
}  // namespace cylon::conformance
