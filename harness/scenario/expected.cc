#include "harness/scenario/expected.h"

#include "harness/core/content_hash.h"
#include "harness/scenario/glob.h"
#include "harness/scenario/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::scenario {
namespace {

bool same_step(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

std::string place_of(const Table& t) { return fmt::format("{}:{}", t.file(), t.raw().source().begin.line); }

bool explains(const Symptoms& symptoms, std::string_view scenario, std::string_view engine,
              std::string_view claim) {
  return any_glob_match(symptoms.engine, engine) && any_glob_match(symptoms.scenario, scenario) &&
         any_glob_match(symptoms.claim, claim);
}

bool explains(const Cause& cause, std::string_view scenario, std::string_view engine,
              std::string_view claim) {
  return std::ranges::any_of(cause.explains,
                             [&](const Symptoms& s) { return explains(s, scenario, engine, claim); });
}

Counterfactual counterfactual(const Table& t) {
  Counterfactual c{.scenario = t.text("scenario"),
                   .claim = t.text("claim"),
                   .engine = t.text("engine"),
                   .dt = t.text("dt"),
                   .other_scenario = t.text("other_scenario"),
                   .other_claim = t.text("other_claim"),
                   .other_engine = t.text("other_engine"),
                   .other_dt = t.text("other_dt"),
                   .becomes = {},
                   .place = place_of(t)};
  if (c.other_scenario.empty() && c.other_engine.empty() && c.other_dt.empty())
    t.fail("one of 'other_scenario', 'other_engine' and 'other_dt' is needed: what is changed");
  for (auto [other, own] : {std::pair{&c.other_scenario, &c.scenario},
                            {&c.other_claim, &c.claim},
                            {&c.other_engine, &c.engine},
                            {&c.other_dt, &c.dt}})
    if (other->empty()) *other = *own;
  const bool ratio = t.has("at_least") || t.has("at_most");
  if (t.has("becomes") == ratio)
    t.fail("either 'becomes', or 'at_least' and 'at_most', must say what comes of the change");
  if (!ratio) c.becomes = results::status_from(t.text("becomes"));
  c.low = t.number("at_least", 0);
  c.high = t.number("at_most", std::numeric_limits<double>::infinity());
  if (!(c.low < c.high)) t.fail("at_least", "'at_least' must be less than 'at_most'");
  return c;
}

Cause cause(const Table& t) {
  Cause result{.name = t.text("name"),
               .mechanism = t.text("mechanism"),
               .law = t.text("law"),
               .source = t.texts("source"),
               .power = {},
               .within = t.number("within", 3),
               .explains = {},
               .counterfactuals = {}};
  if (t.has("power")) result.power = t.number("power");
  for (const Table& s : t.tables("explains"))
    result.explains.push_back({s.text("engine"), s.text("scenario"), s.text("claim", "*")});
  for (const Table& c : t.tables("counterfactual")) result.counterfactuals.push_back(counterfactual(c));
  if (result.source.empty()) t.fail("'source' must name a place");
  if (result.explains.empty()) t.fail("[[cause.explains]] is missing: the cause explains nothing");
  if (result.counterfactuals.empty()) t.fail("[[cause.counterfactual]] is missing: the cause was not tested");
  return result;
}

std::map<std::string, std::vector<std::string>> versions_in(const Table& root) {
  std::map<std::string, std::vector<std::string>> result;
  const auto versions = root.table("versions");
  if (!versions) return result;
  for (auto&& [engine, list] : versions->raw()) {
    auto& known = result[std::string(engine.str())];
    const toml::array* values = list.as_array();
    if (!values || !std::ranges::all_of(*values, [](const toml::node& v) { return v.is_string(); }))
      versions->fail(engine.str(), fmt::format("versions of '{}' must be an array of strings", engine.str()));
    for (const toml::node& value : *values) known.push_back(value.as_string()->get());
  }
  return result;
}

}  // namespace

std::string refutation(const Counterfactual& c, const results::Verdict& first,
                       const results::Verdict& other) {
  if (first.status == results::Status::pass)
    return fmt::format("no symptom: {:.4g} of {:.4g} allowed", first.measured, first.allowed);
  if (c.becomes)
    return other.status == *c.becomes ? ""
                                      : fmt::format("becomes {} ({:.4g} of {:.4g} allowed) and not {}; {}",
                                                    results::name(other.status), other.measured,
                                                    other.allowed, results::name(*c.becomes), other.detail);
  const double ratio = other.measured / first.measured;
  if (c.low <= ratio && ratio <= c.high) return "";  // false for NaN
  return fmt::format("{:.4g} becomes {:.4g}, {:.4g} times as much, and not {:g} to {:g} times; {}",
                     first.measured, other.measured, ratio, c.low, c.high, other.detail);
}

Expectations Expectations::load(const std::filesystem::path& path) {
  const std::filesystem::path rows = path.parent_path() / "data" / "expected_rows.toml";
  return parse(read_file(path), path.string(), std::filesystem::exists(rows) ? read_file(rows) : "",
               rows.string());
}

Expectations Expectations::parse(std::string_view causes, const std::string& causes_name,
                                 std::string_view rows, const std::string& rows_name) {
  Expectations result;
  core::ContentHash content;
  content.add(causes);
  content.add(rows);
  result.hash_ = content.hex();

  const Document document(causes, causes_name, expected_keys());
  result.versions_ = versions_in(document.root());
  for (const Table& t : document.root().tables("cause")) {
    if (std::ranges::any_of(result.causes_, [&](const Cause& c) { return c.name == t.text("name"); }))
      t.fail("name", fmt::format("a second cause '{}'", t.text("name")));
    result.causes_.push_back(cause(t));
  }
  if (rows.empty()) return result;

  const Document measured(rows, rows_name, expected_row_keys());
  for (const Table& t : measured.root().tables("row")) {
    Row row{.scenario = t.text("scenario"),
            .engine = t.text("engine"),
            .claim = t.text("claim"),
            .dt = parse_step(t.text("dt")),
            .cause = t.text("cause"),
            .status = *results::status_from(t.text("status")),
            .size = {}};
    if (t.has("measured")) row.size = t.number("measured");
    const Cause* first = result.explain(row.scenario, row.engine, row.claim);
    if (!first || first->name != row.cause)
      t.fail("cause", fmt::format("'{}' of {} on {} is explained by {}, not by '{}'; {}", row.claim,
                                  row.scenario, row.engine, first ? "'" + first->name + "'" : "no cause",
                                  row.cause, "docs/expected.py writes these rows"));
    result.rows_of_[{row.scenario, row.engine, row.claim}].push_back(result.rows_.size());
    result.rows_.push_back(std::move(row));
  }
  return result;
}

const Cause* Expectations::explain(std::string_view scenario, std::string_view engine,
                                   std::string_view claim) const {
  const auto found =
      std::ranges::find_if(causes_, [&](const Cause& c) { return explains(c, scenario, engine, claim); });
  return found == causes_.end() ? nullptr : &*found;
}

Expected Expectations::find(std::string_view scenario, std::string_view engine, double dt,
                            std::string_view claim) const {
  const auto cell = rows_of_.find({std::string(scenario), std::string(engine), std::string(claim)});
  if (cell == rows_of_.end()) return {};
  for (const std::size_t i : cell->second) {
    const Row& row = rows_[i];
    if (!same_step(row.dt, dt)) continue;
    const Cause& why = *explain(scenario, engine, claim);
    return {.status = row.status,
            .size = row.size,
            .within = why.within,
            .reason = fmt::format("{}: {}", why.name, why.mechanism)};
  }
  return {};
}

bool Expectations::version_listed(std::string_view engine, std::string_view version) const {
  const std::string_view id = engine.substr(0, engine.find('/'));
  return std::ranges::any_of(versions_, [&](const auto& entry) {
    return glob_match(entry.first, id) && std::ranges::any_of(entry.second, [&](const std::string& known) {
             return glob_match(known, version);
           });
  });
}

std::vector<std::string> Expectations::unused() const {
  std::vector<std::string> result;
  for (const Cause& cause : causes_)
    for (const Symptoms& s : cause.explains)
      if (std::ranges::none_of(rows_, [&](const Row& row) {
            return row.cause == cause.name && explains(s, row.scenario, row.engine, row.claim);
          }))
        result.push_back(fmt::format("{}: engine '{}', scenario '{}', claim '{}'", cause.name, s.engine,
                                     s.scenario, s.claim));
  return result;
}

}  // namespace cylon::scenario
