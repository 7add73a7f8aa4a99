#include "reports/verdict_matrix.h"

#include "harness/results/digits_text.h"
#include "harness/results/duration.h"
#include "harness/results/substeps.h"
#include "reports/sentence.h"
#include "reports/text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace cylon::reports {
namespace {

using results::Status;
using results::Verdict;

struct Meaning {
  Status status;
  std::string_view words;
};

// From best to worst.
constexpr std::array meanings = {
    Meaning{Status::pass, "within tolerance"},
    Meaning{Status::unsupported, "the engine refuses the scene"},
    Meaning{Status::undecided,
            "undecided: the tolerance lies within the uncertainty, or theory bounds nothing"},
    Meaning{Status::low_quality, "within ten times the tolerance"},
    Meaning{Status::fail, "more than ten times the tolerance"},
    Meaning{Status::non_finite, "NaN or infinite"},
    Meaning{Status::timeout, "time limit exceeded"},
    Meaning{Status::crash, "the worker died"},
    Meaning{Status::protocol, "the worker broke the protocol"},
};

std::size_t severity(Status status) {
  const auto is = [&](const Meaning& m) { return m.status == status; };
  return static_cast<std::size_t>(std::find_if(meanings.begin(), meanings.end(), is) - meanings.begin());
}

// Labels in order of first appearance; the second word only where a first word has several.
class Labels {
 public:
  void add(const std::string& first, const std::string& second) {
    if (seen_.emplace(first, second).second) order_.emplace_back(first, second), ++count_[first];
  }

  std::size_t size() const { return order_.size(); }

  template <class Words>
  std::vector<std::string> text(const Words& words_of_second) const {
    std::vector<std::string> labels;
    for (const auto& [first, second] : order_)
      labels.push_back(count_.at(first) > 1 ? fmt::format("{} {}", first, words_of_second(second)) : first);
    return labels;
  }

  std::vector<std::string> firsts() const {
    std::vector<std::string> labels;
    for (const auto& [first, second] : order_) labels.push_back(first);
    return labels;
  }

  std::map<std::pair<std::string, std::string>, std::size_t> index() const {
    std::map<std::pair<std::string, std::string>, std::size_t> index;
    for (std::size_t i = 0; i < order_.size(); ++i) index[order_[i]] = i;
    return index;
  }

 private:
  std::vector<std::pair<std::string, std::string>> order_;
  std::set<std::pair<std::string, std::string>> seen_;
  std::map<std::string, int> count_;
};

// A claim that an engine cannot answer, as it tells no contact forces, is no refusal where it answers others.
void join(Cell& cell, const Verdict& v) {
  const bool worse = v.status != Status::unsupported && severity(v.status) > severity(cell.worst);
  if (cell.empty || cell.worst == Status::unsupported || worse) cell.worst = v.status;
  if (is_measured(v.status)) cell.digits = std::min(cell.digits, results::digits(v.measured, v.allowed));
  cell.differs |= !v.as_expected();
  cell.closed_form |= v.closed_form;
  cell.substeps = std::max(cell.substeps, v.substeps);
  cell.empty = false;
}

bool is_refused(const Cell& cell) { return !cell.empty && cell.worst == Status::unsupported; }

// In order of first appearance.
std::vector<std::string> distinct(const std::vector<std::string>& texts) {
  std::vector<std::string> out;
  for (const std::string& text : texts)
    if (std::ranges::find(out, text) == out.end()) out.push_back(text);
  return out;
}

// Scenes that the engine was asked to run, and how many of them it ran at every step and with every integrator.
struct Scenes {
  std::size_t ran = 0, asked = 0;
};
Scenes scenes_of(const Matrix& matrix, const std::string& engine) {
  std::map<std::string, bool> ran;
  for (std::size_t i = 0; i < matrix.cells.size(); ++i)
    for (std::size_t j = 0; j < matrix.engine_of.size(); ++j)
      if (const Cell& cell = matrix.cells[i][j]; matrix.engine_of[j] == engine && !cell.empty)
        ran.try_emplace(matrix.scene_of[i], true).first->second &= !is_refused(cell);
  const auto all = std::ranges::count_if(ran, [](const auto& scene) { return scene.second; });
  return {static_cast<std::size_t>(all), ran.size()};
}

void mark_avoidable(std::vector<Cell>& row, const std::vector<std::string>& engines) {
  for (Cell& cell : row) {
    if (!is_refused(cell)) continue;
    for (std::size_t j = 0; j < row.size(); ++j)
      if (!row[j].empty && row[j].worst == Status::pass) cell.passed_by.push_back(engines[j]);
  }
}

std::vector<std::string> all_shown(const std::vector<std::string>& texts, const ConsoleOptions& options) {
  std::vector<std::string> out;
  for (const std::string& text : texts) out.push_back(shown(text, options));
  return out;
}

int widest(const std::vector<std::string>& texts) {
  int width = 0;
  for (const std::string& text : texts) width = std::max(width, display_width(text));
  return width;
}

void end_line(std::string& out) {
  out.erase(out.find_last_not_of(' ') + 1);
  out += '\n';
}

}  // namespace

Matrix fold(const std::vector<Verdict>& verdicts) {
  // An engine may choose its integrator by the scene; only one that ran a scene by several has several columns.
  // One that could not take a scene names no integrator: the row is its first one's.
  std::map<std::string, std::string> first;
  std::map<std::tuple<std::string, std::string, std::string>, std::string> one;
  std::set<std::string> several;
  for (const Verdict& v : verdicts) {
    if (v.integrator.empty()) continue;
    first.emplace(v.engine, v.integrator);
    if (one.emplace(std::tuple(v.engine, v.scenario, v.dt_text), v.integrator).first->second != v.integrator)
      several.insert(v.engine);
  }
  const auto integrator = [&](const Verdict& v) -> std::string {
    if (!several.contains(v.engine)) return "";
    return v.integrator.empty() ? first.at(v.engine) : v.integrator;
  };

  Labels scenarios, engines;
  for (const Verdict& v : verdicts) {
    scenarios.add(v.scenario, v.dt_text);
    engines.add(v.engine, integrator(v));
  }
  Matrix matrix{.scenarios = scenarios.text(results::step_in_words),
                .engines = engines.text([](const std::string& name) { return name; }),
                .cells = {},
                .scene_of = scenarios.firsts(),
                .engine_of = engines.firsts()};
  matrix.cells.assign(scenarios.size(), std::vector<Cell>(engines.size()));
  const auto row = scenarios.index(), column = engines.index();
  for (const Verdict& v : verdicts)
    join(matrix.cells[row.at({v.scenario, v.dt_text})][column.at({v.engine, integrator(v)})], v);
  for (auto& cells : matrix.cells) mark_avoidable(cells, matrix.engines);
  return matrix;
}

std::string cell_text(const Cell& cell, const ConsoleOptions& options) {
  if (cell.empty) return "";
  std::string text(glyph(cell.worst, options));
  if (is_measured(cell.worst)) text += " " + results::digits_text(cell.digits);
  if (cell.closed_form) text += " =";
  if (!cell.passed_by.empty()) text += " avoidable";
  return cell.differs ? text + " !" : text;
}

std::string draw(const Matrix& matrix, const ConsoleOptions& options) {
  constexpr int gap = 2;
  const int total = std::max(40, options.width);
  const std::string_view ellipsis = options.utf8 ? "…" : "..";
  const std::vector<std::string> rows = all_shown(matrix.scenarios, options);
  const std::vector<std::string> heads = all_shown(matrix.engines, options);

  // Widths: the labels at most two fifths of the line, an engine at most what is left.
  const int label = std::min(widest(rows), total * 2 / 5);
  std::vector<int> widths;
  for (std::size_t j = 0; j < heads.size(); ++j) {
    int width = display_width(heads[j]);
    for (const auto& row : matrix.cells) width = std::max(width, display_width(cell_text(row[j], options)));
    widths.push_back(std::min(width, total - label - gap));
  }

  std::string out;
  for (std::size_t begin = 0, end = 0; begin < heads.size(); begin = end) {
    int used = label;
    for (end = begin; end < heads.size() && (end == begin || used + gap + widths[end] <= total); ++end)
      used += gap + widths[end];

    if (begin > 0) out += '\n';
    out += fitted("", label, ellipsis);
    for (std::size_t j = begin; j < end; ++j)
      out += std::string(gap, ' ') + fitted(heads[j], widths[j], ellipsis);
    end_line(out);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      out += fitted(rows[i], label, ellipsis);
      for (std::size_t j = begin; j < end; ++j) {
        const Cell& cell = matrix.cells[i][j];
        const std::string content = fitted(cell_text(cell, options), widths[j], ellipsis);
        out += std::string(gap, ' ') + (cell.empty ? content : painted(content, cell.worst, options));
      }
      end_line(out);
    }
  }
  return out;
}

std::string refusals(const Matrix& matrix, const ConsoleOptions& options) {
  std::string avoidable;
  for (std::size_t j = 0; j < matrix.engines.size(); ++j)
    for (std::size_t i = 0; i < matrix.scenarios.size(); ++i)
      if (const Cell& cell = matrix.cells[i][j]; !cell.passed_by.empty())
        avoidable += shown(fmt::format("  {}: {}, which {} {}", matrix.engines[j], matrix.scenarios[i],
                                       fmt::join(cell.passed_by, ", "),
                                       cell.passed_by.size() == 1 ? "passes" : "pass"),
                           options) +
                     '\n';

  const std::size_t scenes = distinct(matrix.scene_of).size();
  const std::vector<std::string> engines = distinct(matrix.engine_of);
  if (engines.empty()) return "";
  std::string counts;
  bool all = engines.size() > 1;
  for (const std::string& engine : engines) {
    const auto [ran, asked] = scenes_of(matrix, engine);
    all &= ran == scenes;
    counts += fmt::format("{}{} {} of {}", counts.empty() ? "" : ", ", shown(engine, options), ran, asked);
  }
  std::string out =
      all ? fmt::format("scenes supported: all {} by each of {} engines\n", scenes, engines.size())
          : fmt::format("scenes supported: {}\n", counts);
  if (!avoidable.empty()) out += "refused, though another engine passes:\n" + avoidable;
  return out;
}

std::string legend(const Matrix& matrix, const ConsoleOptions& options) {
  std::set<Status> present;
  bool differs = false, measured = false, avoidable = false, closed_form = false;
  for (const auto& row : matrix.cells) {
    for (const Cell& cell : row) {
      if (cell.empty) continue;
      present.insert(cell.worst);
      differs |= cell.differs;
      measured |= is_measured(cell.worst);
      avoidable |= !cell.passed_by.empty();
      closed_form |= cell.closed_form;
    }
  }
  std::string out;
  int used = 0;  // columns of the last line
  const auto add = [&](std::string_view sign, std::string_view words) {
    const std::string entry = fmt::format("{} {}", sign, words);
    const bool fits = used + 2 + display_width(entry) <= std::max(40, options.width);
    out += (out.empty() ? "" : fits ? "; " : "\n") + entry;
    used = display_width(entry) + (fits ? used + 2 : 0);
  };
  for (const auto& [status, words] : meanings)
    if (const std::string sign(glyph(status, options)); present.count(status))
      add(sign + (sign.find(' ') == std::string::npos ? "" : ":"), words);
  if (avoidable) add("avoidable:", "refused, though another engine passes");
  if (measured)
    add("+1.0:", "log10(allowed / measured) of the worst claim: + is better than allowed, - is worse");
  if (closed_form) add("=:", "no steps: the engine has the motion in closed form");
  if (differs) add("!", "differs from expected.toml");
  for (std::size_t j = 0; j < matrix.engines.size(); ++j) {
    int most = 1;
    for (const auto& row : matrix.cells) most = std::max(most, row[j].substeps);
    if (most > 1)
      add(shown(matrix.engines[j], options) + ":", results::with_substeps("", most) + " in each step");
  }
  return out.empty() ? "" : out + "\n";
}

}  // namespace cylon::reports
