// Solutions by blocks are those of a dense factorisation, and a tree is not filled.
#include "engine/pile/block_factor.h"

#include <gtest/gtest.h>
#include <Eigen/Cholesky>

#include <cmath>
#include <random>

namespace cylon::engine::pile {
namespace {

using Pairs = std::vector<BlockFactor::Pair>;

struct Case {
  const char* name;
  int bodies;
  Pairs couples;
};

Pairs chain(int bodies) {
  Pairs pairs;
  for (int i = 0; i + 1 < bodies; ++i) pairs.emplace_back(i + 1, i);
  return pairs;
}

// Each hangs on one of those before it.
Pairs tree(int bodies) {
  Pairs pairs;
  for (int i = 1; i < bodies; ++i) pairs.emplace_back(i, (i * 7 + 3) % i);
  return pairs;
}

Pairs wall(int wide, int high) {
  Pairs pairs;
  for (int x = 0; x < wide; ++x)
    for (int y = 0; y < high; ++y) {
      if (x + 1 < wide) pairs.emplace_back(x * high + y, (x + 1) * high + y);
      if (y + 1 < high) pairs.emplace_back(x * high + y + 1, x * high + y);
    }
  return pairs;
}

std::vector<Case> cases() {
  Pairs all;
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < i; ++k) all.emplace_back(k, i), all.emplace_back(i, k);  // twice
  return {{"one", 1, {}},         {"apart", 4, {}},         {"chain", 12, chain(12)},
          {"tree", 15, tree(15)}, {"wall", 20, wall(5, 4)}, {"all with all", 7, all}};
}

// A = sum of (J_a J_b)^T (J_a J_b) over couples, and the identity.
void fill(const Case& of, unsigned seed, BlockFactor& factor, Eigen::MatrixXd& dense) {
  std::mt19937 random(seed);
  const auto block = [&] {
    BlockFactor::Block m;
    for (int i = 0; i < 36; ++i) m(i / 6, i % 6) = static_cast<double>(random()) / 4294967296. - 0.5;
    return m;
  };
  factor.set_pattern(of.bodies, of.couples);
  factor.clear();
  const Eigen::Index size = 6 * Eigen::Index{of.bodies};
  dense = Eigen::MatrixXd::Identity(size, size);
  for (int i = 0; i < of.bodies; ++i) factor.diagonal(i) = BlockFactor::Block::Identity();
  for (const auto& [a, b] : of.couples) {
    const Eigen::Index at = 6 * Eigen::Index{a}, other = 6 * Eigen::Index{b};
    const BlockFactor::Block to_a = block(), to_b = block();
    factor.diagonal(a) += to_a.transpose() * to_a;
    factor.diagonal(b) += to_b.transpose() * to_b;
    const bool later = factor.is_later(a, b);
    factor.at(factor.find(a, b)) += later ? to_a.transpose() * to_b : to_b.transpose() * to_a;
    dense.block<6, 6>(at, at) += to_a.transpose() * to_a;
    dense.block<6, 6>(other, other) += to_b.transpose() * to_b;
    dense.block<6, 6>(at, other) += to_a.transpose() * to_b;
    dense.block<6, 6>(other, at) += to_b.transpose() * to_a;
  }
}

TEST(BlockFactor, SolvesAsADenseFactorisationDoes) {
  BlockFactor factor;  // one for all, so that patterns follow each other
  for (const Case& of : cases())
    for (const unsigned seed : {1U, 2U}) {
      SCOPED_TRACE(of.name);
      Eigen::MatrixXd dense;
      fill(of, seed, factor, dense);
      Eigen::VectorXd right(6 * Eigen::Index{of.bodies});
      for (Eigen::Index i = 0; i < right.size(); ++i) right[i] = std::sin(1.0 + static_cast<double>(i));
      Eigen::VectorXd x = right;
      factor.factor(), factor.solve(x);
      const Eigen::VectorXd exact = dense.llt().solve(right);
      EXPECT_LT((x - exact).norm(), 1e-12 * exact.norm());
    }
}

// work() of a tree is linear, of a row of squares nearly; of bodies that all couple it is their cube.
TEST(BlockFactor, DoesNotFillTrees) {
  const auto work = [](int bodies, const Pairs& couples) {
    BlockFactor factor;
    factor.set_pattern(bodies, couples);
    return static_cast<double>(factor.work());
  };
  EXPECT_NEAR(work(200, chain(200)) / work(100, chain(100)), 2, 0.02);
  EXPECT_NEAR(work(200, tree(200)) / work(100, tree(100)), 2, 0.02);
  EXPECT_LT(work(200, wall(50, 4)) / work(100, wall(25, 4)), 2.3);
}

// A body without anything that holds it has a row of zeros: a little stiffer it is solved, and no number is lost.
TEST(BlockFactor, TakesPivotsOfRoundingForALittleStiffness) {
  BlockFactor factor;
  factor.set_pattern(2, {{0, 1}});
  factor.clear();
  const BlockFactor::Block one = BlockFactor::Block::Identity();
  factor.diagonal(0) = one, factor.diagonal(1) = one, factor.at(factor.find(0, 1)) = -one;  // singular
  Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(12, 1, 2);
  factor.factor(), factor.solve(x);
  EXPECT_TRUE(x.allFinite());
}

}  // namespace
}  // namespace cylon::engine::pile
