#include "harness/scenario/check.h"

#include "harness/core/input_error.h"
#include "harness/scenario/reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace cylon::scenario {
namespace {

struct Checker {
  const std::string& file;

  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const {
    throw core::InputError(file, where.begin.line, where.begin.column, message);
  }

  [[noreturn]] void wrong_type(const Key& key, const toml::node& node, std::string_view expected) const {
    fail(node.source(), fmt::format("{} must be {}, not {}", key.name, expected, describe_type(node)));
  }

  static std::string describe_type(const toml::node& node) {
    if (const auto* array = node.as_array()) return fmt::format("an array of {}", array->size());
    if (node.is_table()) return "a table";
    if (node.is_string()) return "a string";
    if (node.is_boolean()) return "a boolean";
    if (node.is_integer()) return "an integer";
    if (node.is_floating_point()) return "a float";
    return "a date or time";
  }

  double number(const Key& key, const toml::node& node, std::string_view expected) const {
    double x = 0;
    if (const auto* integer = node.as_integer()) {
      x = static_cast<double>(integer->get());
    } else if (const auto* real = node.as_floating_point()) {
      x = real->get();
    } else {
      wrong_type(key, node, expected);
    }
    if (!std::isfinite(x)) fail(node.source(), fmt::format("{} = {}, but must be finite", key.name, x));
    const Range& r = key.range;
    if (x < r.low || x > r.high || (r.open && x == r.low))
      fail(node.source(), fmt::format("{} = {}, but must be {}", key.name, x, describe(r, key.unit)));
    return x;
  }

  void whole(const Key& key, const toml::node& node, std::string_view expected) const {
    if (!node.is_integer()) wrong_type(key, node, expected);
    number(key, node, expected);
  }

  void word(const Key& key, const toml::node& node, std::string_view expected = "a string") const {
    const auto* text = node.as_string();
    if (!text) wrong_type(key, node, expected);
    if (text->get().empty()) fail(node.source(), fmt::format("{} is empty", key.name));
    if (key.choices.empty() || std::ranges::find(key.choices, text->get()) != key.choices.end()) return;
    unknown_word(key.name, text->get(), key.choices, node.source());
  }

  [[noreturn]] void unknown_word(std::string_view key, const std::string& word,
                                 const std::vector<std::string>& valid,
                                 const toml::source_region& where) const {
    fail(where, fmt::format("{} = '{}' is unknown{}; valid: {}", key, word, core::did_you_mean(word, valid),
                            fmt::join(valid, ", ")));
  }

  void step(const Key& key, const toml::node& node) const {
    try {
      if (const auto* text = node.as_string()) {
        parse_step(text->get());
        return;
      }
    } catch (const core::InputError& error) {
      fail(node.source(), fmt::format("{}: {}", key.name, error.what()));
    }
    Key positive = key;
    positive.range = {.low = 0, .open = true};
    positive.unit = "s";
    number(positive, node, "a number or a string like \"1/60\"");
  }

  // An array of `size` (0: any number of) entries, each checked by `entry`.
  template <class Entry>
  void array(const Key& key, const toml::node& node, std::initializer_list<std::size_t> sizes,
             std::string_view expected, Entry entry) const {
    const auto* values = node.as_array();
    if (!values || (sizes.size() && std::ranges::find(sizes, values->size()) == sizes.end()))
      wrong_type(key, node, expected);
    for (const toml::node& value : *values) entry(value);
  }

  void numbers(const Key& key, const toml::node& node, std::initializer_list<std::size_t> sizes,
               std::string_view expected) const {
    array(key, node, sizes, expected, [&](const toml::node& value) { number(key, value, expected); });
  }
  void wholes(const Key& key, const toml::node& node, std::string_view expected) const {
    array(key, node, {3}, expected, [&](const toml::node& value) { whole(key, value, expected); });
  }
  void texts(const Key& key, const toml::node& node, std::initializer_list<std::size_t> sizes,
             std::string_view expected) const {
    array(key, node, sizes, expected, [&](const toml::node& value) { word(key, value, expected); });
  }

  // A positive time in seconds, or the one word that stands for it.
  void seconds_or(const Key& key, const toml::node& node, const char* choice) const {
    Key positive = key;
    positive.choices = {choice};
    positive.range = {.low = 0, .open = true};
    positive.unit = "s";
    return node.is_string() ? word(positive, node)
                            : void(number(positive, node, fmt::format("a number or \"{}\"", choice)));
  }

  void value(const Key& key, const toml::node& node) const {
    switch (key.kind) {
      case Kind::text:
        return word(key, node);
      case Kind::number:
        return void(number(key, node, "a number"));
      case Kind::whole:
        return whole(key, node, "a whole number");
      case Kind::boolean:
        if (!node.is_boolean()) wrong_type(key, node, "true or false");
        return;
      case Kind::vector:
        return numbers(key, node, {3}, "three numbers [x, y, z]");
      case Kind::counts:
        return wholes(key, node, "three whole numbers");
      case Kind::quaternion:
        return numbers(key, node, {4}, "four numbers [w, x, y, z]");
      case Kind::moments:
        return numbers(key, node, {3, 9}, "three principal moments or nine numbers");
      case Kind::points: {
        constexpr std::string_view expected = "an array of points [[x, y, z], …]";
        return array(key, node, {}, expected, [&](const toml::node& p) { numbers(key, p, {3}, expected); });
      }
      case Kind::triangles: {
        constexpr std::string_view expected = "an array of triangles [[0, 1, 2], …]";
        return array(key, node, {}, expected, [&](const toml::node& t) { wholes(key, t, expected); });
      }
      case Kind::texts:
        return texts(key, node, {}, "an array of strings");
      case Kind::pair:
        return texts(key, node, {2}, "two names [\"a\", \"b\"]");
      case Kind::step:
        return step(key, node);
      case Kind::steps:
        return array(key, node, {}, "an array of steps [0.001, \"1/60\"]",
                     [&](const toml::node& s) { step(key, s); });
      case Kind::sample:
        return seconds_or(key, node, "step");
      case Kind::until:
        return seconds_or(key, node, "horizon");
      case Kind::table: {
        const auto* inner = node.as_table();
        if (!inner) wrong_type(key, node, "a table");
        if (key.spec) table(*inner, *key.spec());
        return;
      }
      case Kind::tables:
        return array(key, node, {}, "an array of tables", [&](const toml::node& entry) {
          if (!entry.is_table()) wrong_type(key, entry, "a table");
          table(*entry.as_table(), *key.spec());
        });
      case Kind::text_or_table:
        if (node.is_string()) return word(key, node);
        if (!node.is_table()) wrong_type(key, node, "a name or a table { file = \"…\" }");
        return table(*node.as_table(), *key.spec());
    }
  }

  // The common keys and those of the variant that the tag's value selects.
  std::vector<Key> keys_of(const toml::table& t, const Spec& spec) const {
    std::vector<Key> keys = spec.keys;
    if (spec.tag.empty()) return keys;
    const toml::node* tag = t.get(spec.tag);
    if (!tag) fail(t.source(), fmt::format("{} needs '{}'", spec.label, spec.tag));
    if (!tag->is_string()) wrong_type({.name = spec.tag}, *tag, "a string");
    const std::string& word = tag->as_string()->get();
    std::vector<std::string> names;
    for (const auto& variant : spec.variants) {
      names.push_back(variant.name);
      if (variant.name == word) {
        keys.insert(keys.end(), variant.keys.begin(), variant.keys.end());
        return keys;
      }
    }
    unknown_word(spec.tag, word, names, tag->source());
  }

  void table(const toml::table& t, const Spec& spec) const {
    const std::vector<Key> keys = keys_of(t, spec);
    std::vector<std::string> names;
    for (const Key& key : keys) names.push_back(key.name);
    for (auto&& [name, node] : t) {
      const auto known = std::ranges::find(names, std::string(name.str()));
      if (known == names.end())
        fail(name.source(), fmt::format("unknown key '{}' in {}{}; valid: {}", name.str(), spec.label,
                                        core::did_you_mean(name.str(), names), fmt::join(names, ", ")));
      value(keys[static_cast<std::size_t>(known - names.begin())], node);
    }
    for (const Key& key : keys)
      if (key.required && !t.contains(key.name))
        fail(t.source(), fmt::format("{} needs '{}'", spec.label, key.name));
  }
};

}  // namespace

void check(const toml::table& table, const Spec& spec, const std::string& file) {
  Checker{file}.table(table, spec);
}

}  // namespace cylon::scenario
