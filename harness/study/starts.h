// The starts from which a setting is tried: the scenario's own, and others near it, each with its yardstick.
#pragma once

#include "harness/study/yardstick.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace cylon::study {

struct Start {
  std::unique_ptr<const scenario::Scenario> scenario;  ///< The yardstick points here.
  std::unique_ptr<const Yardstick> yardstick;
  std::size_t by = 0;  ///< The measure that decides.
};

/// The scenario itself, and its variations by those parts (scenario::varied) as far as they exist.
/// `observable`: a measure's name, or "" for the principal one.  Empty where the scenario has no measure.
/// Throws core::InputError for an unknown observable.
std::vector<Start> starts(const scenario::Scenario&, std::span<const double> variations, std::int64_t samples,
                          const std::string& observable, std::span<const process::EngineRow>,
                          const process::Limits&);

}  // namespace cylon::study
