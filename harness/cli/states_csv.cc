#include "harness/cli/states_csv.h"

#include "harness/cli/read_whole.h"
#include "harness/core/input_error.h"
#include "reports/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace cylon::cli {
namespace {

constexpr std::size_t columns = 15, numbers = columns - 2;
constexpr std::size_t longest_shown = 80;  // of what is refused [characters]

class Reader {
 public:
  Reader(std::string_view text, const std::string& file, const core::Scene& scene)
      : file_(file), scene_(scene), rest_(text) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) index_.emplace(scene.bodies[i].name, i);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)  // as it is written, guarded against spreadsheets
      index_.emplace(reports::csv_field(scene.bodies[i].name), i);
  }

  core::Trajectory read() {
    if (!next() || line_ != states_header)
      fail(fmt::format("the first line must be '{}', as `cylon simulate` writes it", states_header));
    while (next()) row();
    close();
    if (motion_.time.empty()) fail("no states");
    return std::move(motion_);
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw core::InputError(file_, number_, 1, problem);
  }

  bool next() {
    ++number_;
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return true;
  }

  double number(std::string_view text, std::size_t column) const {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail(fmt::format("column {}: '{}' is not a number", column + 1, text.substr(0, longest_shown)));
    return value;
  }

  void row() {
    // A name may hold commas; numbers do not: the time is before the first, the rest after the last thirteen.
    const std::string_view text = line_;
    std::array<std::string_view, numbers> cells;
    std::size_t end = text.size();
    for (std::size_t i = numbers; i-- > 0;) {
      const std::size_t comma = end == 0 ? std::string_view::npos : text.rfind(',', end - 1);
      if (comma == std::string_view::npos) fail(fmt::format("{} columns are needed", columns));
      cells[i] = text.substr(comma + 1, end - comma - 1);
      end = comma;
    }
    const std::size_t first = text.find(',');
    if (first >= end) fail(fmt::format("{} columns are needed", columns));
    const double time = number(text.substr(0, first), 0);
    if (motion_.time.empty() || time != motion_.time.back()) open(time);
    std::array<double, numbers> x{};
    for (std::size_t i = 0; i < numbers; ++i) x[i] = number(cells[i], i + 2);
    const std::size_t body = index(text.substr(first + 1, end - first - 1));
    if (seen_[body]) fail(fmt::format("body '{}' is listed twice at {} s", scene_.bodies[body].name, time));
    seen_[body] = true;
    motion_.states.back()[body] = {{x[0], x[1], x[2]},
                                   core::Quaternion(x[3], x[4], x[5], x[6]),
                                   {x[7], x[8], x[9]},
                                   {x[10], x[11], x[12]}};
  }

  std::size_t index(std::string_view name) const {
    const auto at = index_.find(std::string(name));
    if (at == index_.end())
      fail(fmt::format("column 2: the scene has no body '{}'", name.substr(0, longest_shown)));
    return at->second;
  }

  void open(double time) {
    close();
    if (!motion_.time.empty() && !(time > motion_.time.back()))
      fail(fmt::format("time {} s does not follow {} s", time, motion_.time.back()));
    motion_.time.push_back(time);
    motion_.states.emplace_back(scene_.bodies.size());
    seen_.assign(scene_.bodies.size(), false);
  }

  void close() const {
    const auto missing = std::find(seen_.begin(), seen_.end(), false);
    if (missing != seen_.end())
      fail(fmt::format("before this line: body '{}' is missing at {} s",
                       scene_.bodies[static_cast<std::size_t>(missing - seen_.begin())].name,
                       motion_.time.back()));
  }

  std::string file_;
  const core::Scene& scene_;
  std::string_view rest_, line_;
  unsigned number_ = 0;
  core::Trajectory motion_;
  std::vector<bool> seen_;
  std::unordered_map<std::string, std::size_t> index_;
};

}  // namespace

core::Trajectory read_states(const std::string& file, const core::Scene& scene) {
  return parse_states(read_whole(file, largest_states), file, scene);
}

core::Trajectory parse_states(std::string_view text, const std::string& file, const core::Scene& scene) {
  return Reader(text, file, scene).read();
}

}  // namespace cylon::cli
