// Newton's second law as a check of the contact forces that an engine tells.
//
//   momentum_balance          F = m (v_n - v_{n-1})/dt - m g - sum J/dt
//   angular_momentum_balance  M = (L_n - L_{n-1})/dt - sum (p - x_n) x J/dt,  L = R I R^T w
//
// over the last step, with J the impulses of the contacts on the body (normal and friction, world axes) and p
// their points.  Both are zero where what the engine tells is what moved the body, or held it.  M is that to
// first order in dt: within the step p and x move.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/recording.h"

#include <optional>
#include <string>

namespace cylon::core {

/// Why no balance can be drawn: forces other than contacts and uniform gravity act, or no body that moves may
/// touch anything.
std::optional<std::string> balance_undefined(const Observable&, const Scene&);

/// What the recording lacks for a balance, in words, or nothing: the engine tells no contact forces, or no
/// friction where surfaces are rough.
std::optional<std::string> untold(const Observable&, const Scene&, const Recording&);

/// The size of the balance of the body for which it is largest [N] or [N m]; what is untold counts as zero.  NaN
/// where a state is.  Needs the states of the last two steps: throws std::logic_error without them.
double contact_imbalance(const Observable&, const Scene&, const Recording&);

}  // namespace cylon::core
