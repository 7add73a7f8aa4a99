// What the schema says of workers is what workers get: docs/protocol.md is made from it.
#include "harness/process/scene_json.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace cylon::scenario {
namespace {

using nlohmann::json;

/// Key -> "always" or "optional", of the keys that workers get of one kind of element.
std::map<std::string, std::string> worker_keys(const json& schema) {
  std::map<std::string, std::string> keys;
  for (const json& table : schema.contains("oneOf") ? schema["oneOf"] : json::array({schema}))
    for (const auto& [name, key] : table["properties"].items())
      if (name == "type") {
        keys[name] = "always";
      } else if (key.contains("x-worker")) {
        keys[name] = key["x-worker"];
      }
  return keys;
}

TEST(Schema, NamesTheKeysThatWorkersGet) {
  const json elements = json::parse(schema_json())["properties"];
  std::set<std::string> seen;  // "spring.pin"
  for (const char* folder : {"/scenarios", "/tests/data/mixes", "/docs/examples/force"})
    for (const auto& file : std::filesystem::directory_iterator(std::string(source_dir) + folder)) {
      if (file.path().extension() != ".toml" || file.path().stem() == "expected") continue;
      const json scene = process::to_json(read(file.path()).scene);
      for (const auto& [name, rows] : scene.items()) {
        if (name == "gravity" || name == "impacts") continue;
        ASSERT_TRUE(elements.contains(name)) << name;
        const bool is_list = rows.is_array();
        const auto keys = worker_keys(is_list ? elements[name]["items"] : elements[name]);
        for (const json& row : is_list ? rows : json::array({rows})) {
          for (const auto& [key, value] : row.items()) {
            EXPECT_TRUE(keys.contains(key)) << file << ": " << name << "." << key << " is not in the schema";
            seen.insert(fmt::format("{}.{}", name, key));
          }
          for (const auto& [key, when] : keys)
            EXPECT_TRUE(when != "always" || row.contains(key)) << file << ": " << name << "." << key;
        }
      }
    }
  for (const auto& [name, element] : elements.items())
    if (element.contains("x-worker") && name != "gravity") {
      for (const auto& [key, when] : worker_keys(element.value("items", element)))
        EXPECT_TRUE(seen.contains(fmt::format("{}.{}", name, key)))
            << name << "." << key << ": no scene has it";
    }
}

}  // namespace
}  // namespace cylon::scenario
