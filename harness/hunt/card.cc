#include "harness/hunt/card.h"

#include "harness/core/content_hash.h"
#include "harness/core/fields.h"
#include "harness/core/input_error.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <set>

namespace cylon::hunt {
namespace {

// The kinds of parts of a scene, by the names that files have for them.
std::set<std::string> parts(const core::Scene& scene) {
  std::set<std::string> names;
  for (const core::Body& body : scene.bodies) {
    if (body.locked) names.insert("locked body");
    std::visit(
        [&]<class Shape>(const Shape&) {
          if constexpr (!std::is_same_v<Shape, std::monostate>) names.emplace(core::Element<Shape>::name);
        },
        body.shape);
  }
  for (const core::Force& force : scene.forces)
    std::visit([&]<class Kind>(const Kind&) { names.emplace(core::Element<Kind>::name); }, force);
  for (const core::Joint& joint : scene.joints) names.emplace(core::kind_of(joint.type).name);
  if (!scene.planes.empty()) names.insert("plane");
  if (scene.frame) names.insert("frame");
  for (const core::Material& material : scene.materials) {
    if (material.friction > 0) names.insert("friction");
    if (material.restitution > 0) names.insert("restitution");
  }
  return names;
}

std::string number(double x) { return fmt::format("{:.3g}", x); }

std::string command(const Card& card, const std::string& file) {
  return fmt::format("cylon run {} --engine {}{}", file, card.engine,
                     card.fault.oracle.starts_with("relation ") ? " --metamorphic" : "");
}

// "0.12 J at 0.01 s, 0.13 J at 0.005 s, 0.13 J at 0.0025 s"
std::string measured(const Card& card) {
  if (!card.fault.detail.empty() || card.fault.unit.empty()) return card.fault.detail;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < halvings; ++i)
    values.push_back(fmt::format("{} {} at {} s", number(card.fault.measured[i]),
                                 card.fault.unit == "1" ? "of the scale" : card.fault.unit,
                                 card.trial.step / static_cast<double>(1 << i)));
  return fmt::format("{}", fmt::join(values, ", "));
}

}  // namespace

std::string signature(const Fault& fault, const core::Scene& scene) {
  return fmt::format("{}: {} {}, {}", fault.oracle, scene.bodies.size(),
                     scene.bodies.size() == 1 ? "body" : "bodies", fmt::join(parts(scene), ", "));
}

std::string Card::file_stem() const {
  core::ContentHash content;
  content.add(engine + signature);
  std::string stem = fmt::format("{}-{}-{}", engine, fault.oracle, content.hex().substr(0, 6));
  for (char& c : stem)
    if (c == ' ' || c == '/' || c == '=' || c == ',') c = '-';
  return stem;
}

Kept read_card(const std::string& file) {
  const scenario::Scenario scenario = scenario::read(file);
  Kept kept;
  std::string measured;
  const std::pair<std::string_view, std::string*> facts[] = {
      {"engine: ", &kept.engine}, {"oracle: ", &kept.oracle}, {"measured: ", &measured}};
  for (const std::string& tag : scenario.tags)
    for (const auto& [key, value] : facts)
      if (tag.starts_with(key)) *value = tag.substr(key.size());
  for (const auto& [key, value] : facts)
    if (value->empty())
      throw core::InputError(fmt::format("{}: no card of `cylon hunt`: it has no tag \"{}…\"", file, key));
  const auto [end, error] =
      std::from_chars(measured.data(), measured.data() + measured.size(), kept.measured);
  if (error != std::errc())
    throw core::InputError(fmt::format("{}: tag \"measured: {}\": not a number", file, measured));
  kept.trial = {scenario.scene, scenario.step, std::llround(scenario.duration / scenario.step)};
  return kept;
}

std::string scenario_toml(const Card& card) {
  const std::string head = fmt::format(
      "# {} breaks this: {}.\n# Measured: {}; allowed: {} {}.\n# Found in scene {} of seed {} ({}).\n"
      "tags = [\"hunted\", {}, {}, {}]\n",
      card.engine, card.fault.says, measured(card), number(card.fault.allowed), card.fault.unit, card.number,
      card.seed, card.family, scenario::toml_text("engine: " + card.engine),
      scenario::toml_text("oracle: " + card.fault.oracle),
      scenario::toml_text(fmt::format("measured: {}", card.fault.measured[0])));
  return head + to_toml(card.trial, card.fault.claim);
}

std::string markdown(const Card& card) {
  const std::string file = card.file_stem() + ".toml";
  std::string text = fmt::format("# {}: {}\n\n", card.engine, card.signature);
  text += fmt::format("**What should happen:** {}.\n\n", card.fault.says);
  text += fmt::format("**What happens** in {} {}: {}.", card.engine, card.version, measured(card));
  if (card.fault.detail.empty())
    text += fmt::format(" Allowed: {} {}; ten times that counts as a fault.", number(card.fault.allowed),
                        card.fault.unit == "1" ? "of the scale" : card.fault.unit);
  text += "\n\n";
  text += fmt::format(
      "The error does not fall with the step, so that it is no truncation. Seen in {} scenes of the hunt; "
      "this is the least.\n\n",
      card.hits);
  if (!card.opinions.empty()) {
    text += "| engine | the same scene |\n|---|---|\n";
    for (const Opinion& o : card.opinions)
      text += fmt::format("| {} | {} |\n", o.engine,
                          o.refuses  ? "refused"
                          : o.faulty ? "the same fault"
                                     : "no fault");
    text += '\n';
  }
  text += fmt::format("```sh\n{}\n```\n\n```toml\n{}```\n", command(card, file), scenario_toml(card));
  return text;
}

}  // namespace cylon::hunt
