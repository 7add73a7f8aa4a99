#include "harness/process/client.h"

#include "harness/core/event_watch.h"
#include "harness/core/input_error.h"
#include "harness/process/conversation.h"
#include "harness/process/cpu_witness.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "harness/process/opening.h"
#include "harness/process/read_back.h"
#include "harness/process/run_messages.h"
#include "harness/process/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace cylon::process {
namespace {

using nlohmann::json;

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

constexpr double most_states = 4e7;             // of bodies: 4 GiB
constexpr std::size_t most_events = 1'000'000;  // of a run

Run requested(const RunRequest& request) {
  if (!request.scene) throw std::invalid_argument("a run needs a scene");
  if (request.steps < 0 || request.every < 1 || request.repetitions < 0)
    throw std::invalid_argument("a run needs steps >= 0, every >= 1 and repetitions >= 0");
  if (!(request.setup.tolerance >= 0) || !std::isfinite(request.setup.tolerance))
    throw std::invalid_argument("a tolerance must be finite and not negative");
  Run run{request.steps, request.every, request.at, request.watch, false, request.contacts};
  std::sort(run.at.begin(), run.at.end());
  run.at.erase(std::unique(run.at.begin(), run.at.end()), run.at.end());
  if (!run.at.empty() && (run.at.front() < 0 || run.at.back() > run.steps))
    throw std::invalid_argument("a step to keep lies outside the run");
  if (!run.at.empty() && run.at.front() == 0) run.at.erase(run.at.begin());
  const double kept = 1.0 + std::floor(static_cast<double>(run.steps) / static_cast<double>(run.every)) +
                      static_cast<double>(run.at.size());
  if (const double states = kept * static_cast<double>(request.scene->bodies.size()); states > most_states)
    throw core::InputError(fmt::format(
        "the run keeps {:.3g} states of bodies, at most {:g} fit in memory: take fewer samples, or a "
        "shorter duration",
        states, most_states));
  return run;
}

/// Why an orientation of the state is none, or nothing: it would pass every claim that does not look at it.
/// What is not finite is judged later.
std::optional<std::string> no_orientation(const core::Scene& scene, const core::State& state,
                                          std::int64_t step) {
  constexpr double off = 1e-3;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double length = state[i].orientation.norm();
    if (std::isfinite(length) && std::abs(length - 1) > off)
      return fmt::format("step {}: the orientation of body '{}' has length {:.4g}, which must be 1 to {:g}",
                         step, scene.bodies[i].name, length, off);
  }
  return std::nullopt;
}

/// Asks for the run and collects it.  A worker that cannot watch is asked for every step instead, and the
/// harness watches and keeps what was wanted.
class Recorder {
 public:
  Recorder(const core::Scene& scene, const Run& wanted, const Hello& hello, double dt, core::State start)
      : scene_(scene),
        wanted_(wanted),
        asked_(wanted),
        here_(!wanted.watch.empty() && !hello.events),
        watch_(scene, here_ ? wanted.watch : std::vector<core::Pair>{}, dt),
        state_(start.size()) {
    if (here_) asked_ = {wanted.steps, 1, {}, {}};
    asked_.contacts = wanted.contacts && hello.live;
    if (here_) watch_.observe(0, start);
    recording_.dt = dt;
    recording_.steps.push_back(0);
    recording_.states.push_back(std::move(start));
  }

  core::Recording record(Conversation& worker) {
    const CpuWitness witness(worker);
    worker.ask(run_request(asked_));
    for (;;) {
      const std::variant<json, Frame> message = worker.next();
      if (const Frame* frame = std::get_if<Frame>(&message)) {
        add(*frame);
        continue;
      }
      const json& answer = std::get<json>(message);
      if (answer.contains("event")) {
        add(event_from_json(answer));
      } else if (answer.contains("contacts")) {
        if (!asked_.contacts) broken("contacts that were not asked for");
        ConstraintForces told = constraint_forces_from_json(answer, scene_);
        recording_.contacts = std::move(told.contacts);
        recording_.reactions = std::move(told.reactions);
      } else if (const auto reason = text_of(answer, "error")) {
        throw Failure(results::Status::crash, fmt::format("stopped after step {}: {}", last_, *reason));
      } else {
        require_ok(answer, "run");
        finish(done_from_json(answer));
        witness.require_at_most_used(times_.step_seconds);
        recording_.cpu_verified = witness.confirms(times_.step_seconds);
        return std::move(recording_);
      }
    }
  }

  /// Of the run that record() collected.
  Repetition times() const { return times_; }

 private:
  void add(const Frame& frame) {
    ++frames_;
    const char* bytes = frame.payload.data();
    for (std::uint64_t i = 0; i < frame.header.states; ++i, bytes += state_.size() * bytes_per_body) {
      const std::uint64_t step = frame.header.first_step + i * frame.header.stride;
      const std::int64_t due = next_sample(asked_, last_);
      if (last_ >= asked_.steps) broken(fmt::format("a state of step {} after the last one", step));
      if (step != static_cast<std::uint64_t>(due))
        broken(fmt::format("a state of step {} where step {} was expected", step, due));
      unpack_state(bytes, state_);
      if (!no_orientation_) no_orientation_ = no_orientation(scene_, state_, due);
      last_ = due;
      if (here_) watch_.observe(due, state_);
      if (due != next_sample(wanted_, recording_.steps.back())) continue;
      recording_.steps.push_back(due);
      recording_.states.push_back(state_);
    }
  }

  void add(const core::Event& event) {
    if (std::find(asked_.watch.begin(), asked_.watch.end(), event.pair) == asked_.watch.end())
      broken("an event of a pair that was not to be watched");
    if (recording_.events.size() >= most_events) broken(fmt::format("more than {} events", most_events));
    recording_.events.push_back(event);
  }

  void finish(const Done& done) {
    if (last_ != asked_.steps || done.steps != asked_.steps)
      broken(fmt::format("done after step {} of {}", std::min(last_, done.steps), asked_.steps));
    if (done.frames != frames_)
      broken(fmt::format("{} frames came, {} were announced", frames_, done.frames));
    if (no_orientation_) throw Failure(results::Status::fail, *no_orientation_);
    if (here_) recording_.events = watch_.take();
    const auto key = [](const core::Event& e) { return std::isnan(e.time) ? HUGE_VAL : e.time; };
    std::stable_sort(recording_.events.begin(), recording_.events.end(),
                     [&](const core::Event& a, const core::Event& b) { return key(a) < key(b); });
    recording_.cpu_seconds = 1e-9 * done.step_ns;
    times_ = {1e-9 * done.load_ns, 1e-9 * done.step_ns};
    recording_.remarks = done.remarks;
    require_known(done.diagnostics);
    recording_.diagnostics = done.diagnostics;
    recording_.works = done.works;
  }

  // Whatever names a body names one of the scene.
  void require_known(const std::vector<told::Diagnostic>& diagnostics) const {
    std::set<std::string_view> names;
    for (const core::Body& body : scene_.bodies) names.insert(body.name);
    for (const told::Diagnostic& d : diagnostics) {
      if (d.body_count > scene_.bodies.size())
        broken(fmt::format("a diagnostic of {} bodies, but the scene has {}", d.body_count,
                           scene_.bodies.size()));
      for (const std::string& name : d.bodies)
        if (!names.contains(name))
          broken(fmt::format("a diagnostic of body '{}', which the scene lacks", name));
    }
  }

  const core::Scene& scene_;
  Run wanted_, asked_;
  bool here_;  // whether the harness watches
  core::EventWatch watch_;
  core::State state_;
  core::Recording recording_;
  std::optional<std::string> no_orientation_;  // the first
  Repetition times_;
  std::int64_t last_ = 0, frames_ = 0;
};

/// One more run of the request's scene, of that many steps, of which nothing but its times is kept.
struct Repeated {
  Repetition times;
  StepsTold told;
};
Repeated repeat(Conversation& worker, const EngineChoice& choice, const RunRequest& request,
                std::int64_t steps, const Hello& hello, const Limits& limits, Asked asked) {
  open_scene(worker, choice, *request.scene, request.setup, hello.engine, limits.run_seconds);
  core::State start = read_start(worker, request.scene->bodies.size());
  Recorder recorder(*request.scene, {steps, std::max<std::int64_t>(1, steps), {}, {}}, hello,
                    request.setup.dt, std::move(start));
  const CpuWitness witness(worker, asked);
  recorder.record(worker);
  return {recorder.times(), {recorder.times().step_seconds, witness.used()}};
}

/// The request's repetitions, of a worker that hides none of its work.
std::vector<Repetition> repetitions(Conversation& worker, const EngineChoice& choice,
                                    const RunRequest& request, const Hello& hello, const Limits& limits) {
  std::vector<Repetition> times;
  std::vector<StepsTold> told;
  const auto run = [&](std::int64_t steps, Asked asked) {
    return repeat(worker, choice, request, steps, hello, limits, asked);
  };
  for (int i = 0; i < request.repetitions; ++i) {
    const Repeated one = run(request.steps, Asked::process);
    times.push_back(one.times);
    told.push_back(one.told);
  }
  require_no_hidden_work(told, request.scene->bodies.size(), request.steps,
                         [&](std::int64_t steps, Asked asked) { return run(steps, asked).told; });
  return times;
}

/// The request's run in a worker that said hello; the outcome gets what is known of it on the way.
core::Recording recorded(Conversation& worker, const EngineChoice& choice, const RunRequest& request,
                         const Run& wanted, const Hello& hello, const Limits& limits, RunOutcome& outcome) {
  const core::Scene& scene = *request.scene;
  outcome.engine = hello.engine;
  outcome.terms = open_scene(worker, choice, scene, request.setup, hello.engine, limits.run_seconds);
  core::State start = read_start(worker, scene.bodies.size());
  if (const auto difference = read_back_difference(scene, start, hello.engine.precision))
    throw Failure(results::Status::fail, "initial state read back differs: " + *difference);
  Recorder recorder(scene, wanted, hello, request.setup.dt, std::move(start));
  core::Recording recording = recorder.record(worker);
  outcome.peak_bytes = worker.peak_bytes();
  return recording;
}

/// Writes on a recording who made it.
void sign(RunOutcome& outcome) {
  if (!outcome.recording) return;
  core::Recording& recording = *outcome.recording;
  recording.engine.name = outcome.engine.name;
  recording.engine.version = outcome.engine.version;
  recording.engine.precision = outcome.engine.precision;
  if (const auto* ran = outcome.engine.integrator(outcome.terms.integrator))
    recording.engine.integrators = {*ran};
  recording.terms = outcome.terms;
  recording.complaints = outcome.stderr_tail;
}

/// Does `task`, turning its failures into the outcome's status and reason.  Whether the worker may be asked on.
template <class Task>
bool attempt(RunOutcome& outcome, Task task) try {
  task();
  return true;
} catch (const Failure& failure) {
  outcome.status = failure.status;
  outcome.reason = failure.what();
  return dynamic_cast<const Refused*>(&failure) != nullptr;
} catch (const MalformedMessage& error) {
  outcome.status = results::Status::protocol;
  outcome.reason = error.what();
  return false;
}

}  // namespace

struct Session::Worker {
  explicit Worker(const EngineRow& row, const Limits& limits)
      : conversation(command_of(row), limits.memory_bytes) {}
  Conversation conversation;
  Hello hello;
};

RunOutcome run(const EngineChoice& choice, const RunRequest& request, const Limits& limits) {
  if (KeptWorkers* kept = KeptWorkers::here(); kept && request.repetitions == 0)
    return kept->run(choice, request, limits);
  const Run wanted = requested(request);
  RunOutcome outcome;
  std::optional<Conversation> worker;
  std::string death;
  attempt(outcome, [&] {
    worker.emplace(command_of(choice.row), limits.memory_bytes);
    const Hello hello = introduce(*worker, choice.row, limits.hello_seconds);
    core::Recording recording = recorded(*worker, choice, request, wanted, hello, limits, outcome);
    outcome.repetitions = repetitions(*worker, choice, request, hello, limits);
    outcome.recording = std::move(recording);
    death = worker->finish(limits.quit_seconds);
  });
  if (!worker) return outcome;
  worker->kill();
  outcome.stderr_tail = worker->complaints();
  if (!death.empty()) outcome.stderr_tail += fmt::format("killed by {} after the run\n", death);
  sign(outcome);
  return outcome;
}

Session::Session(EngineRow row, const Limits& limits) : row_(std::move(row)), limits_(limits) {}

Session::~Session() {
  if (worker_) worker_->conversation.kill();
}

RunOutcome Session::run(const EngineChoice& choice, const RunRequest& request) {
  const Run wanted = requested(request);
  if (request.repetitions != 0) throw std::invalid_argument("a session repeats no run");
  RunOutcome outcome;
  bool well = false;
  try {
    well = attempt(outcome, [&] {
      if (!worker_) {
        worker_ = std::make_unique<Worker>(row_, limits_);
        worker_->hello = introduce(worker_->conversation, row_, limits_.hello_seconds);
      }
      outcome.recording =
          recorded(worker_->conversation, choice, request, wanted, worker_->hello, limits_, outcome);
    });
  } catch (...) {  // an impossible setup, or an interruption
    worker_.reset();
    throw;
  }
  if (!well && worker_) {
    worker_->conversation.kill();
    outcome.stderr_tail = worker_->conversation.complaints();
    worker_.reset();
  }
  sign(outcome);
  return outcome;
}

namespace {
thread_local KeptWorkers* innermost = nullptr;
}  // namespace

KeptWorkers::KeptWorkers() : outer_(innermost) { innermost = this; }
KeptWorkers::~KeptWorkers() { innermost = outer_; }
KeptWorkers* KeptWorkers::here() { return innermost; }

RunOutcome KeptWorkers::run(const EngineChoice& choice, const RunRequest& request, const Limits& limits) {
  const std::pair process(choice.row.started_by, choice.row.command);
  return sessions_.try_emplace(process, choice.row, limits).first->second.run(choice, request);
}

void require_possible(const EngineChoice& choice) {
  if (choice.id == choice.row.id) return;  // it states nothing
  core::Scene scene;
  scene.bodies.emplace_back().name = "body";
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = 1e-3;
  run(choice, request, {.run_seconds = 10});
}

core::Engine describe(const EngineChoice& choice, const Limits& limits) try {
  Conversation worker(command_of(choice.row), limits.memory_bytes);
  core::Engine engine = introduce(worker, choice.row, limits.hello_seconds).engine;
  worker.finish(limits.quit_seconds);
  return engine;
} catch (const MalformedMessage& error) {
  throw Failure(results::Status::protocol, error.what());
}

}  // namespace cylon::process
