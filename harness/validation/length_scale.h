// Whether the lengths of a data set are as long as it says, from the data alone: two signs that share no number.
#pragma once

#include "harness/validation/score.h"

namespace cylon::validation {

/// What one run says of lengths; what it does not say is not known.
struct RunLengths {
  std::string run;
  double flight = not_known;     ///< (Fitted fall)/(gravity of the scene).
  double roughness = not_known;  ///< Root mean square of the heights less that parabola [m].
  double height = not_known;     ///< Of the centre above the plane, at rest [m].
  double half = not_known;       ///< Half the thickness of the body along up, at rest [m].
  double tilt = not_known;       ///< Between up and the side that is up, at rest; of a box [rad].
  int side = 0;                  ///< The body axis that is nearest to up, ±1, ±2, ±3; 0: not at rest.
};

/// Ratios of measured to true length; each is 1 where lengths are right.
struct LengthScale {
  Estimate flight;          ///< Mean over runs, from frames before the first touch.
  Estimate rest;            ///< Mean over runs of height/half, from runs that end at rest.
  Estimate height;          ///< Mean of the height itself [m].
  double tilt = not_known;  ///< Root mean square over runs [rad].
  double gravity = 0;       ///< Of the scene, along the plane's normal [m/s^2].
  std::vector<RunLengths> each;
};

/// Touching counts from `clearance` [m] above the scene's plane.  Fewer than eight frames of flight, or a last tenth of a
/// second with more than 1 mm of motion, leave a run out.  A box at rest lies on a side: its thickness is that of the side, as the
/// corners below a tilt that is an error of the measurement would count as thickness.  Other shapes are taken as they are measured.
/// Throws core::InputError for a scene that has not exactly one plane, or no uniform gravity.
LengthScale length_scale(const measured::Experiment&, double clearance = 0.01);

/// Heights of a run's flight less the parabola of the scene's gravity that lies nearest, by frame [m]; of a wrong length they are
/// a parabola themselves.  Empty where the flight is too short.
std::vector<double> off_the_fall(const measured::Experiment&, std::size_t run, double clearance = 0.01);

/// Height of the body's lowest point above the scene's plane [m].
double gap(const measured::Experiment&, const core::BodyState&);

/// The body axis of six that is nearest to that direction (in world axes), as ±1, ±2, ±3.
int axis_towards(const core::BodyState&, const core::Vector3& direction);

}  // namespace cylon::validation
