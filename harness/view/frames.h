// Pictures that the page sends while it is recorded: frame-000001.png and so on in a folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <string_view>

namespace cylon::view {

class Frames {
 public:
  /// Throws core::InputError where the folder cannot be made.
  explicit Frames(std::filesystem::path folder);

  /// Keeps frame n, 0 <= n <= 999999, in place of an earlier one of that number or of a link.  Throws BadCommand
  /// unless the bytes are a PNG's, or where it cannot be written.
  void keep(std::int64_t n, std::string_view png);

  std::int64_t count() const;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  std::int64_t count_ = 0;
};

}  // namespace cylon::view
