// What the viewer's server says to its page (reports/web/src/shared/live.ts), as bytes.
#pragma once

#include "harness/view/session.h"

#include <nlohmann/json.hpp>

#include <string>

namespace cylon::view {

/// live.ts: Session.
nlohmann::json session_json(const Session&);

/// live.ts: SessionMessage, in a frame: u32 length of the header, u32 bytes of the payload (none), the
/// header.
std::string session_message(const Session&);

/// live.ts: StateMessage, in a frame with the payload, float32 [lane][body][13]; a lane that does not run
/// shows where it stopped.  Energy and momenta are the harness's, computed from the states; null where they
/// are not finite.
std::string state_message(const Session&);

}  // namespace cylon::view
