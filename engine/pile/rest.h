// Whether a body that hardly moves may be laid to rest.
#pragma once

#include "engine/pile/groups.h"

namespace cylon::engine::pile {

/// Whether all points at which a group touches a body lie on one line, to a part in a thousand of `size` [m]: a
/// body with edges that stands so is in unstable balance.  It falls however slowly it moves at first.
bool stands_on_a_line(int body, const Group&, const std::vector<Block>&, Real size);

}  // namespace cylon::engine::pile
