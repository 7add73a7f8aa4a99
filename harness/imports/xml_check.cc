#include "harness/imports/xml_check.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <vector>

namespace cylon::imports {
namespace {

// Behind the next `end` from `at` on; the end of the text where there is none.
std::size_t behind(std::string_view text, std::size_t at, std::string_view end) {
  const std::size_t found = text.find(end, at);
  return found == std::string_view::npos ? text.size() : found + end.size();
}

// Behind the tag that begins at `at`: its '>' outside the quotes of attributes.
std::size_t behind_tag(std::string_view text, std::size_t at) {
  while (at < text.size() && text[at] != '>')
    at = text[at] == '"' || text[at] == '\'' ? behind(text, at + 1, text.substr(at, 1)) : at + 1;
  return std::min(at + 1, text.size());
}

// The name of an element from behind its '<' or "</" on.
std::string_view name_at(std::string_view text, std::size_t at) {
  return text.substr(at, std::min(text.find_first_of(" \t\r\n/>", at), text.size()) - at);
}

struct Attribute {
  std::string_view name, value;
};

std::vector<Attribute> attributes_of(std::string_view tag) {
  std::vector<Attribute> attributes;
  for (std::size_t at = 0; (at = tag.find_first_of("\"'", at)) < tag.size();) {
    const std::size_t end = std::min(tag.find(tag[at], at + 1), tag.size());
    const std::string_view before = tag.substr(0, at);
    const std::size_t last = before.find_last_not_of(" \t\r\n="),
                      blank = before.find_last_of(" \t\r\n", last);
    if (last != std::string_view::npos && blank != std::string_view::npos)
      attributes.push_back({before.substr(blank + 1, last - blank), tag.substr(at + 1, end - at - 1)});
    at = end + 1;
  }
  return attributes;
}

// "body 'arm'", "<geom>".
std::string shown(std::string_view tag) {
  const std::string_view kind = name_at(tag, 1);
  for (const Attribute& a : attributes_of(tag))
    if (a.name == "name") return fmt::format("{} '{}'", kind, a.value);
  return fmt::format("<{}>", kind);
}

core::InputError error_at(std::string_view text, std::size_t at, const std::string& file,
                          const std::string& why) {
  const std::string_view before = text.substr(0, at);
  const auto lines = std::ranges::count(before, '\n');
  const std::size_t start = lines == 0 ? 0 : before.rfind('\n') + 1;
  return {file, static_cast<unsigned>(lines + 1), static_cast<unsigned>(at - start + 1), why};
}

// Calls opens(at, tag) and closes(at) for all elements in their order; an empty one closes at once.
void walk(std::string_view text, const std::function<void(std::size_t, std::string_view)>& opens,
          const std::function<void()>& closes) {
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(text, at + 4, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = behind(text, at, "]]>");
    } else if (rest.starts_with("<?")) {
      at = behind(text, at, "?>");
    } else if (rest.starts_with("<!")) {
      at = behind(text, at, ">");
    } else if (rest.starts_with("</")) {
      closes();
      at = behind(text, at, ">");
    } else {
      const std::size_t end = behind_tag(text, at);
      const std::string_view tag = text.substr(at, end - at);
      opens(at, tag);
      if (tag.ends_with("/>")) closes();
      at = end;
    }
  }
}

// Attributes of MJCF that hold a name: "nan" is one.
bool is_name(std::string_view attribute) {
  constexpr std::array names = {"name",   "class",  "childclass", "model", "file",     "prefix",
                                "target", "parent", "plugin",     "key",   "instance", "value"};
  constexpr std::array kinds = {"body", "joint",    "geom",     "site",  "tendon",
                                "mesh", "material", "actuator", "hfield"};
  return std::ranges::find(names, attribute) != names.end() ||
         std::ranges::any_of(kinds, [&](const char* kind) { return attribute.starts_with(kind); });
}

// Whether all words are numbers, and one is NaN.
bool has_nan(std::string_view value) {
  std::istringstream words{std::string(value)};
  bool any = false;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (*end != '\0') return false;
    any = any || std::isnan(number);
  }
  return any;
}

// Parts of which an element has one.
struct Single {
  std::string_view whole, part;
};
constexpr Single singles[] = {
    {"link", "inertial"}, {"inertial", "mass"},      {"inertial", "inertia"}, {"inertial", "origin"},
    {"inertial", "pose"}, {"collision", "geometry"}, {"collision", "origin"}, {"collision", "pose"},
    {"joint", "parent"},  {"joint", "child"},        {"joint", "origin"},     {"joint", "pose"},
    {"joint", "axis"},    {"joint", "axis2"},        {"joint", "limit"},      {"joint", "dynamics"},
    {"joint", "mimic"},   {"axis", "xyz"},           {"axis", "limit"},       {"axis", "dynamics"},
    {"axis2", "xyz"},     {"axis2", "limit"},        {"axis2", "dynamics"},   {"geometry", "shape"},
};
// What is inside these is nobody's link or joint.
constexpr std::string_view others[] = {"gazebo", "plugin", "transmission", "state"};

}  // namespace

XmlFacts require_small_xml(std::string_view text, const std::string& file, std::string_view body,
                           int deepest) {
  XmlFacts facts;
  std::vector<std::string_view> open;
  int roots = 0, apart = 0;  // apart: elements around this one in which a body is none of the model
  const auto is_apart = [](std::string_view name) { return name == "state" || name == "plugin"; };
  walk(
      text,
      [&](std::size_t at, std::string_view tag) {
        const std::string_view name = name_at(text, at + 1);
        if (open.empty()) {
          if (++roots > 1)
            throw error_at(
                text, at, file,
                fmt::format("<{}> behind the end of <{}>: a file has one root element", name, facts.root));
          facts.root = name;
          const core::InputError place = error_at(text, at, file, "");
          facts.line = place.line, facts.column = place.column;
        }
        open.push_back(name);
        if (open.size() > static_cast<std::size_t>(deepest))
          throw error_at(text, at, file, fmt::format("an element nested more than {} deep", deepest));
        apart += is_apart(name) ? 1 : 0;
        if (apart == 0 && name == body && ++facts.bodies > most_bodies)
          throw error_at(text, at, file,
                         fmt::format("{}: more than {} elements <{}>, which an import takes at most",
                                     shown(tag), most_bodies, body));
      },
      [&] {
        if (open.empty()) return;
        apart -= is_apart(open.back()) ? 1 : 0;
        open.pop_back();
      });
  return facts;
}

void require_no_nan(std::string_view text, const std::string& file) {
  const auto same = [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; };
  if (std::ranges::search(text, std::string_view("nan"), same).empty()) return;
  walk(
      text,
      [&](std::size_t at, std::string_view tag) {
        for (const Attribute& a : attributes_of(tag))
          if (!is_name(a.name) && has_nan(a.value))
            throw error_at(text, at, file,
                           fmt::format("{}: {}=\"{}\": NaN is no number", shown(tag), a.name, a.value));
      },
      [] {});
}

void require_single(std::string_view text, const std::string& file) {
  struct Open {
    std::string_view name, tag;
    std::vector<std::string_view> parts;
  };
  std::vector<Open> open;
  int apart = 0;
  const auto is_other = [](std::string_view name) {
    return std::ranges::find(others, name) != std::end(others);
  };
  walk(
      text,
      [&](std::size_t at, std::string_view tag) {
        const std::string_view name = name_at(text, at + 1);
        apart += is_other(name) ? 1 : 0;
        // The shape of a collision has many names; what else a geometry shows touches nothing.
        const bool is_shape =
            open.size() > 1 && open.back().name == "geometry" && open[open.size() - 2].name == "collision";
        const std::string_view part = is_shape ? "shape" : name;
        const auto is_this = [&](const Single& s) { return s.whole == open.back().name && s.part == part; };
        if (!open.empty() && apart == 0 && std::ranges::any_of(singles, is_this)) {
          Open& whole = open.back();
          if (std::ranges::find(whole.parts, part) != whole.parts.end())
            throw error_at(
                text, at, file,
                fmt::format("{}: a second {}", shown(whole.tag),
                            is_shape ? fmt::format("shape, <{}>", name) : fmt::format("<{}>", name)));
          whole.parts.push_back(part);
        }
        open.push_back({name, tag, {}});
      },
      [&] {
        if (open.empty()) return;
        apart -= is_other(open.back().name) ? 1 : 0;
        open.pop_back();
      });
}

}  // namespace cylon::imports
