#include "harness/core/input_error.h"
#include "harness/core/joint_coordinates.h"
#include "harness/imports/losses.h"
#include "harness/imports/steps.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>

namespace cylon::imports {
namespace {

using core::JointType;
using foreign::Freedom;
using foreign::Joint;
using foreign::Model;

constexpr double square = 1e-9;  // how far from a right angle, or from parallel, axes may be [rad]

bool at_right_angles(const Freedom& a, const Freedom& b) { return std::abs(a.axis.dot(b.axis)) < square; }

bool acts(const Freedom& f) {
  return f.lower || f.upper || f.stiffness != 0 || f.damping != 0 || f.friction != 0 || f.force != 0;
}

using Freedoms = std::vector<Freedom>;

bool parallel(const Freedom& a, const Freedom& b) { return a.axis.cross(b.axis).norm() < square; }

// Three hinges, the middle one at right angles to the others, leave every turn, but for those that they cannot pass (the
// first and the third parallel).  Where they start so, two are left.
bool leaves_every_turn(std::span<const Freedom> f) {
  return at_right_angles(f[0], f[1]) && at_right_angles(f[1], f[2]) && !parallel(f[0], f[2]) &&
         std::ranges::none_of(f, acts);
}

bool leaves_every_place(std::span<const Freedom> f) {
  return std::abs(f[0].axis.cross(f[1].axis).dot(f[2].axis)) > square && std::ranges::none_of(f, acts);
}

// Which joint of a scene leaves the same motions, and which of them gives it its axes.
struct Row {
  std::string_view motions;       ///< From `to` to `body`.
  std::optional<JointType> type;  ///< None: the bodies are free of each other.
  int axis = -1, axis_2 = -1;     ///< Of which freedom; -1: none.
  bool (*fits)(const Freedoms&) = nullptr;
  bool apart = false;  ///< The axes of its two turns do not meet.
};

constexpr auto square_axes = [](const Freedoms& f) { return at_right_angles(f[0], f[1]); };
constexpr auto one_line = [](const Freedoms& f) { return parallel(f[0], f[1]); };
// The hinge turns in the plane of the sliders, which come first: their axes are fixed in `to`.
constexpr auto one_plane = [](const Freedoms& f) {
  return at_right_angles(f[0], f[1]) && at_right_angles(f[0], f[2]) && at_right_angles(f[1], f[2]);
};
constexpr auto every_turn = [](const Freedoms& f) {
  return leaves_every_turn(f) && std::ranges::all_of(f, [](const Freedom& one) { return one.armature == 0; });
};
constexpr auto gimbal_axes = [](const Freedoms& f) {
  return at_right_angles(f[0], f[1]) && at_right_angles(f[1], f[2]) && !parallel(f[0], f[2]);
};
constexpr auto every_motion = [](const Freedoms& f) {
  const std::span all(f);
  return leaves_every_place(all.first(3)) && (f[3].kind == "ball" || leaves_every_turn(all.last(3)));
};

constexpr std::array rows = {
    Row{"", JointType::fixed},
    Row{"ball", JointType::ball},
    Row{"turn", JointType::hinge, 0},
    Row{"slide", JointType::slider, 0},
    Row{"screw", JointType::screw, 0},
    Row{"slide turn", JointType::cylindrical, 0, -1, one_line},
    Row{"turn slide", JointType::cylindrical, 0, -1, one_line},
    Row{"turn turn", JointType::universal, 0, 1, square_axes},
    Row{"turn turn", JointType::offset_universal, 0, 1, square_axes, true},
    Row{"slide slide", JointType::rectangular, -1, 0, square_axes},
    Row{"slide slide turn", JointType::planar, 2, 0, one_plane},
    Row{"turn turn turn", JointType::ball, -1, -1, every_turn},
    Row{"turn turn turn", JointType::gimbal, 0, 2, gimbal_axes},
    Row{"slide slide slide ball", std::nullopt, -1, -1, every_motion},
    Row{"slide slide slide turn turn turn", std::nullopt, -1, -1, every_motion},
};

std::string motions_of(const Joint& joint) {
  std::vector<std::string> words;
  for (const Freedom& freedom : joint.freedoms) words.push_back(freedom.kind);
  return fmt::format("{}", fmt::join(words, " "));
}

// What acts along a freedom, on the coordinate that the scene counts along `axis`.
template <class Coordinate>
void add_coordinate(const Freedom& f, core::Ordinal which, const core::Vector3& axis,
                    std::vector<Coordinate>& to) {
  if (!acts(f) && f.armature == 0) return;
  Coordinate& c = to.emplace_back();
  c.which = which;
  c.start = f.start, c.lower = f.lower, c.upper = f.upper;
  c.stiffness = f.stiffness, c.target = f.stiffness != 0 ? f.rest : 0;
  c.damping = f.damping, c.friction = f.friction, c.force = f.force, c.armature = f.armature;
  if (f.axis.dot(axis) < 0) core::reverse(c);
}

void add_coordinates(const Joint& from, core::Joint& joint) {
  const core::Vector3 axis_2 = joint.axis_2.value_or(core::Vector3::Zero()),
                      across = joint.axis.cross(axis_2);
  const bool in_plane = core::kind_of(joint.type).place == core::JointPlace::in_plane;
  const core::Vector3 slides[] = {in_plane ? axis_2 : joint.axis, across};
  using enum core::Ordinal;
  const core::Vector3 turns[] = {joint.axis, axis_2, across};
  // In the order from `to` to `body`: of a gimbal the turn between its axes comes second.
  const std::vector<core::Ordinal> order =
      joint.type == JointType::gimbal ? std::vector{first, third, second} : std::vector{first, second};
  std::size_t slide = 0, turn = 0;
  for (const Freedom& f : from.freedoms) {
    if (f.kind == "slide") {
      add_coordinate(f, slide == 0 ? first : second, slides[slide], joint.displacements);
      ++slide;
    } else if (f.kind != "ball") {
      const core::Ordinal which = order[turn++];
      add_coordinate(f, which, turns[static_cast<std::size_t>(which)], joint.angles);
    }
  }
}

const Row* row_of(const Joint& joint) {
  const std::string motions = motions_of(joint);
  const auto row = std::ranges::find_if(rows, [&](const Row& r) {
    return r.motions == motions && r.apart == (joint.offset != 0) && (!r.fits || r.fits(joint.freedoms));
  });
  return row == rows.end() ? nullptr : &*row;
}

core::InputError error_at(const Joint& joint, const std::string& file, const std::string& why) {
  return {joint.place.file.empty() ? file : joint.place.file,
          static_cast<unsigned>(std::max(joint.place.line, 0)), 0,
          fmt::format("{}: {}", joint.place.element, why)};
}

// Rotors of which no coordinate of the joint is left.
void lose_rotors(const Joint& joint, const core::JointKind* kind, Model& model) {
  if (kind && kind->displacements() + kind->angles() > 0) return;
  for (const Freedom& f : joint.freedoms)
    if (f.armature != 0) model.losses.push_back(lost_armature(f.armature, f.moved, joint.place));
}

// A spring or a damper of a scene gives no energy.
void lose_what_feeds(const Joint& joint, Model& model) {
  for (const Freedom& f : joint.freedoms) {
    if (f.stiffness < 0)
      model.losses.push_back({"joint_spring", joint.place, fmt::format("{}", f.stiffness)});
    if (f.damping < 0) model.losses.push_back({"joint_damping", joint.place, fmt::format("{}", f.damping)});
  }
}

}  // namespace

void check_limits(Model& model, const std::string& file) {
  for (Joint& joint : model.joints) {
    for (const Freedom& f : joint.freedoms)
      if (f.lower && f.upper && *f.lower > *f.upper)
        throw error_at(
            joint, file,
            fmt::format("its limits are {} and {}: the lower must be < the upper", *f.lower, *f.upper));
    std::erase_if(joint.freedoms,
                  [](const Freedom& f) { return f.lower && f.lower == f.upper && *f.lower == f.start; });
  }
}

void check_starts(const Model& model, const std::string& file) {
  for (const Joint& joint : model.joints) {
    if (const Row* row = row_of(joint); !row || !row->type) continue;
    for (const Freedom& f : joint.freedoms) {
      const double lower = f.lower.value_or(-HUGE_VAL), upper = f.upper.value_or(HUGE_VAL);
      if (!(lower <= f.start && f.start <= upper))
        throw error_at(
            joint, file,
            fmt::format("it starts at {}, outside of its limits {} and {}", f.start, lower, upper));
    }
  }
}

void leave_rotors_out(Model& model) {
  for (Joint& joint : model.joints)
    for (Freedom& f : joint.freedoms)
      if (const double inertia = std::exchange(f.armature, 0); inertia != 0)
        model.losses.push_back({"armature", joint.place, fmt::format("{} of {:.3g}", inertia, f.moved)});
}

std::vector<core::Joint> joints_of(Model& model) {
  std::vector<core::Joint> joints;
  const std::vector<Joint> all = model.joints;
  std::set<std::string> taken;
  for (const Joint& joint : all) {
    const Row* row = row_of(joint);
    if (!row) {
      model.losses.push_back({"joint_kind", joint.place, motions_of(joint)});
      continue;
    }
    lose_what_feeds(joint, model);
    lose_rotors(joint, row->type ? &core::kind_of(*row->type) : nullptr, model);
    if (!row->type) continue;
    core::Joint& result = joints.emplace_back();
    result.type = *row->type;
    result.body = joint.body, result.to = joint.to, result.point = joint.point;
    if (const std::string name = legal_name(joint.name); !joint.name.empty() && taken.insert(name).second)
      result.name = name;
    if (result.name != joint.name)
      model.losses.push_back(
          {"name", joint.place, result.name.empty() ? "none here" : fmt::format("'{}' here", result.name)});
    if (row->axis >= 0) result.axis = joint.freedoms[static_cast<std::size_t>(row->axis)].axis;
    if (row->axis_2 >= 0) result.axis_2 = joint.freedoms[static_cast<std::size_t>(row->axis_2)].axis;
    if (result.type == JointType::screw) result.pitch = joint.freedoms.front().pitch;
    if (result.type == JointType::rectangular)
      result.axis = joint.freedoms[0].axis.cross(joint.freedoms[1].axis).normalized();
    if (joint.offset < 0) result.axis = -result.axis;  // a length is positive, towards axis x axis_2
    result.length = std::abs(joint.offset);
    add_coordinates(joint, result);
  }
  return joints;
}

}  // namespace cylon::imports
