#include "harness/cli/commands/limits_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace cylon::cli {
namespace {

using Kind = study::Limit::Kind;

std::string word(Kind kind) {
  return kind == Kind::found ? "limit" : kind == Kind::none ? "none" : "nowhere";
}

// "2.0001", "no limit up to 100", "no limit down to 1e-09", "fails at 0.01".
std::string limit_text(const LimitRow& row) {
  if (!row.unsupported.empty()) return "unsupported";
  const bool falls = row.limit.kind != Kind::found;
  if (!falls) return fmt::format("{:.4g}", row.value);
  if (row.limit.kind == Kind::nowhere) return fmt::format("fails at {:.4g}", row.limit.breaks);
  return fmt::format("no limit {} to {:.4g}", row.downward ? "down" : "up", row.limit.holds);
}

std::string theory_text(const LimitRow& row) {
  if (!row.theory) return "";
  if (*row.theory == 0) return "never holds";
  if (std::isinf(*row.theory)) return "no limit";
  return fmt::format("{:.4f}", *row.theory);
}

std::string remark(const LimitRow& row) {
  if (!row.unsupported.empty()) return row.unsupported;
  std::string text = row.limit.what;
  if (!row.limit.holds_again.empty())
    text += fmt::format("{}not the only limit: works again at {:.4g}", text.empty() ? "" : "; ",
                        fmt::join(row.limit.holds_again, ", "));
  return text;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string number(double x) { return fmt::format("{:.17g}", x); }

}  // namespace

std::optional<double> LimitRow::ratio() const {
  if (!unsupported.empty() || limit.kind != Kind::found || !theory || !(*theory > 0) || std::isinf(*theory))
    return std::nullopt;
  return value / *theory;
}

std::string limits_text(const std::vector<LimitRow>& rows, int) {
  std::size_t wide = 6, integrator = 10;
  for (const LimitRow& row : rows) {
    wide = std::max(wide, row.engine.size());
    integrator = std::max(integrator, row.integrator.size());
  }
  std::string out, family;
  for (const LimitRow& row : rows) {
    if (row.family != family) {
      family = row.family;
      out += fmt::format("{}{}: {}{}; breaks: {}\n", out.empty() ? "" : "\n", row.family, row.asks,
                         row.unit.empty() ? "" : fmt::format(" [{}]", row.unit), row.breaks);
      out += fmt::format("  {:<{}}  {:<{}}  {:<18} {:<24} {:<12} {:<7} {}\n", "engine", wide, "integrator",
                         integrator, "limit", "holds … breaks", "theory", "ratio", "what broke");
    }
    const bool bracket = row.unsupported.empty() && row.limit.kind == Kind::found;
    const auto ratio = row.ratio();
    // The ellipsis is one column and three bytes: fmt counts columns.
    out += fmt::format("  {:<{}}  {:<{}}  {:<18} {:<24} {:<12} {:<7} {}\n", row.engine, wide, row.integrator,
                       integrator, limit_text(row),
                       bracket ? fmt::format("{:.5g} … {:.5g}", row.limit.holds, row.limit.breaks) : "",
                       theory_text(row), ratio ? fmt::format("{:.4f}", *ratio) : "", remark(row));
  }
  return out;
}

std::string limits_json(const std::vector<LimitRow>& rows) {
  using nlohmann::ordered_json;
  ordered_json list = ordered_json::array();
  const auto maybe = [](const std::optional<double>& x) {
    return x && std::isfinite(*x) ? ordered_json(*x) : ordered_json(nullptr);
  };
  for (const LimitRow& row : rows) {
    const bool asked = row.unsupported.empty();
    const bool held = asked && row.limit.kind != Kind::nowhere, broke = asked && row.limit.kind != Kind::none;
    list.push_back(
        {{"family", row.family},
         {"asks", row.asks},
         {"unit", row.unit},
         {"breaks_when", row.breaks},
         {"engine", row.engine},
         {"scheme", row.integrator},
         {"kind", asked ? word(row.limit.kind) : "unsupported"},
         {"limit", asked && row.limit.kind == Kind::found ? ordered_json(row.value) : ordered_json()},
         {"holds", held ? ordered_json(row.limit.holds) : ordered_json()},
         {"breaks", broke ? ordered_json(row.limit.breaks) : ordered_json()},
         {"what_broke", row.limit.what},
         {"holds_again", row.limit.holds_again},
         {"theory", maybe(row.theory)},
         {"theory_text", theory_text(row)},
         {"ratio", maybe(row.ratio())},
         {"runs", row.limit.runs},
         {"reason", row.unsupported}});
  }
  return ordered_json{{"schema", 1}, {"limits", list}}.dump(1, ' ', true,
                                                            nlohmann::json::error_handler_t::replace) +
         "\n";
}

std::string limits_csv(const std::vector<LimitRow>& rows) {
  std::string out = "family,engine,scheme,unit,kind,limit,holds,breaks,theory,ratio,runs,what\n";
  for (const LimitRow& row : rows) {
    const bool asked = row.unsupported.empty();
    const Kind kind = row.limit.kind;
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}\n", quoted(row.family), quoted(row.engine),
                       quoted(row.integrator), quoted(row.unit), asked ? word(kind) : "unsupported",
                       asked && kind == Kind::found ? number(row.value) : "",
                       asked && kind != Kind::nowhere ? number(row.limit.holds) : "",
                       asked && kind != Kind::none ? number(row.limit.breaks) : "",
                       row.theory ? number(*row.theory) : "", row.ratio() ? number(*row.ratio()) : "",
                       row.limit.runs, quoted(remark(row)));
  }
  return out;
}

}  // namespace cylon::cli
