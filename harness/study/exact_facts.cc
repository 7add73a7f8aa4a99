#include "harness/study/exact_facts.h"

#include "harness/core/content_hash.h"

#include <algorithm>
#include <cstring>

namespace cylon::study {

ExactFacts exact_facts(const core::Recording& recording) {
  core::ContentHash hash;
  const auto add = [&](const auto& value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value);
    hash.add({bytes, sizeof bytes});
  };
  for (std::size_t i = 0; i < recording.states.size(); ++i) {
    add(recording.steps[i]);
    for (const core::BodyState& s : recording.states[i]) {
      for (int k = 0; k < 3; ++k) add(s.position[k]);
      for (int k = 0; k < 4; ++k) add(s.orientation.coeffs()[k]);
      for (int k = 0; k < 3; ++k) add(s.velocity[k]);
      for (int k = 0; k < 3; ++k) add(s.angular_velocity[k]);
    }
  }
  const auto bounces =
      std::count_if(recording.events.begin(), recording.events.end(),
                    [](const core::Event& event) { return event.kind == core::EventKind::bounce; });
  return {hash.hex(), static_cast<std::int64_t>(recording.events.size()), bounces};
}

}  // namespace cylon::study
