#include "harness/process/conversation.h"

#include "harness/input/json.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::process {
namespace {

using nlohmann::json;

constexpr std::size_t longest_line = std::size_t{16} << 20;  // [bytes]

[[noreturn]] void broken(const std::string& reason) { throw Failure(results::Status::protocol, reason); }

// The start of what came, fit to be printed.
std::string excerpt(std::string_view bytes) {
  std::string text;
  for (const char c : bytes.substr(0, 40)) {
    if (c == '\n') break;
    text +=
        c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return text;
}

}  // namespace

Conversation::Conversation(const std::vector<std::string>& command, std::size_t memory_bytes)
    : filter_(sandboxing() ? std::make_unique<SandboxFilter>() : nullptr),
      child_(filter_ ? sandboxed(command, *filter_) : command, memory_bytes, filter_ ? filter_->fd() : -1) {}

void Conversation::ask(const json& command, double seconds) {
  child_.set_deadline(seconds, command.at("cmd").get<std::string>());
  ask(command);
}

void Conversation::ask(const json& command) {
  child_.set_task(command.at("cmd").get<std::string>());
  child_.send(line(command));
}

bool Conversation::complete_line(std::string_view output) {
  const std::size_t end = output.find('\n', searched_);
  searched_ = output.size();
  if (std::min(end, output.size()) > longest_line) broken("a line of more than 16 MiB");
  if (end == std::string_view::npos) return false;
  taken_ = end + 1;
  return true;
}

bool Conversation::complete_frame(std::string_view output) {
  if (output.size() < FrameHeader::size) return false;
  const FrameHeader header = unpack_header(output.data());
  if (!frames_expected_) broken("a frame before the scene was loaded");
  const std::uint64_t state = bodies_ * bytes_per_body;
  if (header.states == 0) broken("a frame without states");
  if (header.payload != header.states * state)
    broken(fmt::format("a frame of {} bytes for {} states of {} bodies, where {} are expected",
                       header.payload, header.states, bodies_, header.states * state));
  if (header.states > 1 && header.payload > frame_payload)
    broken(fmt::format("a frame of {} states and {} bytes; the limit is {}", header.states, header.payload,
                       frame_payload));
  if (output.size() < FrameHeader::size + header.payload) return false;
  taken_ = FrameHeader::size + header.payload;
  return true;
}

std::variant<json, Frame> Conversation::next() {
  child_.consume(std::exchange(taken_, 0));
  searched_ = 0;
  for (;;) {
    const std::string_view output = child_.output();
    const std::string_view start = output.substr(0, FrameHeader::magic.size());
    if (start.empty()) {
      // Nothing yet.
    } else if (start.front() == '{') {
      if (complete_line(output)) {
        try {
          return parse_object(output.substr(0, taken_ - 1));
        } catch (const MalformedMessage& error) {
          broken(fmt::format("{}: '{}'", error.what(), excerpt(output)));
        }
      }
    } else if (FrameHeader::magic.starts_with(start)) {
      if (complete_frame(output))
        return Frame{unpack_header(output.data()),
                     output.substr(FrameHeader::size, taken_ - FrameHeader::size)};
    } else {
      broken(fmt::format("neither a JSON line nor a frame: '{}'", excerpt(output)));
    }
    if (!child_.receive()) throw child_.ending();
  }
}

json Conversation::next_line() {
  std::variant<json, Frame> message = next();
  if (json* value = std::get_if<json>(&message)) return std::move(*value);
  broken("a frame where a line was expected");
}

Frame Conversation::next_frame() {
  std::variant<json, Frame> message = next();
  if (Frame* frame = std::get_if<Frame>(&message)) return *frame;
  broken(fmt::format("a line where a frame was expected: '{}'", input::shown(std::get<json>(message))));
}

std::string Conversation::finish(double seconds) {
  ask({{"cmd", "quit"}});
  return child_.finish(seconds);
}

}  // namespace cylon::process
