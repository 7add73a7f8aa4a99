#include "harness/process/message_reader.h"

#include "harness/process/failure.h"
#include "harness/process/json_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::process {
namespace {

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

bool MessageReader::complete_line(std::string_view output) {
  const std::size_t end = output.find('\n', searched_);
  searched_ = output.size();
  if (std::min(end, output.size()) > longest_line) broken("a line of more than 16 MiB");
  if (end == std::string_view::npos) return false;
  taken_ = end + 1;
  return true;
}

bool MessageReader::complete_frame(std::string_view output) {
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

std::optional<Message> MessageReader::read(std::string_view output) {
  const std::string_view start = output.substr(0, FrameHeader::magic.size());
  if (start.empty()) return std::nullopt;
  if (start.front() == '{') {
    if (!complete_line(output)) return std::nullopt;
    try {
      return Message(std::in_place_type<nlohmann::json>, parse_object(output.substr(0, taken_ - 1)));
    } catch (const MalformedMessage& error) {
      broken(fmt::format("{}: '{}'", error.what(), excerpt(output)));
    }
  }
  if (!FrameHeader::magic.starts_with(start))
    broken(fmt::format("neither a JSON line nor a frame: '{}'", excerpt(output)));
  if (!complete_frame(output)) return std::nullopt;
  return Frame{unpack_header(output.data()), output.substr(FrameHeader::size, taken_ - FrameHeader::size)};
}

std::size_t MessageReader::taken() {
  searched_ = 0;
  return std::exchange(taken_, 0);
}

}  // namespace cylon::process
