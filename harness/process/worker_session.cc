#include "harness/process/worker_session.h"

#include "harness/core/event_watch.h"
#include "harness/core/input_error.h"
#include "harness/process/frame.h"
#include "harness/process/json_fields.h"
#include "harness/process/scene_json.h"
#include "harness/process/step_timer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::process {

using nlohmann::json;

bool WorkerSession::obey(const json& request) {
  const std::string cmd = Fields(request, "").text("cmd");
  if (cmd == "quit") return false;
  if (cmd == "hello") {
    pipes_.write(hello_json({simulator_.engine(), true, true}));
  } else if (cmd == "load") {
    load(request);
  } else if (cmd == "run") {
    const Run asked = run_from_json(request);
    if (!(asked.resume ? going_ : loaded_))
      throw MalformedMessage(asked.resume ? "continue: there is no run to go on from"
                                          : "cmd: each run needs a load before it");
    loaded_ = false, going_ = true;
    try {
      run(asked);
    } catch (const core::GaveUp& reason) {
      going_ = false;
      pipes_.write(json{{"error", reason.what()}});
    }
    load_ns_ = 0;
  } else {
    throw MalformedMessage(fmt::format("cmd: unknown command '{}'", cmd));
  }
  return true;
}

void WorkerSession::load(const json& request) {
  loaded_ = going_ = false;
  setup_ = setup_from_json(request);
  scene_ = scene_from_json(request.at("scene"));
  pipes_.write(answer_to_load());
  if (!loaded_) return;
  state_.resize(scene_.bodies.size());
  simulator_.read(state_);
  FramePacker start(state_.size());
  start.add(0, state_);
  pipes_.write(start.take());
}

// Impossible setups are the user's mistake and an answer, as is a start from which a run cannot go on; whatever else load()
// throws is a crash.
json WorkerSession::answer_to_load() try {
  const double before = process_cpu_ns();
  const core::Loaded loaded = simulator_.load_if_supported(scene_, setup_);
  load_ns_ = process_cpu_ns() - before;
  loaded_ = !loaded.unsupported;
  if (!loaded_) return {{"unsupported", *loaded.unsupported}};
  return terms_json(loaded.terms);
} catch (const core::GaveUp& reason) {
  return {{"unsupported", reason.what()}};
} catch (const core::InputError& error) {
  return {{"error", error.what()}};
} catch (const std::invalid_argument& error) {
  return {{"error", error.what()}};
}

void WorkerSession::run(const Run& run) {
  const bool watching = !run.watch.empty();
  core::EventWatch watch(scene_, run.watch, setup_.dt);
  if (watching) watch.observe(0, state_);
  FramePacker frame(state_.size());
  // While pairs are watched each step is a burst, and the CPU clock would cost too much.
  StepTimer timer(watching ? std::numeric_limits<std::int64_t>::max() : run.steps / run.every);
  Done done{run.steps, 0, 0, load_ns_, {}};
  const auto send = [&] {
    timer.end_batch();
    pipes_.write(frame.take());
    ++done.frames;
    for (const core::Event& event : watch.take()) pipes_.write(event_json(event));
    timer.begin_batch();
  };

  timer.begin_batch();
  std::int64_t sample = next_sample(run, 0);
  for (std::int64_t step = 0; step < run.steps;) {
    // Contacts are those of the last step, which is then a burst of its own.
    const bool last = run.contacts && step + 1 == run.steps;
    const std::int64_t due =
        run.contacts && sample == run.steps ? std::max<std::int64_t>(1, sample - step - 1) : sample - step;
    const std::int64_t burst = watching ? 1 : due;
    if (last) simulator_.keep_contacts(true);
    timer.begin_burst();
    simulator_.advance(burst);
    timer.end_burst();
    step += burst;

    simulator_.read(state_);
    if (watching) watch.observe(step, state_);
    if (step < sample) continue;
    const auto index = static_cast<std::uint64_t>(step);
    if (!frame.fits(index)) send();
    frame.add(index, state_);
    sample = next_sample(run, step);
  }
  if (!frame.empty()) send();
  if (run.contacts) {
    ConstraintForces told;
    if (run.steps > 0) told = {simulator_.contacts(), simulator_.reactions()};
    pipes_.write(constraint_forces_json(told));
    simulator_.keep_contacts(false);
  }
  done.step_ns = timer.total_ns();
  done.remarks = simulator_.remarks();
  done.diagnostics = simulator_.diagnostics();
  done.works = simulator_.works();
  pipes_.write(done_json(done));
}

}  // namespace cylon::process
