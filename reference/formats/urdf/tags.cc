#include "reference/formats/urdf/tags.h"

#include "reference/formats/resources/plugins.h"

#include <tinyxml.h>

#include <array>
#include <string_view>
#include <utility>

namespace cylon::formats {
namespace {

// An element below another: "" of what the reader reads, else a kind of loss.
struct Row {
  std::string_view parent, name;
  const char* what;
};

constexpr std::array rows = {
    Row{"robot", "link", ""},
    Row{"robot", "joint", ""},
    Row{"robot", "material", ""},
    Row{"robot", "transmission", "transmission"},
    Row{"robot", "sensor", "sensor"},
    Row{"link", "inertial", ""},
    Row{"link", "visual", ""},
    Row{"link", "collision", ""},
    Row{"joint", "parent", ""},
    Row{"joint", "child", ""},
    Row{"joint", "origin", ""},
    Row{"joint", "axis", ""},
    Row{"joint", "limit", ""},
    Row{"joint", "dynamics", ""},
    Row{"joint", "mimic", ""},
    Row{"joint", "safety_controller", ""},
    Row{"joint", "calibration", "sensor"},
    Row{"gazebo", "sensor", "sensor"},
    // What Gazebo takes from there into the motion.
    Row{"gazebo", "static", "unread"},
    Row{"gazebo", "gravity", "unread"},
    Row{"gazebo", "turnGravityOff", "unread"},
    Row{"gazebo", "dampingFactor", "unread"},
    Row{"gazebo", "springStiffness", "unread"},
    Row{"gazebo", "springReference", "unread"},
    Row{"gazebo", "initial_joint_position", "unread"},
    Row{"gazebo", "gravity_compensation", "unread"},
};

// "link 'arm'", "gazebo of 'arm'", "<bogus>".
std::string shown(const TiXmlElement& element) {
  const std::string kind = element.Value();
  if (const char* name = element.Attribute("name")) return kind + " '" + name + "'";
  if (const char* name = element.Attribute("reference")) return kind + " of '" + name + "'";
  return "<" + kind + ">";
}

class Walk {
 public:
  explicit Walk(Tags& tags) : tags_(tags) {}

  void below(const TiXmlElement& parent) {
    for (const TiXmlElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement()) take(parent, *e);
  }

 private:
  void lose(const char* what, const TiXmlElement& element, std::string detail) {
    tags_.losses.push_back({what, {shown(element), "", element.Row()}, std::move(detail)});
  }

  void take(const TiXmlElement& parent, const TiXmlElement& element) {
    const std::string in = parent.Value(), name = element.Value();
    const std::string of = in == "robot" ? "" : " of " + shown(parent);
    if (name == "gazebo") return below(element);
    if (name == "plugin") {
      const char* library = element.Attribute("filename");
      const bool moves = moves_bodies(shown(element) + " " + (library ? library : ""));
      return lose(moves ? "plugin_force" : "plugin", element, "");
    }
    for (const Row& row : rows) {
      if (row.parent != in || row.name != name) continue;
      if (*row.what) lose(row.what, element, "<" + name + ">" + of);
      if (name == "inertial" && parent.Attribute("name"))
        tags_.inertials[parent.Attribute("name")] = element.Row();
      if (in == "robot" && (name == "link" || name == "joint")) below(element);
      return;
    }
    lose("custom", element, "<" + name + ">" + of);
  }

  Tags& tags_;
};

}  // namespace

Tags tags_of(const std::string& file) {
  Tags tags;
  TiXmlDocument document;
  if (document.LoadFile(file.c_str()) && document.RootElement()) Walk(tags).below(*document.RootElement());
  return tags;
}

}  // namespace cylon::formats
