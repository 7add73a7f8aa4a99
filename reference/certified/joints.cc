// Joints as equations for the accelerations, d^2/dt^2 (what the joint keeps) = 0.
#include "harness/core/joint_coordinates.h"
#include "reference/certified/angle.h"
#include "reference/certified/builder.h"

#include <algorithm>

namespace cylon::certified {
namespace {

// A body, or the world, as a joint sees it; `at` is absent for what does not move.
struct End {
  const Motion* at = nullptr;     // now
  const Motion* start = nullptr;  // at t = 0
  std::size_t body = 0;
  double sign = 1;
};

struct Rows {
  const Builder& b;
  const std::vector<Motion>& now;
  std::vector<Row> rows;

  End end(int body, double sign) const {
    if (body == core::world) return {nullptr, nullptr, 0, sign};
    const auto i = static_cast<std::size_t>(body);
    return {&now[i], &b.start[i], i, sign};
  }
  bool moves(const End& e) const { return e.at && !b.bodies[e.body].locked; }
  Expr signed_sum(Expr sum, double sign, Expr x) const { return sign > 0 ? sum + x : sum - x; }

  // A direction of the world at the start, fixed in the body: in body axes.
  static Vector fixed_in(const End& e, const Vector& world) {
    return e.start ? transposed(e.start->rotation) * world : world;
  }

  // The points of both bodies that are at `point` at the start stay together: p + R r, whose second
  // derivative is v' + R (w' x r + w x (w x r)).
  void together(const core::Joint& joint) {
    const Vector point = b.vector(joint.point);
    for (std::size_t i = 0; i < 3; ++i) {
      Row row{{}, b.exact(0)};
      for (const End& e : {end(joint.body, 1), end(joint.to, -1)}) {
        if (!moves(e)) continue;
        const Vector arm = fixed_in(e, point - e.start->position);
        const Vector along = e.at->rotation[i];  // world axis i in body axes
        Vector unit = b.zero();
        unit[i] = b.exact(e.sign);
        row.parts.push_back({e.body, unit, b.exact(e.sign) * cross(arm, along)});
        row.rest = signed_sum(row.rest, e.sign, dot(along, cross(e.at->spin, cross(e.at->spin, arm))));
      }
      rows.push_back(row);
    }
  }

  // The second derivative of  x_a - x_b - l h x u,  h fixed in `to`, u in `body`, the point of `body` as far away at the start:
  //   h" = a_h x h + w_b x (w_b x h),  u" the same of `body`,  (h x u)" = h" x u + 2 h' x u' + h x u"
  void along_normal(const core::Joint& joint) {
    const Vector h_start = b.vector(joint.axis), u_start = b.vector(*joint.axis_2),
                 point = b.vector(joint.point),
                 far = point + b.number(joint.length) * cross(h_start, u_start);
    const End a = end(joint.body, 1), to = end(joint.to, -1);
    const auto now_of = [&](const End& e, const Vector& start) {
      return e.at ? e.at->rotation * fixed_in(e, start) : start;
    };
    const auto spin_of = [&](const End& e) { return moves(e) ? e.at->rotation * e.at->spin : b.zero(); };
    const Vector h = now_of(to, h_start), u = now_of(a, u_start), w_a = spin_of(a), w_b = spin_of(to);
    const Vector h_rate = cross(w_b, h), u_rate = cross(w_a, u);
    const Vector change =
        cross(cross(w_b, h_rate), u) + b.exact(2) * cross(h_rate, u_rate) + cross(h, cross(w_a, u_rate));
    const Expr length = b.number(joint.length);
    for (std::size_t i = 0; i < 3; ++i) {
      Vector unit = b.zero();
      unit[i] = b.exact(1);
      Row row{{}, -(length * change[i])};
      for (const End& e : {a, to}) {
        if (!moves(e)) continue;
        const Vector arm = fixed_in(e, (e.sign > 0 ? far : point) - e.start->position);
        const Vector along = e.at->rotation[i];  // world axis i in body axes
        // Of  -l (h x u)"  what the accelerations of the two turns make:  (h x (w x u)).e = w.(u x (e x h)),
        // ((w x h) x u).e = w.(h x (u x e))
        const Vector of_turn = e.sign > 0 ? cross(u, cross(unit, h)) : cross(h, cross(u, unit));
        row.parts.push_back(
            {e.body, b.exact(e.sign) * unit,
             b.exact(e.sign) * cross(arm, along) - length * (transposed(e.at->rotation) * of_turn)});
        row.rest = signed_sum(row.rest, e.sign, dot(along, cross(e.at->spin, cross(e.at->spin, arm))));
      }
      rows.push_back(row);
    }
  }

  // A direction s fixed in the one body stays perpendicular to a direction e fixed in the other: (s . e)'' =
  // s'' . e + 2 s' . e' + s . e'', with s = R s_b and s'' = R (w' x s_b + w x (w x s_b)).
  void perpendicular(const core::Joint& joint, const Vector& first, const Vector& second) {
    const End ends[2] = {end(joint.body, 1), end(joint.to, 1)};
    const Vector at_start[2] = {first, second};
    Vector fixed[2], world[2], rate[2];
    for (std::size_t k = 0; k < 2; ++k) {
      fixed[k] = fixed_in(ends[k], at_start[k]);
      world[k] = ends[k].at ? ends[k].at->rotation * fixed[k] : at_start[k];
      rate[k] = moves(ends[k]) ? ends[k].at->rotation * cross(ends[k].at->spin, fixed[k]) : b.zero();
    }
    Row row{{}, b.exact(2) * dot(rate[0], rate[1])};
    for (std::size_t k = 0; k < 2; ++k) {
      if (!moves(ends[k])) continue;
      const Motion& m = *ends[k].at;
      const Vector other = transposed(m.rotation) * world[1 - k];
      row.parts.push_back({ends[k].body, b.zero(), cross(fixed[k], other)});
      row.rest = row.rest + dot(other, cross(m.spin, cross(m.spin, fixed[k])));
    }
    rows.push_back(row);
  }

  // A direction n of the world at the start, fixed in `to`, keeps its component of d = x_body - x_to, the points:
  //   (n . d)'' = n'' . d + 2 n' . d' + n . d'',   n'' = R (w' x n_b + w x (w x n_b)),   d'' as in together().
  Row carried(const core::Joint& joint, const Vector& at_start) {
    const Vector point = b.vector(joint.point);
    const End a = end(joint.body, 1), to = end(joint.to, -1);
    const Vector fixed = fixed_in(to, at_start), n = to.at ? to.at->rotation * fixed : at_start;
    Vector d = b.zero(), rate = b.zero();
    Row row{{}, b.exact(0)};
    for (const End& e : {a, to}) {
      const Vector arm = fixed_in(e, e.start ? point - e.start->position : point);
      const Vector place = e.at ? e.at->position + e.at->rotation * arm : point;
      d = e.sign > 0 ? d + place : d - place;
      if (!moves(e)) continue;
      const Vector velocity = e.at->velocity + e.at->rotation * cross(e.at->spin, arm);
      rate = e.sign > 0 ? rate + velocity : rate - velocity;
      const Vector along = transposed(e.at->rotation) * n;
      row.parts.push_back({e.body, b.exact(e.sign) * n, b.exact(e.sign) * cross(arm, along)});
      row.rest = signed_sum(row.rest, e.sign, dot(along, cross(e.at->spin, cross(e.at->spin, arm))));
    }
    if (!moves(to)) return row;
    const Vector here = transposed(to.at->rotation) * d, spin = to.at->spin;
    row.parts.back().angular = row.parts.back().angular + cross(fixed, here);
    row.rest = row.rest + dot(here, cross(spin, cross(spin, fixed))) +
               b.exact(2) * dot(to.at->rotation * cross(spin, fixed), rate);
    return row;
  }

  // The second derivative of a displacement: that of what `carried` is in the row above.
  void rotor(const core::Joint& joint, const core::JointDisplacement& c) {
    rows.push_back(carried(joint, b.vector(core::direction_of(joint, c.which))));
    rows.back().rotor = c.armature;
  }

  // g . (R_a w_a' - R_b w_b') + g' . (R_a w_a - R_b w_b)
  void rotor(const core::Joint& joint, const core::JointAngle& c) {
    const End a = end(joint.body, 1), to = end(joint.to, -1);
    const auto now_of = [&](const End& e, const core::Vector3& axis) {
      return e.at ? e.at->rotation * fixed_in(e, b.vector(axis)) : b.vector(axis);
    };
    const auto rate_of = [&](const End& e, const Vector& axis) {
      return moves(e) ? cross(e.at->rotation * e.at->spin, axis) : b.zero();
    };
    Axes axes{.h = now_of(to, joint.axis), .u = now_of(a, joint.axis_2.value_or(joint.axis))};
    axes.h_rate = rate_of(to, axes.h), axes.u_rate = rate_of(a, axes.u);
    const core::JointKind& kind = core::kind_of(joint.type);
    const Vector n = angle_direction(kind, c.which, axes);
    Row row{{}, b.exact(0), c.armature};
    Vector spin = b.zero();
    for (const End& e : {a, to}) {
      if (!moves(e)) continue;
      row.parts.push_back({e.body, b.zero(), b.exact(e.sign) * (transposed(e.at->rotation) * n)});
      const Vector own = e.at->rotation * e.at->spin;
      spin = e.sign > 0 ? spin + own : spin - own;
    }
    row.rest = dot(angle_direction_rate(kind, c.which, axes), spin);
    rows.push_back(row);
  }

  // Two unit vectors across an axis.
  std::array<Vector, 2> across(const core::Vector3& axis) const {
    int least = 0;
    axis.cwiseAbs().minCoeff(&least);
    Vector unit = b.zero();
    unit[static_cast<std::size_t>(least)] = b.exact(1);
    const Vector first = cross(b.vector(axis), unit);
    return {first, cross(b.vector(axis), first)};
  }

  void along_axis(const core::Joint& joint) {
    for (const Vector& n : across(joint.axis)) rows.push_back(carried(joint, n));
  }

  // n . d - pitch (angle about n):  the angle's second derivative is n . (w_body' - w_to'), as n is fixed in both.
  void screw(const core::Joint& joint) {
    const Vector axis = b.vector(joint.axis);
    Row row = carried(joint, axis);
    for (const End& e : {end(joint.body, 1), end(joint.to, -1)}) {
      if (!moves(e)) continue;
      const Vector turn = b.exact(-e.sign) * (b.number(joint.pitch) * fixed_in(e, axis));
      for (Row::Part& part : row.parts)
        if (part.body == e.body) part.angular = part.angular + turn;
    }
    rows.push_back(row);
  }

  // d . d keeps its value: (d . d)''/2 = d' . d' + d . d''.
  void at_length(const core::Joint& joint) {
    const End from = end(joint.body, 1), to = end(joint.to, -1);
    const Vector d = from.at->position - (to.at ? to.at->position : b.vector(joint.point));
    const Vector rate = from.at->velocity - (to.at ? to.at->velocity : b.zero());
    Row row{{}, dot(rate, rate)};
    for (const End& e : {from, to})
      if (moves(e)) row.parts.push_back({e.body, b.exact(e.sign) * d, b.zero()});
    rows.push_back(row);
  }

  // Two directions perpendicular to the axis, the first from the unit vector that lies least along it.
  void about_axis(const core::Joint& joint) {
    for (const Vector& n : across(joint.axis)) perpendicular(joint, b.vector(joint.axis), n);
  }

  void never(const core::Joint& joint) {
    const auto unit = [&](int i) { return b.vector(core::Vector3::Unit(i)); };
    perpendicular(joint, unit(0), unit(1));
    perpendicular(joint, unit(0), unit(2));
    perpendicular(joint, unit(1), unit(2));
  }

  // The body that a joint pins, or null: its coordinates keep the place, and the axis where it has one.
  const Frozen* pinned_by(int joint) const {
    const core::Joint& j = b.scene.joints[static_cast<std::size_t>(joint)];
    for (const int body : {j.body, j.to})
      if (body != core::world && b.bodies[static_cast<std::size_t>(body)].pin == joint)
        return &b.bodies[static_cast<std::size_t>(body)];
    return nullptr;
  }

  void add(int index) {
    const core::Joint& joint = b.scene.joints[static_cast<std::size_t>(index)];
    const core::JointKind& kind = core::kind_of(joint.type);
    const Frozen* pinned = pinned_by(index);
    if (!pinned) add_place(joint, kind.place);
    if (!pinned || !pinned->one_axis) add_turn(joint, kind.turn);
    if (kind.screws) screw(joint);
  }

  void add_place(const core::Joint& joint, core::JointPlace place) {
    switch (place) {
      case core::JointPlace::together:
        return together(joint);
      case core::JointPlace::at_length:
        return at_length(joint);
      case core::JointPlace::along_axis:
        return along_axis(joint);
      case core::JointPlace::in_plane:
        return rows.push_back(carried(joint, b.vector(joint.axis)));
      case core::JointPlace::along_normal:
        return along_normal(joint);
    }
  }

  void add_turn(const core::Joint& joint, core::JointTurn turn) {
    switch (turn) {
      case core::JointTurn::freely:
      case core::JointTurn::about_three_axes:
        return;
      case core::JointTurn::about_axis:
        return about_axis(joint);
      case core::JointTurn::never:
        return never(joint);
      case core::JointTurn::about_two_axes:
        return perpendicular(joint, b.vector(*joint.axis_2), b.vector(joint.axis));
    }
  }
};

// A pinned body has v' = R (w' x c) + R (w x (w x c)), c from the pivot to the centre: its part in terms of
// w' alone.
void use_pins(const Builder& b, const std::vector<Motion>& now, Row& row) {
  for (Row::Part& part : row.parts) {
    const Frozen& f = b.bodies[part.body];
    if (f.pin < 0) continue;
    const Motion& m = now[part.body];
    part.angular = part.angular + cross(f.arm, transposed(m.rotation) * part.linear);
    row.rest = row.rest + dot(part.linear, centripetal(m, f.arm));
    part.linear = b.zero();
  }
}

// M^-1 J^T of one row and one body.
Row::Part relieved(const Builder& b, const Row::Part& part) {
  const Frozen& f = b.bodies[part.body];
  Row::Part result = part;
  for (Expr& x : result.linear) x = x / f.mass;
  if (f.turns) result.angular = f.inverse * part.angular;
  return result;
}

Expr overlap(const Builder& b, const Row& x, const std::vector<Row::Part>& y) {
  Expr sum = b.exact(0);
  for (const Row::Part& p : x.parts)
    for (const Row::Part& q : y)
      if (p.body == q.body) sum = sum + dot(p.linear, q.linear) + dot(p.angular, q.angular);
  return sum;
}

// M^-1 J^T, and the lower triangle of A = J M^-1 J^T.
struct Products {
  std::vector<std::vector<Row::Part>> relief;
  std::vector<std::vector<Expr>> a;

  Products(const Builder& b, const std::vector<Row>& rows) {
    for (const Row& row : rows) {
      relief.emplace_back();
      for (const Row::Part& part : row.parts) relief.back().push_back(relieved(b, part));
      a.emplace_back();
      for (const auto& other : relief) a.back().push_back(overlap(b, row, other));
    }
  }
};

// y + k x
void add(Row& y, Expr k, const Row& x) {
  y.rest = y.rest + k * x.rest;
  for (const Row::Part& part : x.parts) {
    const auto same = std::ranges::find(y.parts, part.body, &Row::Part::body);
    if (same == y.parts.end()) {
      y.parts.push_back({part.body, k * part.linear, k * part.angular});
    } else {
      same->linear = same->linear + k * part.linear;
      same->angular = same->angular + k * part.angular;
    }
  }
}

// Solves A x = y, A symmetric positive definite: A = L D L^T without roots.
std::vector<Expr> solve(const Builder& b, std::vector<std::vector<Expr>> a, std::vector<Expr> y) {
  const std::size_t n = y.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Expr pivot = a[k][k];
    if (b.graph[static_cast<std::size_t>(pivot.node)].kind == Kind::fixed &&
        !(b.graph.value(pivot.node).smallest() > 0))
      refuse("the equations of its joints depend on each other");
    for (std::size_t i = k + 1; i < n; ++i) {
      if (a[i][k].is_zero()) continue;
      const Expr factor = a[i][k] / pivot;
      for (std::size_t j = k + 1; j <= i; ++j) a[i][j] = a[i][j] - factor * a[j][k];
      y[i] = y[i] - factor * y[k];
    }
  }
  // Below the diagonal a holds L D.
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t i = k + 1; i < n; ++i) y[k] = y[k] - a[i][k] * y[i];
    y[k] = y[k] / a[k][k];
  }
  return y;
}

}  // namespace

std::vector<Row> joint_rows(const Builder& b, const std::vector<Motion>& now) {
  Rows rows{b, now, {}};
  for (std::size_t i = 0; i < b.scene.joints.size(); ++i) rows.add(static_cast<int>(i));
  for (Row& row : rows.rows) use_pins(b, now, row);
  return rows.rows;
}

std::vector<int> products(const Builder& b, const std::vector<Row>& rows) {
  std::vector<int> result;
  for (const auto& line : Products(b, rows).a)
    for (const Expr x : line) result.push_back(x.node);
  return result;
}

std::vector<Row> combined(const Builder& b, const std::vector<Row>& rows, std::vector<int>& parameters) {
  std::vector<Row> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    result.push_back({{}, b.exact(0)});
    for (std::size_t j = 0; j <= i; ++j) {
      parameters.push_back(b.graph.parameter());
      add(result.back(), {&b.graph, parameters.back()}, rows[j]);
    }
  }
  return result;
}

std::vector<Row> rotor_rows(const Builder& b, const std::vector<Motion>& now) {
  Rows rows{b, now, {}};
  for (const core::Joint& joint : b.scene.joints) {
    const auto add = [&](const auto& c) {
      if (core::has_rotor(c)) rows.rotor(joint, c);
    };
    for (const core::JointDisplacement& c : joint.displacements) add(c);
    for (const core::JointAngle& c : joint.angles) add(c);
  }
  std::erase_if(rows.rows, [](const Row& row) { return row.parts.empty(); });
  for (Row& row : rows.rows) use_pins(b, now, row);
  return rows.rows;
}

void solve_joints(const Builder& b, const std::vector<Row>& rows, std::vector<Vector>& linear,
                  std::vector<Vector>& angular, bool with_rest) {
  auto [relief, a] = Products(b, rows);
  std::vector<Expr> excess;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    if (row.rotor != 0) a[i][i] = a[i][i] + b.exact(1) / b.number(row.rotor);
    Expr sum = with_rest ? row.rest : b.exact(0);
    for (const Row::Part& part : row.parts)
      sum = sum + dot(part.linear, linear[part.body]) + dot(part.angular, angular[part.body]);
    excess.push_back(sum);
  }
  const std::vector<Expr> pull = solve(b, a, excess);
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const Row::Part& part : relief[r]) {
      linear[part.body] = linear[part.body] - pull[r] * part.linear;
      angular[part.body] = angular[part.body] - pull[r] * part.angular;
    }
}

}  // namespace cylon::certified
