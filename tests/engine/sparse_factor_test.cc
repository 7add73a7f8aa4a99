// The sparse factor against a dense solution, and how much it fills.
#include "engine/sparse_factor.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <random>

namespace cylon::engine {
namespace {

using Ends = SparseFactor::Ends;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

struct Kind {
  const char* name;
  int bodies, rows_each;
  int (*to)(int link, std::mt19937&);  // the body before, or -1
  bool shuffled;
};

// Rows as joints have them: each link is tied to one before it.
std::vector<Ends> ends_of(const Kind& kind, std::mt19937& random) {
  std::vector<Ends> ends;
  for (int link = 0; link < kind.bodies; ++link) ends.push_back({link, kind.to(link, random)});
  if (kind.shuffled) std::shuffle(ends.begin(), ends.end(), random);
  std::vector<Ends> rows;
  for (const Ends& e : ends) rows.insert(rows.end(), static_cast<std::size_t>(kind.rows_each), e);
  return rows;
}

// J J^T + 1/8 with a random entry for each end of a row.
Matrix matrix_of(const std::vector<Ends>& ends, int bodies, std::mt19937& random) {
  std::uniform_real_distribution<double> entry(-1, 1);
  const auto n = static_cast<Eigen::Index>(ends.size());
  Matrix j = Matrix::Zero(n, Eigen::Index{6} * bodies);
  for (Eigen::Index i = 0; i < n; ++i)
    for (const int body : ends[static_cast<std::size_t>(i)])
      for (int c = 0; body >= 0 && c < 6; ++c) j(i, 6 * body + c) = static_cast<Real>(entry(random));
  return j * j.transpose() + Matrix::Identity(n, n) / 8;
}

int before(int link, std::mt19937&) { return link - 1; }
int half(int link, std::mt19937&) { return link == 0 ? -1 : (link - 1) / 2; }
int any_before(int link, std::mt19937& random) {
  return link == 0 ? -1 : static_cast<int>(random() % static_cast<unsigned>(link));
}
int any(int link, std::mt19937& random) {
  const int other = static_cast<int>(random() % 40U);
  return other == link ? -1 : other;
}

constexpr Kind kinds[] = {{"chain", 40, 3, before, false}, {"shuffled_chain", 40, 5, before, true},
                          {"tree", 40, 3, half, false},    {"random_tree", 40, 2, any_before, true},
                          {"loops", 40, 3, any, true},     {"few", 5, 3, any_before, true}};

class Sparse : public testing::TestWithParam<Kind> {};

TEST_P(Sparse, SolvesAsDenseDoes) {
  std::mt19937 random(7);
  const std::vector<Ends> ends = ends_of(GetParam(), random);
  const Matrix a = matrix_of(ends, GetParam().bodies, random);
  SparseFactor factor;
  for (int again = 0; again < 2; ++again) {  // the pattern is kept, the numbers are new
    const Real scale = static_cast<Real>(1 + again);
    factor.set_pattern(ends);
    factor.factor(
        [&](std::size_t i, std::size_t j) {
          return scale * a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        },
        Real(1e-12), true);
    Vector b = Vector::LinSpaced(a.rows(), -1, 2);
    const Vector truth = (scale * a).partialPivLu().solve(b);
    std::vector<Real> x(b.begin(), b.end());
    factor.solve(x);
    EXPECT_LE((Vector::Map(x.data(), a.rows()) - truth).norm(), Real(1e-10) * truth.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Sparse, testing::ValuesIn(kinds),
                         [](const auto& row) { return std::string(row.param.name); });

// The same row three times: one of them carries, the others get nothing.
TEST(SparseDependent, RowsGetZero) {
  const std::vector<Ends> ends(3, Ends{0, -1});
  SparseFactor factor;
  factor.set_pattern(ends);
  factor.factor([](std::size_t, std::size_t) { return Real(2); }, Real(1e-12), true);
  std::vector<Real> x = {3, 3, 3};
  factor.solve(x);
  EXPECT_EQ(x, (std::vector<Real>{Real(1.5), 0, 0}));
}

// Three directions in a plane: one, one near it, and one across.  The last two may each stand for the other: where
// joints are closed the one that gives more digits is chosen, where they are open nothing is chosen anew.
TEST(SparseDependent, RowsWithASmallPivotGoLast) {
  const Real near = Real(1e-2);
  const Vector3 rows[] = {{1, 0, 0}, {std::cos(near), std::sin(near), 0}, {0, 1, 0}};
  const auto a = [&](std::size_t i, std::size_t j) { return rows[i].dot(rows[j]); };
  const Vector3 wanted(Real(0.3), Real(-0.7), 0);
  for (const bool closed : {true, false}) {
    SparseFactor factor;
    factor.set_pattern(std::vector<Ends>(3, Ends{0, -1}));
    factor.factor([](std::size_t i, std::size_t j) { return Real(i == j); }, Real(1e-12), true);
    factor.factor(a, Real(1e-12), closed);
    std::vector<Real> x;
    for (const Vector3& row : rows) x.push_back(row.dot(wanted));
    factor.solve(x);
    Vector3 given = Vector3::Zero();
    for (std::size_t i = 0; i < 3; ++i) given += x[i] * rows[i];
    EXPECT_LT((given - wanted).norm(), Real(1e-12)) << closed;
    EXPECT_EQ(x[closed ? 1 : 2], 0) << closed;
    EXPECT_NE(x[closed ? 2 : 1], 0) << closed;
  }
}

// What the stages of a step open makes rows differ a little that say the same: that is no new condition.
TEST(SparseDependent, RowsStaySoWhileJointsAreOpen) {
  for (const Real open : {Real(1e-4), Real(1e-2)}) {  // sin^2: 1e-8 and 1e-4, of 1e-6
    const Vector3 rows[] = {{1, 0, 0}, {std::cos(open), std::sin(open), 0}};
    SparseFactor factor;
    factor.set_pattern(std::vector<Ends>(2, Ends{0, -1}));
    factor.factor([](std::size_t, std::size_t) { return Real(1); }, Real(1e-12), true);
    factor.factor([&](std::size_t i, std::size_t j) { return rows[i].dot(rows[j]); }, Real(1e-12), false);
    std::vector<Real> x = {1, 2};
    factor.solve(x);
    EXPECT_EQ(x[1] == 0, open < Real(1e-3));
  }
}

TEST(SparseFill, IsLinearInTheLinksOfTrees) {
  for (const Kind& kind : {Kind{"chain", 0, 3, before, true}, Kind{"tree", 0, 3, half, true},
                           Kind{"random", 0, 3, any_before, true}}) {
    for (const int bodies : {100, 400}) {
      std::mt19937 random(11);
      Kind sized = kind;
      sized.bodies = bodies;
      SparseFactor factor;
      factor.set_pattern(ends_of(sized, random));
      // 6 for the joint itself and 9 for what it leaves its neighbours; a random tree's bodies have more.
      EXPECT_LE(factor.entries(), static_cast<std::size_t>(bodies) * (kind.to == any_before ? 60 : 24))
          << kind.name << ' ' << bodies;
    }
  }
}

}  // namespace
}  // namespace cylon::engine
