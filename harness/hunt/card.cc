#include "harness/hunt/card.h"

#include "harness/core/content_hash.h"
#include "harness/core/input_error.h"
#include "harness/hunt/scene_parts.h"
#include "harness/process/sandbox.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/writer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace cylon::hunt {
namespace {

std::string number(double x) { return fmt::format("{:.3g}", x); }

std::string in_unit(const Fault& fault) {
  return fault.unit == "1" || fault.unit.empty() ? "of the scale" : fault.unit;
}

double number_of(const std::string& file, const std::string& tag, const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc())
    throw core::InputError(fmt::format("{}: tag \"{}{}\": not a number", file, tag, text));
  return value;
}

}  // namespace

std::string command(const Card& card, const std::string& file) {
  const char* program = process::sandboxing() ? "cylon --sandbox" : "cylon";
  if (card.fault.oracle.starts_with("relation "))
    return fmt::format("{} run {} --engine {} --metamorphic", program, file, card.engine);
  if (card.fault.claim.empty()) return fmt::format("{} hunt --replay . --engine {}", program, card.engine);
  return fmt::format("{} run {} --engine {}", program, file, card.engine);
}

std::string measured(const Card& card) {
  if (!card.fault.detail.empty() || card.fault.steps == 0) return card.fault.detail;
  std::vector<std::string> values;
  for (std::size_t i = 0; i < card.fault.steps; ++i)
    values.push_back(fmt::format("{} {} at {} s", number(card.fault.measured[i]), in_unit(card.fault),
                                 card.trial.step / static_cast<double>(1 << i)));
  return fmt::format("{}", fmt::join(values, ", "));
}

std::string reason(const Fault& fault) {
  if (fault.by_time)
    return "A run was stopped by the clock. A faster machine, or a longer --timeout, may see no fault.";
  if (!fault.detail.empty()) return "It depends on no tolerance.";
  switch (fault.kind) {
    case Kind::every_step:
      return "The error does not fall with the step, so that it is no truncation.";
    case Kind::own_promise:
      return "The engine states the order of its scheme, or a bound of its error. The error falls more "
             "slowly than "
             "that, or is larger.";
    case Kind::coarse_step:
      return "The fault is of the coarse step alone: half the step, or a quarter, shows none. It falls "
             "faster than the "
             "error of a "
             "scheme of the stated order can, and the step resolves every rate of the scene, so that it is "
             "neither "
             "truncation nor an unstable scheme, but a limit that the engine sets on a step.";
    case Kind::fine_step:
      return "The fault is of fine steps: it comes when the step is halved, which truncation does not.";
    case Kind::slow:
      return "The error does not fall at the steps above, though the last of them resolves every rate of the "
             "scene. At "
             "a 64th of the step it falls, so that it is truncation in the end.";
    case Kind::erratic:
      return "The right motion has no error of a step here, however large the step. The error rises and "
             "falls "
             "as the step is halved, and is as large at the finest steps.";
  }
  return "";
}

std::string signature(const Fault& fault, const core::Scene& scene) {
  std::string text = fmt::format("{}{}: {} {}", fault.oracle,
                                 fault.kind == Kind::every_step ? "" : fmt::format(" {}", name(fault.kind)),
                                 scene.bodies.size(), scene.bodies.size() == 1 ? "body" : "bodies");
  for (const std::string& part : parts(scene)) text += ", " + part;
  return text;
}

std::string Card::file_stem() const {
  core::ContentHash content;
  content.add(engine + signature);
  std::string stem = fmt::format("{}-{}-{}", engine, fault.oracle, content.hex().substr(0, 6));
  for (char& c : stem)
    if (c == ' ' || c == '/' || c == '=' || c == ',') c = '-';
  return stem;
}

std::vector<std::filesystem::path> card_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  if (error) throw core::InputError(fmt::format("cards in {}: {}", folder.string(), error.message()));
  std::ranges::sort(files);
  return files;
}

Kept read_card(const std::string& file) {
  const scenario::Scenario scenario = scenario::read(file);
  Kept kept;
  std::string measured, kind;
  const std::pair<std::string_view, std::string*> facts[] = {
      {"engine: ", &kept.engine}, {"oracle: ", &kept.oracle}, {"kind: ", &kind}, {"measured: ", &measured}};
  for (const std::string& tag : scenario.tags)
    for (const auto& [key, value] : facts)
      if (tag.starts_with(key)) *value = tag.substr(key.size());
  for (const auto& [key, value] : facts)
    if (value->empty())
      throw core::InputError(fmt::format("{}: no card of `cylon hunt`: it has no tag \"{}…\"", file, key));
  kept.measured = number_of(file, "measured: ", measured);
  const std::optional<Kind> known = kind_from(kind);
  if (!known) throw core::InputError(fmt::format("{}: tag \"kind: {}\": no kind of fault", file, kind));
  kept.kind = *known;
  kept.trial = {scenario.scene, scenario.step, std::llround(scenario.duration / scenario.step)};
  return kept;
}

std::string_view name(Replayed::What what) {
  constexpr std::array<std::string_view, 4> names = {"fixed", "still there", "changed", "refused"};
  return names[static_cast<std::size_t>(what)];
}

Replayed replay(const Kept& card, const process::EngineChoice& engine, const process::Limits& limits) {
  const std::vector<Fault> faults = examine(card.trial, engine, limits, {card.oracle, card.kind}).faults;
  if (faults.empty())
    return {refuses(card.trial, engine, limits) ? Replayed::What::refused : Replayed::What::fixed};
  const double now = faults[0].measured[0], ratio = now / card.measured;
  // A fault without a number, such as a crash, is the same fault.
  const bool same = (ratio > 1 / 1.1 && ratio < 1.1) || !(card.measured > 0) || std::isnan(card.measured);
  return {same ? Replayed::What::still_there : Replayed::What::changed, now, faults[0].allowed,
          faults[0].unit};
}

std::string scenario_toml(const Card& card) {
  const std::string head = fmt::format(
      "# {} breaks this: {}.\n# Measured: {}; allowed: {} {}.\n# Found in scene {} of {} ({}).\n"
      "tags = [\"hunted\", {}, {}, {}, {}]\n",
      card.engine, card.fault.says, measured(card), number(card.fault.allowed), in_unit(card.fault),
      card.number, card.source, card.family, scenario::toml_text("engine: " + card.engine),
      scenario::toml_text("oracle: " + card.fault.oracle),
      scenario::toml_text(fmt::format("kind: {}", name(card.fault.kind))),
      scenario::toml_text(fmt::format("measured: {}", card.fault.measured[0])));
  return head + to_toml(card.trial, card.fault.claim);
}

std::string markdown(const Card& card, const std::string& after) {
  const std::string file = card.file_stem() + ".toml";
  std::string text = fmt::format("# {}: {}\n\n", card.engine, card.signature);
  text += fmt::format("**What should happen:** {}.\n\n", card.fault.says);
  text += fmt::format("**What happens** in {} {}: {}.", card.engine, card.version, measured(card));
  if (card.fault.detail.empty() && card.fault.kind != Kind::own_promise)
    text += fmt::format(" Allowed: {} {} ({}); ten times that counts as a fault.", number(card.fault.allowed),
                        in_unit(card.fault), card.fault.why);
  text += fmt::format("\n\n{} Seen in {} of the hunt's scenes; this is the least.\n\n", reason(card.fault),
                      card.hits);
  if (!card.opinions.empty()) {
    text += "| engine | the same scene |\n|---|---|\n";
    for (const Opinion& o : card.opinions)
      text += fmt::format("| {} {} | {} |\n", o.engine, o.version, o.says());
    text += '\n';
  }
  text += after;
  text += fmt::format("```sh\n{}\n```\n\n```toml\n{}```\n", command(card, file), scenario_toml(card));
  return text;
}

}  // namespace cylon::hunt
