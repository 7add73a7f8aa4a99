#include "harness/tracking/store/model.h"

#include "harness/core/content_hash.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <tuple>

namespace cylon::store {
namespace {

constexpr std::array<std::string_view, 5> kinds = {"exact", "error", "time", "size", "info"};
constexpr std::size_t detail_bytes = 1000;

// Each text with its length, so that "a", "bc" and "ab", "c" are two.
void add(std::string& content, std::initializer_list<std::string_view> texts) {
  for (const std::string_view text : texts)
    fmt::format_to(std::back_inserter(content), "{}:{}", text.size(), text);
}

void add(std::string& content, double value) {
  fmt::format_to(std::back_inserter(content), "{:.17g};", value);
}

std::string hash_of(std::string_view content) {
  core::ContentHash hash;
  hash.add(content);
  return hash.hex();
}

double storable(double value) {
  if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
  return value == 0 ? 0 : value;
}

auto key(const Sample& s) { return std::tie(s.metric.name, s.metric.kind, s.metric.unit, s.repetition); }
auto key(const Judgement& j) { return std::tie(j.claim, j.observable, j.unit); }

void clean_all(std::initializer_list<std::string*> texts) {
  for (std::string* text : texts) *text = clean(*text);
}

}  // namespace

std::string_view name(Kind kind) { return kinds[static_cast<std::size_t>(kind)]; }

std::optional<Kind> kind_from(std::string_view word) {
  const auto* const row = std::find(kinds.begin(), kinds.end(), word);
  return row == kinds.end() ? std::nullopt : std::optional(static_cast<Kind>(row - kinds.begin()));
}

std::string Cell::name() const {
  return fmt::format("{}/{}{}{}", scenario, engine, dt_text.empty() ? "" : "@", dt_text);
}

std::string cell_hash(const Cell& c) {
  std::string content;
  add(content, {c.scenario, c.scenario_hash, c.engine, c.path, c.integrator, c.precision, c.settings});
  add(content, c.dt);
  return hash_of(content);
}

std::string run_uid(const RunInfo& r, std::int64_t ordinal) {
  std::string content;
  add(content, {r.label, r.revision, r.date, r.machine, r.os, r.compiler, r.flags, r.build, r.command_line,
                r.request, r.note});
  content += fmt::format("{}", ordinal);
  return hash_of(content);
}

std::string series_id(const Cell& cell, const Metric& metric) { return cell.hash + "/" + metric.name; }

std::string content_of(const Result& given) {
  const Result r = canonical(given);
  std::string content;
  add(content, {r.cell.hash, r.engine_version, r.asked});
  for (const Sample& s : r.samples) {
    add(content, {s.metric.name, name(s.metric.kind), s.metric.unit, s.text});
    content += fmt::format("{};", s.repetition);
    add(content, s.value);
  }
  for (const Judgement& j : r.judgements) {
    add(content, {j.claim, j.observable, j.unit, j.status, j.expected, j.detail});
    for (const double value : {j.measured, j.allowed, j.truth_error}) add(content, value);
  }
  return content;
}

std::string content_of(const RunInfo& r) {
  std::string content;
  add(content, {r.uid, r.label, r.revision, r.date, r.machine, r.os, r.compiler, r.flags, r.build,
                r.command_line, r.request, r.note});
  content += fmt::format("{};", r.revision_order.value_or(0));
  return content;
}

std::string content_of(const Anchor& a) {
  std::string content;
  add(content, {a.name, a.binary, a.build, a.date, a.note, a.run});
  return content;
}

std::string content_of(const ChangePoint& p) {
  std::string content;
  add(content, {p.series, p.revision, p.state, p.date, p.note});
  return content;
}

std::string digest(const Result& r) { return hash_of(content_of(r)); }
std::string digest(const RunInfo& r) { return hash_of(content_of(r)); }
std::string digest(const Anchor& a) { return hash_of(content_of(a)); }
std::string digest(const ChangePoint& p) { return hash_of(content_of(p)); }

std::string twice(const Result& given) {
  const Result r = canonical(given);
  const auto same = [](const auto& a, const auto& b) { return key(a) == key(b); };
  const auto s = std::adjacent_find(r.samples.begin(), r.samples.end(), same);
  if (s != r.samples.end()) return fmt::format("metric {}, repetition {}", s->metric.name, s->repetition);
  const auto j = std::adjacent_find(r.judgements.begin(), r.judgements.end(), same);
  return j == r.judgements.end() ? "" : fmt::format("claim {}", j->claim);
}

Result canonical(Result r) {
  Cell& c = r.cell;
  clean_all({&c.scenario, &c.scenario_hash, &c.engine, &c.path, &c.integrator, &c.precision, &c.settings,
             &c.dt_text, &r.engine_version, &r.asked});
  c.dt = storable(c.dt);
  c.hash = cell_hash(c);
  for (Sample& s : r.samples) {
    clean_all({&s.metric.name, &s.metric.unit, &s.text});
    s.value = storable(s.value);
  }
  for (Judgement& j : r.judgements) {
    clean_all({&j.claim, &j.observable, &j.unit, &j.status, &j.expected, &j.detail});
    for (double* value : {&j.measured, &j.allowed, &j.truth_error}) *value = storable(*value);
    if (j.detail.size() > detail_bytes + 40) j.detail = reports::head(j.detail, detail_bytes);
  }
  const auto by_key = [](const auto& a, const auto& b) { return key(a) < key(b); };
  std::stable_sort(r.samples.begin(), r.samples.end(), by_key);
  std::stable_sort(r.judgements.begin(), r.judgements.end(), by_key);
  return r;
}

std::string clean(std::string_view text) { return reports::escaped(text, reports::is_printable); }

}  // namespace cylon::store
