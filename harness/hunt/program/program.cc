#include "harness/hunt/program/program.h"

#include "harness/hunt/oracle.h"
#include "harness/hunt/program/dialect.h"
#include "harness/hunt/program/formulas.h"
#include "harness/hunt/program/numbers.h"
#include "harness/hunt/program/scene_text.h"
#include "harness/scenario/scenario.h"
#include "harness/study/relations.h"
#include "harness/study/restate.h"
#include "harness/study/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cylon::hunt {
namespace {

using namespace program;
using core::Quaternion;
using core::Scene;
using core::State;
using core::Vector3;

class Writer {
 public:
  Writer(const Card& card, const Dialect& dialect, const Formula& formula,
         const process::EngineChoice& engine, const process::Limits& limits)
      : card_(card),
        dialect_(dialect),
        language_(*dialect.language),
        numbers_(language_),
        formula_(formula),
        engine_(engine),
        limits_(limits) {
    // Of a fault of fine steps alone the coarse one shows nothing.
    const auto& measured = card.fault.measured;
    if (measured[0] <= card.fault.allowed) shown_ = std::ranges::max_element(measured) - measured.begin();
    step_ = std::ldexp(card.trial.step, -static_cast<int>(shown_));
    steps_ = card.trial.steps << shown_;
  }

  Program written() {
    takes_ = {card_.trial.scene};
    if (formula_.reduce == Reduce::pair) restate();
    require_expressible(takes_);
    Program program;
    program.prints = printed();
    settings();
    words_["dt"] = Numbers::number(step_), words_["steps"] = std::to_string(steps_);
    say_scene(takes_, dialect_, words_);
    if (formula_.oracle == "penetration") words_["depths"] = depths(takes_[0], language_);
    if (formula_.oracle == "rebound") {
      const core::Plane& plane = takes_[0].planes.at(0);
      words_["normal"] = numbers_.vector(plane.normal);
      words_["height"] =
          Numbers::number(plane.offset + std::get<core::Sphere>(takes_[0].bodies.at(0).shape).radius);
    }
    if (!required_.empty())
      words_["required"] =
          numbers_.list(required_, [&](const core::BodyState& b) { return numbers_.state(b); });
    program.unit = words_["unit"] = formula_.unit;
    program.file = fmt::format("{}.{}", card_.file_stem(), language_.ending);
    words_["file"] = program.file;
    program.needs = dialect_.needs, program.command = filled(dialect_.command, words_);
    program.text = without_unused(text(program), language_.helpers);
    if (const auto at = program.text.find("${"); at != std::string::npos)
      throw None{"no text for " + program.text.substr(at, program.text.find('}', at) + 1 - at)};
    return program;
  }

 private:
  // As study/relations.cc restates it.
  void restate() {
    study::Restatement change;
    if (formula_.oracle == "relation rotation") {
      change.turn = Eigen::AngleAxisd(0.9, Vector3(-0.2, 0.5, 0.3).normalized()).toRotationMatrix();
      turn_ = Quaternion(change.turn);
    } else {
      const Scene& scene = card_.trial.scene;
      const double duration = card_.trial.step * static_cast<double>(card_.trial.steps);
      change.move = study::scales(scene, duration).length * Vector3(0.73, -1.31, 0.47);
      move_ = change.move;
    }
    takes_.push_back(change(takes_[0]));
  }

  // ---- What it must print ------------------------------------------------------------------------------------

  core::Recording recorded(const Scene& scene) {
    process::RunOutcome last;
    const study::Runner run = study::worker_runner(engine_, limits_, &last);
    core::Recording recording = run(scene, step_, steps_, 1);
    terms_ = recording.terms;
    return recording;
  }

  double printed() {
    const core::Recording one = recorded(takes_[0]);
    if (formula_.reduce == Reduce::sample) return at_worst_sample(one);
    if (formula_.reduce != Reduce::pair) return card_.fault.measured[static_cast<std::size_t>(shown_)];
    const core::Recording other = recorded(takes_[1]);
    double worst = 0;
    for (std::size_t k = 0; k < one.states.size(); ++k)
      for (std::size_t i = 0; i < one.states[k].size(); ++i)
        worst =
            std::max(worst, (other.states[k][i].position - turn_ * one.states[k][i].position - move_).norm());
    words_["change"] =
        formula_.oracle == "relation rotation" ? numbers_.vector(turn_) : numbers_.vector(move_);
    return worst;
  }

  double at_worst_sample(const core::Recording& run) {
    scenario::Scenario scenario = scenario::parse(to_toml(card_.trial, card_.fault.claim), "hunted.toml");
    const core::Truth& truth = scenario.claims.at(0).truth.value();
    double worst = -1;
    for (std::size_t k = 0; k < run.states.size(); ++k) {
      const State required = truth.state(run.time(k));
      double far = 0;
      for (std::size_t i = 0; i < required.size(); ++i) {
        const core::BodyState &is = run.states[k][i], &must = required[i];
        const double half = std::min((is.orientation.coeffs() - must.orientation.coeffs()).norm(),
                                     (is.orientation.coeffs() + must.orientation.coeffs()).norm()) /
                            2;
        far = std::max(far, formula_.oracle == "place" ? (is.position - must.position).norm()
                                                       : 4 * std::asin(std::min(1.0, half)));
      }
      if (far <= worst) continue;
      worst = far;
      words_["sample"] = std::to_string(k);
      required_ = required;
    }
    return worst;
  }

  // ---- The rows --------------------------------------------------------------------------------------------------

  // An integrator is told where it is not the engine's own; a row may name that one as well.
  std::vector<core::Setting> told() const {
    std::vector<core::Setting> all = terms_.settings;
    const auto integrator = std::ranges::find(all, "integrator", &core::Setting::name);
    if (integrator == all.end())
      all.insert(all.begin(), {"integrator", terms_.integrator, terms_.integrator, ""});
    else
      std::rotate(all.begin(), integrator, integrator + 1);
    return all;
  }

  void settings() {
    for (const char* word : {"world_settings", "body_settings", "shape_settings"}) words_[word];
    for (const core::Setting& setting : told()) {
      words_[setting.name] = setting.value;
      const auto row = std::ranges::find_if(dialect_.settings, [&](const SettingRow& r) {
        const bool begins =
            r.name.ends_with('*') && setting.name.starts_with(r.name.substr(0, r.name.size() - 1));
        return (begins || r.name == setting.name) && (r.value.empty() || r.value == setting.value);
      });
      if (row == dialect_.settings.end()) {
        if (setting.value == setting.engine_default) continue;
        throw None{fmt::format("no line for the setting {} = {}", setting.name, setting.value)};
      }
      const std::string line = filled(row->text, {{"name", setting.name}, {"value", setting.value}});
      using enum SettingRow::Where;
      if (row->where != program)
        words_[row->where == world  ? "world_settings"
               : row->where == body ? "body_settings"
                                    : "shape_settings"] += line;
    }
  }

  // ---- The text ------------------------------------------------------------------------------------------------------

  std::string text(const Program& program) {
    const auto comment = [&](const std::string& line) {
      return std::string(language_.comment) + line + '\n';
    };
    std::string out = comment(fmt::format("{} {}, {}.", dialect_.title, card_.version, card_.signature));
    out += comment(fmt::format("What should happen: {}.", card_.fault.says));
    out += comment(fmt::format("It prints {:.3g} {}.", program.prints, formula_.unit));
    out += comment(fmt::format("{} && {}", program.needs, program.command));
    out += dialect_.head;
    out += language_.helpers;
    out += filled(language_.data, words_);
    const auto shared = [&](std::string_view formulas) {
      return language_.translated(filled(formulas, words_));
    };
    std::string constants;
    if (const auto at = words_.find("change"); at != words_.end())
      constants += "const let change = " + at->second + ";\n";
    if (const auto at = words_.find("required"); at != words_.end())
      constants += fmt::format("const {} required = {}{};\n", &language_ == &cpp ? "std::vector<State>" : "",
                               at->second, &language_ == &cpp ? "" : ".map(moving)");
    if (&language_ == &javascript)
      for (std::size_t at = 0; (at = constants.find("const let")) != std::string::npos;)
        constants.replace(at, 9, "const");
    out += language_.translated(constants);
    out += filled(dialect_.functions, words_);
    out += shared(laws(takes_[0]));
    const bool forced = !words_["forces"].empty();
    if (forced || dialect_.asks) out += filled(language_.act, words_);
    words_["act"] = forced && !dialect_.asks ? "    act((k - 1) * dt, path[k - 1]);\n" : "";
    out += shared(run);
    out += shared(formula_.text);
    out += filled(language_.main,
                  {{"main", indented(shared(reduction(formula_)))}, {"unit", std::string(formula_.unit)}});
    return out;
  }

  std::string indented(const std::string& lines) const {
    if (&language_ != &cpp) return lines;
    std::string out = "  ";
    for (std::size_t i = 0; i < lines.size(); ++i) {
      out += lines[i];
      if (lines[i] == '\n' && i + 1 < lines.size()) out += "  ";
    }
    return out;
  }

  const Card& card_;
  const Dialect& dialect_;
  const Language& language_;
  const Numbers numbers_;
  const Formula& formula_;
  const process::EngineChoice& engine_;
  const process::Limits& limits_;
  std::vector<Scene> takes_;  // the scene, and what it is restated as
  Quaternion turn_ = Quaternion::Identity();
  Vector3 move_ = Vector3::Zero();
  State required_;
  core::Terms terms_;
  std::ptrdiff_t shown_ = 0;  // of the measured ones
  double step_ = 0;           // [s]
  std::int64_t steps_ = 0;
  Words words_;
};

}  // namespace

Written write_program(const Card& card, const process::EngineChoice& engine, const process::Limits& limits) {
  if (!card.fault.detail.empty()) return {std::nullopt, "the fault has no number"};
  const std::string name = process::describe(engine, limits).name;
  const auto all = dialects();
  // A row may have texts of its own, beside those of its engine.
  auto dialect = std::ranges::find_if(all, [&](const Dialect* d) { return d->engine == engine.row.id; });
  if (dialect == all.end())
    dialect = std::ranges::find_if(all, [&](const Dialect* d) { return d->engine == name; });
  if (dialect == all.end()) return {std::nullopt, fmt::format("no table of texts for the API of {}", name)};
  const auto formula = std::ranges::find(formulas(), card.fault.oracle, &Formula::oracle);
  if (formula == formulas().end())
    return {std::nullopt, fmt::format("the oracle '{}' takes more than a few lines", card.fault.oracle)};
  try {
    return {Writer(card, **dialect, *formula, engine, limits).written(), ""};
  } catch (const None& none) {
    return {std::nullopt, none.why};
  } catch (const study::RunFailed&) {
    return {std::nullopt, "the engine did not end"};
  }
}

std::string markdown(const Written& written) {
  if (!written.program)
    return fmt::format("There is no program against the engine's own API: {}.\n\n", written.none);
  const Program& p = *written.program;
  return fmt::format("`{}` shows it without Cylon. It must print {:.6g} {}:\n\n```sh\n{}\n```\n\n", p.file,
                     p.prints, p.unit, p.needs + " && " + p.command);
}

}  // namespace cylon::hunt
