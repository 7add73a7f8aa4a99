// A scenario as judge.  Each claim is asked as it stands in its file, of whoever promises to be that good,
// and by theory, of everyone: with the integrator's order p and the motion's fastest rate Omega, an error of a
// quantity of size S over a time T is at most
//   S (e^x - 1), x = (Omega h)^p Omega T   for a fixed step h: a part (Omega h)^(p+1) a step, compounded,
//   10 tolerance S                         for an integrator that bounds its error (it may misjudge that by ten),
//   10 tolerance S Omega T                 for one that bounds the error of each of its steps,
// times what the motion magnifies; and it must fall as h^p does.
#include "harness/core/measure.h"
#include "harness/process/read_back.h"
#include "tests/mutants/matrix/judge.h"
#include "tests/mutants/matrix/record.h"
#include "tests/mutants/matrix/scenes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace cylon::mutants {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Half a power short of the declared order: steps are in the asymptotic range, yet two terms of the error may
// still partly cancel.
constexpr double order_slack = 0.5;
// What some ten operations a step leave, all of one sign; an order is not seen below it.
constexpr double rounding_per_step = 10 * std::numeric_limits<double>::epsilon();

struct Promise {
  int order = 1;
  bool adaptive = false;
  double tolerance = 0;    ///< Of an adaptive integrator, relative.
  bool each_step = false;  ///< Whether that is of each step alone.
};

Promise promise_of(const core::Engine& engine, const core::Terms& terms) {
  Promise promise{terms.order, core::controls_its_error(engine, terms), 0, false};
  for (const core::Setting& setting : terms.settings)
    if (setting.name == "tolerance") {
      promise.tolerance = std::stod(setting.value);
      promise.each_step = setting.reason.find("each step") != std::string::npos;
    }
  if (promise.adaptive && promise.tolerance == 0)
    promise.tolerance = 1e-10;  // a closed form: rounding, and less
  return promise;
}

class Session {
 public:
  Session(const Examined& examined, const Subject& subject) : e_(examined), setup_(subject.setup) {
    setup_.dt = e_.scenario.step;
    simulator_ = subject.make();
  }

  bool unsupported() const { return simulator_->unsupported(e_.scenario.scene, setup_).has_value(); }

  std::vector<Finding> findings() {
    runs_.push_back(run());
    if (const auto bad = core::first_bad_step(runs_.front()))
      return {{"finite", nan, 0}};  // proves nothing else
    findings_.push_back({"read back", starts_elsewhere() ? 1.0 : 0.0, 0.5});
    promise_ = promise_of(simulator_->engine(), runs_.front().terms);
    for (std::size_t i = 0; i < e_.scenario.claims.size(); ++i) ask(i);
    return findings_;
  }

 private:
  core::Recording run() {
    core::Setup setup = setup_;
    setup.dt = std::ldexp(setup_.dt, -static_cast<int>(runs_.size()));
    return record(*simulator_, e_.scenario.scene, setup, study::sampling(e_.scenario, setup.dt));
  }

  bool starts_elsewhere() const {
    return process::read_back_difference(e_.scenario.scene, runs_.front().states.front(),
                                         simulator_->engine().precision)
        .has_value();
  }

  double rounding(std::size_t i) const {
    return rounding_per_step * static_cast<double>(runs_.front().steps.back()) * e_.scales[i] *
           e_.row.magnification;
  }

  double by_theory(std::size_t i) const {
    const double size = e_.scales[i] * e_.row.magnification, turns = e_.row.rate * e_.scenario.duration;
    if (promise_.adaptive) return 10 * promise_.tolerance * size * (promise_.each_step ? turns : 1);
    const double order = e_.row.forces == Forces::jumping ? 1 : promise_.order;
    return size * std::expm1(std::pow(e_.row.rate * setup_.dt, order) * turns) + rounding(i);
  }

  void ask(std::size_t i) {
    const core::Claim& claim = e_.scenario.claims[i];
    const double theory = by_theory(i);
    if (claim.tolerance.reason.starts_with("rounding") || theory <= e_.shipped[i]) {
      const core::Measured m =
          core::measure(claim, e_.scenario.scene, {runs_.data(), 1}, e_.scenario.duration);
      findings_.push_back({claim.label, m.broken ? nan : m.value, e_.shipped[i]});
    }
    if (claim.observable.quantity == core::Quantity::event || claim.reduction > core::Reduction::end ||
        claim.at_least)
      return;
    findings_.push_back({claim.label + " by theory", deviation(i, 0), theory});
    // Where the bound is a tenth of the motion itself, no order shows.
    const bool asymptotic = theory < 0.1 * e_.scales[i] && e_.row.forces == Forces::smooth;
    if (claim.truth && !promise_.adaptive && asymptotic) ask_order(i);
  }

  double deviation(std::size_t claim, std::size_t of) {
    while (runs_.size() <= of) runs_.push_back(run());
    const core::Series series = core::deviation(e_.scenario.claims[claim], e_.scenario.scene, runs_[of]);
    if (e_.scenario.claims[claim].reduction == core::Reduction::end) return series.deviation.back();
    double worst = 0;
    for (const double d : series.deviation) worst = std::isnan(d) || d > worst ? d : worst;
    return worst;
  }

  void ask_order(std::size_t i) {
    std::vector<double> steps, errors;
    for (std::size_t k = 0; k < 3; ++k) {
      errors.push_back(deviation(i, k));
      steps.push_back(std::ldexp(setup_.dt, -static_cast<int>(k)));
      if (!(errors.back() > 4 * rounding(i))) return;
    }
    const double order = core::observed_order(steps, errors);
    findings_.push_back(
        {e_.scenario.claims[i].label + " order", std::max(0.0, promise_.order - order), order_slack});
  }

  const Examined& e_;
  core::Setup setup_;
  std::unique_ptr<core::Simulator> simulator_;
  Promise promise_;
  std::vector<core::Recording> runs_;  // at h, h/2, h/4
  std::vector<Finding> findings_;
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
  return fmt::format("{}{}; {:g} rad/s: {}", row.file, time, row.rate, row.why);
}

}  // namespace

std::vector<Judge> scene_judges() {
  std::vector<Judge> result;
  for (const SceneRow& row : scene_rows()) {
    const auto scene = std::make_shared<Once>(row);
    result.push_back({row.name, asks(row), [scene](const Subject& subject) {
                        Session session(scene->examined(), subject);
                        std::optional<std::vector<Finding>> findings;
                        if (!session.unsupported()) findings = session.findings();
                        return findings;
                      }});
  }
  return result;
}

}  // namespace cylon::mutants
