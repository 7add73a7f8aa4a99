// Small oscillations that are not small: points on springs whose pull is linear in the displacements move in
// normal modes, each a harmonic oscillator of its own.
// H. Goldstein, C. Poole, J. Safko, Classical Mechanics, 3rd ed., sections 6.2 and 6.3.
#pragma once

#include "engine/model.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace cylon::engine {

/// A force that acts on the modes, at t = 0 and for ever: its share in each mode along x, y and z.
struct ModalForce {
  double frequency = 0;                   ///< It goes as cos(frequency t) [rad/s].
  std::array<Eigen::VectorXd, 3> shares;  ///< U^T F, per axis.
};

/// Points that springs tie together.  With y the displacements from the start, M y'' + K y = F(t) along each
/// axis, U^T M U = 1 and U^T K U = diag(frequency^2), the modes q = U^T M y obey q'' + frequency^2 q = U^T F.
struct ModeGroup {
  std::vector<std::size_t> bodies;
  Eigen::VectorXd frequencies;            ///< One per mode [rad/s], >= 0; 0: moves off as a whole.
  Eigen::MatrixXd shapes;                 ///< U: bodies x modes [kg^(-1/2)].
  std::array<Eigen::VectorXd, 3> pushes;  ///< U^T K: dq/dt at t = 0, per axis.
  std::vector<ModalForce> forces;         ///< All that acts at the start, springs included; then the drives.
};

/// The modes of a model.  `why_not` is empty where the motion is that of the modes for all time; otherwise
/// it names what is not linear, and there are no groups.
struct NormalModes {
  std::string why_not;
  std::vector<ModeGroup> groups;
};

/// Springs without rest length pull linearly.  So do those with one while all that they tie together moves on
/// one line parallel to an axis and nothing passes through another: |d| is d or -d.  Whether anything ever
/// will is bounded by the sum of all amplitudes.  Groups of more than `most_tied` points are left to
/// integration, as n^3 of setting up and n^2 of each sample are no longer little.
NormalModes normal_modes(const Model&);

inline constexpr std::size_t most_tied = 64;

}  // namespace cylon::engine
