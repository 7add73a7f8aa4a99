#include "engine/normal_modes.h"

#include "engine/jacobi.h"
#include "engine/methods.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace cylon::engine {

namespace {

using Eigen::Index;
using Eigen::Vector3d;

constexpr std::size_t none = static_cast<std::size_t>(-1);

// A spring between two places; `from` or `to` is none where that end does not move.
struct Tie {
  std::size_t from = none, to = none;
  Vector3d apart;  // at t = 0, from `from` to `to`
  double stiffness = 0, rest_length = 0;
};

std::vector<Tie> ties_of(const Model& model) {
  std::vector<Tie> ties;
  const auto end = [&](int body, const Vector3& anchor) {
    const bool moves = body != fixed_world && !model.bodies[index(body)].locked;
    const Vector3 place = body == fixed_world ? anchor : model.motions[index(body)].position;
    return std::pair(moves ? index(body) : none, Vector3d(place.cast<double>()));
  };
  for (const Spring& s : model.forces.springs) {
    const auto [from, start] = end(s.body, s.anchor);
    const auto [to, goal] = end(s.to, s.to_anchor);
    if (s.stiffness == 0 || from == to) continue;
    ties.push_back(
        {from, to, goal - start, static_cast<double>(s.stiffness), static_cast<double>(s.rest_length)});
  }
  return ties;
}

// Moving bodies that springs tie together, and what acts on them alone.
struct Group {
  std::vector<std::size_t> bodies;
  std::vector<Tie> ties;
  std::vector<Drive> drives;
};

// In order of the first body of each.
std::vector<Group> groups_of(const Model& model) {
  const std::vector<Tie> ties = ties_of(model);
  std::vector<std::size_t> root(model.bodies.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const Tie& tie : ties) {
    if (tie.from == none || tie.to == none) continue;
    const std::size_t a = find(tie.from), b = find(tie.to);
    root[std::max(a, b)] = std::min(a, b);
  }
  std::vector<Group> groups(model.bodies.size());
  for (std::size_t i = 0; i < root.size(); ++i) {
    if (!model.bodies[i].locked) groups[find(i)].bodies.push_back(i);
  }
  for (const Tie& tie : ties) groups[find(tie.from == none ? tie.to : tie.from)].ties.push_back(tie);
  for (const Drive& d : model.forces.drives) {
    if (d.body != fixed_world && !model.bodies[index(d.body)].locked)
      groups[find(index(d.body))].drives.push_back(d);
  }
  std::erase_if(groups, [](const Group& group) { return group.bodies.empty(); });
  return groups;
}

// The modes of one group.
class Builder {
 public:
  // `rows`: of each body of the model, its place in its group.
  Builder(const Model& model, Group group, std::vector<Index>& rows)
      : model_(model), ties_(std::move(group.ties)), drives_(std::move(group.drives)), rows_(rows) {
    group_.bodies = std::move(group.bodies);
    for (std::size_t i = 0; i < group_.bodies.size(); ++i) rows[group_.bodies[i]] = static_cast<Index>(i);
  }

  std::string why_not() {
    if (group_.bodies.size() > most_tied)
      return "springs connect more than " + std::to_string(most_tied) + " points together";
    const bool straight =
        std::all_of(ties_.begin(), ties_.end(), [](const Tie& tie) { return tie.rest_length == 0; });
    const int axis = straight ? -1 : line();
    if (!straight && axis < 0) return "springs with a rest length rotate";
    solve();
    excite();
    if (!straight && meets(axis))
      return "springs with a rest length may reach zero length, or grow without limit";
    return "";
  }

  ModeGroup take() { return std::move(group_); }

 private:
  Index size() const { return static_cast<Index>(group_.bodies.size()); }
  Index row(std::size_t body) const { return body == none ? -1 : rows_[body]; }
  double mass(Index i) const { return static_cast<double>(model_.bodies[group_.bodies[index(i)]].mass); }
  static std::size_t index(Index i) { return static_cast<std::size_t>(i); }

  // The axis along which everything lies, moves and is pushed; -1: there is none.
  int line() const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto along = [&](auto v) { return v[axis] = 0, v.isZero(0); };
      bool all = true;
      for (const std::size_t body : group_.bodies)
        all = all && along(Vector3(model_.gravity_of(body))) && along(Vector3(model_.motions[body].momentum));
      for (const Tie& tie : ties_) all = all && along(Vector3d(tie.apart));
      for (const Drive& d : drives_) all = all && along(Vector3(d.force));
      if (all) return axis;
    }
    return -1;
  }

  //   M^(-1/2) K M^(-1/2) = V diag(w^2) V^T,  U = M^(-1/2) V,  w^2 = sum k (u_to - u_from)^2
  // The last, Rayleigh's quotient with U^T M U = 1, has no cancellation but in the shapes: its error is of
  // second order in theirs.
  void solve() {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size(), size());
    bool free = true;
    for (const Tie& tie : ties_) {
      const Index a = row(tie.from), b = row(tie.to);
      if (a >= 0) k(a, a) += tie.stiffness;
      if (b >= 0) k(b, b) += tie.stiffness;
      if (a >= 0 && b >= 0) k(std::min(a, b), std::max(a, b)) -= tie.stiffness;
      free = free && a >= 0 && b >= 0;
    }
    for (Index j = 0; j < size(); ++j)
      for (Index i = 0; i <= j; ++i) k(i, j) /= std::sqrt(mass(i)) * std::sqrt(mass(j));
    Eigen::MatrixXd& u = group_.shapes;
    diagonalise(k, u);
    for (Index j = 0; j < size(); ++j)
      for (Index i = 0; i < size(); ++i) u(i, j) /= std::sqrt(mass(i));
    if (free) move_as_one(k);
    group_.frequencies.setZero(size());
    for (Index j = 0; j < size(); ++j) {
      double square = 0;
      for (const Tie& tie : ties_) square += tie.stiffness * stretch(tie, j) * stretch(tie, j);
      group_.frequencies[j] = std::sqrt(square);
    }
  }

  // Of a group that nothing holds, the mode of the smallest eigenvalue is its motion as a whole.
  void move_as_one(const Eigen::MatrixXd& k) {
    Index least = 0;
    double whole = 0;
    for (Index i = 0; i < size(); ++i) {
      if (k(i, i) < k(least, least)) least = i;
      whole += mass(i);
    }
    for (Index i = 0; i < size(); ++i) group_.shapes(i, least) = 1 / std::sqrt(whole);
  }

  // What a spring feels of a mode.
  double stretch(const Tie& tie, Index mode) const {
    const Index a = row(tie.from), b = row(tie.to);
    return (b >= 0 ? group_.shapes(b, mode) : 0) - (a >= 0 ? group_.shapes(a, mode) : 0);
  }

  // U^T f for a vector per body.
  template <class Of>
  std::array<Eigen::VectorXd, 3> shares(Of of) const {
    std::array<Eigen::VectorXd, 3> s;
    for (int c = 0; c < 3; ++c) {
      Eigen::VectorXd& along = s[static_cast<std::size_t>(c)];
      along.setZero(size());
      for (Index i = 0; i < size(); ++i) {
        const double f = of(i)[c];
        for (Index j = 0; j < size(); ++j) along[j] += group_.shapes(i, j) * f;
      }
    }
    return s;
  }

  // At the start: momenta; weights and pulls; drives.
  void excite() {
    const auto body = [&](Index i) { return group_.bodies[index(i)]; };
    group_.pushes =
        shares([&](Index i) { return Vector3d(model_.motions[body(i)].momentum.cast<double>()); });
    std::vector<Vector3d> force;
    for (Index i = 0; i < size(); ++i)
      force.emplace_back(mass(i) * model_.gravity_of(body(i)).cast<double>());
    for (const Tie& tie : ties_) {
      const Vector3d pull = pull_of(tie);
      if (row(tie.from) >= 0) force[index(row(tie.from))] += pull;
      if (row(tie.to) >= 0) force[index(row(tie.to))] -= pull;
    }
    group_.forces.push_back({0, shares([&](Index i) { return force[index(i)]; })});
    for (const Drive& d : drives_) {
      const Index driven = row(static_cast<std::size_t>(d.body));
      const Vector3d f = d.force.cast<double>();
      group_.forces.push_back({std::abs(static_cast<double>(d.frequency)), shares([&](Index i) {
                                 return i == driven ? f : Vector3d(Vector3d::Zero());
                               })});
    }
  }

  //   k (1 - L/|d|) d
  static Vector3d pull_of(const Tie& tie) {
    const Vector3d& d = tie.apart;
    if (tie.rest_length == 0) return tie.stiffness * d;
    const double length = std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
    return tie.stiffness * (1 - tie.rest_length / length) * d;
  }

  // Whether a spring with a rest length may come to length 0 on the line.  A mode goes around f/w^2 with the
  // amplitude sqrt((f/w^2)^2 + (v/w)^2), and by a drive at W by 2 |f|/|w^2 - W^2| at most; a spring feels
  // nothing of a motion as a whole.
  bool meets(int axis) const {
    const auto c = static_cast<std::size_t>(axis);
    for (const Tie& tie : ties_) {
      if (tie.rest_length == 0) continue;
      double middle = tie.apart[axis], reach = 0;
      for (Index j = 0; j < size(); ++j) {
        const double w = group_.frequencies[j], s = stretch(tie, j);
        if (w == 0 || s == 0) continue;
        const double shift = group_.forces[0].shares[c][j] / (w * w), kick = group_.pushes[c][j] / w;
        middle += s * shift;
        reach += std::abs(s) * std::sqrt(shift * shift + kick * kick);
        for (std::size_t f = 1; f < group_.forces.size(); ++f) {
          const double drive = group_.forces[f].frequency, share = group_.forces[f].shares[c][j];
          if (share != 0) reach += 2 * std::abs(s * share) / std::abs((w - drive) * (w + drive));
        }
      }
      constexpr double slack = 1e-9;  // far above rounding
      const bool keeps_side = tie.apart[axis] * middle > 0;
      if (!(keeps_side && std::abs(middle) > reach * (1 + slack))) return true;
    }
    return false;
  }

  const Model& model_;
  std::vector<Tie> ties_;
  std::vector<Drive> drives_;
  const std::vector<Index>& rows_;
  ModeGroup group_;
};

}  // namespace

NormalModes normal_modes(const Model& model) {
  NormalModes modes;
  modes.why_not = missing(Method::modes, model);
  if (!modes.why_not.empty()) return modes;
  std::vector<Index> rows(model.bodies.size());
  for (Group& group : groups_of(model)) {
    Builder builder(model, std::move(group), rows);
    modes.why_not = builder.why_not();
    if (!modes.why_not.empty()) {
      modes.groups.clear();
      return modes;
    }
    modes.groups.push_back(builder.take());
  }
  return modes;
}

}  // namespace cylon::engine
