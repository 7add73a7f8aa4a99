// The worker's side, driven without a process: commands from one file, answers into another.
#include "harness/process/worker_loop.h"
#include "harness/process/frame.h"
#include "harness/process/messages.h"
#include "harness/process/run_messages.h"
#include "tests/harness/process/fixture.h"

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#include <cmath>
#include <memory>
#include <stdexcept>

namespace cylon::process {
namespace {

using nlohmann::json;

/// Falls exactly, and bounces exactly off y = 0 with restitution 1; takes as long for a step as it is told
/// to.
class Toy : public core::Simulator {
 public:
  double burn_ns = 0;       ///< Thread CPU time that each step takes, at least.
  double burnt_ns = 0;      ///< That it took, by its own account.
  int kept = 0;             ///< Steps that were made with contacts kept.
  double load_burn_ns = 0;  ///< Thread CPU time that each load takes, at least.

  const core::Engine& engine() const override { return engine_; }
  std::optional<std::string> unsupported(const core::Scene& scene, const core::Setup&) const override {
    return scene.joints.empty() ? std::nullopt : std::optional<std::string>("no joints");
  }
  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    const double start = cpu_ns();
    while (load_burn_ns > 0 && cpu_ns() - start < load_burn_ns) {
    }
    if (!setup.integrator.empty())
      throw std::invalid_argument("unknown integrator '" + setup.integrator + "'");
    state_ = core::initial_state(scene), dt_ = setup.dt, steps_ = 0;
    return {"", "exact", 9, "exact", {{"a", "b", "c", "d"}}, {"stops at nothing"}};
  }
  void step() override {
    const double start = cpu_ns();
    ++steps_;
    kept += keep_ ? 1 : 0;
    for (core::BodyState& body : state_) {
      // y = h - g s^2/2 with s in [-T, T] from the apex, T = sqrt(2 h / g).
      const double h = 1, g = 9.81, period = 2 * std::sqrt(2 * h / g);
      const double s = std::remainder(static_cast<double>(steps_) * dt_, period);
      body.position.y() = h - g * s * s / 2;
      body.velocity.y() = -g * s;
    }
    while (burn_ns > 0 && cpu_ns() - start < burn_ns) {
    }
    burnt_ns += cpu_ns() - start;
  }
  void read(core::State& out) const override { out = state_; }
  void keep_contacts(bool keep) override { keep_ = keep; }
  std::vector<core::Contact> contacts() const override {
    return {{{0, core::world, 0}, {0, 0, 0}, {0, 1, 0}, {}},
            {{0, core::world, 0}, {NAN, 0, 0}, {0, 1, 0}, 1.0}};
  }

 private:
  static double cpu_ns() {
    timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
  }
  core::Engine engine_{"toy", "1", "double", {}, "", {{"exact", 9, ""}}, {}};
  core::State state_;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  bool keep_ = false;
};

/// Everything that serve() said, in order.
struct Answers {
  std::vector<json> lines;
  std::vector<std::vector<std::int64_t>> frames;  // the steps of each
  std::vector<core::State> states;
};

Answers serve_all(core::Simulator& simulator, const std::vector<json>& commands, std::size_t bodies) {
  const int in = memfd_create("in", 0), out = memfd_create("out", 0);
  for (const json& command : commands) {
    const std::string text = line(command);
    EXPECT_EQ(::write(in, text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }
  ::lseek(in, 0, SEEK_SET);
  EXPECT_EQ(serve(simulator, in, out), 0);
  std::string bytes(static_cast<std::size_t>(::lseek(out, 0, SEEK_CUR)), '\0');
  EXPECT_EQ(::pread(out, bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
  ::close(in), ::close(out);

  Answers answers;
  for (std::size_t at = 0; at < bytes.size();) {
    if (bytes[at] == '{') {
      const std::size_t end = bytes.find('\n', at);
      answers.lines.push_back(json::parse(bytes.substr(at, end - at)));
      at = end + 1;
      continue;
    }
    EXPECT_EQ(bytes.substr(at, 4), "CYLF");
    const FrameHeader header = unpack_header(bytes.data() + at);
    EXPECT_EQ(header.payload, header.states * bodies * 104);
    EXPECT_LE(header.payload, std::max(frame_payload, bodies * 104));
    at += FrameHeader::size;
    answers.frames.emplace_back();
    for (std::uint32_t i = 0; i < header.states; ++i, at += bodies * 104) {
      answers.frames.back().push_back(static_cast<std::int64_t>(header.first_step + i * header.stride));
      answers.states.emplace_back(bodies);
      unpack_state(bytes.data() + at, answers.states.back());
    }
  }
  return answers;
}

core::Scene ball() {
  core::Scene scene;
  scene.bodies = {point("ball", {0, 1, 0}, {0, 0, 0})};
  scene.bodies[0].shape = core::Sphere{0.0};
  scene.bodies[0].collide = true;
  scene.planes = {{"floor", core::Vector3::UnitY(), 0}};
  return scene;
}

json load_of(const core::Scene& scene, double dt = 0.01) {
  core::Setup setup;
  setup.dt = dt;
  return load_request(scene, setup);
}

TEST(WorkerLoop, AnswersEveryCommandInTurn) {
  Toy toy;
  core::Scene jointed = ball();
  jointed.joints.resize(1);
  json wrong = load_of(ball());
  wrong["integrator"] = "magic";
  const Answers answers = serve_all(toy,
                                    {{{"cmd", "hello"}, {"protocol", 1}},
                                     load_of(jointed),
                                     wrong,
                                     run_request({10, 1, {}, {}}),
                                     {{"cmd", "dance"}},
                                     load_of(ball()),
                                     run_request({0, 1, {}, {}}),
                                     {{"cmd", "quit"}},
                                     {{"cmd", "hello"}, {"protocol", 1}}},
                                    1);
  ASSERT_EQ(answers.lines.size(), 7u);  // and nothing after quit
  EXPECT_EQ(hello_from_json(answers.lines[0]).engine.integrators[0].order, 9);
  EXPECT_TRUE(hello_from_json(answers.lines[0]).events);
  EXPECT_EQ(answers.lines[1], json({{"unsupported", "no joints"}}));
  EXPECT_EQ(answers.lines[2], json({{"error", "unknown integrator 'magic'"}}));
  EXPECT_EQ(answers.lines[3], json({{"error", "cmd: each run needs a load before it"}}));
  EXPECT_EQ(answers.lines[4], json({{"error", "cmd: unknown command 'dance'"}}));
  const core::Terms terms = terms_from_json(answers.lines[5]);
  EXPECT_EQ(terms.settings.at(0).reason, "d");
  EXPECT_EQ(terms.unforceable.at(0), "stops at nothing");
  EXPECT_EQ(done_from_json(answers.lines[6]).frames, 0);
  EXPECT_EQ(answers.frames, (std::vector<std::vector<std::int64_t>>{{0}}));
}

TEST(WorkerLoop, AFrameHoldsEvenlySpacedStates) {
  Toy toy;
  const Answers answers = serve_all(toy, {load_of(ball()), run_request({107, 25, {60, 61}, {}})}, 1);
  EXPECT_EQ(answers.frames,
            (std::vector<std::vector<std::int64_t>>{{0}, {25, 50}, {60, 61}, {75, 100}, {107}}));
  EXPECT_EQ(done_from_json(answers.lines.back()).frames, 4);
}

TEST(WorkerLoop, AFrameIsFullAt256KiB) {
  core::Scene scene;
  for (int i = 0; i < 1000; ++i) scene.bodies.push_back(point("b" + std::to_string(i), {0, 1, 0}, {0, 0, 0}));
  Toy toy;
  const Answers answers = serve_all(toy, {load_of(scene), run_request({5, 1, {}, {}})}, 1000);
  EXPECT_EQ(answers.frames, (std::vector<std::vector<std::int64_t>>{{0}, {1, 2}, {3, 4}, {5}}));
  for (const core::State& state : answers.states) EXPECT_EQ(state[0].position, state[999].position);
}

// t_n = (2n - 1) sqrt(2h/g), |v| = sqrt(2gh); apexes of height h between.
TEST(WorkerLoop, ReportsRequestedEventsOnly) {
  Toy toy;
  const Answers answers =
      serve_all(toy, {load_of(ball(), 0.001), run_request({2000, 500, {}, {{0, core::world, 0}}})}, 1);
  std::vector<core::Event> bounces;
  for (const json& line : answers.lines)
    if (line.contains("event") && line["event"]["kind"] == "bounce") bounces.push_back(event_from_json(line));
  ASSERT_EQ(bounces.size(), 2u);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(bounces[n].index, static_cast<int>(n + 1));
    EXPECT_EQ(bounces[n].pair, (core::Pair{0, core::world, 0}));
    EXPECT_NEAR(bounces[n].time, static_cast<double>(2 * n + 1) * std::sqrt(2 / 9.81), 1e-9);
    EXPECT_NEAR(bounces[n].speed, std::sqrt(2 * 9.81), 1e-6);
  }
  EXPECT_EQ(answers.frames.size(), 2u);  // the start, and {500, 1000, 1500, 2000}
}

// The pieces of a run are the run; each ends with its own contacts, and the steps of each count from 1.
TEST(WorkerLoop, ContinuesFromEndOfRun) {
  const auto piece = [](std::int64_t steps, std::int64_t every, bool resume) {
    process::Run run{steps, every, {}, {}};
    run.resume = resume, run.contacts = true;
    return run_request(run);
  };
  Toy toy, whole;
  const Answers parts =
      serve_all(toy, {load_of(ball()), piece(3, 2, false), piece(40, 40, true), piece(0, 1, true)}, 1);
  const Answers one = serve_all(whole, {load_of(ball()), run_request({43, 43, {}, {}})}, 1);
  EXPECT_EQ(parts.frames, (std::vector<std::vector<std::int64_t>>{{0}, {2, 3}, {40}}));
  EXPECT_EQ(parts.states.back()[0].position, one.states.back()[0].position);
  std::vector<std::size_t> told;
  for (const json& line : parts.lines)
    if (line.contains("contacts")) told.push_back(line["contacts"].size());
  EXPECT_EQ(told, (std::vector<std::size_t>{1, 1, 0}));
  EXPECT_EQ(toy.kept, 2);  // the last step of each piece that has one, and no other
  EXPECT_EQ(whole.kept, 0);
}

TEST(WorkerLoop, ContinuesOnlyAfterARun) {
  Toy toy;
  json on = run_request({1, 1, {}, {}});
  on["continue"] = true;
  json watched = run_request({1, 1, {}, {{0, core::world, 0}}});
  watched["continue"] = true;
  const Answers answers = serve_all(
      toy, {on, load_of(ball()), on, run_request({1, 1, {}, {}}), watched, run_request({1, 1, {}, {}})}, 1);
  std::vector<std::string> errors;
  for (const json& line : answers.lines)
    if (line.contains("error")) errors.push_back(line["error"]);
  const std::string none = "continue: there is no run to go on from";
  EXPECT_EQ(errors, (std::vector<std::string>{none, none, "watch: must be empty where a run continues",
                                              "cmd: each run needs a load before it"}));
}

// step_ns is the time of the steps and of nothing else, however densely they are recorded.
TEST(WorkerLoop, TimesStepsOnly) {
  for (const std::int64_t every : {1, 7, 2000}) {
    Toy toy;
    toy.burn_ns = 20e3;
    const Answers answers = serve_all(toy, {load_of(ball()), run_request({2000, every, {}, {}})}, 1);
    const double told = done_from_json(answers.lines.back()).step_ns;
    EXPECT_NEAR(told / toy.burnt_ns, 1, 0.1) << "every " << every;
  }
}

// The load's time is told apart from the steps', though the engine burns time in both.
TEST(WorkerLoop, ReportsLoadTimeSeparately) {
  Toy toy;
  toy.load_burn_ns = 5e6;
  const Answers answers = serve_all(toy, {load_of(ball()), run_request({10, 1, {}, {}})}, 1);
  const Done done = done_from_json(answers.lines.back());
  EXPECT_GE(done.load_ns, 5e6);
  EXPECT_LT(done.step_ns, 2e6);
}

}  // namespace
}  // namespace cylon::process
