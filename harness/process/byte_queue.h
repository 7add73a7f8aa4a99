// Bytes in order of arrival: room at the back is not cleared before it is filled, which megabytes of states
// feel.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>

namespace cylon::process {

class ByteQueue {
 public:
  /// What has arrived and is not consumed.  Valid until the next room().
  std::string_view view() const { return {bytes_.get() + begin_, end_ - begin_}; }
  std::size_t size() const { return end_ - begin_; }
  void consume(std::size_t count) { begin_ += count; }
  void clear() { begin_ = end_ = 0; }

  /// Space for `count` bytes behind the last one; say with added() how many of them were filled.
  char* room(std::size_t count) {
    if (end_ + count > capacity_) {
      const std::size_t kept = size();
      if (kept + count > capacity_) {
        capacity_ = 2 * (kept + count);
        std::unique_ptr<char[]> larger(new char[capacity_]);  // not make_unique, which would clear it
        if (kept) std::memcpy(larger.get(), bytes_.get() + begin_, kept);
        bytes_ = std::move(larger);
      } else if (kept) {
        std::memmove(bytes_.get(), bytes_.get() + begin_, kept);
      }
      begin_ = 0, end_ = kept;
    }
    return bytes_.get() + end_;
  }
  void added(std::size_t count) { end_ += count; }

 private:
  std::unique_ptr<char[]> bytes_;
  std::size_t capacity_ = 0, begin_ = 0, end_ = 0;
};

}  // namespace cylon::process
