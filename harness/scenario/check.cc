// The key tables applied to a parsed document.

#include "harness/core/input_errors.h"
#include "harness/scenario/reader.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cylon::scenario {
namespace {

// Faults beyond these are not looked for: a file of another kind has thousands.
constexpr std::size_t most_faults = 10;

struct Checker {
  const std::string& file;
  std::vector<core::InputError> faults = {};

  [[noreturn]] void fail(const toml::source_region& where, const std::string& message) const {
    throw core::InputError(file, where.begin.line, where.begin.column, message);
  }

  // What a node is to its key: all of its value, or an element of it.
  enum class Role { whole, element };

  [[noreturn]] void wrong_type(const Key& key, const toml::node& node, Role role = Role::whole) const {
    fail(node.source(), fmt::format("{} must be {}, {} {}", key.name, form_of(key.kind),
                                    role == Role::whole ? "not" : "but an element is", describe_type(node)));
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

  double number(const Key& key, const toml::node& node, Role role = Role::whole) const {
    double x = 0;
    if (const auto* integer = node.as_integer()) {
      x = static_cast<double>(integer->get());
    } else if (const auto* real = node.as_floating_point()) {
      x = real->get();
    } else {
      wrong_type(key, node, role);
    }
    if (!std::isfinite(x)) fail(node.source(), fmt::format("{} = {}, but must be finite", key.name, x));
    const Range& r = key.range;
    if (x < r.low || x > r.high || (r.open && x == r.low))
      fail(node.source(), fmt::format("{} = {}, but must be {}", key.name, x, describe(r, key.unit)));
    return x;
  }

  void whole(const Key& key, const toml::node& node, Role role = Role::whole) const {
    if (!node.is_integer()) wrong_type(key, node, role);
    number(key, node);
  }

  void word(const Key& key, const toml::node& node, Role role = Role::whole) const {
    const auto* text = node.as_string();
    if (!text) wrong_type(key, node, role);
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

  void step(const Key& key, const toml::node& node, Role role = Role::whole) const {
    try {
      if (const auto* text = node.as_string()) {
        parse_step(text->get());
        return;
      }
    } catch (const core::InputError& error) {
      fail(node.source(), fmt::format("{}: {}", key.name, error.what()));
    }
    number(in_seconds(key), node, role);
  }

  static Key in_seconds(Key key) {
    key.range = {.low = 0, .open = true};
    key.unit = "s";
    return key;
  }

  // An array of one of the sizes (none: any), each entry checked by `entry`.
  template <class Entry>
  void array(const Key& key, const toml::node& node, std::initializer_list<std::size_t> sizes, Entry entry,
             Role role = Role::whole) const {
    const auto* values = node.as_array();
    if (!values || (sizes.size() && std::ranges::find(sizes, values->size()) == sizes.end()))
      wrong_type(key, node, role);
    for (const toml::node& value : *values) entry(value);
  }

  void numbers(const Key& key, const toml::node& node, std::initializer_list<std::size_t> sizes,
               Role role = Role::whole) const {
    array(
        key, node, sizes, [&](const toml::node& value) { number(key, value, Role::element); }, role);
  }
  void wholes(const Key& key, const toml::node& node, Role role = Role::whole) const {
    array(
        key, node, {3}, [&](const toml::node& value) { whole(key, value, Role::element); }, role);
  }
  void texts(const Key& key, const toml::node& node, std::initializer_list<std::size_t> sizes) const {
    array(key, node, sizes, [&](const toml::node& value) { word(key, value, Role::element); });
  }

  // A positive time in seconds, or the one word that stands for it.
  void seconds_or(Key key, const toml::node& node, const char* choice) const {
    key.choices = {choice};
    if (node.is_string())
      word(key, node);
    else
      number(in_seconds(key), node);
  }

  void table(const Key& key, const toml::node& node, Role role = Role::whole) {
    if (!node.is_table()) wrong_type(key, node, role);
    if (key.spec) table(*node.as_table(), *key.spec());
  }

  void value(const Key& key, const toml::node& node) {
    switch (key.kind) {
      case Kind::text:
        return word(key, node);
      case Kind::number:
        return void(number(key, node));
      case Kind::whole:
        return whole(key, node);
      case Kind::boolean:
        if (!node.is_boolean()) wrong_type(key, node);
        return;
      case Kind::vector:
        return numbers(key, node, {3});
      case Kind::counts:
        return wholes(key, node);
      case Kind::quaternion:
        return numbers(key, node, {4});
      case Kind::moments:
        return numbers(key, node, {3, 9});
      case Kind::numbers:
        return numbers(key, node, {});
      case Kind::points:
        return array(key, node, {},
                     [&](const toml::node& point) { numbers(key, point, {3}, Role::element); });
      case Kind::triangles:
        return array(key, node, {},
                     [&](const toml::node& triangle) { wholes(key, triangle, Role::element); });
      case Kind::texts:
        return texts(key, node, {});
      case Kind::named:
        if (!node.is_table()) wrong_type(key, node);
        for (auto&& [name, value] : *node.as_table())
          number({.name = std::string(name.str()), .kind = Kind::number}, value);
        return;
      case Kind::pair:
        return texts(key, node, {2});
      case Kind::step:
        return step(key, node);
      case Kind::steps:
        return array(key, node, {}, [&](const toml::node& s) { step(key, s, Role::element); });
      case Kind::sample:
        return seconds_or(key, node, "step");
      case Kind::until:
        return seconds_or(key, node, "horizon");
      case Kind::table:
        return table(key, node);
      case Kind::tables:
        return array(key, node, {}, [&](const toml::node& entry) { table(key, entry, Role::element); });
      case Kind::text_or_table:
        return node.is_string() ? word(key, node) : table(key, node);
    }
  }

  using Keys = std::vector<const Key*>;

  static void add(const std::vector<Key>& keys, Keys& all) {
    for (const Key& key : keys) all.push_back(&key);
  }

  // The common keys and those of the variant that the tag's value selects.
  Keys keys_of(const toml::table& t, const Spec& spec) const {
    Keys keys;
    add(spec.keys, keys);
    if (spec.tag.empty()) return keys;
    const toml::node* tag = t.get(spec.tag);
    if (!tag) fail(t.source(), fmt::format("{} needs '{}'", spec.label, spec.tag));
    if (!tag->is_string()) wrong_type({.name = spec.tag}, *tag);
    const std::string& word = tag->as_string()->get();
    const auto variant = std::ranges::find(spec.variants, word, &Spec::Variant::name);
    if (variant == spec.variants.end()) {
      std::vector<std::string> names;
      for (const Spec::Variant& one : spec.variants) names.push_back(one.name);
      unknown_word(spec.tag, word, names, tag->source());
    }
    add(variant->keys, keys);
    return keys;
  }

  [[noreturn]] void unknown_key(const toml::key& name, const Spec& spec, const Keys& keys) const {
    std::vector<std::string> names;
    for (const Key* key : keys) names.push_back(key->name);
    fail(name.source(), fmt::format("unknown key '{}' in {}{}; valid: {}", name.str(), spec.label,
                                    core::did_you_mean(name.str(), names), fmt::join(names, ", ")));
  }

  // One fault hides no other.
  template <class Task>
  void attempt(Task task) {
    if (faults.size() >= most_faults) return;
    try {
      task();
    } catch (const core::InputError& fault) {
      faults.push_back(fault);
    }
  }

  void table(const toml::table& t, const Spec& spec) {
    const Keys keys = keys_of(t, spec);
    for (auto&& [name, node] : t)
      attempt([&, &name = name, &node = node] {
        const auto known =
            std::ranges::find(keys, name.str(), [](const Key* key) { return std::string_view(key->name); });
        if (known == keys.end()) unknown_key(name, spec, keys);
        value(**known, node);
      });
    for (const Key* key : keys)
      if (key->required && !t.contains(key->name))
        attempt([&] { fail(t.source(), fmt::format("{} needs '{}'", spec.label, key->name)); });
  }

  void end() {
    if (faults.empty()) return;
    std::ranges::stable_sort(
        faults, {}, [](const core::InputError& fault) { return std::pair(fault.line, fault.column); });
    if (faults.size() == most_faults)
      faults.push_back(
          core::InputError(fmt::format("{}: after {} errors no more are looked for", file, most_faults)));
    throw core::InputErrors(std::move(faults));
  }
};

}  // namespace

void check(const toml::table& table, const Spec& spec, const std::string& file) {
  Checker checker{file};
  checker.attempt([&] { checker.table(table, spec); });
  checker.end();
}

}  // namespace cylon::scenario
