// How the pile stepper trades cost for accuracy.
#pragma once

#include "engine/vector.h"

#include <algorithm>

namespace cylon::engine {

struct PileSettings {
  /// Parts of a step, each with one sweep over all contacts: the iterations of other engines.  Small parts
  /// with one sweep converge faster than one part with many sweeps (M. Macklin et al., Small steps in physics
  /// simulation, SCA 2019).
  int substeps = 10;

  /// 0: as many as the machine has.  The result does not depend on it, bit for bit.
  int threads = 1;

  /// Bodies that sweeps have brought to rest keep their place, at no cost, until something touches them.  Their last steps
  /// before that are solved to rounding, if direct_points allows.
  bool rest = true;

  /// Share of the overlap that a step takes away, by moving bodies apart without touching their velocities.  The direct
  /// solution takes all of it up to `at_once`, relative to the smaller radius or half-extent.
  Real relaxation = Real(0.2);
  Real at_once = Real(1) / 64;

  /// Overlap that is left alone, relative to the smaller radius or half-extent: by sweeps, whose contacts it keeps from
  /// coming and going; by the direct solution, which needs none, only what is near rounding.
  Real slop = Real(2e-4);
  Real direct_slop = std::max(Real(2e-7), 64 * epsilon);

  /// Bodies that touch or are jointed, with at most this many contact points and parts of joints among them,
  /// are solved to rounding by a direct method in every step, in one part a step; if all groups of this size
  /// that move have together at most `exact_total` of them, so that the work is bounded.
  int exact_points = 64;
  int exact_total = 128;

  /// So are other groups with at most this many, where they come to rest, and those
  /// that sweeps cannot take: with joints, or with other forces than gravity.
  int direct_points = 512;

  /// Spheres alone are swept by themselves, fast and on any number of threads, if there are more than `few_spheres`, but for up
  /// to `standing_spheres` that begin at rest and stand.
  int few_spheres = 32;
  int standing_spheres = 256;

  /// In the first step so are groups with at most this many that begin at rest and are found to stand: that is asked once, in
  /// at most `standing_work` operations for each of the points (engine/operations.h).
  int standing_points = 1 << 15;
  int standing_work = 1 << 15;
};

}  // namespace cylon::engine
