#include "harness/scenario/key_rows.h"

#include <utility>

namespace cylon::scenario {

Key word(std::string name, std::string meaning, std::vector<std::string> choices) {
  return {.name = std::move(name), .meaning = std::move(meaning), .choices = std::move(choices)};
}
Key plain(std::string name, Kind kind, std::string meaning) {
  return {.name = std::move(name), .kind = kind, .meaning = std::move(meaning)};
}
Key seconds(std::string name, Kind kind, std::string meaning) {
  return {.name = std::move(name), .kind = kind, .meaning = std::move(meaning), .unit = "s"};
}
Key real(std::string name, std::string unit, std::string meaning, Range range) {
  return {.name = std::move(name),
          .kind = Kind::number,
          .meaning = std::move(meaning),
          .unit = std::move(unit),
          .range = range};
}
Key integer(std::string name, std::string meaning, Range range) {
  return {.name = std::move(name), .kind = Kind::whole, .meaning = std::move(meaning), .range = range};
}
Key arrow(std::string name, std::string unit, std::string meaning, Range range) {
  return {.name = std::move(name),
          .kind = Kind::vector,
          .meaning = std::move(meaning),
          .unit = std::move(unit),
          .range = range};
}
Key nested(std::string name, Kind kind, const Spec* (*spec)(), std::string meaning) {
  return {.name = std::move(name), .kind = kind, .meaning = std::move(meaning), .spec = spec};
}
Key required(Key key) {
  key.required = true;
  return key;
}
Key absent(std::string means, Key key) {
  key.absent = std::move(means);
  return key;
}

}  // namespace cylon::scenario
