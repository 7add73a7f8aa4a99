// Binary frames: evenly spaced states as little-endian float64.  Knows no JSON and no pipes.
#pragma once

#include "harness/core/scene.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace cylon::process {

/// The 32 bytes before a payload, little-endian: magic "CYLF", u32 states, u64 first_step, u64 stride,
/// u64 payload bytes.  State i of the frame belongs to step first_step + i stride.
struct FrameHeader {
  static constexpr std::string_view magic = "CYLF";
  static constexpr std::size_t size = 32;

  std::uint32_t states = 0;
  std::uint64_t first_step = 0;
  std::uint64_t stride = 1;
  std::uint64_t payload = 0;  ///< states x bodies x 13 x 8 [bytes]
};

/// A frame's payload is at most this, or one state where a single one is larger [bytes].
inline constexpr std::size_t frame_payload = std::size_t{256} << 10;

/// One body: px py pz qw qx qy qz vx vy vz wx wy wz.
inline constexpr std::size_t doubles_per_body = 13;
inline constexpr std::size_t bytes_per_body = doubles_per_body * sizeof(double);

/// Requires FrameHeader::size bytes that start with the magic.
FrameHeader unpack_header(const char* bytes);

/// Reads one state of out.size() bodies.
void unpack_state(const char* bytes, core::State& out);

/// Collects states into frames: greedy, a frame ends where the spacing changes or it is full.
class FramePacker {
 public:
  explicit FramePacker(std::size_t bodies);

  /// Whether the state after `step` can join the frame under way; if not, take() first.
  bool fits(std::uint64_t step) const;
  void add(std::uint64_t step, const core::State&);
  bool empty() const { return header_.states == 0; }

  /// The finished frame, header included; valid until the next add().
  std::string_view take();

 private:
  std::size_t state_bytes_;
  FrameHeader header_;
  std::string buffer_;
};

}  // namespace cylon::process
