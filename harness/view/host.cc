#include "harness/view/host.h"

#include "harness/core/input_error.h"
#include "harness/process/failure.h"
#include "harness/process/interruption.h"
#include "harness/view/record_file.h"
#include "harness/view/viewer_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::view {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto tick = std::chrono::microseconds(16'667);  // 60 states per second, as screens show them
constexpr auto heartbeat = std::chrono::seconds(1);

}  // namespace

Host::Host(std::unique_ptr<Session> session, std::filesystem::path record,
           std::function<void(const std::string&)> say)
    : session_(std::move(session)), record_(std::move(record)), say_(std::move(say)) {
  publish();
  thread_ = std::thread([this] { pace(); });
}

Host::~Host() { stop(); }

void Host::stop() {
  if (!thread_.joinable()) return;
  stop_ = true;
  changed_.notify_all();
  thread_.join();
  if (asking_.joinable()) asking_.join();
  save();
}

// A lane shows after half a second; all engines take several.
void Host::ask_engines() {
  SessionOptions options;
  {
    const std::lock_guard lock(session_mutex_);
    options = session_->options();
  }
  asking_ = std::thread([this, options = std::move(options)] {
    for (const process::EngineRow& row : options.rows) {
      if (stop_) return;
      if (std::ranges::find(options.engines, row.id, &EngineInfo::id) != options.engines.end()) continue;
      try {
        EngineInfo info = ask(row, options.limits);
        ++waiting_;
        const std::lock_guard lock(session_mutex_);
        --waiting_;
        session_->offer(std::move(info));
        publish();
      } catch (const process::Failure&) {
        continue;  // not installed
      } catch (const process::Interrupted&) {
        return;
      }
    }
  });
}

void Host::pace() {
  Clock::time_point last = Clock::now();
  while (!stop_) {
    while (waiting_ > 0 && !stop_) std::this_thread::yield();  // commands go first
    const Clock::time_point now = Clock::now();
    {
      const std::lock_guard lock(session_mutex_);
      if (session_->advance(std::chrono::duration<double>(now - last).count())) publish();
    }
    last = now;
    std::this_thread::sleep_until(now + tick);
  }
}

// With the session's mutex held, or before anybody else has it.
void Host::publish() {
  auto state = std::make_shared<const std::string>(state_message(*session_));
  {
    const std::lock_guard lock(newest_mutex_);
    if (!description_ || changes_ != session_->changes()) {
      changes_ = session_->changes();
      description_ = std::make_shared<const std::string>(session_message(*session_));
      ++session_number_;
    }
    state_ = std::move(state);
    ++state_number_;
    ++states_;
  }
  changed_.notify_all();
}

void Host::command(std::string_view line) {
  const Command command = parse_command(line);
  ++waiting_;
  const std::lock_guard lock(session_mutex_);
  --waiting_;
  if (std::holds_alternative<Reset>(command)) save();
  session_->apply(command);
  publish();
}

std::string Host::session_json() {
  ++waiting_;
  const std::lock_guard lock(session_mutex_);
  --waiting_;
  return view::session_json(*session_).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::vector<std::string> Host::failures() {
  const std::lock_guard lock(session_mutex_);
  std::vector<std::string> lines;
  for (const auto& lane : session_->lanes())
    if (!lane->running()) lines.push_back(lane->spec().engine + ": " + lane->reason());
  return lines;
}

std::string Host::newer(Seen& seen) {
  std::shared_ptr<const std::string> state, description;
  {
    std::unique_lock lock(newest_mutex_);
    changed_.wait_for(lock, heartbeat, [&] { return stop_ || state_number_ != seen.state; });
    if (stop_) return "";
    if (session_number_ != seen.session) description = description_;
    state = state_;
    seen = {state_number_, session_number_};
  }
  return description ? *description + *state : *state;
}

void Host::save() {
  if (record_.empty() || session_->recorder().empty()) return;
  try {
    say_(fmt::format("recorded {}",
                     save_recording(session_->recorder(), session_->scenario(), record_).string()));
  } catch (const core::InputError& error) {
    say_(error.what());
  }
}

}  // namespace cylon::view
