#include "harness/input/json.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <vector>

namespace cylon::input {
namespace {

// Memory [bytes] of nlohmann::json and ordered_json with the allocator of glibc, measured on lists of millions: a place
// in a list that grows; what a list, an object and a text are beside it; the node of a name, whose text is counted as
// one; and where a text has more than 15 bytes a block of its own.  A list that is freed is moved to a stack, which
// grows: in a long one a place takes three times as much.
constexpr std::size_t of_place = 24, of_list = 64, of_object = 80, of_text = 48, of_name = 32, of_block = 17,
                      short_text = 15, of_place_in_long = 64, long_list = 1'000'000;

// Calls visit(byte, memory) for every character that begins, separates or ends a value, bytes counted from 0.
template <class Visit>
void look_through(std::string_view text, const Visit& visit) {
  std::array<std::size_t, deepest_json + 1> places = {};  // of the open list or object of each depth
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    switch (text[i]) {
      case '"': {
        const std::size_t start = i;
        while (++i < text.size() && text[i] != '"')
          if (text[i] == '\\') ++i;
        const std::size_t length = i - start - 1;
        visit(start, of_text + (length > short_text ? length + of_block : 0));
        break;
      }
      case '[':
      case '{':
        places[std::min(++depth, deepest_json)] = 0;
        visit(i, text[i] == '[' ? of_list : of_object);
        break;
      case ',':
        visit(i, ++places[std::min(depth, deepest_json)] > long_list ? of_place_in_long : of_place);
        break;
      case ':':
        visit(i, of_name);
        break;
      case ']':
      case '}':
        if (depth > 0) --depth;
        visit(i, 0);
        break;
      default:
        break;
    }
  }
}

// Remembers the keys of all objects that are open.
struct KeysOnce : nlohmann::json_sax<nlohmann::json> {
  std::vector<std::set<std::string>> open;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open.emplace_back(), true; }
  bool end_object() override { return open.pop_back(), true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override {
    return false;
  }
  bool key(string_t& name) override {
    if (!open.back().insert(name).second)
      throw BadJson(0, "the key " + shown(nlohmann::json(name)) + " twice in one object");
    return true;
  }
};

}  // namespace

std::size_t memory_of(std::string_view text) {
  std::size_t sum = of_place;
  look_through(text, [&](std::size_t, std::size_t memory) { sum += memory; });
  return sum;
}

void require_bounded(std::string_view text, std::size_t most) {
  std::size_t depth = 0, sum = of_place;
  look_through(text, [&](std::size_t i, std::size_t memory) {
    const char c = text[i];
    if ((c == '[' || c == '{') && ++depth > deepest_json)
      throw BadJson(i + 1, "nested more than " + std::to_string(deepest_json) + " deep at byte " +
                               std::to_string(i + 1));
    if ((c == ']' || c == '}') && depth > 0) --depth;
    if ((sum += memory) > most)
      throw BadJson(i + 1, "values that take more than " + std::to_string(most / 1'000'000) +
                               " MB of memory at byte " + std::to_string(i + 1));
  });
}

void require_unique_keys(std::string_view text) {
  KeysOnce keys;
  nlohmann::json::sax_parse(text, &keys);
}

}  // namespace cylon::input
