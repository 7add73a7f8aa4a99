#include "harness/scenario/input.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>

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
  if (size > largest_input)
    throw refuse(fmt::format("{} bytes, but at most {} (16 MB) are read", size, largest_input));
  std::ifstream in(path, std::ios::binary);
  if (!in) throw refuse("cannot be opened for reading");
  return {std::istreambuf_iterator<char>(in), {}};
}

double parse_step(std::string_view text) {
  const auto slash = text.find('/');
  const auto top = real(text.substr(0, slash));
  const auto bottom = slash == std::string_view::npos ? std::optional(1.0) : real(text.substr(slash + 1));
  const double step = top && bottom ? *top / *bottom : std::nan("");
  if (!(step > 0) || !std::isfinite(step))
    throw core::InputError(
        fmt::format("'{}' is no step; valid: a number > 0 of seconds, or a fraction like 1/60", text));
  return step;
}

}  // namespace cylon::scenario
