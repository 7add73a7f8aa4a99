// One engine on one scene in a worker process, advanced piece by piece for as long as somebody looks on.
#pragma once

#include "harness/core/engine.h"
#include "harness/process/client.h"
#include "harness/process/conversation.h"
#include "harness/process/joint_hold.h"
#include "harness/process/messages.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace cylon::process {

/// What a piece of a run brought.
struct Piece {
  core::State state;                    ///< At its end.
  std::vector<core::Contact> contacts;  ///< Of its last step.
  double cpu_seconds = 0;               ///< Thread CPU time of its steps; of a load where it needed one, too.
};

/// A worker and what it runs.  Belongs to the thread that made it; the worker dies with it.  Every call
/// throws Failure where the engine fails (its status says how: crash, timeout, protocol, unsupported, fail,
/// non-finite), after which the object serves no more, and Interrupted.
///
/// A worker that is live (docs/protocol.md) goes on from where it is, with its caches warm.  Any other loads
/// the scene anew, from the present state, for each piece; scenes that can only start at t = 0 are
/// unsupported there.
class LiveRun {
 public:
  explicit LiveRun(EngineChoice, Limits = {});

  const core::Engine& engine() const { return hello_.engine; }
  const core::Terms& terms() const { return terms_; }
  bool live() const { return hello_.live; }

  /// Starts the scene over; any number of times, with any scene and setup.  Throws core::InputError for a
  /// setup that the engine calls impossible, after which another load may follow.
  void load(const core::Scene&, const core::Setup&);

  /// Advances by n steps, n >= 1.  Requires load().  A state that is not finite is a Failure.
  Piece advance(std::int64_t n);

  /// The end of what the worker wrote to stderr.
  std::string complaints() const { return worker_.complaints(); }

 private:
  void open(const core::Scene&);
  Piece run(std::int64_t n, bool resume);

  EngineChoice choice_;
  Limits limits_;
  Conversation worker_;
  Hello hello_;
  core::Terms terms_;
  core::Scene scene_;
  std::vector<core::HeldJoint> joints_;
  core::Setup setup_;
  core::State state_;
  std::int64_t steps_ = 0;  // since load()
};

}  // namespace cylon::process
