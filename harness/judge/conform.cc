#include "harness/judge/conform.h"

#include "harness/core/input_error.h"
#include "harness/results/digits_text.h"
#include "harness/results/duration.h"
#include "harness/results/substeps.h"
#include "harness/scenario/scenario.h"
#include "harness/study/cell.h"

#include <fmt/format.h>
#include <immintrin.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <span>

namespace cylon::judge {
namespace {

namespace fs = std::filesystem;

constexpr const char* id = "engine";

fs::path find(const std::string& scenario, const fs::path& folder) {
  if (scenario.ends_with(".toml")) return scenario;
  std::vector<std::string> names;
  for (const fs::path& place : {folder, folder / "extremes"}) {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(place, ignored)) {
      if (entry.path().extension() != ".toml") continue;
      if (entry.path().stem() == scenario) return entry.path();
      names.push_back(entry.path().stem().string());
    }
  }
  std::sort(names.begin(), names.end());
  throw core::InputError(fmt::format("no scenario '{}' in {}{}", scenario, folder.string(),
                                     core::did_you_mean(scenario, names)));
}

// The truths are computed in this process, whose program is not ours: -ffast-math at its link sets both flags.
void require_plain_arithmetic() {
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;  // of MXCSR
  if (std::fegetround() != FE_TONEAREST || (_mm_getcsr() & (flush_to_zero | denormals_are_zero)))
    throw core::InputError(
        "the judge computes with rounding to nearest and subnormal numbers, and this program has changed "
        "that: link the "
        "tests without -ffast-math");
}

study::Cell cell_of(const scenario::Scenario& scenario, const Engine& engine, const Asked& asked) {
  if (!(asked.dt >= 0) || !std::isfinite(asked.dt))
    throw core::InputError(
        fmt::format("dt = {}: must be a step > 0 [s], or 0 for the nominal one", asked.dt));
  if (!(asked.tolerance_scale >= 0) || !std::isfinite(asked.tolerance_scale))
    throw core::InputError(fmt::format("tolerance_scale = {}: must be >= 0", asked.tolerance_scale));
  if (engine.command.empty()) throw core::InputError("the engine has no command");
  const process::EngineRow row{id, engine.command, ""};
  const std::string variant = engine.variant.empty() ? "" : "/" + engine.variant;
  study::Cell cell{&scenario, process::parse_engine(id + variant, std::span(&row, 1)),
                   asked.dt > 0 ? asked.dt : scenario.step,
                   asked.dt > 0 ? fmt::format("{}", asked.dt) : scenario.step_text};
  cell.tolerance_scale = asked.tolerance_scale;
  return cell;
}

std::string line(const results::Verdict& v) {
  std::string text = fmt::format("  {}: {}", v.claim, results::name(v.status));
  if (std::isfinite(v.measured))
    text += fmt::format(": measured {:.4g} {}, allowed {:.4g} {}, {}", v.measured, v.unit, v.allowed, v.unit,
                        results::digits_in_words(results::digits(v.measured, v.allowed)));
  if (v.first_bad_step) text += fmt::format(": not finite from step {} on", *v.first_bad_step);
  if (!v.detail.empty()) text += ": " + v.detail;
  if (v.status != results::Status::pass && !v.tolerance_reason.empty())
    text += "\n    tolerance: " + v.tolerance_reason;
  return text + '\n';
}

}  // namespace

bool Conformity::conforms() const {
  return !verdicts.empty() &&
         std::ranges::all_of(verdicts, [](const auto& v) { return v.status == results::Status::pass; });
}

std::string Conformity::text() const {
  if (verdicts.empty()) return "the scenario claims nothing\n";
  const results::Verdict& first = verdicts.front();
  std::string text =
      fmt::format("{} at step {}{}{}:\n", first.scenario,
                  results::with_substeps(results::step_in_words(first.dt_text), first.substeps),
                  first.integrator.empty() ? "" : ", ", first.integrator);
  for (const results::Verdict& verdict : verdicts) text += line(verdict);
  if (!first.complaints.empty()) text += "  on stderr: " + first.complaints + '\n';
  return text;
}

Conformity conform(const Engine& engine, const std::string& scenario, const fs::path& folder,
                   const Asked& asked) {
  require_plain_arithmetic();
  const scenario::Scenario judged = scenario::load(find(scenario, folder));
  process::Limits limits;
  limits.run_seconds = asked.run_seconds;
  return {study::run(cell_of(judged, engine, asked), limits, scenario::Expectations{})};
}

}  // namespace cylon::judge
