// The coefficients of the table against all order conditions, and the declared properties of each row.
#include "engine/integrators/integrator.h"

#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <map>
#include <string>
#include <vector>

namespace cylon::engine {
namespace {

// Rounding of coefficients (<= 1.5, half an ulp 1e-16) through at most 30 factors of size <= 2.
constexpr double rounding = 2e-14;

std::string test_name(std::string_view integrator) {
  std::string name(integrator);
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

// --- Splittings: exp(c_1 X_1) exp(c_2 X_2)... must have the coefficient 1/n! before every word of n letters
// A (drift), B (kick), as exp(A + B) has; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration,
// section III.5.

using Series = std::map<std::string, double>;

std::vector<std::string> words(int longest) {
  std::vector<std::string> all{""};
  for (std::size_t i = 0; all[i].size() < static_cast<std::size_t>(longest); ++i) {
    all.push_back(all[i] + 'A');
    all.push_back(all[i] + 'B');
  }
  return all;
}

Series product(const Composition& splitting, int longest) {
  Series product{{"", 1.0}};
  char letter = splitting.first == Part::kick ? 'B' : 'A';
  for (const double c : splitting.coefficients) {
    Series next;
    for (const auto& [word, value] : product) {
      double term = value;
      std::string longer = word;
      for (int k = 1; longer.size() <= static_cast<std::size_t>(longest); ++k) {
        next[longer] += term;
        longer += letter;
        term *= c / k;
      }
    }
    product = std::move(next);
    letter = letter == 'A' ? 'B' : 'A';
  }
  return product;
}

// The largest deviation from exp(A + B) among words of `length` letters; with `nystrom` only as far as it is
// no multiple of [B,[B,[B,A]]], which is 0 where T is quadratic in the momenta.
double deviation(const Composition& splitting, int length, bool nystrom) {
  Series series = product(splitting, length);
  std::vector<std::string> all;
  for (const std::string& word : words(length)) {
    if (word.size() == static_cast<std::size_t>(length)) all.push_back(word);
  }
  double factorial = 1;
  for (int i = 2; i <= length; ++i) factorial *= i;
  Eigen::VectorXd residual(static_cast<Eigen::Index>(all.size()));
  std::map<std::string, Eigen::Index> index;
  for (std::size_t i = 0; i < all.size(); ++i) {
    index[all[i]] = static_cast<Eigen::Index>(i);
    residual[static_cast<Eigen::Index>(i)] = series[all[i]] - 1 / factorial;
  }
  if (!nystrom || length < 4) return residual.lpNorm<Eigen::Infinity>();

  const std::vector<std::string> outer = words(length - 4);
  std::vector<Eigen::VectorXd> columns;
  for (const std::string& left : outer) {
    for (const std::string& right : outer) {
      if (left.size() + right.size() + 4 != static_cast<std::size_t>(length)) continue;
      Eigen::VectorXd v = Eigen::VectorXd::Zero(residual.size());
      const std::pair<const char*, double> terms[] = {{"BBBA", 1}, {"BBAB", -3}, {"BABB", 3}, {"ABBB", -1}};
      for (const auto& [middle, factor] : terms) {
        std::string word = left;
        v[index[word.append(middle).append(right)]] += factor;
      }
      columns.push_back(v);
    }
  }
  Eigen::MatrixXd ideal(residual.size(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i) ideal.col(static_cast<Eigen::Index>(i)) = columns[i];
  return (residual - ideal * ideal.colPivHouseholderQr().solve(residual)).lpNorm<Eigen::Infinity>();
}

// --- Runge-Kutta: sum b_i phi_i(tree) = 1/gamma(tree) for every rooted tree of at most `order` nodes;
// J. C. Butcher, Numerical Methods for Ordinary Differential Equations, section 31.

struct Tree {
  int order = 1;
  double density = 1;       // gamma
  std::vector<double> phi;  // per stage: the product over its branches of sum_j a_ij phi_j(branch)
};

std::vector<double> through_matrix(const Tableau& rk, const std::vector<double>& x) {
  std::vector<double> y(x.size(), 0);
  for (std::size_t i = 1, at = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) y[i] += rk.matrix[at++] * x[j];
  }
  return y;
}

// Adds every tree whose branches are those of `base` and further ones from trees[first...].
void grow(const Tableau& rk, int order, const Tree& base, std::size_t first, const std::vector<Tree>& smaller,
          std::vector<Tree>& out) {
  if (base.order == order) {
    Tree whole = base;
    whole.density *= order;
    out.push_back(whole);
    return;
  }
  for (std::size_t b = first; b < smaller.size(); ++b) {
    if (base.order + smaller[b].order > order) continue;
    Tree next = base;
    next.order += smaller[b].order;
    next.density *= smaller[b].density;
    const std::vector<double> branch = through_matrix(rk, smaller[b].phi);
    for (std::size_t i = 0; i < branch.size(); ++i) next.phi[i] *= branch[i];
    grow(rk, order, next, b, smaller, out);
  }
}

struct Conditions {
  std::size_t trees = 0;
  double worst = 0;
};

Conditions conditions(const Tableau& rk, int order) {
  std::vector<Tree> all;
  Conditions result;
  for (int n = 1; n <= order; ++n) {
    std::vector<Tree> grown;
    grow(rk, n, Tree{1, 1, std::vector<double>(rk.weights.size(), 1)}, 0, all, grown);
    for (const Tree& tree : grown) {
      double sum = 0;
      for (std::size_t i = 0; i < tree.phi.size(); ++i) sum += rk.weights[i] * tree.phi[i];
      if (n == order) ++result.trees;
      result.worst = std::max(result.worst, std::abs(sum - 1 / tree.density));
    }
    all.insert(all.end(), grown.begin(), grown.end());
  }
  return result;
}

class SchemeRow : public testing::TestWithParam<Integrator> {};

TEST_P(SchemeRow, IsFoundByItsName) { EXPECT_EQ(find_integrator(GetParam().name)->name, GetParam().name); }

TEST_P(SchemeRow, MeetsTheConditionsOfItsOrderAndOfNoMore) {
  const Integrator& row = GetParam();
  if (row.kind != Kind::splitting) {
    EXPECT_LT(conditions(row.tableau, row.order).worst, rounding);
    EXPECT_GT(conditions(row.tableau, row.order + 1).worst, 1e-8);  // least of all: rk8, 4e-6
    return;
  }
  for (int n = 1; n <= row.order; ++n)
    EXPECT_LT(deviation(row.splitting, n, true), rounding) << n << " letters";
  for (int n = 1; n <= row.drag_order; ++n)
    EXPECT_LT(deviation(row.splitting, n, false), rounding) << n << " letters, with drag";
  EXPECT_GT(deviation(row.splitting, row.order + 1, true), 1e-8);
  if (row.drag_order < row.order) {
    EXPECT_GT(deviation(row.splitting, row.drag_order + 1, false), 1e-8);
  }
}

TEST_P(SchemeRow, CountsItsEvaluations) {
  const Integrator& row = GetParam();
  std::size_t count = row.tableau.weights.size();
  if (row.kind == Kind::splitting)
    count = (row.splitting.coefficients.size() + (row.splitting.first == Part::kick ? 1 : 0)) / 2;
  EXPECT_EQ(static_cast<std::size_t>(row.evaluations), count);
}

TEST_P(SchemeRow, IsAPalindromeIfItIsReversible) {
  const auto c = GetParam().splitting.coefficients;
  const bool palindrome = c.size() % 2 == 1 && std::equal(c.begin(), c.end(), c.rbegin());
  EXPECT_EQ(GetParam().reversible, palindrome);
}

TEST_P(SchemeRow, KeepsConstraintsOnlyAsVerletSteps) {
  EXPECT_EQ(GetParam().constraints, !GetParam().splitting.weights.empty());
}

INSTANTIATE_TEST_SUITE_P(Table, SchemeRow, testing::ValuesIn(integrators().begin(), integrators().end()),
                         [](const auto& row) { return test_name(row.param.name); });

TEST(SchemeTable, HasNoNameTwiceAndNoOther) {
  for (const Integrator& row : integrators()) EXPECT_EQ(find_integrator(row.name), &row);
  EXPECT_EQ(find_integrator("rk5"), nullptr);
}

// The measures themselves: the number of trees is known, and a coefficient that is off by 1e-12 is seen.
TEST(SchemeTable, ConditionsAreComplete) {
  const int count[] = {1, 1, 2, 4, 9, 20, 48, 115};
  for (int n = 1; n <= 8; ++n)
    EXPECT_EQ(conditions(find_integrator("rk8")->tableau, n).trees, static_cast<std::size_t>(count[n - 1]));

  const Integrator& bm6 = *find_integrator("bm6");
  std::vector<double> off(bm6.splitting.coefficients.begin(), bm6.splitting.coefficients.end());
  off[3] += 1e-12, off[5] -= 1e-12;
  EXPECT_GT(deviation({bm6.splitting.first, off, {}}, 3, false), rounding);
}

}  // namespace
}  // namespace cylon::engine
