// Keys of claims and their tolerances.
#include "harness/core/claim.h"
#include "harness/core/fields.h"
#include "harness/core/observable.h"
#include "harness/scenario/key_rows.h"

#include <fmt/format.h>

namespace cylon::scenario {
namespace {

using enum Kind;

const Spec* follows_spec() {
  static const Spec spec{
      .label = "follows",
      .keys = {
          word("file", "Recorded data in the format truth/1, beside the scenario."),
          word(
              "measured",
              "In its place a measured motion: the file that describes it (docs/measured.md), named from the "
              "scenario's folder."),
          word("run", "Of `measured`: which of its runs.")}};
  return &spec;
}
const Spec* constants_spec() {
  static const Spec spec = [] {
    Spec by_order{.label = "constants"};
    for (int p = 1; p <= highest_order; ++p)
      by_order.keys.push_back(real(std::to_string(p), fmt::format("unit/s^{}", p + 1), "", positive));
    return by_order;
  }();
  return &spec;
}
const Spec* tolerance_spec() {
  static const Spec spec{
      .label = "tolerance",
      .keys = {
          real("absolute", "", "In the unit of the observable.", not_negative),
          real("relative", "",
               "Times the scale of the claim: the range of the required motion (docs/claims.md#scales). "
               "Added to `absolute`.",
               not_negative),
          real("roundings", "",
               "Times the epsilon of the engine's precision, 2^-52 or 2^-23, and times `size`: how many "
               "roundings, all of "
               "one sign. Added to `absolute` and `relative`.",
               positive),
          absent("the largest value of what is claimed, for angles 1 rad",
                 real("size", "", "Of what is rounded, in the unit of the observable.", positive)),
          plain("order", boolean,
                "The bound is C dt^p T, with p the integrator's order, which is checked too."),
          real("level", "", "Of `expects`: the part of right engines that may fail, 1e-6 or so.",
               {.low = 1e-300, .high = 0.5}),
          real("constant", "unit/s^(p+1)", "C of that bound, whatever the order.", positive),
          nested("constants", table, constants_spec,
                 "C of that bound by order: { 1 = 4.9, 4 = 0.2 }; an integrator is held to the highest up to "
                 "its own."),
          required(
              word("reason", "Rounding, truncation, convention or measured, and how the number follows."))}};
  return &spec;
}
// Each kind with what it is and the numbers that it has.
std::string event_meaning() {
  std::string text = "Of `observable = \"event\"`.";
  for (const core::EventType& type : core::event_types()) {
    text += fmt::format(" {}: {} (", type.name, type.meaning);
    for (const core::EventQuantity which : type.quantities)
      text += fmt::format("{}{}", which == type.quantities.front() ? "" : ", ", core::name(which));
    text += ").";
  }
  return text;
}
}  // namespace

const std::vector<std::string>& forces_of_theory() {
  static const std::vector<std::string> words = {"smooth", "kinked", "jumping"};
  return words;
}

const Spec* theory_spec() {
  static const Spec spec{
      .label = "[theory]",
      .keys = {
          required(real("rate", "1/s", "The fastest rate of the motion.", positive)),
          absent("1", real("magnification", "", "What the motion itself makes of an error.", {.low = 1})),
          absent("smooth",
                 word("forces",
                      "kinked: friction changes its law within a step, and no order shows. jumping: forces "
                      "jump or bodies strike, and fixed steps are of first order.",
                      forces_of_theory())),
          absent("the duration", real("until", "s", "How far it goes: a whole number of steps.", positive)),
          required(word("reason", "Where the rate comes from."))}};
  return &spec;
}

const Spec* claim_spec() {
  static const Spec spec{
      .label = "[[claim]]",
      .keys = {
          nested(
              "follows", text_or_table, follows_spec,
              "The truth: an exact solution by name, \"certified\" (any smooth scene), recorded data, or a "
              "measured motion. Either this or `conserves` or `changes` or `expects`."),
          word("conserves", "The observable that keeps its initial value.", words(core::Quantity::event)),
          word("changes",
               "The observable that must differ from its initial value by `at_least`, at some time.",
               words(core::Quantity::event)),
          real("at_least", "", "Of `changes`, in the observable's unit.", positive),
          word("expects",
               "The observable of which statistical mechanics expects a value, once the motion has mixed: "
               "energy_share.",
               words(core::Quantity::event)),
          word("observable", "With `follows`: what is compared.", words(core::Quantity::event)),
          absent("all bodies: the worst counts, momenta and energies are totals",
                 word("body", "Name of the body.")),
          absent("all joints that have one: the worst counts",
                 word("joint", "Name of a joint, of whose coordinate or force it is.")),
          absent("first",
                 word("which", "Of a joint with two such coordinates.",
                      {core::Words<core::Ordinal>::list.begin(), core::Words<core::Ordinal>::list.end()})),
          absent("the whole vector",
                 word("component", "Of a vector, or of an `energy_share`.", {"x", "y", "z", "horizontal"})),
          absent("the origin", arrow("about", "m", "Reference point of `angular_momentum` and of an apsis.")),
          absent("the duration", seconds("until", Kind::until,
                                         "End of the claim. \"horizon\", with `follows = \"certified\"`: "
                                         "as long as an error of one "
                                         "ulp stays below a tenth of the tolerance.")),
          seconds("sample", Kind::sample, "Time between samples, or every step."),
          absent("max",
                 word("measure", "How the deviations become one number.", words(core::Reduction::decrease))),
          word("event", event_meaning(), words(core::EventKind::crossing)),
          absent("`about`, a point of the world", word("to", "Of `event = \"apsis\"`: the other body.")),
          absent("1", integer("index", "Of the event, counted per pair or body.", {.low = 0, .high = 1e9})),
          absent("time",
                 word("quantity", "Of the event: which of its numbers.", words(core::EventQuantity::count))),
          required(nested("tolerance", table, tolerance_spec,
                          "How well it must hold, and why: `absolute`, `relative`, `roundings` or their "
                          "sum, or `order`, or `level`."))}};
  return &spec;
}

}  // namespace cylon::scenario
