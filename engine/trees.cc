#include "engine/trees.h"

#include "engine/forest.h"
#include "engine/methods.h"
#include "engine/plan.h"
#include "engine/rotation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace cylon::engine {

namespace {

// Two unit vectors square to a unit vector and to each other.
std::array<Vector3, 2> square_to(const Vector3& n) {
  const Vector3 first = n.unitOrthogonal();
  return {first, n.cross(first)};
}

// Of a motion or a force: its part that turns, then the other.
template <class Columns>
void set(Columns& to, int column, const Vector3& turning, const Vector3& going) {
  to.col(column).template head<3>() = turning;
  to.col(column).template tail<3>() = going;
}

// Calls f.operator()<N>() for N = n, 1 to 6.
template <class F>
void with_size(int n, F&& f) {
  switch (n) {
    case 1:
      return f.template operator()<1>();
    case 2:
      return f.template operator()<2>();
    case 3:
      return f.template operator()<3>();
    case 4:
      return f.template operator()<4>();
    case 5:
      return f.template operator()<5>();
    default:
      return f.template operator()<6>();
  }
}

}  // namespace

bool Trees::applies(const Model& model, const Options& options, const Integrator& integrator) {
  if (integrator.kind == Kind::splitting || !model.reduce_joints || options.constraints ||
      model.joints.empty())
    return false;
  if (!(required(model, options) - supports(Method::trees)).empty()) return false;
  // Displacements in a plane that spins go and come at its rate, faster than anything in the world, and no step makes their
  // rounding smooth.
  const auto spins = [&](const Joint& joint) {
    return joint.type.place == Joint::Place::in_plane && model.moves(joint.body) && model.moves(joint.to);
  };
  if (integrator.kind == Kind::adaptive && std::ranges::any_of(model.joints, spins)) return false;
  // What switches on and off is located in motions.
  if (integrator.kind == Kind::adaptive && !model.forces.waters.empty()) return false;
  if (!std::ranges::any_of(
          model.joints, [&](const Joint& joint) { return model.moves(joint.body) && model.moves(joint.to); }))
    return false;
  // A law of which the turns count belongs to an angle of its joint.
  for (const CoordinateLaw& law : model.forces.coordinate_laws)
    if (law.counts_turns() && std::ranges::none_of(model.joints, [&](const Joint& joint) {
          const Joint::Turn turn = joint.type.turn;
          const bool turns = turn == Joint::Turn::about_axis || turn == Joint::Turn::about_two_axes ||
                             turn == Joint::Turn::about_three_axes;
          return turns && ((joint.body == law.at.body && joint.to == law.at.to) ||
                           (joint.body == law.at.to && joint.to == law.at.body));
        }))
      return false;
  if (!std::ranges::all_of(model.bodies, [](const Body& body) {
        return body.locked || (body.inverse_mass > 0 && body.inverse_moments.minCoeff() > 0);
      }))
    return false;
  return !forest(model).empty();
}

Trees::Trees(Model model) : model_(std::move(model)), count_(movable_end(model_.bodies)) {
  model_.forces.start_turns();
  const std::size_t n = model_.bodies.size();
  motions_ = model_.motions;
  kinematics_.resize(n), loads_.resize(n), articulated_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    Body& body = model_.bodies[i];
    body.turns = !body.locked;
    kinematics_[i] = {rotation_matrix(motions_[i].orientation), velocity(body, motions_[i]),
                      engine::angular_velocity(body, motions_[i])};
  }
  motions_.emplace_back();  // the world, as a body that does not move
  kinematics_.push_back({Matrix3::Identity(), Vector3::Zero(), Vector3::Zero()});
  for (const Hung& one : forest(model_)) hang(one.body, one.joint, one.parent);
  Node* root = nullptr;  // trees that hang from nothing come last, one after the other
  for (Node& node : nodes_) {
    if (node.slides == 3) root = &node;
    if (root) ++root->members, root->mass += model_.bodies[index(node.body)].mass;
  }
  count_turns();
  add_rotors();
}

void Trees::hang(int body, const Joint* joint, int parent) {
  Node node;
  node.body = body, node.parent = parent, node.at = size_;
  node.above = parent == fixed_world ? motions_.size() - 1 : index(parent);
  node.relative = motions_[node.above].orientation.conjugate() * motions_[index(body)].orientation;
  if (!joint) {  // in space: its place and its orientation
    node.anchor = node.parent_anchor = Vector3::Zero();
    node.directions = {Vector3::UnitX(), Vector3::UnitY(), Vector3::UnitZ()};
    node.turns = Turns::freely;
  } else {
    const bool is_body = joint->body == body;
    node.anchor = is_body ? joint->anchor : joint->to_anchor;
    node.parent_anchor = is_body ? joint->to_anchor : joint->anchor;
    node.child_slides = !is_body;
    if (joint->type.place == Joint::Place::along_axis) node.directions = {joint->to_axis};
    if (joint->type.place == Joint::Place::in_plane) {
      const auto [first, second] = square_to(joint->to_axis);
      node.directions = {first, second};
    }
    node.first = is_body ? joint->to_axis : joint->axis;
    node.second_axis = is_body ? joint->axis : joint->to_axis;
    node.second = node.relative * node.second_axis;
    if (joint->type.place ==
        Joint::Place::along_normal)  // from the point on `to`, and from that on `body` back
      node.offset = joint->length * node.first.cross(node.second);
    using Turn = Joint::Turn;
    const Turn turn = joint->type.turn;
    node.turns = turn == Turn::freely             ? Turns::freely
                 : turn == Turn::about_axis       ? Turns::about_one
                 : turn == Turn::about_two_axes   ? Turns::about_two
                 : turn == Turn::about_three_axes ? Turns::about_three
                                                  : Turns::never;
    if (node.turns == Turns::about_three) node.third = node.first.cross(node.second).normalized();
  }
  arm_ = std::max({arm_, node.anchor.norm(), parent == fixed_world ? Real(0) : node.parent_anchor.norm()});
  node.slides = static_cast<int>(node.directions.size());
  node.angles = node.turns == Turns::freely ? 0 : static_cast<int>(node.turns);
  node.freedoms = node.slides + (node.turns == Turns::freely ? 3 : node.angles);
  size_ += node.coordinates() + static_cast<std::size_t>(node.freedoms);
  nodes_.push_back(std::move(node));
}

// Which angle of a joint a law is about.  The second of two or three is about the axis that the body carries.
int Trees::angle_of(const Node& node, const CoordinateLaw& law) const {
  if (law.at.kind == Coordinate::Kind::inclination) return 2;
  return node.angles > 1 && (law.at.on_body ? law.at.body : law.at.to) == node.body ? 1 : 0;
}

// An angle of a law is that of its joint, counted from the start, on the side of the law.
void Trees::count_turns() {
  for (std::size_t k = 0; k < model_.forces.coordinate_laws.size(); ++k) {
    const CoordinateLaw& law = model_.forces.coordinate_laws[k];
    if (!law.counts_turns()) continue;
    for (const Node& node : nodes_) {
      const bool from_body = node.body == law.at.body && node.parent == law.at.to;
      if (node.angles == 0 || !(from_body || (node.body == law.at.to && node.parent == law.at.body)))
        continue;
      const int which = angle_of(node, law);
      const bool carried = (law.at.on_body ? law.at.body : law.at.to) == node.body;
      const Matrix3 &below = kinematics_[index(node.body)].rotation,
                    &above = kinematics_[node.above].rotation;
      const Vector3 ours = which == 1 ? Vector3(below * node.second_axis) : Vector3(above * node.first);
      const Real along = ours.dot((carried ? below : above) * law.at.axis);
      counted_.push_back({k, node.at + index(node.slides + which),
                          (along > 0) == from_body ? Real(1) : Real(-1), law.at.near});
    }
  }
}

// A rotor turns with c.q', c the axis of its law in terms of those of its joint: their inertia is armature c c^T.
void Trees::add_rotors() {
  for (const CoordinateLaw& law : model_.forces.coordinate_laws) {
    if (law.armature == 0) continue;
    for (Node& node : nodes_) {
      const bool same = node.body == law.at.body && node.parent == law.at.to,
                 turned = node.body == law.at.to && node.parent == law.at.body;
      if (node.members > 0 || !(same || turned)) continue;
      const bool slides = law.at.kind == Coordinate::Kind::displacement;
      const int carrier = law.at.on_body ? law.at.body : law.at.to;
      const Vector3 axis =
          carrier == fixed_world ? law.at.axis : Vector3(kinematics_[index(carrier)].rotation * law.at.axis);
      Vector3 along = Vector3::Zero();
      for (int i = 0; slides && i < node.slides; ++i)
        along[i] = axis.dot(direction(node, i, kinematics_.data()));
      if (!slides) {
        const Vector3 first = kinematics_[node.above].rotation * node.first,
                      second = kinematics_[index(node.body)].rotation * node.second_axis;
        const int which = angle_of(node, law);
        // The angle between two axes grows with that of a gimbal, from whichever side.
        along[node.slides + which] = which == 2 ? 1 : axis.dot(which == 1 ? second : first);
      }
      node.rotor += law.armature * along * along.transpose();
      node.drives = true;
    }
  }
}

void Trees::read_turns(const Real* y, std::vector<Real>& turns) const {
  model_.forces.read_turns(turns);
  for (const Counted& one : counted_) turns[one.law] = one.start + one.sign * y[one.at];
}

// The direction of a displacement, as who carries it turns.
Vector3 Trees::direction(const Node& node, int i, const Kinematics* kinematics) const {
  const Vector3& d = node.directions[static_cast<std::size_t>(i)];
  if (node.child_slides) return -(kinematics[index(node.body)].rotation * d);
  return kinematics[node.above].rotation * d;
}

// Of a tree in space: sum m x and sum m v.
Trees::Sums Trees::sums_of(const Node& root, const Motion* motions) const {
  Sums sums;
  for (const Node* node = &root; node != &root + root.members; ++node) {
    const Motion& motion = motions[index(node->body)];
    sums.places += model_.bodies[index(node->body)].mass * motion.position, sums.momentum += motion.momentum;
  }
  return sums;
}

// The coordinates of the model's motions; requires that nothing was evaluated before.
std::vector<Real> Trees::initial() const {
  std::vector<Real> y(size_, 0);
  for (const Node& node : nodes_) {
    const Motion& m = motions_[index(node.body)];
    const Kinematics &k = kinematics_[index(node.body)], &above = kinematics_[node.above];
    const Vector3 centre = motions_[node.above].position, held = centre + above.rotation * node.parent_anchor;
    const Vector3 mine = m.position + k.rotation * node.anchor, pivot = node.child_slides ? held : mine;
    const Vector3 slip = k.velocity - above.velocity - above.angular_velocity.cross(pivot - centre) -
                         k.angular_velocity.cross(m.position - pivot),
                  spin = k.angular_velocity - above.angular_velocity;
    Real* q = y.data() + node.at;
    Real* rate = y.data() + node.rates_at();
    for (int i = 0; i < node.slides; ++i) {
      const Vector3 d = direction(node, i, kinematics_.data());
      *q++ = d.dot(mine - held), *rate++ = d.dot(slip);
    }
    if (node.turns == Turns::freely) {
      std::copy_n(m.orientation.coeffs().data(), 4, q);
      std::copy_n(k.angular_velocity.data(), 3, rate);
    }
    const Vector3 first = above.rotation * node.first, second = k.rotation * node.second_axis;
    if (node.angles > 2) {  // of axes that are not square
      Matrix3 axes;
      axes << first, second, above.rotation * node.third;
      const Vector3 rates = axes.inverse() * spin;
      rate = std::copy_n(rates.data(), 3, rate);
    } else {
      if (node.angles > 0) *rate++ = first.dot(spin);
      if (node.angles > 1) *rate++ = second.dot(spin);
    }
    if (node.members < 2) continue;
    const Sums sums = sums_of(node, motions_.data());
    for (int i = 0; i < 3; ++i) {
      y[node.at + index(i)] = sums.places[i] / node.mass;
      y[node.rates_at() + index(i)] = sums.momentum[i] / node.mass;
    }
  }
  return y;
}

// Of the turn between the two axes of a gimbal: square to both, and what the first carries.
Vector3 Trees::axis_between(const Node& node, const Real* angles, const Kinematics* kinematics) const {
  return kinematics[node.above].rotation * (exponential(angles[0] * node.first) * node.third);
}

Vector3 Trees::offset(const Node& node, const Real* angles, const Kinematics* kinematics) const {
  if (node.offset.isZero(0)) return Vector3::Zero();
  return kinematics[node.above].rotation * (exponential(angles[0] * node.first) * node.offset);
}

// Where a body is and how it moves, from its coordinates and its parent:
//   R = R_p exp(a h) exp(b n) exp(c u) R_0,   c = pivot - R anchor  (with displacements on the side of who carries them),
//   w = w_p + sum e a',   v = v_p + w_p x (pivot - c_p) + sum d s' + w x (c - pivot)
void Trees::place(const Node& node, const Real* y, Motion* motions, Kinematics* kinematics) const {
  const Body& body = model_.bodies[index(node.body)];
  Motion& m = motions[index(node.body)];
  Kinematics& k = kinematics[index(node.body)];
  const Kinematics& above = kinematics[node.above];
  const Vector3 centre = motions[node.above].position, held = centre + above.rotation * node.parent_anchor;
  const Real* q = y + node.at + node.slides;
  const Real* rate = y + node.rates_at() + node.slides;
  if (node.turns == Turns::freely) {
    m.orientation = Quaternion(q[3], q[0], q[1], q[2]).normalized();
    k.rotation = rotation_matrix(m.orientation);
    k.angular_velocity = {rate[0], rate[1], rate[2]};
  } else {
    Quaternion turn = node.relative;
    if (node.angles > 1) turn = exponential(q[1] * node.second) * turn;
    if (node.angles > 2) turn = exponential(q[2] * node.third) * turn;
    if (node.angles > 0) turn = exponential(q[0] * node.first) * turn;
    m.orientation = renormalised(motions[node.above].orientation * turn);
    k.rotation = rotation_matrix(m.orientation);
    k.angular_velocity = above.angular_velocity;
    if (node.angles > 0) k.angular_velocity += rate[0] * (above.rotation * node.first);
    if (node.angles > 1) k.angular_velocity += rate[1] * (k.rotation * node.second_axis);
    if (node.angles > 2) k.angular_velocity += rate[2] * axis_between(node, q, kinematics);
  }
  Vector3 slid = Vector3::Zero(), slip = Vector3::Zero();
  for (int i = 0; i < node.slides; ++i) {
    const Vector3 d = direction(node, i, kinematics);
    slid += y[node.at + index(i)] * d;
    slip += y[node.rates_at() + index(i)] * d;
  }
  const Vector3 off = offset(node, q, kinematics);
  if (!node.offset.isZero(0)) slip += rate[0] * (above.rotation * node.first).cross(off);
  m.position = held + slid + off - k.rotation * node.anchor;
  const bool child_slides = node.child_slides && node.slides > 0;
  const Vector3 pivot = child_slides ? held : Vector3(held + slid + off);
  k.velocity = above.velocity + above.angular_velocity.cross(pivot - centre) + slip +
               k.angular_velocity.cross(m.position - pivot);
  m.momentum = body.mass * k.velocity;
  m.angular_momentum = k.rotation * (body.inertia * (k.rotation.transpose() * k.angular_velocity));
}

// The root was placed at the centre of mass, and moved with it.
void Trees::move_to_centre(const Node& root, const Real* y, Motion* motions, Kinematics* kinematics) const {
  const Real *q = y + root.at, *rate = y + root.rates_at();
  const Sums sums = sums_of(root, motions);
  const Vector3 shift = Vector3(q[0], q[1], q[2]) - sums.places / root.mass,
                push = Vector3(rate[0], rate[1], rate[2]) - sums.momentum / root.mass;
  for (const Node* node = &root; node != &root + root.members; ++node) {
    const std::size_t i = index(node->body);
    motions[i].position += shift;
    motions[i].momentum += model_.bodies[i].mass * push;
    kinematics[i].velocity += push;
  }
}

void Trees::place_all(const Real* y, Motion* motions, Kinematics* kinematics) const {
  for (const Node& node : nodes_) place(node, y, motions, kinematics);
  for (const Node& node : nodes_)
    if (node.members > 1) move_to_centre(node, y, motions, kinematics);
}

void Trees::read(const Real* y, std::vector<Motion>& motions) const {
  motions = motions_;
  std::vector<Kinematics> kinematics = kinematics_;
  place_all(y, motions.data(), kinematics.data());
}

// Of a turn about e through the pivot, of which the body's centre is off by r, and of a displacement along d:
//   S = (e, e x r),  S = (0, d);  S' q' with  e' and d' of who carries them and  r' = v - that of the pivot.
// And of the parent:  a = a_p + alpha_p x (c - c_p) + w_p x (v - v_p).
void Trees::find_space(const Node& node, const Real* y) {
  Articulated& a = articulated_[index(node.body)];
  if (node.members > 0) {  // in space: along and about the axes of the world through its own centre
    a.space.setZero();
    a.space.topRightCorner<3, 3>().setIdentity(), a.space.bottomLeftCorner<3, 3>().setIdentity();
    a.change.setZero(), a.shift.setZero();
    return;
  }
  const Motion& m = motions_[index(node.body)];
  const Kinematics &k = kinematics_[index(node.body)], &above = kinematics_[node.above];
  const Vector3 centre = motions_[node.above].position, w_above = above.angular_velocity;
  const Vector3 pivot = node.child_slides ? Vector3(centre + above.rotation * node.parent_anchor)
                                          : Vector3(m.position + k.rotation * node.anchor);
  const Vector3 r = m.position - pivot;
  a.shift = m.position - centre;
  Vector3 turned = Vector3::Zero();  // of the change: alpha, then a
  Vector3 carried = w_above.cross(k.velocity - above.velocity);
  Vector3 r_rate = k.velocity - above.velocity - w_above.cross(pivot - centre);
  const Real* rate = y + node.rates_at();
  int column = 0;
  for (; column < node.slides; ++column) {
    const Vector3 d = direction(node, column, kinematics_.data());
    set(a.space, column, Vector3::Zero(), d);
    carried += rate[column] * (node.child_slides ? k.angular_velocity : w_above).cross(d);
    if (!node.child_slides) r_rate -= rate[column] * d;
  }
  const auto turn_about = [&](const Vector3& e) { set(a.space, column++, e, e.cross(r)); };
  const auto turn_at_rate = [&](const Vector3& e, const Vector3& w_carrier) {
    const Vector3 change = rate[column] * w_carrier.cross(e);
    turned += change, carried += change.cross(r) + rate[column] * e.cross(r_rate);
    turn_about(e);
  };
  if (node.turns == Turns::freely) {
    for (int i = 0; i < 3; ++i) turn_about(Vector3::Unit(i));
    carried += (k.angular_velocity - w_above).cross(r_rate);
  }
  if (!node.offset.isZero(0)) return find_offset_space(node, y);
  if (node.angles > 0) turn_at_rate(above.rotation * node.first, w_above);
  if (node.angles > 1) turn_at_rate(k.rotation * node.second_axis, k.angular_velocity);
  if (node.angles > 2)
    turn_at_rate(axis_between(node, y + node.at + node.slides, kinematics_.data()),
                 w_above + rate[node.slides] * (above.rotation * node.first));
  set(a.change, 0, turned, carried);
}

// The same of two turns about axes that do not meet: about e_0 through the parent's point, and about e_1, which is farther by
// what the first carries, through the body's.  With r_i from there to the centre:  r_0' = v - that of the parent's point,
// r_1' = r_0' - (w_p + e_0 q_0') x offset.
void Trees::find_offset_space(const Node& node, const Real* y) {
  Articulated& a = articulated_[index(node.body)];
  const Motion& m = motions_[index(node.body)];
  const Kinematics &k = kinematics_[index(node.body)], &above = kinematics_[node.above];
  const Vector3 centre = motions_[node.above].position, w_above = above.angular_velocity,
                point = centre + above.rotation * node.parent_anchor;
  const Real* rate = y + node.rates_at();
  const Vector3 first = above.rotation * node.first, second = k.rotation * node.second_axis;
  const Vector3 w_between = w_above + rate[0] * first, off = offset(node, y + node.at, kinematics_.data());
  a.shift = m.position - centre;
  Vector3 turned = Vector3::Zero(), carried = w_above.cross(k.velocity - above.velocity);
  const auto turn = [&](int column, const Vector3& e, const Vector3& w_carrier, const Vector3& r,
                        const Vector3& r_rate) {
    const Vector3 change = rate[column] * w_carrier.cross(e);
    turned += change, carried += change.cross(r) + rate[column] * e.cross(r_rate);
    set(a.space, column, e, e.cross(r));
  };
  const Vector3 r = m.position - point, r_rate = k.velocity - above.velocity - w_above.cross(point - centre);
  turn(0, first, w_above, r, r_rate);
  turn(1, second, k.angular_velocity, r - off, r_rate - w_between.cross(off));
  set(a.change, 0, turned, carried);
}

// What a body and all that hangs from it are to its parent:
//   I_p += X^T (I - I S (S^T I S)^-1 S^T I) X,   b_p += X^T (b + that g + I S (S^T I S)^-1 u),   u = -S^T b
template <int N>
void Trees::lean(const Node& node, Articulated& a) {
  const Eigen::Matrix<Real, 6, N> s = a.space.template leftCols<N>();
  const Eigen::Matrix<Real, 6, N> force = a.inertia * s;
  Eigen::Matrix<Real, N, N> mass = s.transpose() * force;
  if constexpr (N <= 3)
    if (node.drives) mass += node.rotor.template topLeftCorner<N, N>();
  const Eigen::Matrix<Real, N, 1> push = -s.transpose() * a.bias;
  a.push.template head<N>() = push;
  if (!model_.moves(
          node.parent)) {  // solved here: the inverse of a tree whose bodies are far apart would lose digits
    a.push.template head<N>() -= force.transpose() * a.change;
    mass.llt().solveInPlace(a.push.template head<N>());
    return;
  }
  Eigen::Matrix<Real, N, N> inverse;
  if constexpr (N == 1)
    inverse(0, 0) = 1 / mass(0, 0);
  else
    inverse = mass.llt().solve(Eigen::Matrix<Real, N, N>::Identity());
  a.force.template leftCols<N>() = force;
  a.inverse.template topLeftCorner<N, N>() = inverse;
  const Eigen::Matrix<Real, 6, N> share = force * inverse;
  a.inertia -= share * force.transpose();
  a.bias += a.inertia * a.change + share * push;
}

template <int N>
void Trees::accelerate(const Node& node, Articulated& a, const Vector6& parent, const Real* y,
                       Real* rate) const {
  a.acceleration = parent + a.change;
  Eigen::Matrix<Real, N, 1> q = a.push.template head<N>();
  if (model_.moves(node.parent)) {
    q -= a.force.template leftCols<N>().transpose() * a.acceleration;
    q = a.inverse.template topLeftCorner<N, N>() * q;
  }
  a.acceleration += a.space.template leftCols<N>() * q;
  const Real* now = y + node.rates_at();
  Real* change = rate + node.at;
  for (int i = 0; i < node.slides + node.angles; ++i) *change++ = now[i];
  if (node.turns == Turns::freely) {
    const Real* c = y + node.at + node.slides;
    const Vector3 half = Vector3(now[node.slides], now[node.slides + 1], now[node.slides + 2]) / 2;
    const Quaternion turn = Quaternion(0, half.x(), half.y(), half.z()) * Quaternion(c[3], c[0], c[1], c[2]);
    change = std::copy_n(turn.coeffs().data(), 4, change);
  }
  for (int i = 0; i < node.slides + node.angles; ++i) *change++ = q[i];
  if (node.turns == Turns::freely) std::copy_n(a.acceleration.data(), 3, change);
}

void Trees::rates(Time t, const Real* y, Real* rate) {
  place_all(y, motions_.data(), kinematics_.data());
  for (const Counted& one : counted_)
    model_.forces.coordinate_laws[one.law].at.near = one.start + one.sign * y[one.at];
  apply(model_.forces, t, model_.bodies, count_, motions_.data(), kinematics_.data(), loads_.data());
  for (const Node& node : nodes_) {
    const std::size_t i = index(node.body);
    const Body& body = model_.bodies[i];
    const Kinematics& k = kinematics_[i];
    Articulated& a = articulated_[i];
    a.inertia.setZero();
    a.inertia.topLeftCorner<3, 3>() = k.rotation * body.inertia * k.rotation.transpose();
    a.inertia.bottomRightCorner<3, 3>().diagonal().setConstant(body.mass);
    set(a.bias, 0, k.angular_velocity.cross(motions_[i].angular_momentum) - loads_[i].torque,
        -loads_[i].force);
    find_space(node, y);
  }
  for (std::size_t k = nodes_.size(); k-- > 0;) {
    const Node& node = nodes_[k];
    Articulated& a = articulated_[index(node.body)];
    if (node.freedoms > 0)
      with_size(node.freedoms, [&]<int N>() { lean<N>(node, a); });
    else
      a.bias += a.inertia * a.change;
    if (!model_.moves(node.parent)) continue;
    Articulated& parent = articulated_[index(node.parent)];
    const Matrix3 d = cross_matrix(a.shift);
    const auto turns = a.inertia.topLeftCorner<3, 3>(), mixed = a.inertia.topRightCorner<3, 3>(),
               goes = a.inertia.bottomRightCorner<3, 3>();
    const Matrix3 at = d * goes, both = mixed + at;
    parent.inertia.topLeftCorner<3, 3>() += turns - both * d + d * mixed.transpose();
    parent.inertia.topRightCorner<3, 3>() += both;
    parent.inertia.bottomLeftCorner<3, 3>() += both.transpose();
    parent.inertia.bottomRightCorner<3, 3>() += goes;
    const Vector3 force = a.bias.tail<3>();
    parent.bias.tail<3>() += force;
    parent.bias.head<3>() += a.bias.head<3>() + a.shift.cross(force);
  }
  for (const Node& node : nodes_) {
    Articulated& a = articulated_[index(node.body)];
    Vector6 parent = Vector6::Zero();
    if (model_.moves(node.parent)) {
      parent = articulated_[index(node.parent)].acceleration;
      parent.tail<3>() += parent.head<3>().cross(a.shift);
    }
    if (node.freedoms > 0)
      with_size(node.freedoms, [&]<int N>() { accelerate<N>(node, a, parent, y, rate); });
    else
      a.acceleration = parent + a.change;
  }
  // What the bodies do to each other cancels.
  for (const Node& root : nodes_) {
    if (root.members < 2) continue;
    Vector3 force = Vector3::Zero();
    for (const Node* node = &root; node != &root + root.members; ++node)
      force += loads_[index(node->body)].force;
    for (int i = 0; i < 3; ++i) rate[root.rates_at() + index(i)] = force[i] / root.mass;
  }
}

void Trees::project(Real* y) const {
  for (const Node& node : nodes_) {
    if (node.turns != Turns::freely) continue;
    Eigen::Map<Eigen::Matrix<Real, 4, 1>>(y + node.at + node.slides).normalize();
  }
}

// Places against the largest distance from the origin so far, speeds against the largest speed, turns against 1 and spins
// against the largest spin.  What is at rest is shaken by the rounding of its forces, which no step makes smooth: a speed is
// small against what these give over the length of the scene, sqrt(F/m L), not against nothing.  Bodies that turn about their
// own centres move along their joints by that times its arm.
void Trees::scales(const Real* y, Real* scale) {
  place_all(y, motions_.data(), kinematics_.data());
  for (const Node& node : nodes_) {
    const std::size_t i = index(node.body);
    length_ = std::max(length_, motions_[i].position.norm());
    speed_ = std::max(speed_, kinematics_[i].velocity.norm());
    turn_ = std::max(turn_, kinematics_[i].angular_velocity.norm());
    pull_ = std::max(pull_, loads_[i].force.norm() / model_.bodies[i].mass);
  }
  const Real shaken = std::sqrt(std::max(pull_, model_.strongest_gravity()) * length_);
  const auto or_one = [](Real x) { return x > 0 ? x : Real(1); };
  const Real length = or_one(std::max(length_, arm_)),
             speed = or_one(std::max({speed_, shaken, turn_ * arm_})),
             turn = or_one(std::max(turn_, length_ > 0 ? shaken / length_ : 0));
  for (const Node& node : nodes_) {
    std::fill_n(scale + node.at, node.slides, length);
    std::fill_n(scale + node.at + node.slides, node.coordinates() - static_cast<std::size_t>(node.slides),
                Real(1));
    std::fill_n(scale + node.rates_at(), node.slides, speed);
    std::fill_n(scale + node.rates_at() + node.slides, node.freedoms - node.slides, turn);
  }
}

}  // namespace cylon::engine
