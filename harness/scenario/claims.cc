#include "harness/scenario/claims.h"

#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "harness/core/uncertain.h"
#include "harness/scenario/bind_motion.h"
#include "harness/scenario/budget.h"
#include "harness/scenario/certified_truth.h"
#include "harness/scenario/claim_observable.h"
#include "harness/scenario/claim_tolerance.h"
#include "harness/scenario/claim_truths.h"
#include "harness/scenario/measured_truth.h"
#include "harness/scenario/recorded_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cylon::scenario {
namespace {

using core::Claim;
using core::Quantity;
using core::Reduction;

Reduction reduction_of(const Table& t) {
  for (int i = 0; i <= static_cast<int>(Reduction::decrease); ++i)
    if (core::name(static_cast<Reduction>(i)) == t.text("measure", "max")) return static_cast<Reduction>(i);
  t.fail("measure", "measure is unknown");
}

// "orbit.json"; "measured swings.toml, run 2".
std::string name_of(const Table& data) {
  if (data.has("file") == data.has("measured")) data.fail("follows: needs either 'file' or 'measured'");
  if (data.has("run") != data.has("measured"))
    data.fail(data.has("run") ? "run" : "measured", "follows: 'measured' and 'run' go together");
  if (data.has("file")) return data.text("file");
  return fmt::format("measured {}, run {}", std::filesystem::path(data.text("measured")).filename().string(),
                     data.text("run"));
}

// Without its truth and its tolerance checked.
Claim parse_claim(const Table& t, const Draft& draft, double duration, double step) {
  Claim claim;
  claim.observable = read_observable(t, draft);
  claim.reduction = reduction_of(t);
  if (t.has("changes")) claim.at_least = t.number("at_least"), claim.reduction = Reduction::end;
  if (t.has("expects")) claim.reduction = Reduction::end;
  if (claim.at_least && is_angle(claim.observable.quantity) && !(*claim.at_least < std::numbers::pi))
    t.fail("at_least", fmt::format("at_least = {}, but an angle between two directions is at most pi; "
                                   "valid: less than pi",
                                   *claim.at_least));
  const bool horizon = t.is_text("until");
  if (horizon && (!t.is_text("follows") || t.text("follows") != certified_name))
    t.fail("until", "until = \"horizon\" belongs to follows = \"certified\", which knows how errors grow");
  refuse(t, {"until"}, horizon && claim.observable.quantity == Quantity::event,
         "= \"horizon\" does not go with an event");
  if (t.has("until") && !horizon) claim.until = t.number("until");
  if (t.has("until") && !horizon && claim.until > duration)
    t.fail("until", fmt::format("until = {}, but must be in (0, {}] s, the duration", claim.until, duration));
  if (t.has("until") && !horizon && !claim.at_least && claim.until < step * (1 - 1e-9))
    t.fail("until", fmt::format("until = {}, but must be at least a step, {} s", claim.until, step));
  refuse(t, {"sample", "measure"}, claim.observable.quantity == Quantity::event, "does not go with an event");
  refuse(t, {"until", "sample", "measure"}, core::of_last_step(claim.observable.quantity),
         fmt::format("does not go with {}, which is that of the last step",
                     core::name(claim.observable.quantity)));
  if (t.has("sample")) {
    claim.sample = t.is_text("sample") ? 0 : t.number("sample");
    try {
      if (*claim.sample > 0) core::whole_steps(*claim.sample, step);
      if (*claim.sample > std::min(claim.until, duration) * (1 + 1e-9))
        throw std::invalid_argument(fmt::format("{} s is beyond the end of the claim, {} s", *claim.sample,
                                                std::min(claim.until, duration)));
    } catch (const std::invalid_argument& error) {
      t.fail("sample", fmt::format("sample: {}", error.what()));
    }
  }
  if (const auto data = t.table("follows"))
    claim.follows = name_of(*data);
  else
    claim.follows = t.text("follows");
  claim.tolerance = read_tolerance(*t.table("tolerance"), claim);
  if (horizon && (claim.tolerance.order || claim.reduction == Reduction::order))
    t.fail("until", "until = \"horizon\" needs a tolerance that is absolute or relative");
  claim.label = label_of(t, claim);
  return claim;
}

// Why recorded data cannot say what is claimed, or "".  A point has neither orientation nor spin.
std::string lacks(const core::Truth& truth, Quantity quantity, bool only_points) {
  const std::string velocity = truth.knows_velocity ? "" : "velocity",
                    orientation = truth.knows_orientation || only_points ? "" : "orientation",
                    spin = truth.knows_angular_velocity || only_points ? "" : "angular_velocity";
  switch (quantity) {
    case Quantity::position:
    case Quantity::event:
      return "";
    case Quantity::velocity:
    case Quantity::linear_momentum:
      return velocity;
    case Quantity::orientation:
    case Quantity::axis:
    case Quantity::normal_gap:
    case Quantity::joint_gap:
    case Quantity::angular_joint_gap:
    case Quantity::joint_displacement:
    case Quantity::joint_angle:
      return orientation;
    case Quantity::joint_displacement_rate:
    case Quantity::joint_angle_rate:
      return !velocity.empty() ? velocity : !spin.empty() ? spin : orientation;
    case Quantity::angular_velocity:
      return spin;
    case Quantity::energy_share:
    case Quantity::momentum_balance:
    case Quantity::angular_momentum_balance:
      return "";  // no truth is followed there
    case Quantity::joint_force:
    case Quantity::joint_torque:
      return "the motion between its times";
    case Quantity::angular_momentum:
    case Quantity::energy:
    case Quantity::kinetic_energy:
      return !velocity.empty() ? velocity : !spin.empty() ? spin : orientation;
  }
  return "";
}

// The truths of one scenario, each made once; what they all keep is limited.
class Truths {
 public:
  Truths(Draft& draft, double step) : draft_(draft), exact_(draft.scene, step) {}

  core::Truth recorded(const Table& t, const std::string& name) {
    const std::string text = draft_.read(t, "file");  // every use counts in the scenario's hash
    auto& known = recorded_[name];
    try {
      if (!known) known = parse_truth(text, name, draft_.scene);
    } catch (const core::InputError& error) {
      t.fail("file", error.what());
    }
    keep(t, "file", *known);
    return *known;
  }

  core::MeasuredTruth measured(const Table& t) {
    auto& known = measured_[{t.text("measured"), t.text("run")}];
    if (!measured_reader()) t.fail("measured", "measured: this program reads no measured motions");
    if (!known) known = measured_reader()(t, draft_.folder, draft_.scene, draft_.content);
    keep(t, "measured", known->truth);
    return *known;
  }

  core::Truth exact(const Table& t, const Claim& claim, double horizon) {
    const core::Truth& known = exact_.at(t, claim, horizon);
    keep(t, "follows", known);
    return known;
  }

 private:
  void keep(const Table& t, std::string_view key, const core::Truth& truth) {
    entries_ += truth.events.size() + truth.times.size();
    if (entries_ > budget::truth_entries)
      t.fail(key, fmt::format(
                      "{}: the truths of all claims together have more than {} events and times; end claims "
                      "sooner with 'until', or make fewer",
                      key, budget::truth_entries));
  }

  Draft& draft_;
  ExactTruths exact_;
  std::map<std::string, std::optional<core::Truth>> recorded_;
  std::map<std::pair<std::string, std::string>, std::optional<core::MeasuredTruth>>
      measured_;             // by file and run
  std::size_t entries_ = 0;  // events and times
};

// Recorded states are compared where the nominal step comes by.
void require_steps_at(const Table& t, const std::vector<double>& times, double step) {
  for (const double time : times) try {
      if (time > 0) core::whole_steps(time, step);
    } catch (const std::invalid_argument& error) {
      t.fail("follows", fmt::format("follows: a time of the recorded data: {}", error.what()));
    }
}

// The frames that the claim's `sample` comes by.
void sample_frames(const Table& t, Claim& claim) {
  if (!claim.sample || *claim.sample == 0) return;
  std::erase_if(claim.truth->times, [&](double time) {
    return std::abs(std::remainder(time, *claim.sample)) > 1e-6 * *claim.sample;
  });
  if (claim.truth->times.empty()) t.fail("sample", "sample: no frame of the data comes by");
}

void follow_measured(const Table& t, Claim& claim, double horizon, double step) {
  if (const std::string why = core::no_interval(claim); !why.empty())
    t.fail(why.substr(0, why.find(':')), why);
  if (claim.observable.quantity != Quantity::position && !claim.truth->knows_orientation)
    t.fail("observable", fmt::format("observable: of '{}', {} states no noise",
                                     core::name(claim.observable.quantity), claim.follows));
  if (!(horizon <= claim.truth->horizon * (1 + 1e-9)))
    t.fail("until", fmt::format("until: {} ends at {} s, and the claim at {} s", claim.follows,
                                claim.truth->horizon, horizon));
  cut(t, *claim.truth, horizon);
  sample_frames(t, claim);
  require_steps_at(t, claim.truth->times, step);
}

void follow(const Table& t, const Draft& draft, Truths& truths, Claim& claim, double duration, double step) {
  const double horizon = std::min(claim.until, duration);
  const auto recorded = t.table("follows");
  if (recorded && recorded->has("measured")) {
    const core::MeasuredTruth known = truths.measured(*recorded);
    claim.truth = known.truth, claim.uncertainty = known.uncertainty;
    return follow_measured(t, claim, horizon, step);
  }
  if (recorded) {
    claim.truth = truths.recorded(*recorded, claim.follows);
    const bool only_points = std::ranges::all_of(draft.point, [](bool p) { return p; });
    if (const std::string key = lacks(*claim.truth, claim.observable.quantity, only_points); !key.empty())
      t.fail("observable", fmt::format("observable: '{}' of a body needs '{}', which the file {} lacks",
                                       core::name(claim.observable.quantity), key, claim.follows));
    cut(t, *claim.truth, horizon);
    if (claim.observable.quantity != Quantity::event &&
        claim.truth->times.back() < horizon - step * (1 + 1e-9))
      t.fail(t.has("until") ? "until" : "follows",
             fmt::format("{}: {} ends at {} s, and the claim at {} s; end the claim there with 'until'",
                         t.has("until") ? "until" : "follows", claim.follows, claim.truth->times.back(),
                         horizon));
    if (claim.observable.quantity != Quantity::event) require_steps_at(t, claim.truth->times, step);
  } else {
    claim.truth = truths.exact(t, claim, horizon);
  }
  require_event(t, claim, horizon);
}

// The times after the start that a claim looks at, in a run at `step`.
std::int64_t samples_after_start(const Claim& claim, double duration, double step) {
  if (claim.truth && !claim.truth->times.empty())
    return std::ranges::count_if(claim.truth->times, [](double time) { return time > 0; });
  const double end = std::min(claim.until, duration) * (1 + 1e-9);
  const double apart = claim.sample && *claim.sample > 0 ? *claim.sample : step;
  const double whole = std::floor(end / apart);
  const bool last_too = claim.until >= duration && whole * apart < duration * (1 - 1e-9);
  return static_cast<std::int64_t>(std::min(whole, 1e9)) + (last_too ? 1 : 0);
}

// What is known at some times only may lack the start, and a slope needs two times.
void require_samples(const Table& t, const Claim& claim, double duration, double step) {
  const bool recorded = claim.truth && !claim.truth->times.empty();
  const bool starts = !recorded || claim.truth->times.front() == 0;
  const int needed = claim.reduction == Reduction::rate && !starts ? 2 : core::samples_needed(claim);
  const std::int64_t after = samples_after_start(claim, duration, step);
  if (needed < 2 || after >= needed) return;
  t.fail("measure",
         fmt::format("measure = \"{}\" of {} sample{} after the start says nothing{}; valid: {} or more{}",
                     core::name(claim.reduction), after, after == 1 ? "" : "s",
                     claim.reduction == Reduction::mean_square ? ", as the last one has no weight" : "",
                     needed, recorded ? "" : ", by a shorter 'sample' or a later 'until'"));
}

}  // namespace

ReadClaims read_claims(const Table& root, Draft& draft, double duration, double step) {
  Truths truths(draft, step);
  ReadClaims result;
  for (const Table& t : root.tables("claim")) {
    if (result.claims.size() == budget::claims)
      t.fail(fmt::format("a scenario has at most {} claims", budget::claims));
    Claim claim = parse_claim(t, draft, duration, step);
    const bool certified = claim.follows == certified_name && t.is_text("follows");
    // until = "horizon" has a label of its own once the horizon is known
    const bool labelled = !t.is_text("until");
    if (labelled && std::ranges::find(result.claims, claim.label, &Claim::label) != result.claims.end())
      t.fail(fmt::format("the claim '{}' is made twice", claim.label));
    if (certified) {
      require_samples(t, claim, duration, step);
      result.certified.push_back({result.claims.size(), t});
    } else {
      if (!claim.follows.empty()) follow(t, draft, truths, claim, duration, step);
      require_samples(t, claim, duration, step);
      check_tolerance(t, claim, draft.scene, duration, step);
    }
    result.claims.push_back(std::move(claim));
  }
  bind_motion(result.claims, duration);
  return result;
}

}  // namespace cylon::scenario
