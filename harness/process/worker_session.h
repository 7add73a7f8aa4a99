// What a worker does with each command of the protocol.  Knows no file descriptor.
#pragma once

#include "harness/core/simulator.h"
#include "harness/process/messages.h"
#include "harness/process/pipes.h"
#include "harness/process/run_messages.h"

#include <nlohmann/json.hpp>

namespace cylon::process {

class WorkerSession {
 public:
  WorkerSession(core::Simulator& simulator, Pipes& pipes) : simulator_(simulator), pipes_(pipes) {}

  /// Answers one command; returns false after quit.  Throws MalformedMessage for what is no command, and
  /// Abandoned.
  bool obey(const nlohmann::json& request);

 private:
  void load(const nlohmann::json& request);
  nlohmann::json answer_to_load();
  void run(const Run&);

  core::Simulator& simulator_;
  Pipes& pipes_;
  core::Scene scene_;
  core::Setup setup_;
  core::State state_;
  double load_ns_ = 0;
  bool loaded_ = false;  // and not run yet
  bool going_ = false;   // ran, and can go on
};

}  // namespace cylon::process
