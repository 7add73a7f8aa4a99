// What a worker wrote, cut into messages.  Knows bytes alone and no process.
#pragma once

#include "harness/process/frame.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <string_view>
#include <variant>

namespace cylon::process {

struct Frame {
  FrameHeader header;
  std::string_view payload;  ///< Of the bytes that were read.
};

using Message = std::variant<nlohmann::json, Frame>;

class MessageReader {
 public:
  /// Frames are refused until the number of bodies is known.
  void expect_bodies(std::size_t bodies) { bodies_ = bodies, frames_expected_ = true; }

  /// The message that the output starts with, or nothing as long as it is not whole: then the same bytes and
  /// more are to be read.  Throws Failure(protocol) for anything that is neither a JSON object on a line of
  /// at most 16 MiB nor a frame whose sizes agree.
  std::optional<Message> read(std::string_view output);

  /// How many bytes the message took that read() gave, 0 where it gave none; they are to be left out of what
  /// is read next.
  std::size_t taken();

 private:
  bool complete_line(std::string_view output);
  bool complete_frame(std::string_view output);

  std::size_t bodies_ = 0, taken_ = 0, searched_ = 0;
  bool frames_expected_ = false;
};

}  // namespace cylon::process
