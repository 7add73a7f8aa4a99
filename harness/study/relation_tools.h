// What the relations share: why a scene is left out, and how two runs are compared.
#pragma once

#include "harness/core/fields.h"
#include "harness/core/force_law.h"
#include "harness/study/relations.h"

#include <functional>

namespace cylon::study {

/// Why a relation says nothing about a scene; nothing when it does.
using Reason = std::optional<std::string>;

/// Why the first force, in their order, breaks a law.
Reason broken(const core::Scene&, const char* core::Broken::*law);
/// The place of the origin or the axes matter to a force: the first such reason.
Reason placed(const core::Scene&);
/// As above, or the frame turns about its origin.
Reason fixed_place(const core::Scene&);

/// The other run's state at each sample against what the plain one requires there; NaN where either is.
double worst(const Subject&, const core::Recording& other,
             const std::function<core::State(const core::State&, double time)>& required);

/// Another scene run as the plain one was; `time` is the new unit of time.
core::Recording again(const Subject&, const Runner&, const core::Scene&, double time = 1);

/// General values: no axis, no round number, nothing that an engine's grid could fit.
inline const core::Vector3 along(0.73, -1.31, 0.47);

/// Calls visit(int&) for each index of a body in a force or a joint, also where it is the world.
template <class Element, class Visit>
void each_body_index(Element& element, Visit&& visit) {
  core::for_each_field(element, [&]<class Value>(const auto&, Value& value) {
    if constexpr (std::is_same_v<std::remove_const_t<Value>, int>) visit(value);
    if constexpr (std::is_same_v<std::remove_const_t<Value>, std::vector<int>>)
      for (auto& body : value) visit(body);
  });
}

}  // namespace cylon::study
