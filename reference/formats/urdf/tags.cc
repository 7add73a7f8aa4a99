#include "reference/formats/urdf/tags.h"

#include "reference/formats/resources/gazebo.h"
#include "reference/formats/resources/resources.h"

#include <tinyxml.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
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
    Row{"inertial", "origin", ""},
    Row{"inertial", "mass", ""},
    Row{"inertial", "inertia", ""},
    Row{"collision", "origin", ""},
    Row{"collision", "geometry", ""},
    Row{"geometry", "box", ""},
    Row{"geometry", "sphere", ""},
    Row{"geometry", "cylinder", ""},
    Row{"geometry", "mesh", ""},
    Row{"gazebo", "sensor", "sensor"},
    // What Gazebo takes from there into the motion, beside moving_elements.
    Row{"gazebo", "turnGravityOff", "unread"},
    Row{"gazebo", "dampingFactor", "unread"},
    Row{"gazebo", "springStiffness", "unread"},
    Row{"gazebo", "springReference", "unread"},
    Row{"gazebo", "initial_joint_position", "unread"},
    Row{"gazebo", "gravity_compensation", "unread"},
};

// The attributes that the format knows of what the reader reads (http://wiki.ros.org/urdf/XML).
struct Attributes {
  std::string_view element;
  std::array<std::string_view, 6> names;
};
constexpr std::array known = {
    Attributes{"robot", {"name", "version"}},
    Attributes{"link", {"name", "type"}},
    Attributes{"joint", {"name", "type"}},
    Attributes{"parent", {"link"}},
    Attributes{"child", {"link"}},
    Attributes{"origin", {"xyz", "rpy"}},
    Attributes{"axis", {"xyz"}},
    Attributes{"limit", {"lower", "upper", "effort", "velocity"}},
    Attributes{"dynamics", {"damping", "friction"}},
    Attributes{"mimic", {"joint", "multiplier", "offset"}},
    Attributes{"safety_controller", {"soft_lower_limit", "soft_upper_limit", "k_position", "k_velocity"}},
    Attributes{"inertial", {}},
    Attributes{"mass", {"value"}},
    Attributes{"inertia", {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}},
    Attributes{"collision", {"name", "group"}},
    Attributes{"geometry", {}},
    Attributes{"box", {"size"}},
    Attributes{"sphere", {"radius"}},
    Attributes{"cylinder", {"radius", "length"}},
    Attributes{"mesh", {"filename", "scale"}},
};

// What is below these is theirs, and is drawn.
constexpr std::array<std::string_view, 2> drawn = {"material", "visual"};

// "link 'arm'", "gazebo of 'arm'", "<bogus>".
std::string shown(const TiXmlElement& element) {
  const std::string kind = element.Value();
  if (const char* name = element.Attribute("name")) return kind + " '" + name + "'";
  if (const char* name = element.Attribute("reference")) return kind + " of '" + name + "'";
  return "<" + kind + ">";
}

bool has_no_axis(const TiXmlElement& joint) {
  const char* type = joint.Attribute("type");
  return type && (std::string_view(type) == "fixed" || std::string_view(type) == "floating");
}

class Walk {
 public:
  explicit Walk(Tags& tags) : tags_(tags) {}

  void whole(const TiXmlElement& robot) {
    check_attributes(robot, "");
    below(robot);
  }

 private:
  void below(const TiXmlElement& parent) {
    for (const TiXmlElement* e = parent.FirstChildElement(); e; e = e->NextSiblingElement()) take(parent, *e);
  }

  // Namespaces say nothing of the robot.
  void check_attributes(const TiXmlElement& element, const std::string& of) {
    const auto row = std::ranges::find(known, element.Value(), &Attributes::element);
    if (row == known.end()) return;
    for (const TiXmlAttribute* a = element.FirstAttribute(); a; a = a->Next()) {
      const std::string_view name = a->Name();
      if (std::ranges::find(row->names, name) != row->names.end() || name.starts_with("xmlns")) continue;
      // quat_xyzw is of URDF 1.1, and an orientation.
      lose(name == "quat_xyzw" ? "unread" : "custom", element, "attribute '" + std::string(name) + "'" + of);
    }
  }

  // "Defaults to 0 if not specified": a hinge with an effort alone does not turn.
  void check_bounds(const TiXmlElement& limit, const TiXmlElement& joint, const std::string& of) {
    const char* type = joint.Attribute("type");
    if (!type || (std::string_view(type) != "revolute" && std::string_view(type) != "prismatic")) return;
    for (const char* bound : {"lower", "upper"})
      if (!limit.Attribute(bound)) lose("assumed", limit, std::string(bound) + " = 0" + of);
  }

  void lose(const char* what, const TiXmlElement& element, std::string detail) {
    tags_.losses.push_back({what, {shown(element), "", element.Row()}, std::move(detail)});
  }

  void judge_plugin(const TiXmlElement& plugin) {
    const char *library = plugin.Attribute("filename"), *own = plugin.Attribute("name");
    const bool alone = leaves_bodies_alone(library ? library : "", own ? own : "");
    lose(alone ? "plugin" : "plugin_force", plugin, "");
  }

  // Of what is not walked, as a sensor: its plugins run in the server, where they reach all bodies.
  void judge_plugins_below(const TiXmlElement& element) {
    for (const TiXmlElement* e = element.FirstChildElement(); e; e = e->NextSiblingElement())
      if (std::string_view(e->Value()) == "plugin")
        judge_plugin(*e);
      else
        judge_plugins_below(*e);
  }

  void take(const TiXmlElement& parent, const TiXmlElement& element) {
    const std::string in = parent.Value(), name = element.Value();
    const std::string of = in == "robot" ? "" : " of " + shown(parent);
    if (name == "gazebo") return below(element);
    if (name == "plugin") return judge_plugin(element);
    for (const Row& row : rows) {
      if (row.parent != in || row.name != name) continue;
      if (name == "axis" && has_no_axis(parent)) lose("unused", element, "<axis>" + of);
      if (*row.what) lose(row.what, element, std::string("<").append(name).append(">").append(of));
      if (name == "inertial" && parent.Attribute("name"))
        tags_.inertials[parent.Attribute("name")] = element.Row();
      if (!*row.what) check_attributes(element, of);
      if (name == "limit") check_bounds(element, parent, of);
      if (!*row.what && std::ranges::find(drawn, name) == drawn.end())
        below(element);
      else
        judge_plugins_below(element);
      return;
    }
    lose(moves(name) ? "unread" : "custom", element, "<" + name + ">" + of);
    judge_plugins_below(element);
  }

  // Where it stands it is not read: of Gazebo, in a wrong place, or a macro from which links and joints would come.
  static bool moves(std::string_view name) {
    return std::ranges::find(moving_elements, name) != std::end(moving_elements) || name == "mimic" ||
           name == "origin" || name.starts_with("xacro:");
  }

  Tags& tags_;
};

}  // namespace

Tags tags_of(const std::string& file) {
  Tags tags;
  TiXmlDocument document;
  if (document.LoadFile(file.c_str()) && document.RootElement()) Walk(tags).whole(*document.RootElement());
  return tags;
}

void require_tree(const std::string& file) {
  TiXmlDocument document;
  if (!document.LoadFile(file.c_str()) || !document.RootElement()) return;  // urdfdom says why
  struct Up {
    std::string parent;
    const TiXmlElement* joint;
  };
  std::map<std::string, Up> up;  // from a link
  const auto link_of = [](const TiXmlElement& joint, const char* end) -> std::string {
    const TiXmlElement* element = joint.FirstChildElement(end);
    const char* link = element ? element->Attribute("link") : nullptr;
    return link ? link : "";
  };
  for (const TiXmlElement* joint = document.RootElement()->FirstChildElement("joint"); joint;
       joint = joint->NextSiblingElement("joint")) {
    const std::string child = link_of(*joint, "child");
    const auto [first, is_new] = up.try_emplace(child, Up{link_of(*joint, "parent"), joint});
    if (!is_new && !child.empty())  // urdfdom would make two links of it, and lose the first joint
      throw Refused("line " + std::to_string(joint->Row()) + ": " + shown(*joint) + ": link '" + child +
                    "' is the child of " + shown(*first->second.joint) + " already");
  }
  std::set<std::string> rooted;  // links that are known not to hang on themselves
  for (const auto& [first, ignored] : up) {
    std::set<std::string> below;
    for (std::string link = first; up.contains(link) && !rooted.contains(link); link = up.at(link).parent)
      if (!below.insert(link).second) {
        const Up& joint = up.at(link);
        throw Refused("line " + std::to_string(joint.joint->Row()) + ": " + shown(*joint.joint) + ": link '" +
                      link + "' hangs on itself" +
                      (joint.parent == link ? "" : ", through link '" + joint.parent + "'"));
      }
    rooted.merge(below);
  }
}

}  // namespace cylon::formats
