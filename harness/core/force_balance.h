// Newton's second law as a check of the forces of contacts and joints that an engine tells.
//
//   momentum_balance          F = m (v_n - v_{n-1})/dt - m g - sum J/dt
//   angular_momentum_balance  M = (L_n - L_{n-1})/dt - sum ((p - x_n) x J + N)/dt,  L = R I R^T w
//
// over the last step, with J the impulses of contacts (normal and friction) and joints on the body, p their
// points and N the moments of joints beside them, in world axes.  Both are zero where what the engine tells is
// what moved the body, or held it.  M is that to first order in dt: within the step p and x move.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/recording.h"

#include <optional>
#include <string>

namespace cylon::core {

/// Why no balance can be drawn: forces other than contacts, joints and uniform gravity act, or no body
/// that moves may touch anything or hangs on a joint.
std::optional<std::string> balance_undefined(const Observable&, const Scene&);

/// What the recording lacks for a balance, in words, or nothing: the engine tells no forces of contacts or of
/// joints, or no friction where surfaces are rough.  An engine that tells the forces of joints is taken to tell
/// those of all contacts too.
std::optional<std::string> untold(const Observable&, const Scene&, const Recording&);

/// The size of the balance of the body for which it is largest [N] or [N m]; what is untold counts as zero.  NaN
/// where a state is.  Needs the states of the last two steps: throws std::logic_error without them.
double force_imbalance(const Observable&, const Scene&, const Recording&);

}  // namespace cylon::core
