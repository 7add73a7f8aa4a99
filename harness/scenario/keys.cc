#include "harness/scenario/keys.h"

#include "harness/results/verdict.h"
#include "harness/scenario/field_keys.h"
#include "harness/scenario/key_rows.h"

#include <fmt/format.h>

#include <cmath>

namespace cylon::scenario {
namespace {

using enum Kind;

const Spec* explains_spec() {
  static const Spec spec{.label = "[[cause.explains]]",
                         .keys = {required(word("engine", "Globs over engine ids.")),
                                  required(word("scenario", "Globs over scenario names.")),
                                  absent("all", word("claim", "Globs over claim labels."))}};
  return &spec;
}
const Spec* counterfactual_spec() {
  static const Spec spec{
      .label = "[[cause.counterfactual]]",
      .keys = {
          required(word("scenario", "Where the symptom is seen.")),
          required(word("claim", "Glob that matches one claim.")),
          required(word("engine", "Id of the engine.")),
          absent("the scenario's own", seconds("dt", step, "Step.")),
          absent("the same", word("other_scenario", "Another scene, to compare with.")),
          absent("the same", word("other_claim", "Glob that matches one claim of the other run.")),
          absent("the same", word("other_engine", "Another engine, or setting.")),
          absent("the same", seconds("other_dt", step, "Another step.")),
          word("becomes", "The other run's verdict.", words(results::Status::protocol)),
          absent("0", real("at_least", "", "Error of the other run over that of the first.", not_negative)),
          absent("no limit", real("at_most", "", "The same, from above.", positive))}};
  return &spec;
}
const Spec* cause_spec() {
  static const Spec spec{
      .label = "[[cause]]",
      .keys = {
          required(word("name", "Short, for the rows and reports.")),
          required(word("mechanism", "What happens in the engine.")),
          required(plain("source", texts, "Where: \"engine: file:line function\".")),
          required(word("law", "Formula of the size.")), word("note", "What was tried and is not the cause."),
          absent("none", real("power", "", "Of the step, in the law.")),
          absent("3", real("within", "", "Factor by which another measurement may differ.", core::Range{1})),
          nested("explains", tables, explains_spec, "Cells that the cause explains."),
          nested("counterfactual", tables, counterfactual_spec, "A pair of runs that tests the cause.")}};
  return &spec;
}
const Spec* row_spec() {
  static const Spec spec{
      .label = "[[row]]",
      .keys = {required(word("cause", "Name in expected.toml.")), required(word("scenario", "Name.")),
               required(word("engine", "Id.")), required(seconds("dt", step, "Step.")),
               required(word("claim", "Label.")),
               required(word("status", "The verdict.", words(results::Status::protocol))),
               real("measured", "", "In the observable's unit; absent: the status says all.")}};
  return &spec;
}
const Spec* published_spec() {
  static const Spec spec{
      .label = "[[published]]",
      .keys = {required(word("engine", "Id as in `engines`.")), required(seconds("dt", step, "Step.")),
               required(word("value", "As published.")), required(word("source", "Where."))}};
  return &spec;
}

}  // namespace

std::string_view form_of(Kind kind) {
  switch (kind) {
    case text:
      return "a string";
    case number:
      return "a number";
    case whole:
      return "a whole number";
    case boolean:
      return "true or false";
    case vector:
      return "three numbers [x, y, z]";
    case counts:
      return "three whole numbers";
    case quaternion:
      return "four numbers [w, x, y, z]";
    case moments:
      return "three principal moments or nine numbers";
    case numbers:
      return "an array of numbers";
    case points:
      return "an array of points [[x, y, z], …]";
    case triangles:
      return "an array of triangles [[0, 1, 2], …]";
    case texts:
      return "an array of strings";
    case named:
      return "a table of numbers { k = 0.5, … }";
    case pair:
      return "two names [\"a\", \"b\"]";
    case step:
      return "a number or a string like \"1/60\"";
    case steps:
      return "an array of steps [0.001, \"1/60\"]";
    case sample:
      return "a number or \"step\"";
    case until:
      return "a number or \"horizon\"";
    case table:
      return "a table";
    case tables:
      return "an array of tables";
    case text_or_table:
      return "a name, or a table { file = \"…\" } or { measured = \"…\", run = \"…\" }";
  }
  return {};
}

std::string describe(const Range& range, const std::string& unit) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  const std::string suffix = unit.empty() ? "" : " " + unit;
  if (low && high)
    return fmt::format("in {}{:g}, {:g}]{}", range.open ? '(' : '[', range.low, range.high, suffix);
  if (low) return fmt::format("{} {:g}{}", range.open ? ">" : ">=", range.low, suffix);
  if (high) return fmt::format("<= {:g}{}", range.high, suffix);
  return "finite" + suffix;
}

const Spec& scenario_keys() {
  static const Spec spec = [] {
    std::vector<Key> keys = {
        absent("the name of the file", word("title", "One line for people.")),
        word("story", "Two to four sentences for people."),
        plain("tags", texts, "For selection: `cylon list --tag TAG`."),
        plain("sources", texts,
              "Where the case was reported or proposed: \"owner/repository#number\" of GitHub, or a title."),
        required(real("duration", "s", "Must be a whole number of steps.", positive)),
        required(seconds("step", step, "The nominal step: `0.001` or `\"1/60\"`.")),
        keys_of<core::UniformGravity>().front(),
        absent("sequential",
               word("impacts",
                    "How several impacts at one instant are resolved: one after another in the order of the "
                    "bodies, or all at once. Where the order counts, the in-house engine says so.",
                    {core::Words<core::Impacts>::list.begin(), core::Words<core::Impacts>::list.end()}))};
    const auto add = [&]<class T>(std::type_identity<T>, Kind kind, const Spec* (*of)()) {
      keys.push_back(
          nested(std::string(core::Element<T>::name), kind, of, std::string(core::Element<T>::meaning)));
      keys.back().worker = kind == table || core::comes_later<T> ? "optional" : "always";
    };
    add(std::type_identity<core::Body>{}, tables, body_spec);
    keys.push_back(nested(
        "lattice", tables, lattice_spec,
        "Equal bodies on a grid, named name[0], name[1], … with x fastest. It has all keys of a body."));
    keys.push_back(nested(
        "cloud", tables, cloud_spec,
        "Equal bodies at random places that do not overlap, named name[0], name[1], …. It has all keys "
        "of a body."));
    core::for_each_force([&]<class Force>() {
      if constexpr (!std::is_same_v<Force, core::UniformGravity>)
        add(std::type_identity<Force>{}, tables, spec_of<Force>);
    });
    add(std::type_identity<core::Joint>{}, tables, joint_spec);
    add(std::type_identity<core::Plane>{}, tables, spec_of<core::Plane>);
    add(std::type_identity<core::Material>{}, tables, spec_of<core::Material>);
    add(std::type_identity<core::Frame>{}, table, spec_of<core::Frame>);
    keys.push_back(nested("claim", tables, claim_spec, "What must hold, and how well."));
    keys.push_back(
        nested("theory", table, theory_spec,
               "How fast the motion goes, for the claims by theory (docs/claims.md#claims-by-theory)."));
    return Spec{.label = "a scenario", .keys = keys};
  }();
  return spec;
}

const Spec& expected_keys() {
  static const Spec spec{
      .label = "expected.toml",
      .keys = {
          {.name = "versions", .kind = table, .meaning = "Engine glob = list of version globs."},
          nested("cause", tables, cause_spec, "Why some verdicts are no pass; the first that matches.")}};
  return spec;
}

const Spec& expected_row_keys() {
  static const Spec spec{.label = "expected_rows.toml",
                         .keys = {nested("row", tables, row_spec, "One verdict that is no pass.")}};
  return spec;
}

const Spec& suite_keys() {
  static const Spec spec{
      .label = "a suite",
      .keys = {word("title", "One line."), word("story", "What the suite reproduces."),
               absent("all", word("claim", "Glob over the claim labels that `published` speaks of.")),
               required(plain("scenarios", texts, "Globs over scenario names.")),
               required(plain("engines", texts, "Engine ids, with options: \"ode/erp=0,cfm=0\".")),
               absent("the nominal step of each scenario",
                      plain("steps", steps, "Numbers, or texts like \"1/60\".")),
               nested("published", tables, published_spec, "A published value.")}};
  return spec;
}

}  // namespace cylon::scenario
