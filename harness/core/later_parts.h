// What a scene may have that an engine written before does not know.  Such an engine would leave it out and say
// nothing, so it gets no such scene unless it says that it knows the part.
#pragma once

#include "harness/core/collision_filter.h"
#include "harness/core/engine.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace cylon::core {

struct LaterPart {
  std::string_view word;  ///< In Engine::knows.
  std::string_view text;  ///< For people.
  bool (*is_in)(const Scene&);
};

inline constexpr std::array later_parts = {
    LaterPart{"collision_filters", "collision groups and masks", states_filters},
    LaterPart{"body_gravity", "bodies with gravities of their own", states_own_gravity},
};

/// Why the engine may not get the scene: the first part of it that it does not say it knows.
inline std::optional<std::string> not_known(const Engine& engine, const Scene& scene) {
  for (const LaterPart& part : later_parts)
    if (part.is_in(scene) && std::ranges::find(engine.knows, part.word) == engine.knows.end())
      return "the scene has " + std::string(part.text) +
             ", and the engine does not say that it knows them (" + std::string(part.word) + ")";
  return std::nullopt;
}

}  // namespace cylon::core
