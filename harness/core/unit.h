// Units as people write them, "kg m^2/s", and the dimension that follows from the text at compile time.
#pragma once

#include <stdexcept>
#include <string_view>

namespace cylon::core {

/// Exponents of kilogram, metre and second.
struct Dimension {
  int mass = 0, length = 0, time = 0;
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

/// The dimension of a product of "kg", "m", "s", "N", "rad" and "1" with powers, "m^2".  "/" divides by the
/// next symbol, or by a product in parentheses: "m^3/(kg s^2)".  "" is a pure number.  Throws
/// std::invalid_argument for any other text, which does not compile where the text is a constant.
constexpr Dimension dimension(std::string_view unit) {
  struct Symbol {
    std::string_view name;
    Dimension dimension;
  };
  constexpr Symbol symbols[] = {{"kg", {.mass = 1}}, {"m", {.length = 1}},
                                {"s", {.time = 1}},  {"N", {.mass = 1, .length = 1, .time = -2}},
                                {"rad", {}},         {"1", {}}};
  Dimension result;
  int sign = 1;
  bool group = false;
  while (!unit.empty()) {
    const char c = unit.front();
    if (c == ' ' || c == '/' || c == '(' || c == ')') {
      if (c == '/') sign = -1;
      if (c == '(') group = true;
      if (c == ')') group = false, sign = 1;
      unit.remove_prefix(1);
      continue;
    }
    const std::string_view name = unit.substr(0, unit.find_first_of(" /^()"));
    unit.remove_prefix(name.size());
    int power = sign;
    if (unit.size() > 1 && unit.front() == '^') {
      if (unit[1] < '0' || unit[1] > '9') throw std::invalid_argument("a power is one digit");
      power *= unit[1] - '0';
      unit.remove_prefix(2);
    }
    bool known = false;
    for (const Symbol& symbol : symbols) {
      if (symbol.name != name) continue;
      known = true;
      result.mass += power * symbol.dimension.mass;
      result.length += power * symbol.dimension.length;
      result.time += power * symbol.dimension.time;
    }
    if (!known) throw std::invalid_argument("unknown unit");
    if (!group) sign = 1;
  }
  return result;
}

static_assert(dimension("kg m^2/s") == Dimension{1, 2, -1});
static_assert(dimension("m^3/(kg s^2)") == Dimension{-1, 3, -2});
static_assert(dimension("N s/m") == Dimension{1, 0, -1});

}  // namespace cylon::core
