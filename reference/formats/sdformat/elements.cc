// The tree of libsdformat against what the reader reads: elements of the format that it leaves out, elements and attributes
// that the format does not know, and numbers with something behind them, of which the library takes the start ("0,5" as 0).
#include "reference/formats/sdformat/reader.h"

#include "reference/formats/resources/gazebo.h"
#include "reference/formats/resources/resources.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <sstream>
#include <string_view>
#include <utility>

namespace cylon::formats {
namespace {

using foreign::Place;

using Holds = bool (*)(const sdf::Element&, bool windy);

constexpr Holds always = [](const sdf::Element&, bool) { return true; };
constexpr Holds nonzero = [](const sdf::Element& e, bool) { return e.Get<double>() != 0; };
constexpr Holds in_wind = [](const sdf::Element& e, bool windy) { return windy && e.Get<bool>(); };

// An element below another, and the kind of loss that it is where it `holds`.
struct Row {
  std::string_view parent, name;
  const char* what;
  Holds holds = always;
};

constexpr std::array rows = {
    // ---- Moves bodies ------------------------------------------------------------------------------------
    Row{"model", "enable_wind", "wind", in_wind},
    Row{"link", "enable_wind", "wind", in_wind},
    Row{"ode", "max_force", "actuator_force", nonzero},
    Row{"axis", "mimic", "mimic"},
    Row{"axis2", "mimic", "mimic"},
    Row{"inertial", "fluid_added_mass", "fluid"},
    Row{"world", "population", "unread"},
    Row{"model", "gripper", "unread"},
    Row{"contact", "category_bitmask", "unread"},
    // ---- Starts elsewhere --------------------------------------------------------------------------------
    Row{"world", "state", "keyframe"},
    Row{"axis", "initial_position", "keyframe", nonzero},
    Row{"axis2", "initial_position", "keyframe", nonzero},
    // ---- How an engine solves ----------------------------------------------------------------------------
    Row{"physics", "ode", "solver"},
    Row{"physics", "bullet", "solver"},
    Row{"physics", "simbody", "solver"},
    Row{"physics", "dart", "solver"},
    Row{"physics", "max_contacts", "solver"},
    Row{"link", "must_be_base_link", "solver"},
    Row{"collision", "max_contacts", "solver"},
    Row{"limit", "stiffness", "solver"},
    Row{"limit", "dissipation", "solver"},
    // ---- Shows or measures -------------------------------------------------------------------------------
    Row{"world", "road", "presentation"},
    Row{"link", "projector", "presentation"},
    Row{"link", "particle_emitter", "presentation"},
    Row{"link", "audio_sink", "presentation"},
    Row{"link", "audio_source", "presentation"},
    Row{"link", "battery", "sensor"},
    Row{"collision", "laser_retro", "sensor"},
};

// What is below these is theirs: no body follows from it, or it has been told as a whole.
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

}  // namespace

void SdfReader::check_elements(const sdf::ElementPtr& element, int line) {
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
  for (sdf::ElementPtr child = element->GetFirstElement(); child; child = child->GetNextElement()) {
    if (!child->GetExplicitlySetInFile()) continue;
    const std::string& name = child->GetName();
    Place where = place("element", name, child);
    if (where.line == 0) where.line = line;  // the library tells none of what it does not know
    where.element = "<" + name + "> of " + element->GetName();
    if (element->HasAttribute("name"))
      where.element += " '" + element->GetAttribute("name")->GetAsString() + "'";
    const auto row = std::ranges::find_if(
        rows, [&](const Row& r) { return r.parent == element->GetName() && r.name == name; });
    const bool is_known = element->HasElementDescription(name);
    if (row != rows.end() ? row->holds(*child, windy_) : !is_known)
      lose(row != rows.end()                                                       ? row->what
           : std::ranges::find(moving_elements, name) != std::end(moving_elements) ? "unread"
                                                                                   : "custom",
           where, "<" + name + ">");
    if (is_known && std::ranges::find(closed, name) == closed.end()) check_elements(child, line);
  }
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
    where.element = "attribute '" + attribute + "' of <" + element + ">";
    // Of SDFormat 1.11: the inertia follows from the shapes.
    const bool is_auto = element == "inertial" && attribute == "auto" && !path.ends_with("=\"false\"]") &&
                         !path.ends_with("=\"0\"]");
    lose(is_auto ? "unread" : "custom", std::move(where));
  }
}

}  // namespace cylon::formats
