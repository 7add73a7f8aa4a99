#include "harness/scenario/suite.h"

#include "harness/scenario/reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::scenario {

Suite load_suite(const std::filesystem::path& path) { return parse_suite(read_file(path), path.string()); }

Suite parse_suite(std::string_view text, const std::string& file_name) {
  const Document document(text, file_name, suite_keys());
  const Table root = document.root();
  Suite suite{.name = std::filesystem::path(file_name).stem().string(),
              .title = root.text("title"),
              .story = root.text("story"),
              .claim = root.text("claim", "*"),
              .scenarios = root.texts("scenarios"),
              .engines = root.texts("engines"),
              .steps = root.texts("steps"),
              .published = {}};
  for (const char* key : {"scenarios", "engines"})
    if (root.texts(key).empty()) root.fail(key, fmt::format("{} must not be empty", key));
  for (const Table& t : root.tables("published")) {
    Published row{t.text("engine"), t.text("dt"), t.text("value"), t.text("source")};
    if (std::ranges::find(suite.engines, row.engine) == suite.engines.end())
      t.fail("engine", fmt::format("engine = '{}' is none of the suite's{}", row.engine,
                                   core::did_you_mean(row.engine, suite.engines)));
    const double dt = parse_step(row.dt);
    const auto step =
        std::ranges::find_if(suite.steps, [&](const std::string& s) { return parse_step(s) == dt; });
    if (step == suite.steps.end()) t.fail("dt", fmt::format("dt = {} is none of the suite's steps", row.dt));
    row.dt = *step;
    suite.published.push_back(std::move(row));
  }
  return suite;
}

}  // namespace cylon::scenario
