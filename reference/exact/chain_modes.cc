#include "reference/exact/chain_modes.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace cylon::exact {

Network network(const core::Scene& scene) {
  // The world is the last node; every node takes the least number that reaches it.
  const std::size_t n = scene.bodies.size();
  std::vector<std::size_t> piece(n + 1);
  for (std::size_t i = 0; i <= n; ++i) piece[i] = i;
  for (std::size_t pass = 0; pass <= n; ++pass) {
    for (const core::Force& force : scene.forces) {
      const auto* spring = std::get_if<core::Spring>(&force);
      if (!spring) continue;
      std::size_t& a = piece[static_cast<std::size_t>(spring->body)];
      std::size_t& b = piece[spring->to == core::world ? n : static_cast<std::size_t>(spring->to)];
      a = b = std::min(a, b);
    }
  }
  if (!std::all_of(piece.begin(), piece.end() - 1, [](std::size_t p) { return p == 0; })) {
    return Network::several;
  }
  return piece[n] == 0 ? Network::tied : Network::free;
}

ChainModes::ChainModes(const core::Scene& scene) : free(network(scene) == Network::free) {
  const auto n = static_cast<Eigen::Index>(scene.bodies.size());
  root_mass.resize(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    root_mass[i] = std::sqrt(static_cast<Wide>(scene.bodies[static_cast<std::size_t>(i)].mass));
  }
  WideSquare a = WideSquare::Zero(n, n);
  for (const core::Force& force : scene.forces) {
    const auto* spring = std::get_if<core::Spring>(&force);
    if (!spring) continue;
    const Wide k = spring->stiffness;
    const Eigen::Index i = spring->body, j = spring->to;
    a(i, i) += k / (root_mass[i] * root_mass[i]);
    if (j == core::world) continue;
    a(j, j) += k / (root_mass[j] * root_mass[j]);
    a(i, j) -= k / (root_mass[i] * root_mass[j]);
    a(j, i) = a(i, j);
  }
  const Eigen::SelfAdjointEigenSolver<WideSquare> solver(a);
  shapes = solver.eigenvectors();
  WideColumn squares = solver.eigenvalues().cwiseMax(0);
  if (free) squares[0] = 0;
  frequencies = squares.cwiseSqrt();
  const WideSquare gram = shapes.transpose() * shapes;
  residual = (a * shapes - shapes * squares.asDiagonal()).norm() +
             (gram - WideSquare::Identity(n, n)).norm() * squares[n - 1];
}

}  // namespace cylon::exact
