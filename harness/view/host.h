// The one place where the session, the clock and the readers meet: a thread lets time pass, commands come in
// between, and readers get the newest state, never a backlog.
#pragma once

#include "harness/view/session.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace cylon::view {

/// What a reader has seen so far.
struct Seen {
  std::uint64_t state = 0, session = 0;
};

class Host {
 public:
  /// `record`: a scenario file to save to on reset and at the end; empty: none.  `say` gets a line for each
  /// file saved or not saved.
  Host(std::unique_ptr<Session>, std::filesystem::path record, std::function<void(const std::string&)> say);
  ~Host();
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  /// Throws BadCommand.
  void command(std::string_view json);

  /// live.ts: Session.
  std::string session_json();

  /// Of lanes that do not run: "bullet: unsupported: Bullet has no rigid distance joint."
  std::vector<std::string> failures();

  /// The messages that are newer than what was seen, which it moves on; waits for one, at most a second,
  /// after which the newest state comes again so that a reader who is gone shows.  Empty when the host stops.
  std::string newer(Seen&);

  /// States published so far.
  std::uint64_t states() const { return states_; }

  /// Asks all other engines what they are, one after another, and offers those that answer.  Once.
  void ask_engines();

  /// Ends the pacing, the asking, and what readers wait for; saves the recording.
  void stop();

 private:
  void pace();
  void publish();
  void save();

  std::unique_ptr<Session> session_;
  std::filesystem::path record_;
  std::function<void(const std::string&)> say_;
  std::mutex session_mutex_;
  std::atomic<bool> stop_ = false;
  std::atomic<int> waiting_ = 0;  // commands that want the session
  std::atomic<std::uint64_t> states_ = 0;

  std::mutex newest_mutex_;  // of all below
  std::condition_variable changed_;
  std::shared_ptr<const std::string> state_, description_;
  std::uint64_t state_number_ = 0, session_number_ = 0, changes_ = 0;

  std::thread thread_, asking_;
};

}  // namespace cylon::view
