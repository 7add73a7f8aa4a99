#include "harness/process/worker_loop.h"

#include "harness/core/event_watch.h"
#include "harness/core/input_error.h"
#include "harness/process/frame.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "harness/process/scene_json.h"

#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cylon::process {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t most_timed_apart = 1000;  // bursts of a run; the CPU clock costs 0.2 us

double nanoseconds(Clock::duration d) { return std::chrono::duration<double, std::nano>(d).count(); }

double thread_cpu_ns() {
  timespec t;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

/// What two readings of a clock in a row differ by: the least of some.
template <class Read>
double clock_cost_ns(const Read& read) {
  double least = 1e9;
  for (int i = 0; i < 64; ++i) {
    const double before = read();
    least = std::min(least, read() - before);
  }
  return least;
}

double wall_ns() { return nanoseconds(Clock::now().time_since_epoch()); }

/// CPU time of bursts of steps; see serve().
class StepTimer {
 public:
  /// Few bursts: the CPU clock is read around each; many: they share that of their batch.
  explicit StepTimer(bool few) : few_(few), cost_(clock_cost_ns(few ? thread_cpu_ns : wall_ns)) {}

  void begin_batch() {
    if (!few_) cpu_ = thread_cpu_ns(), wall_ = wall_ns(), inside_ = 0;
  }
  void begin_burst() { burst_ = few_ ? thread_cpu_ns() : wall_ns(); }
  void end_burst() {
    const double took = std::max(0.0, (few_ ? thread_cpu_ns() : wall_ns()) - burst_ - cost_);
    (few_ ? total_ : inside_) += took;
  }
  void end_batch() {
    if (few_) return;
    const double cpu = thread_cpu_ns() - cpu_, wall = wall_ns() - wall_;
    total_ += cpu * std::min(1.0, inside_ / std::max(wall, 1.0));
  }
  double total_ns() const { return total_; }

 private:
  bool few_;
  double cost_, total_ = 0, cpu_ = 0, wall_ = 0, inside_ = 0, burst_ = 0;
};

/// Nobody reads our output any more.
struct Abandoned {};

class Pipes {
 public:
  Pipes(int in, int out) : in_(in), out_(out) {}

  /// The next line without its end, or nothing at the end of input.
  std::optional<std::string> read_line() {
    std::size_t searched = 0;
    for (;;) {
      if (const std::size_t end = pending_.find('\n', searched); end != std::string::npos) {
        std::string text = pending_.substr(0, end);
        pending_.erase(0, end + 1);
        return text;
      }
      searched = pending_.size();
      char chunk[1 << 16];
      const ssize_t n = ::read(in_, chunk, sizeof chunk);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return std::nullopt;
      pending_.append(chunk, static_cast<std::size_t>(n));
    }
  }

  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t n = ::write(out_, bytes.data(), bytes.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) throw Abandoned();
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
  }
  void write(const json& message) { write(std::string_view(line(message))); }

 private:
  int in_, out_;
  std::string pending_;
};

class Session {
 public:
  Session(core::Simulator& simulator, Pipes& pipes) : simulator_(simulator), pipes_(pipes) {}

  /// Returns whether to go on.
  bool obey(const json& request) {
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
      run(asked);
      load_ns_ = 0;
    } else {
      throw MalformedMessage(fmt::format("cmd: unknown command '{}'", cmd));
    }
    return true;
  }

 private:
  void load(const json& request) {
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

  // Impossible setups are the user's mistake and an answer; whatever else load() throws is a crash.
  json answer_to_load() try {
    if (const std::optional<std::string> reason = simulator_.unsupported(scene_, setup_))
      return {{"unsupported", *reason}};
    const double before = thread_cpu_ns();
    const core::Terms terms = simulator_.load(scene_, setup_);
    load_ns_ = thread_cpu_ns() - before;
    loaded_ = true;
    return terms_json(terms);
  } catch (const core::InputError& error) {
    return {{"error", error.what()}};
  } catch (const std::invalid_argument& error) {
    return {{"error", error.what()}};
  }

  void run(const Run& run) {
    const bool watching = !run.watch.empty();
    core::EventWatch watch(scene_, run.watch, setup_.dt);
    if (watching) watch.observe(0, state_);
    FramePacker frame(state_.size());
    StepTimer timer(!watching && run.steps / run.every <= most_timed_apart);
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
      pipes_.write(contacts_json(run.steps > 0 ? simulator_.contacts() : std::vector<core::Contact>{}));
      simulator_.keep_contacts(false);
    }
    done.step_ns = timer.total_ns();
    done.remarks = simulator_.remarks();
    pipes_.write(done_json(done));
  }

  core::Simulator& simulator_;
  Pipes& pipes_;
  core::Scene scene_;
  core::Setup setup_;
  core::State state_;
  double load_ns_ = 0;
  bool loaded_ = false;  // and not run yet
  bool going_ = false;   // ran, and can go on
};

}  // namespace

int serve(core::Simulator& simulator, int in_fd, int out_fd) {
  Pipes pipes(in_fd, out_fd);
  Session session(simulator, pipes);
  try {
    while (const std::optional<std::string> text = pipes.read_line()) {
      try {
        if (!session.obey(parse_object(*text))) break;
      } catch (const MalformedMessage& error) {
        pipes.write(json{{"error", error.what()}});
      }
    }
  } catch (const Abandoned&) {
    return 1;
  }
  return 0;
}

}  // namespace cylon::process
