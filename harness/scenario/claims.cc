#include "harness/scenario/claims.h"

#include "harness/core/event_find.h"
#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "reference/exact/catalogue.h"
#include "harness/scenario/certified_truth.h"
#include "harness/scenario/recorded_truth.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>

namespace cylon::scenario {
namespace {

using core::Claim;
using core::Observable;
using core::Quantity;
using core::Reduction;

const std::vector<std::string> components = {"", "x", "y", "z", "horizontal"};

// The words of an enumeration of core, in its own order.
template <class Enum>
std::vector<std::string> words(Enum last) {
  std::vector<std::string> result;
  for (int i = 0; i <= static_cast<int>(last); ++i) result.emplace_back(core::name(static_cast<Enum>(i)));
  return result;
}
const std::vector<std::string> event_kinds = words(core::EventKind::crossing);
const std::vector<std::string> event_quantities = words(core::EventQuantity::order);

bool is_vector(Quantity q) {
  return q == Quantity::position || q == Quantity::velocity || q == Quantity::angular_velocity ||
         q == Quantity::linear_momentum || q == Quantity::angular_momentum;
}
bool is_angle(Quantity q) { return q == Quantity::orientation || q == Quantity::axis; }
bool turns(Quantity q) { return is_angle(q) || q == Quantity::angular_velocity; }

Quantity quantity_of(const Table& t, std::string_view key) {
  for (int i = 0; i <= static_cast<int>(Quantity::event); ++i)
    if (core::name(static_cast<Quantity>(i)) == t.text(key)) return static_cast<Quantity>(i);
  t.fail(key, fmt::format("{} = '{}' is unknown", key, t.text(key)));
}

Reduction reduction_of(const Table& t) {
  for (int i = 0; i <= static_cast<int>(Reduction::rate); ++i)
    if (core::name(static_cast<Reduction>(i)) == t.text("measure", "max")) return static_cast<Reduction>(i);
  t.fail("measure", "measure is unknown");
}

void refuse(const Table& t, std::initializer_list<const char*> keys, bool when, std::string_view why) {
  for (const char* key : keys)
    if (when && t.has(key)) t.fail(key, fmt::format("{} {}", key, why));
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
  refuse(t, {"index"}, q.event_quantity == core::EventQuantity::order,
         "does not go with quantity = \"order\", which is that of all");
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

Observable read_observable(const Table& t, const Draft& draft) {
  if (t.has("follows") == t.has("conserves"))
    t.fail("[[claim]] needs either 'follows' (with 'observable') or 'conserves'");
  if (t.has("conserves") && t.has("observable"))
    t.fail("observable", "observable: 'conserves' names it already");
  if (t.has("follows") && !t.has("observable"))
    t.fail("follows", "a claim that follows a truth needs 'observable'");
  const char* key = t.has("conserves") ? "conserves" : "observable";
  Observable q;
  q.quantity = quantity_of(t, key);
  const bool event = q.quantity == Quantity::event;
  if (event && t.has("conserves")) t.fail(key, "conserves: an event keeps no value; use 'follows'");
  refuse(t, {"component"}, !is_vector(q.quantity),
         fmt::format("belongs to vectors, and {} is none", core::name(q.quantity)));
  refuse(t, {"about"}, q.quantity != Quantity::angular_momentum && !event,
         "belongs to angular_momentum and to event = \"apsis\"");
  refuse(t, {"event", "index", "quantity", "to"}, !event, "belongs to observable = \"event\"");
  refuse(t, {"body"}, q.quantity == Quantity::energy,
         "does not go with energy, which is the scene's; use kinetic_energy");
  if (event && !t.has("event")) t.fail("observable", "observable = \"event\" needs 'event'");

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
  if (const auto why = core::undefined_in(q, draft.scene))
    t.fail(key, fmt::format("{}: {}", core::name(q.quantity), *why));
  return q;
}

// "angular_momentum conserved, y", "event follows bouncing_sphere, apex 2 height": unique, and kind to globs.
std::string label_of(const Table& t, const Claim& claim) {
  const Observable& q = claim.observable;
  std::string label(core::name(q.quantity));
  label += claim.follows.empty() ? " conserved" : " follows " + claim.follows;
  if (q.quantity == Quantity::event)
    label += fmt::format(", {}{} {}", core::name(q.event),
                         q.event_quantity == core::EventQuantity::order ? "" : fmt::format(" {}", q.index),
                         core::name(q.event_quantity));
  if (t.has("body")) label += ", " + t.text("body");
  if (t.has("to")) label += ", to " + t.text("to");
  if (q.component != core::Component::all) label += ", " + t.text("component");
  if (t.has("about")) label += fmt::format(", about {} {} {}", q.about.x(), q.about.y(), q.about.z());
  if (t.has("until")) label += fmt::format(", until {}{}", t.is_text("until") ? "horizon " : "", claim.until);
  if (claim.reduction != Reduction::max) label += ", " + t.text("measure");
  if (claim.tolerance.order) label += ", order";
  return label;
}

core::Tolerance read_tolerance(const Table& t, const Claim& claim) {
  core::Tolerance result{t.number("absolute"), t.number("relative"), t.boolean("order"),
                         t.number("constant"), t.text("reason"),     {}};
  if (const auto constants = t.table("constants"))
    for (int p = 1; p <= highest_order; ++p)
      if (constants->has(std::to_string(p))) result.constants[p] = constants->number(std::to_string(p));
  const char* given = t.has("constants") ? "constants" : "constant";
  if (result.order != t.has(given) || (t.has("constant") && t.has("constants")))
    t.fail(t.has(given) ? given : "order",
           "order = true and constant belong together, or constants by order, one of the two: the bound is C "
           "dt^p T");
  if (t.has("constants") && result.constants.empty())
    t.fail("constants", "constants = {}: say one for some order at least, { 1 = 4.9, 4 = 0.2 }");
  if (result.order && (t.has("absolute") || t.has("relative")))
    t.fail("order", "order = true sets the bound C dt^p T; absolute and relative do not go with it");
  if (result.order && claim.reduction == Reduction::order)
    t.fail("order", "order = true checks the order already; measure = \"order\" takes absolute");
  if (!result.order && !t.has("absolute") && !t.has("relative"))
    t.fail("tolerance needs 'absolute', 'relative', or 'order' with 'constant'");
  if (t.has("relative") && is_angle(claim.observable.quantity))
    t.fail("relative", fmt::format("relative: {} is an angle and has no scale; use absolute [rad]",
                                   core::name(claim.observable.quantity)));
  if (t.has("relative") && claim.reduction != Reduction::max && claim.reduction != Reduction::end)
    t.fail("relative",
           fmt::format("relative does not go with measure = \"{}\", whose unit is another; use absolute",
                       core::name(claim.reduction)));
  return result;
}

// Exact solutions by name, recorded data by file; each is made once per horizon.
class Truths {
 public:
  Truths(Draft& draft, double duration, double step) : draft_(draft), duration_(duration), step_(step) {}

  void attach(const Table& t, Claim& claim) {
    const double horizon = std::min(claim.until, duration_);
    if (const auto recorded = t.table("follows")) {
      claim.follows = recorded->text("file");
      claim.truth = parse_truth(draft_.read(*recorded, "file"), claim.follows, draft_.scene);
      cut(t, claim, horizon);
      return;
    }
    claim.follows = t.text("follows");
    if (claim.follows == certified_name) {
      const certified::Solution& solution = certified_.at(t, draft_.scene, horizon);
      if (!t.is_text("until")) require_whole(t, solution, horizon);
      claim.truth = solution.truth;
      if (claim.observable.quantity == Quantity::event)
        claim.truth = core::with_events(claim.observable, draft_.scene, solution.truth, horizon, step_);
      return;
    }
    auto& known = truths_[{claim.follows, horizon}];
    if (!known) known = make(t, claim.follows, horizon);
    claim.truth = *known;
    if (claim.observable.quantity != Quantity::event) return;
    const Observable& q = claim.observable;
    auto& located = events_[{claim.follows, horizon,
                             fmt::format("{} {} {} {}", core::name(q.event), q.to.value_or(-1),
                                         written(q.about), q.body.value_or(-1))}];
    if (!located) located = core::with_events(q, draft_.scene, *known, horizon, step_);
    claim.truth = *located;
  }

  // until = "horizon", once the tolerance is known.
  void cut_at_horizon(const Table& t, Claim& claim) {
    claim.until = predictable(t, claim, draft_.scene, certified_.at(t, draft_.scene, duration_), duration_);
  }

 private:
  core::Truth make(const Table& t, const std::string& name, double horizon) const {
    std::vector<std::string> names;
    for (const exact::Solution& solution : exact::catalogue()) {
      names.emplace_back(solution.name);
      if (solution.name != name) continue;
      try {
        return solution.make(draft_.scene, horizon);
      } catch (const core::OutOfDomain& error) {
        t.fail("follows", fmt::format("follows = '{}' does not serve this scene: {} (it serves: {})", name,
                                      error.what(), solution.domain));
      }
    }
    names.emplace_back(certified_name);
    t.fail("follows", fmt::format("follows = '{}' is no exact solution{}; valid: {}", name,
                                  core::did_you_mean(name, names), fmt::join(names, ", ")));
  }

  // Data beyond the horizon is no concern of the claim.
  static void cut(const Table& t, Claim& claim, double horizon) {
    auto& times = claim.truth->times;
    std::erase_if(times, [&](double time) { return time > horizon * (1 + 1e-9); });
    if (times.empty()) t.fail("follows", fmt::format("follows: the data has no time up to {} s", horizon));
  }

  Draft& draft_;
  double duration_, step_;
  CertifiedTruths certified_;
  std::map<std::pair<std::string, double>, std::optional<core::Truth>> truths_;
  std::map<std::tuple<std::string, double, std::string>, std::optional<core::Truth>>
      events_;  ///< By what is asked.
};

bool has_event(const core::Truth& truth, const Observable& q) {
  return std::ranges::any_of(truth.events, [&](const core::Event& e) {
    if (e.kind != q.event || (q.body && e.pair.body != *q.body && e.pair.other != *q.body)) return false;
    if (q.event_quantity == core::EventQuantity::order) return true;
    return e.index == q.index && core::quantity(truth.events, e, q.event_quantity).has_value();
  });
}

// The scale of a relative tolerance, and a truth that is tight enough for the tolerance.
void weigh(const Table& t, const Table& tolerance, Claim& claim, const core::Scene& scene, double duration) {
  if (claim.truth && claim.observable.quantity == Quantity::event &&
      !has_event(*claim.truth, claim.observable))
    t.fail(t.has("index") ? "index" : "event",
           fmt::format("'{}' has no {} {} with a {} up to {} s", claim.follows, t.text("event"),
                       claim.observable.index, core::name(claim.observable.event_quantity),
                       std::min(claim.until, duration)));
  const double size = claim.tolerance.relative > 0 ? core::scale(claim, scene, duration) : 0;
  if (claim.tolerance.relative > 0 && !(size > 0))
    tolerance.fail(
        "relative",
        fmt::format(
            "relative = {}: the {} is zero over the whole horizon, so nothing would be allowed; use absolute",
            claim.tolerance.relative, core::name(claim.observable.quantity)));
  if (!claim.truth) return;
  claim.truth_error =
      core::truth_error(claim.observable, scene, *claim.truth, std::min(claim.until, duration));
  if (claim.tolerance.order || claim.reduction == Reduction::order)
    return;  // their bound depends on the run's scheme
  const double allowed = claim.tolerance.absolute + claim.tolerance.relative * size;
  const double error =
      claim.reduction == Reduction::mean_square ? claim.truth_error * claim.truth_error : claim.truth_error;
  if (!(error <= allowed / 10))
    tolerance.fail(fmt::format(
        "tolerance: '{}' is itself only good to {:.3g} {}, but a tenth of the {:.3g} allowed is needed; "
        "valid: {:.3g} or more",
        claim.follows, error, core::unit(claim.observable), allowed, 10 * error));
}

Claim read_claim(const Table& t, Draft& draft, Truths& truths, double duration, double step) {
  Claim claim;
  claim.observable = read_observable(t, draft);
  claim.reduction = reduction_of(t);
  const bool horizon = t.is_text("until");
  if (horizon && (!t.is_text("follows") || t.text("follows") != certified_name))
    t.fail("until", "until = \"horizon\" belongs to follows = \"certified\", which knows how errors grow");
  refuse(t, {"until"}, horizon && claim.observable.quantity == Quantity::event,
         "= \"horizon\" does not go with an event");
  if (t.has("until") && !horizon) claim.until = t.number("until");
  if (t.has("until") && !horizon && claim.until > duration)
    t.fail("until", fmt::format("until = {}, but must be in (0, {}] s, the duration", claim.until, duration));
  refuse(t, {"sample", "measure"}, claim.observable.quantity == Quantity::event, "does not go with an event");
  if (t.has("sample")) {
    claim.sample = t.is_text("sample") ? 0 : t.number("sample");
    try {
      if (*claim.sample > 0) core::whole_steps(*claim.sample, step);
    } catch (const std::invalid_argument& error) {
      t.fail("sample", fmt::format("sample: {}", error.what()));
    }
  }
  if (t.has("follows")) truths.attach(t, claim);
  const Table tolerance = *t.table("tolerance");
  claim.tolerance = read_tolerance(tolerance, claim);
  if (horizon && (claim.tolerance.order || claim.reduction == Reduction::order))
    t.fail("until", "until = \"horizon\" needs a tolerance that is absolute or relative");
  if (horizon) truths.cut_at_horizon(t, claim);
  claim.label = label_of(t, claim);
  weigh(t, tolerance, claim, draft.scene, duration);
  return claim;
}

}  // namespace

std::vector<Claim> read_claims(const Table& root, Draft& draft, double duration, double step) {
  Truths truths(draft, duration, step);
  std::vector<Claim> claims;
  for (const Table& t : root.tables("claim")) {
    Claim claim = read_claim(t, draft, truths, duration, step);
    if (std::ranges::find(claims, claim.label, &Claim::label) != claims.end())
      t.fail(fmt::format("the claim '{}' is made twice", claim.label));
    claims.push_back(std::move(claim));
  }
  return claims;
}

}  // namespace cylon::scenario
