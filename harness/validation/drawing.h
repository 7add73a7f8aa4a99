// A run as a page draws it: measured and predicted curves with the band, and where the bodies are.
#pragma once

#include "harness/validation/band.h"

#include <string>
#include <vector>

namespace cylon::validation {

/// Everything in lengths of the data, at the frames of the run.
struct Drawing {
  std::string run, failure;             ///< Why there is no prediction; the rest is not known then.
  Eigen::MatrixXd measured, predicted;  ///< curves.h.
  std::vector<double> turn;        ///< Angle between predicted and measured orientation of a free body [rad].
  Range band;                      ///< Empty without members.
  core::Scene scene;               ///< Started where the run does, with the parameters of the fit.
  std::vector<core::State> poses;  ///< Of all bodies of the scene, as predicted.
  std::vector<core::State>
      seen;  ///< The same, but for the measured bodies, which are where they were measured.
};

/// One run on one engine, with the parameters of a fit where there is one.
Drawing drawing(const measured::Experiment&, std::size_t run, const study::Runner&, const Band&,
                const Fitted& = {});

}  // namespace cylon::validation
