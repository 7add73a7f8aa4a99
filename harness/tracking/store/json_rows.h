// The rows of the history as JSON objects, and back: what stands in a line of json_lines.h.
#pragma once

#include "harness/tracking/store/json_object.h"
#include "harness/tracking/store/model.h"

#include <nlohmann/json.hpp>

namespace cylon::store {

/// Numbers that are not finite become null.  A result has its samples and verdicts; its run is named by uid,
/// its cell by hash.
nlohmann::ordered_json to_json(const RunInfo&);
nlohmann::ordered_json to_json(const Cell&);
nlohmann::ordered_json to_json(const RunInfo&, const Result&);
nlohmann::ordered_json to_json(const Anchor&);
nlohmann::ordered_json to_json(const ChangePoint&);

/// The inverse; each complains of a key that is missing, unknown or impossible.
RunInfo run_from(JsonObject);
Cell cell_from(JsonObject);
Sample sample_from(JsonObject);
Judgement judgement_from(JsonObject);
Anchor anchor_from(JsonObject);
ChangePoint change_point_from(JsonObject);

}  // namespace cylon::store
