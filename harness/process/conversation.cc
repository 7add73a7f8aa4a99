#include "harness/process/conversation.h"

#include "harness/input/json.h"
#include "harness/process/messages.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace cylon::process {
namespace {

using nlohmann::json;

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

}  // namespace

Conversation::Conversation(const std::vector<std::string>& command, std::size_t memory_bytes)
    : filter_(sandboxing() ? std::make_unique<SandboxFilter>() : nullptr),
      child_(filter_ ? sandboxed(command, *filter_) : command, memory_bytes,
             filter_ ? filter_->inherited() : Inherited{}) {}

void Conversation::ask(const json& command, double seconds) {
  child_.set_deadline(seconds, command.at("cmd").get<std::string>());
  ask(command);
}

void Conversation::ask(const json& command) {
  child_.set_task(command.at("cmd").get<std::string>());
  child_.send(line(command));
}

Message Conversation::next() {
  child_.consume(reader_.taken());
  for (;;) {
    if (std::optional<Message> message = reader_.read(child_.output())) return std::move(*message);
    if (!child_.receive()) throw child_.ending();
  }
}

json Conversation::next_line() {
  Message message = next();
  if (json* value = std::get_if<json>(&message)) return std::move(*value);
  broken("a frame where a line was expected");
}

Frame Conversation::next_frame() {
  Message message = next();
  if (Frame* frame = std::get_if<Frame>(&message)) return *frame;
  broken(fmt::format("a line where a frame was expected: '{}'", input::shown(std::get<json>(message))));
}

std::string Conversation::finish(double seconds) {
  ask({{"cmd", "quit"}});
  return child_.finish(seconds);
}

}  // namespace cylon::process
