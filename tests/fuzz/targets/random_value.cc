#include "tests/fuzz/targets/random_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::fuzz {
namespace {

using scenario::Key, scenario::Kind, scenario::Spec;
using Names = std::vector<std::string>;

// Mostly of the size of what people write; now and then at the end of the range.
double number(const core::Range& range, Random& random) {
  const double low = std::isfinite(range.low) ? range.low : -3,
               high = std::isfinite(range.high) ? range.high : low + 5;
  switch (random.below(8)) {
    case 0:
      return low;
    case 1:
      return std::isfinite(range.high) ? range.high : 1e6;
    case 2:
      return low + 1e-9;
    default:
      return random.between(low, std::min(high, low + 5));
  }
}

std::string list(std::size_t count, const auto& one) {
  std::string text = "[";
  for (std::size_t i = 0; i < count; ++i) text += (i ? ", " : "") + one();
  return text + "]";
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

std::string word(const Key& key, const Names& names, Random& random) {
  if (!key.choices.empty()) return quoted(key.choices[random.below(key.choices.size())]);
  if (key.name == "name") return quoted(fmt::format("new{}", random.below(100)));
  return quoted(names.empty() || random.below(8) == 0 ? "*" : names[random.below(names.size())]);
}

std::string inline_table(const Spec& spec, const Names& names, Random& random) {
  std::string text = "{ ";
  for (const auto& [name, value] : random_table(spec, names, random))
    text.append(text.size() > 2 ? ", " : "").append(name).append(" = ").append(value);
  return text + " }";
}

}  // namespace

std::string Random::written(double x) {
  std::string text = below(2) ? fmt::format("{}", x) : fmt::format("{:.3g}", x);
  return text.find_first_of("inf") != std::string::npos ? "0.5" : text;
}

std::string random_value(const Key& key, const Names& names, Random& random) {
  const auto real = [&] { return random.written(number(key.range, random)); };
  const auto small = [&] {
    return fmt::format("{}", std::max(0., std::isfinite(key.range.low) ? key.range.low : 0.) +
                                 static_cast<double>(random.below(4)));
  };
  const auto point = [&] { return list(3, real); };
  switch (key.kind) {
    case Kind::text:
      return word(key, names, random);
    case Kind::number:
    case Kind::sample:
    case Kind::until:
      return real();
    case Kind::whole:
      return small();
    case Kind::named:
      return "{ rate = " + real() + ", " + quoted(word(key, names, random)) + " = " + real() + " }";
    case Kind::boolean:
      return random.below(2) ? "true" : "false";
    case Kind::vector:
      return point();
    case Kind::counts:
      return list(3, small);
    case Kind::quaternion:
      return random.below(2) ? "[0.6, 0, 0.8, 0]" : "[0.5, -0.5, 0.5, 0.5]";
    case Kind::moments:
      return random.below(2) ? "[1, 1.5, 2]" : point();
    case Kind::numbers:
      return key.name == "target_times" ? "[0, 0.25, 1.5]" : list(3, real);
    case Kind::points:
      return list(4 + random.below(5), point);
    case Kind::triangles:
      return "[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]";
    case Kind::texts:
      if (key.name.starts_with("collision_")) return random.below(2) ? "[\"a\", \"default\"]" : "[\"a\"]";
      return list(random.below(3), [&] { return word(key, names, random); });
    case Kind::pair:
      return list(2, [&] { return word(key, names, random); });
    case Kind::step:
      return random.below(2) ? quoted("1/60") : real();
    case Kind::steps:
      return list(2, real);
    case Kind::table:
      return key.spec ? inline_table(*key.spec(), names, random) : "{}";
    case Kind::tables:
      return list(1 + random.below(3),
                  [&] { return key.spec ? inline_table(*key.spec(), names, random) : std::string("{}"); });
    case Kind::text_or_table:
      return word(key, names, random);
  }
  return "0";
}

std::vector<std::pair<std::string, std::string>> random_table(const Spec& spec, const Names& names,
                                                              Random& random) {
  std::vector<std::pair<std::string, std::string>> result;
  const auto add = [&](const std::vector<Key>& keys) {
    for (const Key& key : keys)
      if (key.name != spec.tag && (key.required || random.below(3) == 0))
        result.emplace_back(key.name, random_value(key, names, random));
  };
  add(spec.keys);
  if (!spec.variants.empty()) {
    const Spec::Variant& variant = spec.variants[random.below(spec.variants.size())];
    result.emplace_back(spec.tag, quoted(variant.name));
    add(variant.keys);
  }
  return result;
}

}  // namespace cylon::fuzz
