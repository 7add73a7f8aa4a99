#include "harness/input/json.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace cylon::input {
namespace {

std::string nested(std::size_t depth, const std::string& inner) {
  return std::string(depth, '[') + inner + std::string(depth, ']');
}

std::string refusal(const std::string& text) {
  try {
    parse_json(text);
  } catch (const BadJson& error) {
    return error.what();
  }
  return "taken";
}

TEST(Json, DepthIsBoundedAndPlacesAreTold) {
  EXPECT_EQ(refusal(nested(deepest_json, "1")), "taken");
  EXPECT_EQ(refusal(nested(deepest_json + 1, "1")), "nested more than 64 deep at byte 65");
  EXPECT_EQ(refusal("{\"a\":" + nested(deepest_json, "1") + "}"), "nested more than 64 deep at byte 69");
  EXPECT_EQ(refusal(std::string(8'000'000, '[')), "nested more than 64 deep at byte 65");
  EXPECT_EQ(refusal("[1, 2"), "not JSON at byte 6");
  EXPECT_EQ(refusal("[-1e999]"), "not JSON: a number beyond the range of a double");
}

TEST(Json, BracketsInsideStringsDoNotCount) {
  const std::string brackets(1000, '[');
  EXPECT_EQ(parse_json("{\"a\": \"" + brackets + "\"}")["a"], brackets);
  EXPECT_EQ(parse_json(R"(["\"[[[", "\\", []])").size(), 3u);
  // One behind another is not one inside another.
  std::string flat = "[0";
  for (int i = 0; i < 1000; ++i) flat += ",[[]]";
  EXPECT_EQ(parse_json(flat + "]").size(), 1001u);
}

// What lists of a million take in memory, measured as they grew; an object of one name takes the most for a byte of text.
TEST(Json, MemoryIsCountedBeforeItIsTaken) {
  struct Unit {
    const char* text;
    std::size_t bytes;  // of json in memory
  };
  for (const auto& [unit, bytes] :
       {Unit{"0", 16}, Unit{"[]", 48}, Unit{"{}", 80}, Unit{R"("")", 64}, Unit{R"({"":0})", 176},
        Unit{R"({"0123456789abcdef":"0123456789abcdef"})", 288}}) {
    std::string list = "[";
    for (int i = 0; i < 1000; ++i) list.append(i == 0 ? "" : ",").append(unit);
    const std::size_t counted = memory_of(list + "]");
    EXPECT_GE(counted, 1000 * bytes) << unit;
    EXPECT_LE(counted, 2000 * bytes) << unit;
  }
  // Each line is a text of its own, and what is in a text is none of it.
  EXPECT_EQ(memory_of("[1]\n[2]\n") + memory_of("1"), memory_of("[1]") + memory_of("[2]"));
  EXPECT_EQ(memory_of(R"("[{:,\"[")"), memory_of(R"("abcdefg")"));
}

TEST(Json, MemoryIsBounded) {
  const std::string list = "[[],[],[]]";
  EXPECT_NO_THROW(require_bounded(list, memory_of(list)));
  try {
    require_bounded(list, memory_of(list) - 1);
    ADD_FAILURE() << "taken";
  } catch (const BadJson& error) {
    EXPECT_EQ(error.byte, 8u);  // the last list
  }
  std::string objects = "[{}";
  for (int i = 0; i < 7'000'000; ++i) objects += ",{}";
  EXPECT_EQ(refusal(objects + "]").substr(0, 52), "values that take more than 700 MB of memory at byte ");
}

TEST(Json, ShowsStrangersValuesInBounds) {
  EXPECT_EQ(shown(parse_json("1.5")), "1.5");
  EXPECT_EQ(shown(parse_json("null")), "null");
  EXPECT_EQ(shown(parse_json("[[], []]")), "an array of 2");
  EXPECT_EQ(shown(parse_json(R"({"a": {}})")), "an object of 1 keys");
  EXPECT_EQ(shown(nlohmann::json("\x1b[31m\xff")), R"("\u001b[31m\ufffd")");
  EXPECT_LT(shown(nlohmann::json(std::string(1 << 20, 'x'))).size(), 100u);
}

// Parsers take the last, and a bound that was stated first was gone.
TEST(Json, KeysOfAnObjectAreUniqueWhereThatIsAsked) {
  for (const char* good : {"[]", R"({"a": 1, "b": {"a": 2}, "c": [{"a": 3}, {"a": 4}]})"})
    EXPECT_NO_THROW(require_unique_keys(good)) << good;
  for (const char* bad :
       {R"({"a": 1, "a": 1})", R"([{"b": {"a": [], "c": 0, "a": 2}}])", R"({"\u0061": 1, "a": 2})"})
    EXPECT_THROW(require_unique_keys(bad), BadJson) << bad;
}

// A parse elsewhere would be one without the bound.
TEST(Json, IsParsedInOnePlace) {
  namespace fs = std::filesystem;
  const std::regex parse("json::parse|Json::parse|json::accept|json::sax_parse");
  int files = 0;
  for (const char* folder : {"harness", "reports", "reference", "engine"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir) / folder)) {
      const std::string path = entry.path().string();
      if (!(path.ends_with(".cc") || path.ends_with(".h")) ||
          path.find("harness/input/json.") != std::string::npos)
        continue;
      ++files;
      std::ifstream in(path);
      for (std::string line; std::getline(in, line);) {
        std::smatch found;
        if (!std::regex_search(line, found, parse)) continue;
        EXPECT_EQ(found.suffix().str().substr(0, 6), "_error") << path << ": " << line;
      }
    }
  EXPECT_GT(files, 500);
}

}  // namespace
}  // namespace cylon::input
