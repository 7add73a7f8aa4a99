// Relations between a scene and one with more, fewer or otherwise ordered parts.
#pragma once

#include "harness/study/relation_tools.h"

namespace cylon::study {

/// The bodies in the opposite order.
Reason one_body(const core::Scene&);
double body_order(const Subject&, const Runner&);

/// Forces, joints and planes in the opposite order.
Reason one_part(const core::Scene&);
double part_order(const Subject&, const Runner&);

/// One more body, far away, at rest, that touches and pulls nothing.
double far_body(const Subject&, const Runner&);

/// The whole scene once more, far away along all its planes: both move as each does alone.
Reason no_room(const core::Scene&);
double bystander(const Subject&, const Runner&);

/// Without a body that nothing joins, pulls or touches.
Reason none_apart(const core::Scene&);
double removal(const Subject&, const Runner&);

/// One body modelled as two that a fixed joint holds together.
Reason none_to_split(const core::Scene&);
double weld(const Subject&, const Runner&);

/// The same joints and springs in other words: ends exchanged, a hinge's point slid along its axis, a fixed
/// joint's point anywhere.
Reason none_between(const core::Scene&);
double other_points(const Subject&, const Runner&);

}  // namespace cylon::study
