// A child that speaks the protocol: whole messages instead of bytes.  Garbage ends the conversation at once.
#pragma once

#include "harness/process/child.h"
#include "harness/process/message_reader.h"
#include "harness/process/sandbox.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace cylon::process {

class Conversation {
 public:
  /// In a sandbox where sandboxing() says so.
  Conversation(const std::vector<std::string>& command, std::size_t memory_bytes);

  /// Sends a command and sets the deadline for everything that follows it.
  void ask(const nlohmann::json& command, double seconds);
  /// The same under the deadline that is set.
  void ask(const nlohmann::json& command);

  /// Frames are refused until the number of bodies is known.
  void expect_bodies(std::size_t bodies) { reader_.expect_bodies(bodies); }

  /// The next message.  Throws Failure: protocol for anything that is neither a JSON object on a line of at
  /// most 16 MiB nor a frame whose sizes agree; crash, timeout, unsupported as the child does.
  Message next();
  /// The next message, which must be of that kind.
  nlohmann::json next_line();
  Frame next_frame();

  /// Says quit, waits for the exit that long; "" or the signal that it died of.
  std::string finish(double seconds);
  void kill() { child_.kill(); }
  std::size_t peak_bytes() const { return child_.peak_bytes(); }
  double cpu_seconds() const { return child_.cpu_seconds(); }
  double family_cpu_seconds() const { return child_.family_cpu_seconds(); }
  std::string complaints() const { return child_.complaints(); }

 private:
  std::unique_ptr<SandboxFilter> filter_;
  Child child_;
  MessageReader reader_;
};

}  // namespace cylon::process
