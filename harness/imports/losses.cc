#include "harness/imports/losses.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace cylon::imports {
namespace {

using enum Decision;

constexpr std::array kinds = {
    // ---- Shows, measures, or waits for a command ---------------------------------------------------------
    LossKind{"presentation", left_out, "cameras, lights, sites and skins move nothing"},
    LossKind{"visual", left_out, "a surface that touches nothing is not part of a scene"},
    LossKind{"sensor", left_out, "a sensor moves nothing"},
    LossKind{"keyframe", left_out,
             "a scene has one start: the model's own, or by --keyframe that of one keyframe"},
    LossKind{"actuator", left_out, "it exerts no force until it is commanded"},
    LossKind{"tendon", left_out, "it has no force of its own"},
    LossKind{"tendon_limit", left_out, "a scene has no tendons; this one pulls only at an end of its range"},
    LossKind{
        "small_armature", left_out,
        "a scene has rotors on hinges and sliders; this one is on a ball or moves a free body, and is at "
        "most a tenth of what that moves"},
    LossKind{
        "plugin", left_out,
        "a scene holds no code of another engine; this one shows, measures, records, or waits for a command"},
    LossKind{"mocap", left_out, "the body stays where it is: nothing in a scene leads it"},
    LossKind{"effort", left_out, "limits of effort and speed bound a drive, and nothing drives the joint"},
    LossKind{"transmission", left_out, "gears and controllers act when they are commanded"},
    LossKind{"custom", left_out, "an element or attribute that the format does not know"},
    LossKind{"unused", left_out, "the format gives it no effect on a joint of this kind"},
    LossKind{"warning", left_out, "the library of the format warns of it"},
    // ---- How an engine solves ----------------------------------------------------------------------------
    LossKind{"soft_constraints", left_out,
             "contacts, limits and closed loops of MuJoCo yield (solref, solimp); those of a scene do not"},
    LossKind{"soft_surface", left_out,
             "compliance and solver parameters of a contact are an engine's affair"},
    LossKind{"contact_margin", left_out, "surfaces of a scene touch at a gap of zero"},
    LossKind{"limit_margin", left_out, "limits of a scene act at the limit itself"},
    LossKind{"sleep", left_out, "no body of a scene falls asleep"},
    LossKind{"solver", left_out, "solver settings are an engine's affair"},
    LossKind{"other_engine", left_out,
             "it is for engines that are not Gazebo's default, which does not read it"},
    LossKind{"pace", left_out, "a run of a scene follows no clock"},
    // ---- What a scene assumes ----------------------------------------------------------------------------
    LossKind{"assumed", left_out, "the format does not say it"},
    LossKind{"joined_contact", left_out, "bodies that a joint ties do not touch each other in a scene"},
    LossKind{"name", left_out,
             "imported names are unique, are not 'world', which the formats have for themselves, and have no "
             "quotes, commas, * and ?; a joint has one"},
    // ---- Would move otherwise ----------------------------------------------------------------------------
    LossKind{
        "armature", refused,
        "a scene has rotors on hinges and sliders; this one is on a ball or moves a free body, and is more "
        "than a tenth of what that moves"},
    LossKind{"actuator_force", refused, "it acts without a command, and a scene has no such force"},
    LossKind{"actuator_state", refused, "a scene has no actuator with a state of its own"},
    LossKind{"tendon_force", refused, "a scene has no tendons"},
    LossKind{"equality", refused, "a scene couples no joints"},
    LossKind{"mimic", refused, "a scene couples no joints"},
    LossKind{"joint_kind", refused, "a scene has no such joint"},
    LossKind{"joint_limit", refused, "a scene limits one coordinate, not a cone"},
    LossKind{"joint_spring", refused,
             "a spring of a scene is linear, is on one coordinate, and gives no energy"},
    LossKind{"joint_damping", refused,
             "a damper of a scene is linear, is on one coordinate, and takes energy"},
    LossKind{"joint_friction", refused, "a scene has dry friction along one coordinate"},
    LossKind{"part_gravity", refused, "all parts of one body have the same gravity"},
    LossKind{"free_drag", refused, "drag of a scene acts at the centre of mass"},
    LossKind{"shape", refused, "a scene has no such surface"},
    LossKind{"surfaces", refused, "all surfaces of one body have one friction and touch the same others"},
    LossKind{"contact_pair", refused, "a scene has no contacts of single pairs of surfaces"},
    LossKind{"torsional_friction", refused, "a scene has no torsional and rolling friction"},
    LossKind{"anisotropic_friction", refused, "friction of a scene is the same in all directions"},
    LossKind{"fluid", refused, "a scene has no forces of such a medium"},
    LossKind{"wind", refused, "a scene has no wind"},
    LossKind{"soft_body", refused, "bodies of a scene are rigid"},
    LossKind{"plugin_force", refused,
             "a scene holds no code of another engine, and this one is not known to leave bodies alone"},
    LossKind{"actor", refused, "a scene has no bodies that follow a script"},
    LossKind{"surface_velocity", refused, "a scene has no surface that conveys"},
    LossKind{"unread", refused, "it changes the motion, and this import does not read it"},
    LossKind{"too_large", refused, "more than an import takes"},
};

std::string shown(const foreign::Place& place, const std::string& file) {
  std::string text = place.file.empty() ? file : place.file;
  if (place.line > 0) text += fmt::format(":{}", place.line);
  return text + ": " + place.element;
}

}  // namespace

std::span<const LossKind> loss_kinds() { return kinds; }

const LossKind& loss_kind(std::string_view what) {
  const auto row = std::ranges::find(kinds, what, &LossKind::what);
  if (row != kinds.end()) return *row;
  std::vector<std::string> words;
  for (const LossKind& kind : kinds) words.emplace_back(kind.what);
  throw std::invalid_argument(
      fmt::format("'{}' is no kind of loss{}", what, core::did_you_mean(what, words)));
}

foreign::Loss lost_armature(double inertia, double whole, const foreign::Place& place) {
  constexpr double small = 0.1;
  return {inertia <= small * whole ? "small_armature" : "armature", place,
          fmt::format("{} of {:.3g}", inertia, whole)};
}

std::string text_of(const foreign::Loss& loss, const std::string& file) {
  return fmt::format("{}: {}{}: {}", shown(loss.place, file), loss.what,
                     loss.detail.empty() ? "" : " (" + loss.detail + ")", loss_kind(loss.what).why);
}

std::vector<std::string> texts_of(std::span<const foreign::Loss> losses, const std::string& file) {
  std::map<std::pair<std::string, std::string>, std::size_t> counts;
  for (const foreign::Loss& loss : losses) ++counts[{loss.what, loss.detail}];
  std::vector<std::string> texts;
  for (const foreign::Loss& loss : losses) {
    const auto found = counts.find({loss.what, loss.detail});
    if (found == counts.end()) continue;  // told already
    foreign::Loss told = loss;
    if (found->second > 1) told.place.element += fmt::format(" and {} more", found->second - 1);
    counts.erase(found);
    texts.push_back(text_of(told, file));
  }
  return texts;
}

}  // namespace cylon::imports
