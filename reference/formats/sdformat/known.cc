#include "reference/formats/sdformat/known.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

namespace cylon::formats {
namespace {

// Whether all words of two values are the same numbers, or else the same text: "0.20" is 0.2, and "true" is 1.
bool is_same(const std::string& a, const std::string& b) {
  const auto plain = [](const std::string& word) -> std::string {
    return word == "true" ? "1" : word == "false" ? "0" : word;
  };
  std::istringstream left(a), right(b);
  std::string x, y;
  while (left >> x) {
    if (!(right >> y)) return false;
    x = plain(x), y = plain(y);
    char *end_x = nullptr, *end_y = nullptr;
    const double number_x = std::strtod(x.c_str(), &end_x), number_y = std::strtod(y.c_str(), &end_y);
    if (*end_x == '\0' && *end_y == '\0' ? number_x != number_y : x != y) return false;
  }
  return !(right >> y);
}

using Holds = bool (*)(const sdf::Element&, bool windy);

constexpr Holds always = [](const sdf::Element&, bool) { return true; };
// Another value than that of a file without the element; one without a value, as it holds others, always.
constexpr Holds differs = [](const sdf::Element& e, bool) {
  const sdf::ParamPtr value = e.GetValue();
  return !value || !is_same(value->GetAsString(), value->GetDefaultAsString());
};
constexpr Holds nonzero = [](const sdf::Element& e, bool) {
  std::istringstream words(e.GetValue() ? e.GetValue()->GetAsString() : "");
  for (std::string word; words >> word;)
    if (std::strtod(word.c_str(), nullptr) != 0) return true;
  return false;
};
constexpr Holds is_true = [](const sdf::Element& e, bool) { return e.Get<bool>(); };
constexpr Holds in_wind = [](const sdf::Element& e, bool windy) { return windy && e.Get<bool>(); };
// Speeds below which nothing bounces: a scene has none, which is a threshold of zero.
constexpr Holds threshold = [](const sdf::Element& e, bool windy) {
  return nonzero(e, windy) && differs(e, windy);
};
// What is for gears and screws is told with the joint that is one.
constexpr Holds without_gears = [](const sdf::Element& e, bool windy) {
  const sdf::ElementPtr joint = e.GetParent();
  const auto type = joint ? joint->Get<std::string>("type") : "";
  return type != "gearbox" && type != "screw" && differs(e, windy);
};

using enum Use;
using Row = ElementRow;

constexpr std::array rows = {
    Row{"sdf/world"},
    Row{"sdf/model"},
    Row{"sdf/actor", lost, "actor", always},
    Row{"sdf/light", lost, "presentation", always},
    // ---- World -------------------------------------------------------------------------------------------
    Row{"world/audio", lost, "presentation", always},
    Row{"world/wind"},
    Row{"world/wind/linear_velocity"},
    Row{"world/include"},
    Row{"world/gravity"},
    Row{"world/magnetic_field", lost, "sensor", differs},
    Row{"world/atmosphere"},
    Row{"world/atmosphere/temperature", lost, "sensor", differs},
    Row{"world/atmosphere/pressure", lost, "sensor", differs},
    Row{"world/atmosphere/temperature_gradient", lost, "sensor", differs},
    Row{"world/gui", lost, "presentation", always},
    Row{"world/scene", lost, "presentation", always},
    Row{"world/physics"},
    Row{"world/physics/max_step_size"},
    Row{"world/physics/real_time_factor", lost, "pace", differs},
    Row{"world/physics/real_time_update_rate", lost, "pace", differs},
    Row{"world/physics/max_contacts", lost, "solver", differs},
    Row{"world/physics/dart", lost, "solver", always},
    Row{"world/physics/simbody", lost, "solver", always},
    Row{"world/physics/bullet", lost, "solver", always},
    Row{"world/physics/ode", lost, "solver", always},
    Row{"world/light", told},
    Row{"world/frame"},
    Row{"world/frame/pose"},
    Row{"world/model"},
    Row{"world/actor", told},
    Row{"world/plugin", told},
    Row{"world/road", lost, "presentation", always},
    Row{"world/spherical_coordinates", lost, "sensor", always},
    Row{"world/state", lost, "keyframe", always},
    Row{"world/population", lost, "unread", always},
    // ---- Model -------------------------------------------------------------------------------------------
    Row{"model/static"},
    Row{"model/self_collide"},
    // `false` is what a scene does.
    Row{"model/allow_auto_disable", lost, "sleep", is_true},
    Row{"model/frame"},
    Row{"model/frame/pose"},
    Row{"model/pose"},
    Row{"model/link"},
    Row{"model/joint"},
    Row{"model/plugin", told},
    Row{"model/gripper", lost, "unread", always},
    Row{"model/include"},
    Row{"model/model"},
    Row{"model/enable_wind", lost, "wind", in_wind},
    Row{"include/uri"},
    Row{"include/name"},
    Row{"include/static"},
    Row{"include/pose"},
    Row{"include/placement_frame"},
    Row{"include/plugin", told},
    // ---- Link --------------------------------------------------------------------------------------------
    Row{"link/gravity"},
    Row{"link/enable_wind", lost, "wind", in_wind},
    Row{"link/self_collide"},
    Row{"link/kinematic"},
    Row{"link/must_be_base_link", lost, "solver", differs},
    Row{"link/velocity_decay"},
    Row{"link/velocity_decay/linear"},
    Row{"link/velocity_decay/angular"},
    Row{"link/pose"},
    Row{"link/inertial"},
    Row{"link/collision"},
    Row{"link/visual", told},
    Row{"link/sensor", told},
    Row{"link/projector", lost, "presentation", always},
    Row{"link/audio_sink", lost, "presentation", always},
    Row{"link/audio_source", lost, "presentation", always},
    Row{"link/battery", lost, "sensor", always},
    Row{"link/light", told},
    Row{"link/particle_emitter", lost, "presentation", always},
    Row{"inertial/mass"},
    Row{"inertial/pose"},
    Row{"inertial/inertia"},
    Row{"inertial/inertia/ixx"},
    Row{"inertial/inertia/ixy"},
    Row{"inertial/inertia/ixz"},
    Row{"inertial/inertia/iyy"},
    Row{"inertial/inertia/iyz"},
    Row{"inertial/inertia/izz"},
    // ---- Joint -------------------------------------------------------------------------------------------
    Row{"joint/parent"},
    Row{"joint/child"},
    Row{"joint/pose"},
    Row{"joint/sensor", told},
    Row{"joint/gearbox_ratio", lost, "unused", without_gears},
    Row{"joint/gearbox_reference_body", lost, "unused", without_gears},
    Row{"joint/thread_pitch", lost, "unused", without_gears},
    Row{"joint/axis"},
    Row{"axis/xyz"},
    Row{"axis/dynamics"},
    Row{"axis/dynamics/damping"},
    Row{"axis/dynamics/friction"},
    Row{"axis/dynamics/spring_reference"},
    Row{"axis/dynamics/spring_stiffness"},
    Row{"axis/limit"},
    Row{"axis/limit/lower"},
    Row{"axis/limit/upper"},
    Row{"axis/limit/effort"},
    Row{"axis/limit/velocity"},
    Row{"axis/limit/stiffness", lost, "solver", differs},
    Row{"axis/limit/dissipation", lost, "solver", differs},
    Row{"joint/physics"},
    Row{"joint/physics/provide_feedback", lost, "sensor", differs},
    Row{"joint/physics/simbody"},
    Row{"joint/physics/simbody/must_be_loop_joint", lost, "solver", differs},
    Row{"joint/physics/ode"},
    Row{"joint/physics/ode/cfm_damping", lost, "solver", differs},
    Row{"joint/physics/ode/implicit_spring_damper", lost, "solver", differs},
    Row{"joint/physics/ode/fudge_factor", lost, "solver", differs},
    Row{"joint/physics/ode/cfm", lost, "solver", differs},
    Row{"joint/physics/ode/erp", lost, "solver", differs},
    Row{"joint/physics/ode/bounce", lost, "other_engine", differs},
    Row{"joint/physics/ode/max_force", lost, "actuator_force", differs},
    Row{"joint/physics/ode/velocity", lost, "other_engine", differs},
    Row{"joint/physics/ode/limit"},
    Row{"joint/physics/ode/limit/cfm", lost, "solver", differs},
    Row{"joint/physics/ode/limit/erp", lost, "solver", differs},
    Row{"joint/physics/ode/suspension"},
    Row{"joint/physics/ode/suspension/cfm", lost, "other_engine", differs},
    Row{"joint/physics/ode/suspension/erp", lost, "other_engine", differs},
    // ---- Collision ---------------------------------------------------------------------------------------
    Row{"collision/laser_retro", lost, "sensor", differs},
    Row{"collision/max_contacts", lost, "solver", differs},
    Row{"collision/pose"},
    Row{"collision/geometry"},
    Row{"collision/geometry/empty"},
    Row{"collision/geometry/box"},
    Row{"collision/geometry/box/size"},
    Row{"collision/geometry/capsule"},
    Row{"collision/geometry/capsule/radius"},
    Row{"collision/geometry/capsule/length"},
    Row{"collision/geometry/cylinder"},
    Row{"collision/geometry/cylinder/radius"},
    Row{"collision/geometry/cylinder/length"},
    Row{"collision/geometry/ellipsoid"},
    Row{"collision/geometry/ellipsoid/radii"},
    Row{"collision/geometry/mesh"},
    Row{"collision/geometry/mesh/uri"},
    Row{"collision/geometry/mesh/submesh", told},
    Row{"collision/geometry/mesh/scale"},
    Row{"collision/geometry/plane"},
    Row{"collision/geometry/plane/normal"},
    Row{"collision/geometry/plane/size"},  // what is drawn of a plane without end
    Row{"collision/geometry/sphere"},
    Row{"collision/geometry/sphere/radius"},
    Row{"collision/geometry/heightmap", told},
    Row{"collision/geometry/image", told},
    Row{"collision/geometry/polyline", told},
    Row{"collision/surface"},
    // ---- Surface: DART reads what is below friction/ode, whatever the engine is called ----------------------
    Row{"surface/bounce"},
    Row{"surface/bounce/restitution_coefficient"},
    Row{"surface/bounce/threshold", lost, "other_engine", threshold},
    Row{"surface/friction"},
    Row{"surface/friction/torsional"},  // told where its coefficient is not zero
    Row{"surface/friction/torsional/coefficient", told},
    Row{"surface/friction/torsional/use_patch_radius", told},
    Row{"surface/friction/torsional/patch_radius", told},
    Row{"surface/friction/torsional/surface_radius", told},
    Row{"surface/friction/torsional/ode"},
    Row{"surface/friction/torsional/ode/slip", told},
    Row{"surface/friction/ode"},
    Row{"surface/friction/ode/mu"},
    Row{"surface/friction/ode/mu2"},
    // Two directions of one friction: those of a pyramid that stands for its cone.
    Row{"surface/friction/ode/fdir1", lost, "soft_surface", nonzero},
    Row{"surface/friction/ode/slip1"},
    Row{"surface/friction/ode/slip2"},
    Row{"surface/friction/bullet"},
    Row{"surface/friction/bullet/friction", told},
    Row{"surface/friction/bullet/friction2", told},
    Row{"surface/friction/bullet/fdir1", lost, "other_engine", nonzero},
    Row{"surface/friction/bullet/rolling_friction", lost, "other_engine", nonzero},
    Row{"surface/contact"},
    Row{"surface/contact/collide_without_contact", told},
    Row{"surface/contact/collide_without_contact_bitmask", lost, "sensor", differs},
    Row{"surface/contact/collide_bitmask"},
    Row{"surface/contact/category_bitmask", lost, "unread", always},
    Row{"surface/contact/poissons_ratio", lost, "soft_surface", differs},
    Row{"surface/contact/elastic_modulus", lost, "soft_surface", differs},
    Row{"surface/contact/ode", told},
    Row{"surface/contact/bullet", told},
    Row{"surface/soft_contact", told},
};

// Of releases before or after that of the library, which does not know them.
constexpr std::array rows_of_others = {
    Row{"axis/initial_position", lost, "keyframe", nonzero},
    Row{"axis/mimic", lost, "mimic", always},
    Row{"inertial/fluid_added_mass", lost, "fluid", always},
    Row{"collision/geometry/cone", lost, "shape", always},
};

constexpr Row without_row{"", lost, "unread", differs};
constexpr Row unknown_shape{"", lost, "unread", always};

constexpr std::array<std::string_view, 9> anchors = {"include", "world",    "model",     "link",   "joint",
                                                     "axis",    "inertial", "collision", "surface"};

// Where a physics engine that the file names does not matter.
constexpr auto any_engine = [](const sdf::Param& type) { return type.GetAsString() == "ignored"; };
constexpr auto never = [](const sdf::Param&) { return false; };

struct AttributeRow {
  std::string_view element, name;  ///< "" of all elements.
  std::string_view what = {};      ///< "" where it is read, else the loss where it differs.
  bool (*is_plain)(const sdf::Param&) = never;
};

constexpr std::array attributes = {
    AttributeRow{"", "name"},
    AttributeRow{"", "relative_to"},
    AttributeRow{"", "rotation_format"},
    AttributeRow{"", "degrees"},
    AttributeRow{"", "expressed_in"},
    AttributeRow{"", "attached_to"},
    AttributeRow{"sdf", "version"},
    AttributeRow{"model", "canonical_link"},  // where frames of others count from: the library does
    AttributeRow{"model", "placement_frame"},
    AttributeRow{"include", "merge"},
    AttributeRow{"joint", "type"},
    AttributeRow{"physics", "default"},
    AttributeRow{"physics", "type", "solver", any_engine},
    AttributeRow{"atmosphere", "type", "sensor"},
};

const AttributeRow* attribute_row(const std::string& element, const std::string& name) {
  const auto row = std::ranges::find_if(attributes, [&](const AttributeRow& r) {
    return (r.element.empty() || r.element == element) && r.name == name;
  });
  return row == attributes.end() ? nullptr : &*row;
}

template <class Rows>
const Row* find(const Rows& table, std::string_view path) {
  const auto row = std::ranges::find(table, path, &Row::path);
  return row == std::end(table) ? nullptr : &*row;
}

std::string text_of(const Row* row) {
  if (!row) return "no row";
  return row->use == read ? "read" : row->use == told ? "told" : std::string("lost ") + row->what;
}

// The lines of all that the format knows below an element; `seen`: the rows that were met.
void list_below(const sdf::ElementPtr& element, const std::string& path, std::set<std::string>& seen,
                std::string& lines) {
  for (std::size_t i = 0; i < element->GetAttributeCount(); ++i) {
    const sdf::ParamPtr attribute = element->GetAttribute(static_cast<unsigned>(i));
    const AttributeRow* row = attribute_row(element->GetName(), attribute->GetKey());
    const std::string use = !row ? "no row" : row->what.empty() ? "read" : "lost " + std::string(row->what);
    lines.append(path).append("@").append(attribute->GetKey()).append(": ").append(use).append("\n");
  }
  for (std::size_t i = 0; i < element->GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = element->GetElementDescription(static_cast<unsigned>(i));
    const Path at = path_of(path, child->GetName());
    if (!seen.insert(at.row).second) continue;  // a model in a model, or <axis2>
    const Row* row = find(rows, at.row);
    lines += at.row + ": " + text_of(row) + "\n";
    if (!row || row->use == read) list_below(child, at.below, seen, lines);
  }
}

}  // namespace

Path path_of(const std::string& parent, const std::string& name) {
  const std::string own = name == "axis2" ? "axis" : name;
  const std::string row = parent + "/" + own;
  return {row, std::ranges::find(anchors, own) != anchors.end() ? own : row};
}

const ElementRow* row_of(std::string_view path, bool is_known) {
  if (const Row* row = find(rows, path)) return row;
  if (const Row* row = find(rows_of_others, path)) return row;
  if (is_known) return &without_row;
  return path.starts_with("collision/geometry/") ? &unknown_shape : nullptr;
}

std::string_view loss_of(const sdf::Element& element, const sdf::Param& attribute) {
  const std::string& name = attribute.GetKey();
  const AttributeRow* row = attribute_row(element.GetName(), name);
  if (name.starts_with("xmlns")) return "";
  if (!row && name.find(':') != std::string::npos) return "custom";  // the library takes any such name
  if ((row && row->what.empty()) || is_same(attribute.GetAsString(), attribute.GetDefaultAsString()))
    return "";
  if (!row) return "unread";
  return row->is_plain(attribute) ? "" : row->what;
}

std::string known_elements() {
  const sdf::SDFPtr format(new sdf::SDF());
  sdf::init(format);
  std::set<std::string> seen;
  std::string lines;
  list_below(format->Root(), "sdf", seen, lines);
  for (const Row& row : rows)
    if (!seen.contains(std::string(row.path))) lines += std::string(row.path) + ": no element\n";
  return lines;
}

}  // namespace cylon::formats
