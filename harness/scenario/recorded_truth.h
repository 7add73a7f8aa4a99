// Recorded data as a Truth: files in the format truth/1, with `trajectory` and `bodies`.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <string>
#include <string_view>

namespace cylon::scenario {

/// Reads truth/1: UTF-8 JSON; numbers of physics as decimal strings (or JSON numbers).
///
///     "t": [t_0, …]            [s], ascending from >= 0
///     "bodies": [{"id": …}]    ids are names of bodies in the scene; one body in both needs no agreement of
///     names "trajectory": {id: {"position": [[x, y, z], …], "velocity": …, "orientation": [[w, x, y, z], …],
///                         "angular_velocity": …}}     world axes; the last two only where the body turns
///     "events": [{"kind": "turn", "body": …, "time": …}, …]     optional, in order of time: the kinds of
///                         harness/core/event.h, all of a kind that is named; "to" or "plane": the other of a
///                         pair; "speed", "height", "distance", "angle", "azimuth" where they are known
///     "agreement": {"max_abs_diff": …}     optional bound on every component, on top of double's rounding
///
/// A key that is neither one of these nor a description (name, source, note, model, …) is refused.
/// The truth is known at the times of the file alone, and state(t) throws std::invalid_argument at others.
/// Bodies that the file leaves out must be locked.  Throws core::InputError, led by `file`.
core::Truth parse_truth(std::string_view json, const std::string& file, const core::Scene&);

}  // namespace cylon::scenario
