// docs/in-house.md lists every kind of diagnostic, as the table of the engine has them.
#include "engine/diagnostic.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace cylon::engine {
namespace {

std::string or_none(std::string_view unit) { return unit.empty() ? "–" : std::string(unit); }

std::string table() {
  std::string text = "| kind | limit in | reached in | sentence |\n|---|---|---|---|\n";
  for (const DiagnosticRow& row : diagnostic_rows)
    text += "| `" + std::string(row.name) + "` | " + or_none(row.limit_unit) + " | " + or_none(row.unit) +
            " | " + std::string(row.text) + " |\n";
  return text;
}

TEST(DiagnosticPage, ListsEveryKind) {
  std::ifstream in(std::filesystem::path(source_dir) / "docs/in-house.md");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  const std::string begin = "<!-- diagnostics -->\n", end = "<!-- /diagnostics -->";
  const std::size_t from = page.find(begin), to = page.find(end);
  ASSERT_TRUE(from != std::string::npos && to != std::string::npos);
  EXPECT_EQ(page.substr(from + begin.size(), to - from - begin.size()), table());
}

}  // namespace
}  // namespace cylon::engine
