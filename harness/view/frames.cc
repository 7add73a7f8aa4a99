#include "harness/view/frames.h"

#include "harness/core/input_error.h"
#include "harness/view/command.h"
#include "harness/view/whole_file.h"

#include <fmt/format.h>

#include <utility>

namespace cylon::view {

namespace {

constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::int64_t last_frame = 999'999;  // six digits

}  // namespace

Frames::Frames(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error || !std::filesystem::is_directory(folder_))
    throw core::InputError(
        fmt::format("--record {}: the folder cannot be made: {}", folder_.string(), error.message()));
}

void Frames::keep(std::int64_t n, std::string_view png) {
  if (n < 0 || n > last_frame)
    throw BadCommand(fmt::format("n = {}: must be a number in 0 … {}", n, last_frame));
  if (!png.starts_with(png_signature)) throw BadCommand("the picture is not a PNG file");
  const std::lock_guard lock(mutex_);
  const std::filesystem::path path = folder_ / fmt::format("frame-{:06}.png", n);
  try {
    write_whole_file(path, png);
  } catch (const core::InputError& error) {
    throw BadCommand(error.what());
  }
  ++count_;
}

std::int64_t Frames::count() const {
  const std::lock_guard lock(mutex_);
  return count_;
}

}  // namespace cylon::view
