#include "harness/process/frame.h"

#include <bit>
#include <cassert>

namespace cylon::process {

static_assert(std::endian::native == std::endian::little, "frames are copied, not converted");

namespace {

template <class T>
T load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <class T>
void store(char* bytes, T value) {
  std::memcpy(bytes, &value, sizeof value);
}

}  // namespace

FrameHeader unpack_header(const char* bytes) {
  return {load<std::uint32_t>(bytes + 4), load<std::uint64_t>(bytes + 8), load<std::uint64_t>(bytes + 16),
          load<std::uint64_t>(bytes + 24)};
}

void unpack_state(const char* bytes, core::State& out) {
  for (core::BodyState& body : out) {
    double d[doubles_per_body];
    std::memcpy(d, bytes, sizeof d);
    bytes += sizeof d;
    body.position = {d[0], d[1], d[2]};
    body.orientation = {d[3], d[4], d[5], d[6]};  // w, x, y, z
    body.velocity = {d[7], d[8], d[9]};
    body.angular_velocity = {d[10], d[11], d[12]};
  }
}

FramePacker::FramePacker(std::size_t bodies) : state_bytes_(bodies * bytes_per_body) {}

bool FramePacker::fits(std::uint64_t step) const {
  if (header_.states == 0) return true;
  if (state_bytes_ * (header_.states + 1) > frame_payload) return false;
  return header_.states == 1 || step == header_.first_step + header_.states * header_.stride;
}

void FramePacker::add(std::uint64_t step, const core::State& state) {
  assert(fits(step) && state.size() * bytes_per_body == state_bytes_);
  if (header_.states == 0) {
    header_ = {0, step, 1, 0};
    buffer_.resize(FrameHeader::size);
  } else if (header_.states == 1) {
    header_.stride = step - header_.first_step;
  }
  ++header_.states;
  std::size_t at = buffer_.size();
  buffer_.resize(at + state_bytes_);
  for (const core::BodyState& body : state) {
    const core::Vector3 &p = body.position, &v = body.velocity, &w = body.angular_velocity;
    const core::Quaternion& q = body.orientation;
    const double d[doubles_per_body] = {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z(),
                                        v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
    std::memcpy(buffer_.data() + at, d, sizeof d);
    at += sizeof d;
  }
}

std::string_view FramePacker::take() {
  header_.payload = buffer_.size() - FrameHeader::size;
  char* bytes = buffer_.data();
  std::memcpy(bytes, FrameHeader::magic.data(), 4);
  store(bytes + 4, header_.states);
  store(bytes + 8, header_.first_step);
  store(bytes + 16, header_.stride);
  store(bytes + 24, header_.payload);
  header_.states = 0;
  return buffer_;
}

}  // namespace cylon::process
