#include "harness/scenario/expected.h"

#include "harness/core/content_hash.h"
#include "harness/scenario/glob.h"
#include "harness/scenario/reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::scenario {
namespace {

bool same_step(double a, double b) { return std::abs(a - b) <= 1e-12 * std::abs(b); }

}  // namespace

Expectations Expectations::load(const std::filesystem::path& path) {
  return parse(read_file(path), path.string());
}

Expectations Expectations::parse(std::string_view text, const std::string& file_name) {
  const Document document(text, file_name, expected_keys());
  const Table root = document.root();
  Expectations result;
  core::ContentHash content;
  content.add(text);
  result.hash_ = content.hex();
  if (const auto versions = root.table("versions"))
    for (auto&& [engine, list] : versions->raw()) {
      auto& known = result.versions_[std::string(engine.str())];
      const toml::array* values = list.as_array();
      if (!values)
        versions->fail(engine.str(),
                       fmt::format("versions of '{}' must be an array of strings", engine.str()));
      for (const toml::node& value : *values) {
        if (!value.is_string())
          versions->fail(engine.str(),
                         fmt::format("versions of '{}' must be an array of strings", engine.str()));
        known.push_back(value.as_string()->get());
      }
    }
  for (const Table& t : root.tables("row")) {
    Row row{.engine = t.text("engine"),
            .scenario = t.text("scenario", "*"),
            .claim = t.text("claim", "*"),
            .integrator = t.text("integrator", "*"),
            .steps = {},
            .expected = {*results::status_from(t.text("status")), t.text("reason"), t.text("link"),
                         fmt::format("{}:{}", file_name, t.raw().source().begin.line)}};
    for (const std::string& step : t.texts("dt")) row.steps.push_back(parse_step(step));
    result.rows_.push_back(std::move(row));
  }
  return result;
}

Expected Expectations::find(std::string_view scenario, std::string_view engine, std::string_view integrator,
                            double dt, std::string_view claim) const {
  const auto matches = [&](const Row& row) {
    return any_glob_match(row.engine, engine) && any_glob_match(row.scenario, scenario) &&
           any_glob_match(row.claim, claim) && any_glob_match(row.integrator, integrator) &&
           (row.steps.empty() ||
            std::ranges::any_of(row.steps, [&](double step) { return same_step(step, dt); }));
  };
  const auto row = std::find_if(rows_.rbegin(), rows_.rend(), matches);
  return row == rows_.rend() ? Expected{} : row->expected;
}

bool Expectations::version_listed(std::string_view engine, std::string_view version) const {
  const std::string_view id = engine.substr(0, engine.find('/'));
  return std::ranges::any_of(versions_, [&](const auto& entry) {
    return glob_match(entry.first, id) && std::ranges::any_of(entry.second, [&](const std::string& known) {
             return glob_match(known, version);
           });
  });
}

std::vector<std::string> Expectations::unused(const std::set<std::string>& decided) const {
  std::vector<std::string> result;
  for (const Row& row : rows_)
    if (!decided.contains(row.expected.place))
      result.push_back(fmt::format("{}: engine '{}', scenario '{}', claim '{}'", row.expected.place,
                                   row.engine, row.scenario, row.claim));
  return result;
}

}  // namespace cylon::scenario
