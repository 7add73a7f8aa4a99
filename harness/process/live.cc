#include "harness/process/live.h"

#include "harness/process/json_fields.h"
#include "harness/process/opening.h"
#include "harness/process/read_back.h"
#include "harness/process/resume.h"
#include "harness/process/run_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::process {
namespace {

using nlohmann::json;

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

bool finite(const core::State& state) {
  return std::all_of(state.begin(), state.end(), [](const core::BodyState& s) {
    return s.position.allFinite() && s.orientation.coeffs().allFinite() && s.velocity.allFinite() &&
           s.angular_velocity.allFinite();
  });
}

/// Messages that are not what the protocol says are a failure of the worker's.
template <class Task>
auto speaking(Task task) try {
  return task();
} catch (const MalformedMessage& error) {
  throw Failure(results::Status::protocol, error.what());
}

}  // namespace

LiveRun::LiveRun(EngineChoice choice, Limits limits)
    : choice_(std::move(choice)),
      limits_(limits),
      worker_(command_of(choice_.row), limits_.memory_bytes),
      hello_(speaking([&] { return introduce(worker_, choice_.row, limits_.hello_seconds); })) {}

void LiveRun::load(const core::Scene& scene, const core::Setup& setup) {
  scene_ = scene;
  setup_ = setup;
  joints_ = held_joints(scene_);
  steps_ = 0;
  speaking([&] { open(scene_); });
}

void LiveRun::open(const core::Scene& scene) {
  terms_ = open_scene(worker_, choice_, scene, setup_, hello_.engine, limits_.run_seconds);
  state_ = read_start(worker_, scene.bodies.size());
  if (const auto difference = read_back_difference(scene, state_, hello_.engine.precision))
    throw Failure(results::Status::fail, "initial state read back differs: " + *difference);
}

Piece LiveRun::advance(std::int64_t n) {
  return speaking([&] {
    if (steps_ > 0 && !hello_.live) {
      if (const auto reason = not_resumable(scene_))
        throw Failure(results::Status::unsupported, "the worker is not live, and " + *reason);
      const double t = static_cast<double>(steps_) * setup_.dt;
      open(resumed(scene_, joints_, state_, t));
      Piece piece = run(n, false);
      steps_ += n;
      return piece;
    }
    Piece piece = run(n, steps_ > 0);
    steps_ += n;
    return piece;
  });
}

Piece LiveRun::run(std::int64_t n, bool resume) {
  Run asked{n, n, {}, {}};
  asked.resume = resume;
  asked.contacts = hello_.live;
  worker_.ask(run_request(asked), limits_.run_seconds);
  Piece piece;
  std::int64_t frames = 0;
  for (;;) {
    const std::variant<json, Frame> message = worker_.next();
    if (const Frame* frame = std::get_if<Frame>(&message)) {
      if (frame->header.states != 1 || frame->header.first_step != static_cast<std::uint64_t>(n))
        broken(fmt::format("a frame where only the state of step {} was expected", n));
      unpack_state(frame->payload.data(), state_);
      ++frames;
      continue;
    }
    const json& answer = std::get<json>(message);
    if (answer.contains("contacts")) {
      if (!asked.contacts) broken("contacts that were not asked for");
      piece.contacts = constraint_forces_from_json(answer, scene_).contacts;
    } else if (const auto reason = text_of(answer, "error")) {
      throw Failure(results::Status::crash, "gave up: " + *reason);
    } else {
      require_ok(answer, "run");
      const Done done = done_from_json(answer);
      if (done.steps != n || frames != 1 || done.frames != 1)
        broken(fmt::format("done after step {} of {} with {} frames, of which {} came", done.steps, n,
                           done.frames, frames));
      piece.cpu_seconds = 1e-9 * (done.step_ns + done.load_ns);
      break;
    }
  }
  if (!finite(state_)) throw Failure(results::Status::non_finite, "the state is NaN or infinite");
  piece.state = state_;
  return piece;
}

}  // namespace cylon::process
