// Several bodies made one.
#pragma once

#include "engine/body.h"

#include <span>

namespace cylon::engine {

struct CompoundPart {
  Body body;
  Motion motion;
};

/// The rigid body that the parts form where they are, and its motion at once after.  Its axes are those of
/// the first part.  Nothing acts from outside, so that mass, K and L stay; kinetic energy is lost unless the
/// parts move as one.
///   m = sum m_i,  p = sum m_i p_i / m,  K = sum K_i,  L = sum (p_i - p) x K_i + L_i,
///   I = sum R_i I_i R_i^T + m_i (|d_i|^2 1 - d_i d_i^T),  d_i = p_i - p
/// Seed eq. 68-72 with p_cm and each part's tensor rotated (errata 15), and its program's sum of bodies put
/// right (errata 41, 59-61).  Locked where a part is; there p and K keep their meaning and nothing moves.
/// Requires at least one part, none pinned.
CompoundPart merge(std::span<const CompoundPart> parts);

}  // namespace cylon::engine
