#include "harness/study/starts.h"

#include "harness/process/interruption.h"
#include "harness/scenario/vary.h"
#include "harness/study/self_reference.h"

#include <optional>
#include <utility>

namespace cylon::study {

std::vector<Start> starts(const scenario::Scenario& scenario, std::span<const double> variations,
                          std::int64_t samples, const std::string& observable,
                          std::span<const process::EngineRow> rows, const process::Limits& limits) {
  std::vector<Start> result;
  const auto add = [&](scenario::Scenario from) {
    if (process::interrupted()) throw process::Interrupted();  // truths take seconds, and ask nobody
    Start start;
    start.scenario = std::make_unique<const scenario::Scenario>(std::move(from));
    start.yardstick = std::make_unique<const Yardstick>(
        *start.scenario, samples, self_reference(*start.scenario, samples, rows, limits));
    if (start.yardstick->measures().empty()) return;
    start.by = observable.empty() ? start.yardstick->principal() : start.yardstick->find(observable);
    result.push_back(std::move(start));
  };
  add(scenario);
  for (const double amount : variations)
    if (auto other = scenario::varied(scenario, amount)) add(std::move(*other));
  return result;
}

}  // namespace cylon::study
