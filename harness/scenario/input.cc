#include "harness/scenario/input.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

namespace cylon::scenario {
namespace {

// Any finite number; nothing may follow it.
std::optional<double> real(std::string_view text) {
  double x = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(x)) return std::nullopt;
  return x;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  const auto refuse = [&](std::string_view why) {
    return core::InputError(fmt::format("{}: {}", path.string(), why));
  };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw refuse("no such file");
  if (std::filesystem::is_directory(status)) throw refuse("is a directory, not a file");
  if (!std::filesystem::is_regular_file(status)) throw refuse("is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw refuse(error.message());
  const auto too_large = [&](std::uintmax_t bytes) {
    return refuse(fmt::format("{} bytes, but at most {} (16 MB) are read", bytes, largest_input));
  };
  if (size > largest_input) throw too_large(size);
  // Files under /proc say that they are regular and empty; what they hold may be endless, or never come.
  const int fd = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) throw refuse("cannot be opened for reading");
  std::string text;
  std::array<char, 1 << 16> piece;
  ssize_t n = 0;
  while (text.size() <= largest_input) {
    n = ::read(fd, piece.data(), piece.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) break;
    text.append(piece.data(), static_cast<std::size_t>(n));
  }
  const int problem = errno;
  ::close(fd);
  if (n < 0) throw refuse(std::generic_category().message(problem));
  if (text.size() > largest_input) throw too_large(text.size());
  return text;
}

namespace {

// "; write 0.0005" of "0.5 ms", as steps are printed; "" of what has no unit.
std::string without_unit(std::string_view text) {
  constexpr std::pair<std::string_view, double> units[] = {
      {"ms", 1e-3}, {"us", 1e-6}, {"µs", 1e-6}, {"s", 1}};
  for (const auto& [unit, scale] : units) {
    if (!text.ends_with(unit)) continue;
    std::string_view number = text.substr(0, text.size() - unit.size());
    while (number.ends_with(' ')) number.remove_suffix(1);
    const std::size_t slash = number.find('/');
    if (scale == 1 && slash != std::string_view::npos && real(number.substr(0, slash)) &&
        real(number.substr(slash + 1)))
      return fmt::format("; write {}", number);
    const auto value = real(number);
    return value ? fmt::format("; write {:.15g}", *value * scale) : "";
  }
  return "";
}

}  // namespace

double parse_step(std::string_view text, std::string_view option) {
  const auto slash = text.find('/');
  const auto top = real(text.substr(0, slash));
  const auto bottom = slash == std::string_view::npos ? std::optional(1.0) : real(text.substr(slash + 1));
  const double step = top && bottom ? *top / *bottom : std::nan("");
  if (!(step > 0) || !std::isfinite(step))
    throw core::InputError(
        fmt::format("{}{}'{}' is no step; valid: a number > 0 of seconds, or a fraction like 1/60{}", option,
                    option.empty() ? "" : ": ", text, without_unit(text)));
  return step;
}

}  // namespace cylon::scenario
