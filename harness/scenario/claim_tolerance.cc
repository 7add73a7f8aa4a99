#include "harness/scenario/claim_tolerance.h"

#include "harness/core/engine.h"
#include "harness/core/equipartition.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/scenario/claim_observable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cylon::scenario {
using core::Claim;
using core::Reduction;

namespace {

// A level that no value can miss tests nothing.
void require_power(const Table& t, const Claim& claim, const core::Scene& scene) {
  const double expected = core::expected_share(claim.observable, scene);
  const double farthest = std::max(expected, 1 - expected);
  if (!(core::allowed_share(claim.observable, scene, claim.tolerance.level) < farthest))
    t.fail("level",
           fmt::format("level = {}, but with so few bodies no value is that unlikely; valid: {:.2g} or more",
                       claim.tolerance.level, 2 * core::chance_of_share(claim.observable, scene, farthest)));
}

// How far the truth is from the scene at the start, where nothing has moved yet.
double off_at_start(const Claim& claim, const core::Scene& scene) {
  core::Values known, given;
  core::evaluate(claim.observable, scene, claim.truth->state(0), known);
  core::evaluate(claim.observable, scene, core::initial_state(scene), given);
  return core::distance(claim.observable, known, given);
}

}  // namespace

core::Tolerance read_tolerance(const Table& t, const Claim& claim) {
  core::Tolerance result{t.number("absolute"), t.number("relative"),  t.boolean("order"),
                         t.number("constant"), t.text("reason"),      {},
                         t.number("level"),    t.number("roundings"), t.number("size")};
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
  if (result.order && core::of_last_step(claim.observable.quantity))
    t.fail("order",
           fmt::format("order does not go with {}: an engine may tell the forces of one instant of the step",
                       core::name(claim.observable.quantity)));
  if (result.order && claim.reduction == Reduction::order)
    t.fail("order", "order = true checks the order already; measure = \"order\" takes absolute");
  if (t.has("roundings") && (result.order || t.has("level")))
    t.fail("roundings",
           "roundings go with absolute and relative alone: order = true allows for rounding by itself");
  if (t.has("roundings") && claim.at_least)
    t.fail("roundings", "roundings do not go with 'changes'; use absolute or relative");
  if (t.has("size") && !t.has("roundings"))
    t.fail("size", "size: is of what is rounded, and needs 'roundings'");
  if (core::of_chance(claim.observable.quantity) != t.has("level"))
    t.fail(t.has("level") ? "level: belongs to 'expects'" : "tolerance of 'expects' needs 'level'");
  if (t.has("level") && (result.order || t.has("absolute") || t.has("relative")))
    t.fail("level",
           "level sets the bound by the law of chance; absolute, relative and order do not go with it");
  if (!result.order && !t.has("absolute") && !t.has("relative") && !t.has("level") && !t.has("roundings"))
    t.fail("tolerance needs 'absolute', 'relative', 'roundings', or 'order' with 'constant'");
  if (result.order && (claim.at_least || core::one_sided(claim.reduction)))
    t.fail("order",
           "order = true does not go with 'changes', nor with a claim of one side; use absolute or relative");
  if (t.has("relative") && !claim.at_least && is_angle(claim.observable.quantity))
    t.fail("relative", fmt::format("relative: {} is an angle and has no scale; use absolute [rad]",
                                   core::name(claim.observable.quantity)));
  if (claim.reduction != Reduction::max && claim.reduction != Reduction::end &&
      !core::one_sided(claim.reduction))
    for (const char* key : {"relative", "roundings"})
      if (t.has(key))
        t.fail(key, fmt::format("{} does not go with measure = \"{}\", whose unit is another; use absolute",
                                key, core::name(claim.reduction)));
  if (claim.at_least && !(result.absolute + result.relative * *claim.at_least < *claim.at_least))
    t.fail(t.has("absolute") ? "absolute" : "relative",
           fmt::format("allows all of at_least = {} to be missing: no motion at all would pass; allow less",
                       *claim.at_least));
  return result;
}

void check_tolerance(const Table& t, Claim& claim, const core::Scene& scene, double duration, double step) {
  const Table tolerance = *t.table("tolerance");
  if (claim.tolerance.level > 0) require_power(tolerance, claim, scene);
  if (claim.tolerance.roundings > 0 && claim.tolerance.size == 0 && !is_angle(claim.observable.quantity) &&
      !(core::largest_value(claim, scene, duration) > 0))
    tolerance.fail(
        "roundings",
        fmt::format("roundings: the {} claimed is 0, and of nothing there is no rounding; give the "
                    "size [{}] of what cancels",
                    core::name(claim.observable.quantity), core::unit(claim.observable)));
  if (!claim.truth) return;
  if (core::validates(claim)) {  // it has no bound on its error, and needs none: undecided is an answer
    claim.truth_error = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  claim.truth_error =
      core::truth_error(claim.observable, scene, *claim.truth, std::min(claim.until, duration), step);
  if (claim.tolerance.order || claim.reduction == Reduction::order)
    return;  // their bound depends on the run's integrator
  const double allowed = core::allowed(claim, scene, duration, core::epsilon_of_double);
  const double error =
      claim.reduction == Reduction::mean_square ? claim.truth_error * claim.truth_error : claim.truth_error;
  if (!(error <= allowed / 10))
    tolerance.fail(fmt::format(
        "tolerance: '{}' is itself only good to {:.3g} {}, but a tenth of the {:.3g} allowed is needed; "
        "valid: {:.3g} or more",
        claim.follows, error, core::unit(claim.observable), allowed, 10 * error));
  const bool recorded = !claim.truth->times.empty() && claim.truth->times.front() == 0;
  if (!recorded || claim.observable.quantity == core::Quantity::event || claim.reduction == Reduction::rate)
    return;
  const double off = off_at_start(claim, scene);
  if (!(off <= (claim.reduction == Reduction::mean_square ? std::sqrt(allowed) : allowed)))
    t.fail("follows",
           fmt::format("follows: {} starts {:.3g} {} from where the scene does, and {:.3g} are allowed: no "
                       "engine can follow it",
                       claim.follows, off, core::unit(claim.observable), allowed));
}

}  // namespace cylon::scenario
