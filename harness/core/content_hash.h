// FNV-1a, 64 bits: the hash by which content is known again.  Not for secrets.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace cylon::core {

/// Of all bytes added, in order (http://www.isthe.com/chongo/tech/comp/fnv/).
class ContentHash {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) value_ = (value_ ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  }

  std::uint64_t value() const { return value_; }

  /// 16 hex digits.
  std::string hex() const { return fmt::format("{:016x}", value_); }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace cylon::core
