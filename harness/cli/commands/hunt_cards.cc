#include "harness/cli/commands/hunt_cards.h"

#include "harness/cli/output.h"
#include "reports/plot.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace cylon::cli {

using nlohmann::ordered_json;

std::string picture(const hunt::Card& card) {
  const hunt::Fault& fault = card.fault;
  if (!fault.detail.empty() || fault.steps < 2) return "";
  reports::Plot plot;
  plot.title = fmt::format("{}: {}", card.engine, fault.oracle);
  plot.x_label = "step [s]";
  plot.y_label = fmt::format("error [{}]", fault.unit);
  plot.line = fault.allowed;
  reports::Curve curve{card.engine, 0, 0, {}};
  for (std::size_t i = fault.steps; i-- > 0;)
    curve.points.emplace_back(card.trial.step / static_cast<double>(1 << i), fault.measured[i]);
  plot.curves.push_back(std::move(curve));
  return to_svg(plot);
}

void write_card(const std::filesystem::path& folder, const WrittenCard& written) {
  const hunt::Card& card = written.card;
  const std::string stem = (folder / card.file_stem()).string();
  const std::string svg = picture(card);
  std::string between = hunt::markdown(written.program);
  if (!svg.empty()) {
    write_whole(stem + ".svg", svg);
    between += fmt::format("![Error at each step]({}.svg)\n\n", card.file_stem());
  }
  write_whole(stem + ".toml", hunt::scenario_toml(card));
  write_whole(stem + ".md", hunt::markdown(card, between));
  if (written.program.program)
    write_whole((folder / written.program.program->file).string(), written.program.program->text);
}

ordered_json document(const std::vector<WrittenCard>& all) {
  ordered_json cards = ordered_json::array();
  for (const WrittenCard& written : all) {
    const hunt::Card& card = written.card;
    ordered_json measured = ordered_json::array(), opinions = ordered_json::array();
    for (std::size_t i = 0; i < card.fault.steps; ++i) {
      const double x = card.fault.measured[i];
      measured.push_back({{"dt", card.trial.step / static_cast<double>(1 << i)},
                          {"error", std::isfinite(x) ? ordered_json(x) : ordered_json(nullptr)}});
    }
    for (const hunt::Opinion& o : card.opinions)
      opinions.push_back({{"engine", o.engine}, {"version", o.version}, {"says", o.says()}});
    ordered_json one = {
        {"name", card.file_stem()},
        {"engine", card.engine},
        {"version", card.version},
        {"signature", card.signature},
        {"oracle", card.fault.oracle},
        {"kind", hunt::name(card.fault.kind)},
        {"says", card.fault.says},
        {"reason", hunt::reason(card.fault)},
        {"detail", card.fault.detail},
        {"by_time", card.fault.by_time},
        {"measured", measured},
        {"allowed", card.fault.allowed},
        {"unit", card.fault.unit},
        {"hits", card.hits},
        {"found_in", fmt::format("scene {} of {} ({})", card.number, card.source, card.family)},
        {"opinions", opinions},
        {"scenario", hunt::scenario_toml(card)},
        {"command", hunt::command(card, card.file_stem() + ".toml")},
        {"no_program", written.program.none}};
    if (const auto& p = written.program.program)
      one["program"] = {{"file", p->file},
                        {"text", p->text},
                        {"command", p->needs + " && " + p->command},
                        {"prints", p->prints},
                        {"unit", p->unit}};
    cards.push_back(std::move(one));
  }
  return {{"format", "cylon-hunt/1"}, {"cards", cards}};
}

}  // namespace cylon::cli
