#include "harness/hunt/trial.h"

#include "harness/scenario/writer.h"

#include <fmt/format.h>

namespace cylon::hunt {

std::string to_toml(const Trial& trial, const std::string& claims) {
  // Twelve digits: 7 steps of 0.01 s are 0.07 s, not 0.07000000000000001 s.
  const std::string duration = fmt::format("{:.12g}", static_cast<double>(trial.steps) * trial.step);
  return fmt::format("duration = {}\nstep = {}\n{}\n{}", duration, scenario::toml_number(trial.step),
                     scenario::to_toml(trial.scene), claims);
}

}  // namespace cylon::hunt
