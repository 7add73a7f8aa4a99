// The tree of libsdformat against what the reader reads: elements and attributes of the format that it leaves out, those
// that the format does not know, and numbers with something behind them, of which the library takes the start ("0,5" as 0).
#include "reference/formats/sdformat/reader.h"

#include "reference/formats/resources/gazebo.h"
#include "reference/formats/resources/resources.h"
#include "reference/formats/sdformat/known.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace cylon::formats {
namespace {

using foreign::Place;

// Numbers below these are not looked at: no body follows from them, or they belong to code of others.
constexpr std::array<std::string_view, 10> closed = {"plugin", "visual",   "sensor", "light", "gui",
                                                     "scene",  "material", "state",  "actor", "population"};

bool is_numeric(const std::string& type) {
  constexpr std::array<std::string_view, 10> types = {"double",     "float",   "int",  "unsigned int",
                                                      "vector2d",   "vector3", "pose", "vector2i",
                                                      "quaternion", "time"};
  return std::ranges::find(types, type) != types.end();
}

// The first word that is not a number from its first to its last character; "" where all are.
std::string not_a_number(const sdf::Param& value) {
  if (!is_numeric(value.GetTypeName())) return "";
  std::istringstream words(value.GetAsString());
  for (std::string word; words >> word;) {
    char* end = nullptr;
    std::strtod(word.c_str(), &end);
    if (*end != '\0') return word;
  }
  return "";
}

// The words of all numbers that a file states in an element.
void refuse_words(const sdf::ElementPtr& element, int line) {
  if (element->LineNumber()) line = *element->LineNumber();
  const auto refuse_word = [&](const sdf::ParamPtr& value, const std::string& of) {
    if (const std::string word = value ? not_a_number(*value) : ""; !word.empty())
      throw Refused("line " + std::to_string(line) + ": <" + element->GetName() + ">" + of + ": '" + word +
                    "' is no number");
  };
  refuse_word(element->GetValue(), "");
  for (std::size_t i = 0; i < element->GetAttributeCount(); ++i)
    if (const sdf::ParamPtr attribute = element->GetAttribute(static_cast<unsigned>(i)); attribute->GetSet())
      refuse_word(attribute, " " + attribute->GetKey());
  for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement())
    if (child->GetExplicitlySetInFile() && element->HasElementDescription(child->GetName()) &&
        std::ranges::find(closed, child->GetName()) == closed.end())
      refuse_words(child, line);
}

// The losses of what a file states in an element, by the table of what the format knows.
class Walk {
 public:
  Walk(bool windy, std::function<Place(const std::string&, const sdf::ElementPtr&)> place,
       std::function<void(const char*, Place, std::string)> lose)
      : windy_(windy), place_(std::move(place)), lose_(std::move(lose)) {}

  void below(const sdf::ElementPtr& element, const std::string& path, int line) const {
    if (element->LineNumber()) line = *element->LineNumber();
    check_attributes(element, line);
    for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement()) {
      // What an included model has in place of its <include>, which the library keeps beside it.
      if (const sdf::ElementPtr include = child->GetIncludeElement()) below(include, "include", line);
      if (!child->GetExplicitlySetInFile()) continue;
      const std::string& name = child->GetName();
      const Path at = path_of(path, name);
      const ElementRow* row = row_of(at.row, element->HasElementDescription(name));
      if (row && row->use == Use::read) {
        below(child, at.below, line);
      } else if (!row) {
        const bool moves = std::ranges::find(moving_elements, name) != std::end(moving_elements);
        lose_(moves ? "unread" : "custom", where(element, child, line), "<" + name + ">");
      } else if (row->use == Use::lost && row->holds(*child, windy_)) {
        lose_(row->what, where(element, child, line), "<" + name + ">");
      }
    }
  }

 private:
  Place where(const sdf::ElementPtr& element, const sdf::ElementPtr& child, int line) const {
    Place where = place_(child->GetName(), child);
    if (where.line == 0) where.line = line;  // the library tells none of what it does not know
    where.element = "<" + child->GetName() + "> of " + element->GetName();
    if (element->HasAttribute("name"))
      where.element += " '" + element->GetAttribute("name")->GetAsString() + "'";
    return where;
  }

  void check_attributes(const sdf::ElementPtr& element, int line) const {
    for (std::size_t i = 0; i < element->GetAttributeCount(); ++i) {
      const sdf::ParamPtr attribute = element->GetAttribute(static_cast<unsigned>(i));
      if (!attribute->GetSet()) continue;
      const std::string_view what = loss_of(*element, *attribute);
      if (what.empty()) continue;
      Place where = place_(element->GetName(), element);
      if (where.line == 0) where.line = line;
      where.element = "attribute '" + attribute->GetKey() + "' of <" + element->GetName() + ">";
      lose_(std::string(what).c_str(), where, "");
    }
  }

  bool windy_;
  std::function<Place(const std::string&, const sdf::ElementPtr&)> place_;
  std::function<void(const char*, Place, std::string)> lose_;
};

}  // namespace

void SdfReader::check_elements(const sdf::ElementPtr& element, int line) {
  refuse_words(element, line);
  const Walk walk(
      windy_,
      [this](const std::string& name, const sdf::ElementPtr& at) { return place("element", name, at); },
      [this](const char* what, Place where, std::string detail) {
        lose(what, std::move(where), std::move(detail));
      });
  walk.below(element, "sdf", line);
}

// The tree has no attribute that the format does not know: the library warns of it.
void SdfReader::check_warnings(sdf::ParserConfig config) {
  config.SetWarningsPolicy(sdf::EnforcementPolicy::ERR);
  config.SetUnrecognizedElementsPolicy(sdf::EnforcementPolicy::LOG);  // check_elements tells them
  sdf::Root root;
  for (const sdf::Error& error : root.Load(file_, config)) {
    Place where{"", error.FilePath() ? other_file(*error.FilePath()) : "", error.LineNumber().value_or(0)};
    // "XML Attribute[auto] in element[inertial] not defined in SDF."; the path ends in [@auto="true"].
    std::smatch words;
    const std::string text = error.Message(), path = error.XmlPath().value_or("");
    if (!std::regex_search(text, words, std::regex(R"(XML Attribute\[([^\]]*)\] in element\[([^\]]*)\])"))) {
      where.element = "model";
      lose("warning", std::move(where), text.substr(0, text.find('\n')));
      continue;
    }
    const std::string attribute = words[1], element = words[2];
    where.element.assign("attribute '").append(attribute).append("' of <").append(element).append(">");
    // Of SDFormat 1.11: the inertia follows from the shapes.
    const bool is_auto = element == "inertial" && attribute == "auto" && !path.ends_with("=\"false\"]") &&
                         !path.ends_with("=\"0\"]");
    lose(is_auto ? "unread" : "custom", std::move(where));
  }
}

}  // namespace cylon::formats
