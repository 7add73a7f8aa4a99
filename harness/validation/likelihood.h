// How likely measured motions are under a model with given parameters on an engine.
//
// A run is cut into windows of equal length that share no frame.  The window w is predicted from its own first frame x, which errs
// by L z, z standard normal; y holds what was measured in its later frames, with independent noise of variance R:
//     y = f(x + L z; p) + noise  =>  y ~ N(f(x; p) + sum_i c_i/2, s C),   C = R + sum_i (d_i d_i^T + c_i c_i^T/2),
//     d_i = (f(x + L e_i) - f(x - L e_i))/2,   c_i = f(x + L e_i) + f(x - L e_i) - 2 f(x),
// mean and covariance of f to second order in each number of z (its square has the variance 2).  Differences are as long as the errors
// themselves: a shorter one would see the steps in which an engine meets a contact, and not what errors do.  The factor s is 1, or,
// where a discrepancy of nu degrees of freedom is stated, an inverse chi-squared variable over nu of each window, so that y has a
// multivariate t distribution.
#pragma once

#include "harness/study/runner.h"
#include "reference/measured/experiment.h"

#include <Eigen/Cholesky>

#include <cstddef>
#include <span>
#include <vector>

namespace cylon::validation {

/// Frames first … first + frames - 1 of a run.
struct Window {
  std::size_t run = 0, first = 0;
};

/// Derivatives of log L in the parameters, at one point.
struct Score {
  Eigen::MatrixXd information;          ///< Fisher's: sum of s^-1 G^T C^-1 G, G = df/dp.
  std::vector<Eigen::VectorXd> of_run;  ///< The part of each run in the gradient of log L.
};

class Likelihood {
 public:
  /// Of those runs.  Throws core::InputError where the experiment states no horizon, no run is as long, there is no noise
  /// stated, or the scene's laws change with time.
  Likelihood(const measured::Experiment&, std::vector<measured::Parameter>, std::vector<std::size_t> runs,
             study::Runner, int jobs);

  const std::vector<measured::Parameter>& parameters() const { return parameters_; }
  const std::vector<std::size_t>& runs() const { return runs_; }
  std::size_t windows() const { return windows_.size(); }
  std::size_t frames() const { return frames_; }  ///< Of each window.
  std::size_t left_over() const {
    return left_over_;
  }                             ///< Frames at the ends of runs that make no whole window.
  std::size_t numbers() const;  ///< That are compared, in all windows together.
  std::size_t predictions() const { return predictions_; }  ///< Made so far.

  /// Takes b and C from starts around the measured ones, with these parameters.  What follows holds them.
  void renew(std::span<const double> values);

  /// -2 log L, less what depends on neither parameters nor engine.  Throws study::RunFailed where a window has no prediction.
  double deviance(std::span<const double> values);
  /// The same, run by run, in the order of runs().
  std::vector<double> deviances(std::span<const double> values);
  /// Sum over windows of r^T C^-1 r: chi-squared with numbers() degrees of freedom under the right model without discrepancy.
  double misfit(std::span<const double> values);

  /// By central differences of those lengths, cut at the parameters' bounds.
  Score score(std::span<const double> values, std::span<const double> lengths);

 private:
  struct Gauss {
    Eigen::VectorXd shift;
    Eigen::LLT<Eigen::MatrixXd> covariance;
    double log_determinant = 0;
  };

  Eigen::VectorXd residual(const measured::Experiment&, const Window&, const core::State& start) const;
  std::vector<Eigen::VectorXd> residuals(std::span<const double> values);
  double deviance(std::size_t window, double misfit) const;

  measured::Experiment experiment_;
  std::vector<measured::Parameter> parameters_;
  std::vector<std::size_t> runs_;
  study::Runner runner_;
  int jobs_;
  std::size_t frames_ = 0, left_over_ = 0, predictions_ = 0;
  std::vector<Window> windows_;  // those of a run stand together, in the order of runs_
  std::vector<Gauss> gauss_;
};

}  // namespace cylon::validation
