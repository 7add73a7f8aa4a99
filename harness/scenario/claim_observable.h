// What a claim measures, and how it is called: the keys `conserves`, `observable`, `event`, `body`,
// `component`, …
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/draft.h"

#include <initializer_list>
#include <string_view>

namespace cylon::scenario {

/// Whether the quantity is an angle, which has no size of its own to be relative to.
bool is_angle(core::Quantity);

/// Fails at the first of the keys that is present, if `when`: "key why".
void refuse(const Table&, std::initializer_list<const char*> keys, bool when, std::string_view why);

/// Fails for an observable that the scene does not have, and for keys that belong to another observable.
core::Observable read_observable(const Table& claim, const Draft&);

/// The name of a claim in reports and in expected.toml: "angular_momentum conserved, y", "event follows
/// bouncing_sphere, apex 2 height".  No character has a meaning in globs.
std::string label_of(const Table&, const core::Claim&);

}  // namespace cylon::scenario
