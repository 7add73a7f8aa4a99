// Normal modes of masses joined by springs: K v = w^2 M v, and how far off they are.
#pragma once

#include "reference/exact/wide.h"

namespace cylon::exact {

using WideColumn = Eigen::Matrix<Wide, Eigen::Dynamic, 1>;
using WideSquare = Eigen::Matrix<Wide, Eigen::Dynamic, Eigen::Dynamic>;

/// Of the network's springs between bodies and to pins; rest lengths and anchors do not enter.
struct ChainModes {
  WideColumn root_mass;    ///< sqrt(m_i) [kg^(1/2)]
  WideColumn frequencies;  ///< w_n >= 0, ascending [rad/s]; exactly 0 first where the network is free.
  WideSquare shapes;       ///< Columns: unit vectors of sqrt(m_i) x_i.
  Wide residual = 0;  ///< |A V - V w^2| + |V^T V - 1| w_max^2 in the 2-norm, A = M^-1/2 K M^-1/2 [1/s^2].
  bool free = false;  ///< Nothing ties the bodies to the world.

  explicit ChainModes(const core::Scene&);

  Wide slowest() const { return frequencies[free ? 1 : 0]; }
  Wide fastest() const { return frequencies[frequencies.size() - 1]; }
};

/// How the springs join bodies and world: into one piece with the world, one piece without it, or several.
enum class Network { tied, free, several };
Network network(const core::Scene&);

}  // namespace cylon::exact
