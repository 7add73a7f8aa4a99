#include "reports/console.h"

#include "harness/results/digits_text.h"
#include "harness/results/duration.h"
#include "harness/results/substeps.h"
#include "reports/sentence.h"
#include "reports/text.h"
#include "reports/verdict_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace cylon::reports {
namespace {

using results::Status;
using results::Verdict;

constexpr std::size_t last_words = 1000;  // bytes of an engine's stderr

// "heavy_top × bullet 3.24 (double), step 1/60 s, rk4"
std::string heading(const Verdict& v, const ConsoleOptions& options) {
  std::string text = fmt::format("{} {} {}", v.scenario, options.utf8 ? "×" : "x", v.engine);
  if (!v.version.empty()) text += fmt::format(" {}", v.version);
  if (!v.precision.empty()) text += fmt::format(" ({})", v.precision);
  if (!v.dt_text.empty())
    text += fmt::format(", step {}", results::with_substeps(results::step_in_words(v.dt_text), v.substeps));
  if (!v.integrator.empty()) text += fmt::format(", {}", v.integrator);
  return shown(text, options);
}

void add_line(std::string& out, std::string_view key, std::string_view value, const ConsoleOptions& options) {
  if (!value.empty()) out += fmt::format("  {}: {}\n", key, shown(value, options));
}

// The end of what an engine printed, a line each, none of which can leave its place.
std::string complaints(const Verdict& v, const ConsoleOptions& options) {
  if (v.complaints.empty()) return "";
  std::string out = "  stderr:\n";
  const std::string text = tail(v.complaints, last_words);
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    out += "    | " + shown(std::string_view(text).substr(begin, end - begin), options) + "\n";
    begin = end + 1;
  }
  return out;
}

// "name = value; …"
std::string list(const std::vector<std::pair<std::string, std::string>>& settings) {
  std::string out;
  for (const auto& [name, value] : settings)
    out += fmt::format("{}{} = {}", out.empty() ? "" : "; ", name, value);
  return out;
}

std::string run_facts(const Verdict& v, const ConsoleOptions& options) {
  std::string out;
  if (v.tolerance_scale != 1)
    out += fmt::format("  all tolerances are multiplied by {:g}\n", v.tolerance_scale);
  add_line(out, "path", v.path, options);
  add_line(out, "gyroscopic", v.gyroscopic, options);
  add_line(out, "settings", list(v.settings), options);
  for (const std::string& sentence : v.unforceable) add_line(out, "known limit", sentence, options);
  for (const told::Diagnostic& d : v.diagnostics) add_line(out, "diagnostic", in_words(d), options);
  add_line(out, "sampling", v.sampling, options);
  // Of what did not run there is none; an engine that tells no time has run all the same.
  if (v.body_steps > 0 && (v.cpu_seconds > 0 || is_measured(v.status)))
    out +=
        fmt::format("  cost: {:.3g} s of CPU, {} body steps, {:.0f} ns each{}\n", v.cpu_seconds, v.body_steps,
                    v.cpu_seconds / static_cast<double>(v.body_steps) * 1e9,
                    v.cpu_verified ? "" : "; not verified: the CPU time of the process does not confirm it");
  return out;
}

// Whether both are claims on a run that came to no measurement, in the same way: one line serves all of them.
bool same_end(const Verdict& a, const Verdict& b, const ConsoleOptions& options) {
  return !is_measured(a.status) && a.status == b.status && a.as_expected() == b.as_expected() &&
         expectation(a) == expectation(b) && sentence(a) == sentence(b) && a.reproduce == b.reproduce &&
         heading(a, options) == heading(b, options);
}

// The ends of groups of such verdicts; any other is a group by itself.
template <class Of>
std::vector<std::size_t> groups(std::size_t count, const ConsoleOptions& options, const Of& verdict) {
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < count; ++i)
    if (i + 1 == count || !same_end(verdict(i), verdict(i + 1), options)) ends.push_back(i + 1);
  return ends;
}

// The claims of a group by its first: "position follows … and 9 more claims".
std::string claims_text(const Verdict& first, std::size_t count, const ConsoleOptions& options) {
  const std::string claim = shown(first.claim, options);
  return count == 1 ? claim : fmt::format("{} and {} more claim{}", claim, count - 1, count == 2 ? "" : "s");
}

using Line = std::array<std::string, 6>;

Line claim_line(const Verdict& v, std::size_t count, const ConsoleOptions& options) {
  const bool measured = is_measured(v.status);
  std::string status(results::name(v.status));
  if (!v.as_expected()) status += fmt::format(" (expected {}) !", expectation(v));
  const std::string& why = v.detail.empty() ? v.tolerance_reason : v.detail;
  return {claims_text(v, count, options),
          measured ? shown(measured_text(v), options) : "",
          has_allowed(v) ? fmt::format("{:.4g} {}", v.allowed, shown(v.unit, options)) : "",
          measured ? results::digits_text(results::digits(v.measured, v.allowed)) : "",
          status,
          shown(head(why, 400), options)};
}

std::string claim_table(const std::vector<const Verdict*>& rows, const ConsoleOptions& options) {
  std::vector<Line> lines = {{"claim", "measured", "allowed", "digits", "status", "reason"}};
  std::vector<Status> statuses;
  std::size_t begin = 0;
  for (const std::size_t end :
       groups(rows.size(), options, [&](std::size_t i) -> const Verdict& { return *rows[i]; })) {
    lines.push_back(claim_line(*rows[begin], end - begin, options));
    statuses.push_back(rows[begin]->status);
    begin = end;
  }

  std::string out;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out += "  ";
    for (std::size_t column = 0; column + 1 < lines[i].size(); ++column) {
      int width = 0;
      for (const Line& line : lines) width = std::max(width, display_width(line[column]));
      const std::string field = fitted(lines[i][column], width, "");
      out += (column == 4 && i > 0 ? painted(field, statuses[i - 1], options) : field) + "  ";
    }
    out += lines[i].back() + "\n";
  }
  return out;
}

// "5 fail, 3 unsupported"
std::string counts(const std::map<Status, int>& by_status) {
  std::string out;
  for (const auto& [status, count] : by_status)
    out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, results::name(status));
  return out;
}

// "8 as expected (5 fail, 3 unsupported)"; the bracket only where there is something in it.
std::string group(const std::map<Status, int>& by_status, std::string_view words) {
  int total = 0;
  for (const auto& [status, count] : by_status) total += count;
  return fmt::format("{} {}{}", total, words, total == 0 ? "" : fmt::format(" ({})", counts(by_status)));
}

}  // namespace

std::string summary(const std::vector<Verdict>& verdicts) {
  int passed = 0, undecided = 0;
  std::map<Status, int> expected, differing;
  for (const Verdict& v : verdicts) {
    if (!v.as_expected())
      ++differing[v.status];
    else if (v.status == Status::undecided)
      ++undecided;
    else if (v.status == Status::pass)
      ++passed;
    else
      ++expected[v.status];
  }
  const bool one = differing.size() == 1 && differing.begin()->second == 1;
  return fmt::format("{} verdict{}: {} pass, {}, {}{}\n", verdicts.size(), verdicts.size() == 1 ? "" : "s",
                     passed, group(expected, "as expected"),
                     undecided > 0 ? fmt::format("{} undecided, ", undecided) : "",
                     group(differing, one ? "differs" : "differ"));
}

std::string unlisted(const std::vector<Verdict>& verdicts, const ConsoleOptions& options) {
  std::set<std::string> lines;
  for (const Verdict& v : verdicts) {
    if (v.version_listed) continue;
    const std::string who = shown(fmt::format("{} {}", v.engine, v.version), options);
    lines.insert(fmt::format("warning: expected.toml has no row for {}\n", who));
  }
  std::string out;
  for (const std::string& line : lines) out += line;
  return out;
}

namespace {

// That this is no plain run, once for each scale.
std::string rescaled(const std::vector<Verdict>& verdicts) {
  std::set<double> scales;
  for (const Verdict& v : verdicts) scales.insert(v.tolerance_scale);
  scales.erase(1);
  std::string out;
  for (const double scale : scales)
    out += fmt::format("warning: all tolerances are multiplied by {:g}\n", scale);
  return out;
}

// A verdict, or a group of them by its first.
std::string difference_of(const Verdict& v, std::size_t count, const ConsoleOptions& options) {
  std::string out = fmt::format("{}: {}\n", heading(v, options), claims_text(v, count, options));
  out += fmt::format("  {}\n", painted(shown(sentence(v), options), v.status, options));
  if (count == 1) add_line(out, "tolerance", v.tolerance_reason, options);
  out += complaints(v, options);
  add_line(out, "repeat with", v.reproduce, options);
  return out;
}

}  // namespace

std::string difference(const Verdict& v, const ConsoleOptions& options) {
  return difference_of(v, 1, options);
}

std::string console_details(const std::vector<Verdict>& verdicts, const ConsoleOptions& options) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<const Verdict*>> runs;
  for (const Verdict& v : verdicts) {
    auto& rows = runs[heading(v, options)];
    if (rows.empty()) order.push_back(heading(v, options));
    rows.push_back(&v);
  }
  std::string out;
  for (const std::string& run : order) {
    const auto& rows = runs[run];
    if (!out.empty()) out += '\n';
    out += run + "\n" + run_facts(*rows.front(), options) + claim_table(rows, options) +
           complaints(*rows.front(), options);
  }
  return out;
}

std::string console_matrix(const std::vector<Verdict>& verdicts, const ConsoleOptions& options) {
  const Matrix matrix = fold(verdicts);
  std::string out = draw(matrix, options);
  if (!out.empty()) out += '\n';
  out += legend(matrix, options);
  return out + (out.empty() ? "" : "\n") + console_summary(verdicts, options);
}

std::string console_summary(const std::vector<Verdict>& verdicts, const ConsoleOptions& options) {
  std::string out;
  const auto differs = [](const Verdict& v) { return !v.as_expected(); };
  if (std::any_of(verdicts.begin(), verdicts.end(), differs)) out += "Not as expected:\n";
  const auto unforeseen = [&](const Verdict& v) { return differs(v) && v.expected_reason.empty(); };
  if (std::any_of(verdicts.begin(), verdicts.end(), unforeseen))
    out += "(without a matching row in expected.toml, pass is expected)\n";
  std::size_t begin = 0;
  for (const std::size_t end :
       groups(verdicts.size(), options, [&](std::size_t i) -> const Verdict& { return verdicts[i]; })) {
    if (differs(verdicts[begin])) out += difference_of(verdicts[begin], end - begin, options);
    begin = end;
  }
  const auto open = [&](const Verdict& v) { return v.status == Status::undecided && !differs(v); };
  if (std::ranges::any_of(verdicts, open)) out += out.empty() ? "Undecided:\n" : "\nUndecided:\n";
  for (const Verdict& v : verdicts)
    if (open(v)) out += difference(v, options);

  const std::string warnings = rescaled(verdicts) + unlisted(verdicts, options);
  if (!out.empty()) out += '\n';
  return out + warnings + refusals(fold(verdicts), options) + summary(verdicts);
}

}  // namespace cylon::reports
