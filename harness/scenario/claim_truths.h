// Truths that claims follow and that cost little: exact solutions by name, recorded data by file.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/reader.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

namespace cylon::scenario {

/// The exact solutions of one scene, each made once per horizon.
class ExactTruths {
 public:
  ExactTruths(const core::Scene& scene, double step) : scene_(scene), step_(step) {}

  /// What the claim follows, with the events that it asks for.  Fails at `follows` for an unknown name, with
  /// the nearest one, and for a solution that does not serve the scene.
  const core::Truth& at(const Table&, const core::Claim&, double horizon);

 private:
  struct Solved {
    core::Truth truth;                        ///< Which remembers the states that it has told.
    std::function<core::State(double)> anew;  ///< Which does not: events are searched at times of their own.
  };
  core::Truth make(const Table&, const std::string& name, double horizon) const;
  core::Truth with_events(const Table&, const core::Observable&, const Solved&, double horizon);

  const core::Scene& scene_;
  double step_;
  std::size_t looks_ = 0;  // states of a body in which events were searched so far
  std::map<std::pair<std::string, double>, std::optional<Solved>> truths_;
  std::map<std::tuple<std::string, double, std::string>, std::optional<core::Truth>>
      events_;  ///< By what is asked.
};

/// Removes the times of recorded data after the horizon; fails at `follows` where none is left.
void cut(const Table& claim, core::Truth& recorded, double horizon);

/// Fails where the claim is about an event that its truth does not have.
void require_event(const Table&, const core::Claim&, double horizon);

}  // namespace cylon::scenario
