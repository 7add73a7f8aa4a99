// Functions of state and time as a graph of elementary operations: written once, then expanded in Taylor
// series, bounded and differentiated by those who walk over it.
#pragma once

#include "reference/certified/ball.h"

#include <array>
#include <cstddef>
#include <map>
#include <tuple>
#include <vector>

namespace cylon::certified {

enum class Op { constant, parameter, time, cosine, state, add, subtract, multiply, divide, root };

/// What a node depends on; each kind takes in those before it.
enum class Kind { fixed, timed, moving };

struct Node {
  Op op = Op::constant;
  int a = -1,
      b = -1;  ///< Operands: earlier nodes.  Of a state: a is its index.  Of a cosine: b its constant.
  Kind kind = Kind::fixed;
};

/// Nodes in an order in which operands come first.  Equal nodes are one, and what is constant is folded.
class Graph {
 public:
  explicit Graph(slong bits) : bits_(bits) {}

  int constant(const Ball&);
  int constant(double exact) { return constant(Ball(exact)); }
  /// A number that whoever expands the graph chooses anew for each series, whatever it is: results do not depend on it.
  int parameter();
  int time();
  int cosine(const Ball& frequency);  ///< cos(frequency t) [rad/s].
  int state();                        ///< The next state variable.
  int add(int, int);
  int subtract(int, int);
  int multiply(int, int);
  int divide(int, int);
  int root(int);

  /// d state/dt, one node per state, once all are known.
  std::vector<int> rates;

  slong bits() const { return bits_; }
  std::size_t size() const { return nodes_.size(); }
  const Node& operator[](std::size_t i) const { return nodes_[i]; }
  /// Value of a constant, frequency of a cosine.
  const Ball& value(int node) const { return values_[static_cast<std::size_t>(node)]; }
  const std::vector<int>& states() const { return states_; }
  bool is(int node, double value) const;
  /// Whether a node is one number all along a series.
  bool steady(int node) const { return kind(node) == Kind::fixed || op(node) == Op::parameter; }

 private:
  int make(Op, int a, int b, Kind, const Ball& value = Ball());
  int fold(Op, int a, int b);
  Op op(int node) const { return nodes_[static_cast<std::size_t>(node)].op; }
  Kind kind(int node) const { return nodes_[static_cast<std::size_t>(node)].kind; }
  bool fixed(int a, int b) const { return kind(a) == Kind::fixed && kind(b) == Kind::fixed; }
  int binary(Op, int a, int b);

  slong bits_;
  std::vector<Node> nodes_;
  std::vector<Ball> values_;
  std::vector<int> states_;
  std::map<std::tuple<Op, int, int>, int> known_;
  std::map<double, int> exact_, cosines_;  // by the value; by the midpoint of the frequency
};

/// A node with the notation of algebra.
struct Expr {
  Graph* graph = nullptr;
  int node = -1;

  friend Expr operator+(Expr x, Expr y) { return {x.graph, x.graph->add(x.node, y.node)}; }
  friend Expr operator-(Expr x, Expr y) { return {x.graph, x.graph->subtract(x.node, y.node)}; }
  friend Expr operator*(Expr x, Expr y) { return {x.graph, x.graph->multiply(x.node, y.node)}; }
  friend Expr operator/(Expr x, Expr y) { return {x.graph, x.graph->divide(x.node, y.node)}; }
  friend Expr operator*(double k, Expr x) { return Expr{x.graph, x.graph->constant(k)} * x; }
  friend Expr operator-(Expr x) { return -1.0 * x; }
  friend Expr sqrt(Expr x) { return {x.graph, x.graph->root(x.node)}; }
  bool is_zero() const { return graph->is(node, 0); }
};

using Vector = std::array<Expr, 3>;
using Matrix = std::array<Vector, 3>;  ///< Rows.

inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(Expr k, const Vector& a) { return {k * a[0], k * a[1], k * a[2]}; }
inline Vector operator-(const Vector& a) { return {-a[0], -a[1], -a[2]}; }
inline Expr dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector operator*(const Matrix& m, const Vector& a) {
  return {dot(m[0], a), dot(m[1], a), dot(m[2], a)};
}
inline Matrix transposed(const Matrix& m) {
  return {Vector{m[0][0], m[1][0], m[2][0]}, Vector{m[0][1], m[1][1], m[2][1]},
          Vector{m[0][2], m[1][2], m[2][2]}};
}

}  // namespace cylon::certified
