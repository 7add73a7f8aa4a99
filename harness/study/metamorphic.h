// One scenario on one engine against the relations of mechanics in place of its claims.
#pragma once

#include "harness/study/cell.h"

namespace cylon::study {

/// Of the scales of a scene, by which two runs may differ where a relation is not exact.
inline constexpr double allowed_of_relations = 1e-3;

/// Runs the cell's scene once plainly and once or twice for each relation that says something about it, and
/// gives a verdict for each.  Allowed is a thousandth of the scene's own scales for every engine; nothing,
/// where the relation holds in any arithmetic.  The claims of the scenario are not asked; the earliest
/// `until` of one that follows a truth is the horizon here too.  Errors as study::run's.
std::vector<results::Verdict> relate(const Cell&, const process::Limits&, const scenario::Expectations&);

}  // namespace cylon::study
