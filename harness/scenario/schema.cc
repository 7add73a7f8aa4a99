// The key tables as a JSON Schema, for editors and for people.
#include "harness/scenario/keys.h"
#include "harness/scenario/scenario.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace cylon::scenario {
namespace {

using Json = nlohmann::ordered_json;

Json table_schema(const Spec&);

Json array_of(const Json& items, std::size_t size = 0) {
  Json schema{{"type", "array"}, {"items", items}};
  if (size) schema["minItems"] = schema["maxItems"] = size;
  return schema;
}

Json number_schema(const Range& range, const char* type = "number") {
  Json schema{{"type", type}};
  if (std::isfinite(range.low)) schema[range.open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (std::isfinite(range.high)) schema["maximum"] = range.high;
  return schema;
}

Json text_schema(const std::vector<std::string>& choices) {
  Json schema{{"type", "string"}};
  if (!choices.empty()) schema["enum"] = choices;
  return schema;
}

Json value_schema(const Key& key) {
  const Json number = number_schema(key.range), whole = number_schema(key.range, "integer"),
             text = text_schema(key.choices);
  const Json step{{"anyOf",
                   {number_schema({.low = 0, .open = true}),
                    Json{{"type", "string"}, {"pattern", "^[0-9.eE+-]+(/[0-9.eE+-]+)?$"}}}}};
  switch (key.kind) {
    case Kind::text:
      return text;
    case Kind::number:
      return number;
    case Kind::whole:
      return whole;
    case Kind::boolean:
      return {{"type", "boolean"}};
    case Kind::vector:
      return array_of(number, 3);
    case Kind::counts:
      return array_of(whole, 3);
    case Kind::quaternion:
      return array_of(number, 4);
    case Kind::moments:
      return {{"anyOf", {array_of(number, 3), array_of(number, 9)}}};
    case Kind::numbers:
      return array_of(number);
    case Kind::points:
      return array_of(array_of(number, 3));
    case Kind::triangles:
      return array_of(array_of(number_schema({.low = 0}, "integer"), 3));
    case Kind::texts:
      return array_of(text);
    case Kind::named:
      return {{"type", "object"}, {"additionalProperties", number}};
    case Kind::pair:
      return array_of(text, 2);
    case Kind::step:
      return step;
    case Kind::steps:
      return array_of(step);
    case Kind::sample:
      return {{"anyOf", {number_schema({.low = 0, .open = true}), Json{{"const", "step"}}}}};
    case Kind::until:
      return {{"anyOf", {number_schema({.low = 0, .open = true}), Json{{"const", "horizon"}}}}};
    case Kind::table:
      return key.spec ? table_schema(*key.spec()) : Json{{"type", "object"}};
    case Kind::tables:
      return array_of(table_schema(*key.spec()));
    case Kind::text_or_table:
      return {{"anyOf", {text, table_schema(*key.spec())}}};
  }
  return {};
}

// For editors, which show the description only; the parts of it are for docs/update.py.
std::string described(const Key& key) {
  std::string text = key.meaning;
  if (!key.unit.empty()) text += (text.empty() ? "[" : " [") + key.unit + "]";
  if (!key.absent.empty()) text += (text.empty() ? "Default: " : " Default: ") + key.absent + ".";
  return text;
}

Json object_schema(const std::vector<Key>& keys) {
  Json properties = Json::object(), required = Json::array();
  for (const Key& key : keys) {
    Json schema = value_schema(key);
    schema["description"] = described(key);
    schema["x-form"] = form_of(key.kind);
    if (!key.meaning.empty()) schema["x-meaning"] = key.meaning;
    if (!key.unit.empty()) schema["x-unit"] = key.unit;
    if (!key.absent.empty()) schema["x-absent"] = key.absent;
    if (!key.worker.empty()) schema["x-worker"] = key.worker;
    properties[key.name] = schema;
    if (key.required) required.push_back(key.name);
  }
  Json schema{{"type", "object"}, {"properties", properties}};
  if (!required.empty()) schema["required"] = required;
  schema["additionalProperties"] = false;
  return schema;
}

Json table_schema(const Spec& spec) {
  if (spec.tag.empty()) return object_schema(spec.keys);
  Json variants = Json::array();
  for (const auto& variant : spec.variants) {
    std::vector<Key> keys = spec.keys;
    keys.insert(keys.end(), variant.keys.begin(), variant.keys.end());
    Json schema = object_schema(keys);
    schema["properties"][spec.tag] = {{"const", variant.name}};
    variants.push_back(schema);
  }
  return {{"oneOf", variants}};
}

}  // namespace

std::string schema_json() {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Cylon scenario"},
              {"description", "One phenomenon: scene, duration, claims, story. SI units, y up."}};
  schema.update(table_schema(scenario_keys()));
  return schema.dump(1) + "\n";
}

}  // namespace cylon::scenario
