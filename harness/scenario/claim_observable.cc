#include "harness/scenario/claim_observable.h"

#include "harness/core/event_find.h"
#include "harness/core/fields.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/key_rows.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace cylon::scenario {
namespace {

using core::Observable;
using core::Quantity;

const std::vector<std::string> components = {"", "x", "y", "z", "horizontal"};

const std::vector<std::string> event_kinds = words(core::EventKind::crossing);
const std::vector<std::string> event_quantities = words(core::EventQuantity::count);

bool is_vector(Quantity q) {
  return q == Quantity::position || q == Quantity::velocity || q == Quantity::angular_velocity ||
         q == Quantity::linear_momentum || q == Quantity::angular_momentum || core::of_joint_forces(q);
}
bool is_number(const Observable& q) {
  return q.quantity == Quantity::energy || q.quantity == Quantity::kinetic_energy ||
         (is_vector(q.quantity) && q.component != core::Component::all &&
          q.component != core::Component::horizontal);
}
bool turns(Quantity q) { return is_angle(q) || q == Quantity::angular_velocity; }

bool one_sided(const Table& t) {
  const std::string measure = t.text("measure", "max");
  return measure == core::name(core::Reduction::increase) || measure == core::name(core::Reduction::decrease);
}

Quantity quantity_of(const Table& t, std::string_view key) {
  for (int i = 0; i <= static_cast<int>(Quantity::event); ++i)
    if (core::name(static_cast<Quantity>(i)) == t.text(key)) return static_cast<Quantity>(i);
  t.fail(key, fmt::format("{} = '{}' is unknown", key, t.text(key)));
}

int joint_of(const Table& t, const Draft& draft) {
  const std::string name = t.text("joint");
  const std::vector<core::Joint>& joints = draft.scene.joints;
  const auto found = std::ranges::find(joints, name, &core::Joint::name);
  if (found != joints.end()) return static_cast<int>(found - joints.begin());
  std::vector<std::string> names;
  for (const core::Joint& joint : joints)
    if (!joint.name.empty()) names.push_back(joint.name);
  t.fail("joint",
         fmt::format("no joint is named '{}'{}; named are: {}", name, core::did_you_mean(name, names),
                     names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

// Which event, and which of its numbers.
void read_event(const Table& t, const Draft& draft, Observable& q) {
  q.event = t.choice("event", event_kinds, core::EventKind::bounce);
  const core::EventType& type = core::event_type(q.event);
  q.index = static_cast<int>(t.whole("index", std::max(1, type.first_index)));
  q.event_quantity = t.choice("quantity", event_quantities, core::EventQuantity::time);
  if (t.has("to")) q.to = draft.body(t, "to");
  refuse(t, {"to", "about"}, q.event != core::EventKind::apsis, "belongs to event = \"apsis\"");
  refuse(t, {"about"}, q.to.has_value(), "does not go with 'to'");
  refuse(
      t, {"index"}, core::of_all(q.event_quantity),
      fmt::format("does not go with quantity = \"{}\", which is that of all", core::name(q.event_quantity)));
  if (q.index < type.first_index)
    t.fail("index", fmt::format("index = {}, but the events of kind '{}' count from {}", q.index, type.name,
                                type.first_index));
  if (std::ranges::find(type.quantities, q.event_quantity) == type.quantities.end()) {
    std::vector<std::string_view> valid;
    for (const core::EventQuantity which : type.quantities) valid.push_back(core::name(which));
    t.fail("quantity", fmt::format("quantity = '{}', but event = '{}' has none; valid: {}",
                                   core::name(q.event_quantity), type.name, fmt::join(valid, ", ")));
  }
  if (core::over_periods(q.event, q.event_quantity) && (q.index < 3 || q.index % 2 == 0))
    t.fail(t.has("index") ? "index" : "quantity",
           fmt::format("index = {}: the {} is a mean over whole periods of two, from event 1 to 3, 5, …",
                       q.index, core::name(q.event_quantity)));
}

}  // namespace

bool is_angle(Quantity q) {
  return q == Quantity::orientation || q == Quantity::axis || q == Quantity::angular_joint_gap ||
         q == Quantity::joint_angle;
}

void refuse(const Table& t, std::initializer_list<const char*> keys, bool when, std::string_view why) {
  for (const char* key : keys)
    if (when && t.has(key)) t.fail(key, fmt::format("{} {}", key, why));
}

Observable read_observable(const Table& t, const Draft& draft) {
  if (t.has("follows") + t.has("conserves") + t.has("changes") + t.has("expects") != 1)
    t.fail(
        "[[claim]] needs exactly one of 'follows' (with 'observable'), 'conserves', 'changes' (with "
        "'at_least'), 'expects'");
  for (const char* named : {"conserves", "changes", "expects"})
    if (t.has(named) && t.has("observable"))
      t.fail("observable", fmt::format("observable: '{}' names it already", named));
  if (t.has("changes") != t.has("at_least"))
    t.fail(t.has("changes") ? "changes" : "at_least", t.has("changes")
                                                          ? "changes: needs 'at_least', the least change"
                                                          : "at_least: belongs to 'changes'");
  refuse(t, {"measure"}, t.has("changes"), "does not go with 'changes', of which the largest change counts");
  if (t.has("follows") && !t.has("observable"))
    t.fail("follows", "a claim that follows a truth needs 'observable'");
  refuse(t, {"measure", "sample"}, t.has("expects"), "does not go with 'expects', which looks at the end");
  const char* key = t.has("conserves") ? "conserves"
                    : t.has("changes") ? "changes"
                    : t.has("expects") ? "expects"
                                       : "observable";
  Observable q;
  q.quantity = quantity_of(t, key);
  const bool event = q.quantity == Quantity::event;
  if (event && !t.has("follows"))
    t.fail(key, fmt::format("{}: an event has no value at the start; use 'follows'", key));
  if (core::of_last_step(q.quantity)) {
    const char* wants = core::of_joint_forces(q.quantity) ? "follows" : "conserves";
    if (!t.has(wants)) t.fail(key, fmt::format("{}: {} belongs to '{}'", key, core::name(q.quantity), wants));
  }
  if (core::of_chance(q.quantity) != t.has("expects"))
    t.fail(key, fmt::format("{}: {} {} to 'expects'", key, core::name(q.quantity),
                            t.has("expects") ? "does not belong" : "belongs"));
  refuse(t, {"component"}, !is_vector(q.quantity) && !core::of_chance(q.quantity),
         fmt::format("belongs to vectors, and {} is none", core::name(q.quantity)));
  refuse(t, {"about"}, q.quantity != Quantity::angular_momentum && !event,
         "belongs to angular_momentum and to event = \"apsis\"");
  refuse(t, {"event", "index", "quantity", "to"}, !event, "belongs to observable = \"event\"");
  refuse(t, {"body"}, q.quantity == Quantity::energy,
         "does not go with energy, which is the scene's; use kinetic_energy");
  if (event && !t.has("event")) t.fail("observable", "observable = \"event\" needs 'event'");

  const bool forces = core::of_joint_forces(q.quantity), joints = core::of_joints(q.quantity) || forces;
  refuse(t, {"joint"}, !joints, "belongs to coordinates and forces of joints");
  refuse(t, {"which"}, !core::of_joints(q.quantity), "belongs to coordinates of joints");
  refuse(t, {"body"}, joints, "does not go with a quantity of joints; use 'joint'");
  if (forces && draft.scene.bodies.size() > budget::bodies_of_truth)
    t.fail(key, fmt::format("{}: {} serves scenes of at most {} bodies", key, core::name(q.quantity),
                            budget::bodies_of_truth));
  if (t.has("joint")) q.joint = joint_of(t, draft);
  const auto& ordinals = core::Words<core::Ordinal>::list;
  q.which = t.choice("which", {ordinals.begin(), ordinals.end()}, core::Ordinal::first);
  if (t.has("body")) q.body = draft.body(t, "body");
  q.component = t.choice("component", components, core::Component::all);
  q.about = t.vector("about");
  if (event) read_event(t, draft, q);

  const auto point = [&](std::size_t i) { return draft.point[i]; };
  bool only_points = q.body && point(static_cast<std::size_t>(*q.body));
  if (!q.body) only_points = std::ranges::all_of(draft.point, [](bool p) { return p; });
  if (turns(q.quantity) && only_points)
    t.fail(key,
           fmt::format("{}: a point (a body without shape and inertia) has none", core::name(q.quantity)));
  if (one_sided(t) && (!t.has("conserves") || !is_number(q)))
    t.fail("measure",
           fmt::format("measure = \"{}\" belongs to 'conserves' with an energy, or with component = "
                       "\"x\", \"y\" or \"z\" of a vector: what neither rises nor falls is no number",
                       t.text("measure")));
  if (const auto why = core::undefined_in(q, draft.scene))
    t.fail(key, fmt::format("{}: {}", core::name(q.quantity), *why));
  return q;
}

std::string label_of(const Table& t, const core::Claim& claim) {
  const Observable& q = claim.observable;
  std::string label(core::name(q.quantity));
  label += claim.at_least                                 ? " changes"
           : core::of_chance(q.quantity)                  ? " as expected"
           : claim.reduction == core::Reduction::increase ? " never rises"
           : claim.reduction == core::Reduction::decrease ? " never falls"
           : claim.follows.empty()                        ? " conserved"
                                                          : " follows " + claim.follows;
  if (q.quantity == Quantity::event)
    label += fmt::format(", {}{} {}", core::name(q.event),
                         core::of_all(q.event_quantity) ? "" : fmt::format(" {}", q.index),
                         core::name(q.event_quantity));
  if (t.has("body")) label += ", " + t.text("body");
  if (t.has("joint")) label += ", " + t.text("joint");
  if (q.which == core::Ordinal::second) label += ", second";
  if (t.has("to")) label += ", to " + t.text("to");
  if (q.component != core::Component::all) label += ", " + t.text("component");
  if (t.has("about")) label += fmt::format(", about {} {} {}", q.about.x(), q.about.y(), q.about.z());
  if (t.has("until")) label += fmt::format(", until {}{}", t.is_text("until") ? "horizon " : "", claim.until);
  if (t.has("measure") && claim.reduction != core::Reduction::max && !core::one_sided(claim.reduction))
    label += ", " + t.text("measure");
  if (claim.tolerance.order) label += ", order";
  return label;
}

}  // namespace cylon::scenario
