// A scenario as judge, by its claims as they stand in its file, of whoever promises to be that good, and by
// theory, of everyone (study/theory.h).
#include "harness/core/measure.h"
#include "harness/process/read_back.h"
#include "harness/study/theory.h"
#include "tests/mutants/matrix/judge.h"
#include "tests/mutants/matrix/record.h"
#include "tests/mutants/matrix/scenes.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <string>

namespace cylon::mutants {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class Session {
 public:
  Session(const Examined& examined, const Subject& subject) : e_(examined), setup_(subject.setup) {
    setup_.dt = e_.scenario.step;
    simulator_ = subject.make();
  }

  bool unsupported() const { return simulator_->unsupported(e_.scenario.scene, setup_).has_value(); }

  std::vector<Finding> findings() {
    runs_.push_back(run(e_.scenario, 0));
    if (const auto bad = core::first_bad_step(runs_.front()))
      return {{"finite", nan, 0}};  // proves nothing else
    std::vector<Finding> result = {{"read back", starts_elsewhere() ? 1.0 : 0.0, 0.5}};
    if (e_.scenario.theory) {
      const scenario::Scenario cut = study::cut_to_theory(e_.scenario);
      for (const study::TheoryFinding& f :
           study::judge_by_theory(cut, setup_.dt, [&](int k) { return run(cut, k); })) {
        result.push_back({f.claim, f.measured, f.allowed});
      }
    }
    for (std::size_t i = 0; i < e_.scenario.claims.size(); ++i) {
      const core::Claim& claim = e_.scenario.claims[i];
      const double promised =
          e_.scenario.theory ? study::bound_of(e_.scenario, claim, setup_.dt, runs_.front()).allowed : 0;
      if (!claim.tolerance.reason.starts_with("rounding") && promised > e_.shipped[i]) continue;
      const core::Measured m =
          core::measure(claim, e_.scenario.scene, {runs_.data(), 1}, e_.scenario.duration);
      if (m.unanswered) continue;
      result.push_back({claim.label, m.broken ? nan : m.value, e_.shipped[i]});
    }
    return result;
  }

 private:
  core::Recording run(const scenario::Scenario& scenario, int halvings) {
    core::Setup setup = setup_;
    setup.dt = std::ldexp(setup_.dt, -halvings);
    return record(*simulator_, scenario.scene, setup, study::sampling(scenario, setup.dt));
  }

  bool starts_elsewhere() const {
    return process::read_back_difference(e_.scenario.scene, runs_.front().states.front(),
                                         simulator_->engine().precision)
        .has_value();
  }

  const Examined& e_;
  core::Setup setup_;
  std::unique_ptr<core::Simulator> simulator_;
  std::vector<core::Recording> runs_;
};

// Truths take longer than runs: a scene is prepared when it is first asked for.
class Once {
 public:
  explicit Once(const SceneRow& row) : row_(row) {}
  const Examined& examined() {
    std::call_once(once_, [this] { examined_ = examine(row_); });
    return examined_;
  }

 private:
  SceneRow row_;
  std::once_flag once_;
  Examined examined_;
};

std::string asks(const SceneRow& row) {
  const std::string time = row.duration > 0 ? fmt::format(", {} s", row.duration) : "";
  return fmt::format("{}{}", row.file, time);
}

}  // namespace

std::vector<Judge> scene_judges() {
  std::vector<Judge> result;
  for (const SceneRow& row : scene_rows()) {
    const auto scene = std::make_shared<Once>(row);
    result.push_back({row.name, asks(row), row.step == 0, [scene](const Subject& subject) {
                        Session session(scene->examined(), subject);
                        std::optional<std::vector<Finding>> findings;
                        if (!session.unsupported()) findings = session.findings();
                        return findings;
                      }});
  }
  return result;
}

}  // namespace cylon::mutants
