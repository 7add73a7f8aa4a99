// The one way in which JSON of strangers is parsed: of bounded depth, so that no later copy, comparison or
// dump of it can exhaust the stack, and of bounded memory, which is up to thirty times the text's.  Knows no message and
// no file.
#pragma once

#include <nlohmann/json.hpp>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace cylon::input {

/// Arrays and objects inside each other; the deepest that Cylon writes has ten.
inline constexpr std::size_t deepest_json = 64;

/// Memory of the values of one text, as memory_of() counts it [bytes]; a report of 10^5 verdicts takes six sevenths of it.
inline constexpr std::size_t largest_json = 700'000'000;

/// Text that is no JSON, or JSON that is refused; `byte` counts from 1, 0 where no place is known.
struct BadJson : std::runtime_error {
  BadJson(std::size_t at, const std::string& why) : std::runtime_error(why), byte(at) {}
  std::size_t byte;
};

/// Memory that the values of a text, or of all lines of a text, take when they are parsed [bytes], rather too much than too
/// little.
std::size_t memory_of(std::string_view text);

/// Throws BadJson where brackets outside strings are open more than `deepest_json` deep, or memory_of(text) > `most`.
void require_bounded(std::string_view text, std::size_t most = largest_json);

/// The value that the text is.  Throws BadJson: "not JSON at byte 7", "a number beyond the range of a
/// double", "nested more than 64 deep at byte 65", "values that take more than 700 MB of memory at byte 81".
template <class Json = nlohmann::json>
Json parse_json(std::string_view text) {
  require_bounded(text);
  try {
    return Json::parse(text);
  } catch (const typename Json::parse_error& error) {
    throw BadJson(error.byte, "not JSON at byte " + std::to_string(error.byte));
  } catch (const typename Json::out_of_range&) {  // 1e999
    throw BadJson(0, "not JSON: a number beyond the range of a double");
  }
}

/// Throws BadJson where an object of the text has a key twice: parsers take the last and say nothing.  Requires that the text is
/// what parse_json() takes.
void require_unique_keys(std::string_view text);

/// The value in an error message: a scalar as JSON, a text cut to 60 bytes; of what holds others only how
/// many.
template <class Json>
std::string shown(const Json& value) {
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_object()) return "an object of " + std::to_string(value.size()) + " keys";
  constexpr std::size_t most = 60;
  if (!value.is_string()) return value.dump();
  const auto& text = value.template get_ref<const std::string&>();
  const std::string cut =
      Json(text.substr(0, most)).dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace);
  return text.size() > most ? cut + "…" : cut;
}

}  // namespace cylon::input
