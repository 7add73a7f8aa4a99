#include "engine/pile/body_contacts.h"

#include "engine/geometry/facetted.h"
#include "engine/geometry/manifold.h"
#include "engine/joint.h"
#include "engine/pile/islands.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine::pile {
namespace {

constexpr Real spare_distance = Real(1e-6);  // of the bounding radius
constexpr Real one_place = Real(1e-4);       // of it, too: points that are so near have one velocity

// Scenes of more moving bodies than this keep their contacts while two bodies move against each other by less
// than `still` of their bounding radius.  What that leaves out is of second order: a gap is that of the same
// two points along the turned normal.
constexpr std::size_t few_bodies = 32;
constexpr Real still = Real(1) / 4096, spare_margin = Real(1) / 64, skin = Real(1) / 8;

// Leaves out points between two others, and all but one of those in one place: they hold nothing that the others do
// not, and where edges of faces lie on each other rounding decides whether there are any.
void leave_out_between(Manifold& manifold, Real size) {
  const auto at = [&](int i) -> const Vector3& { return manifold.points[index(i)].position; };
  const auto is_spare = [&](int k) {
    const Vector3& p = at(k);
    for (int i = 0; i < manifold.count; ++i) {
      if (i == k) continue;
      if ((p - at(i)).norm() <= size) return true;
      for (int j = i + 1; j < manifold.count; ++j) {
        const Vector3 way = at(j) - at(i);
        const Real along = way.dot(p - at(i));
        if (j != k && along > 0 && along < way.squaredNorm() &&
            way.cross(p - at(i)).norm() <= size * way.norm())
          return true;
      }
    }
    return false;
  };
  for (int k = 0; k < manifold.count;) {
    if (is_spare(k))
      std::move(manifold.points.begin() + k + 1, manifold.points.begin() + manifold.count--,
                manifold.points.begin() + k);
    else
      ++k;
  }
}

// How many points with one normal have loads that the motion alone decides.
constexpr int most_unique = 3;

bool is_one_to_one(std::vector<const Block*>& matched, std::ptrdiff_t count) {
  if (static_cast<std::ptrdiff_t>(matched.size()) != count || std::ranges::count(matched, nullptr) > 0)
    return false;
  std::sort(matched.begin(), matched.end());
  return std::adjacent_find(matched.begin(), matched.end()) == matched.end();
}

// Of more points than three the loads are not unique, and a solution adds to what each had before only what is linear in
// the place.  Where some of the points are new, what the others had would stay as a pattern that turns a sliding body, so
// all begin with the same:  J_k = (sum of those before)/n.
void share_evenly(const Block* from, const Block* to, Block* first, Block* last) {
  Vector3 sum = Vector3::Zero();
  for (const Block* b = from; b != to; ++b) sum += b->impulse;
  const Vector3& normal = first->normal;
  const Real along = normal.dot(sum);
  sum += (std::max(along, Real(0)) - along) * normal;
  for (Block* b = first; b != last; ++b) b->impulse = sum / static_cast<Real>(last - first);
}

Vector3 point(const Vector3& anchor, int body, const std::vector<Motion>& motions) {
  if (body == fixed_world) return anchor;
  return motions[index(body)].position + motions[index(body)].orientation * anchor;
}

}  // namespace

Quaternion orientation_of(int body, const std::vector<Motion>& motions) {
  return body == fixed_world ? Quaternion(Quaternion::Identity()) : motions[index(body)].orientation;
}

BodyContacts::BodyContacts(const Model& model)
    : model_(model), seams_(model), gravity_(pressing_gravity(model)) {
  for (const Shape& shape : model.shapes) {
    radius_.push_back(bounding_radius(shape));
    round_.push_back(is_round(shape));
    boxes_.emplace_back(shape);
    const Real half = half_width(shape);
    if (half > 0) smallest_ = smallest_ > 0 ? std::min(smallest_, half) : half;
  }
  persistent_ = static_cast<std::size_t>(std::count_if(model.bodies.begin(), model.bodies.end(),
                                                       [](const Body& b) { return !b.locked; })) > few_bodies;
  margin_.resize(model.bodies.size());
  travel_.resize(model.bodies.size());
  bounds_.resize(model.bodies.size());
}

Vector3 offset(const Block& block, const std::vector<Motion>& motions) {
  return point(block.anchor, block.a, motions) - point(block.to_anchor, block.b, motions);
}

// Pairs whose bounding balls, each with its margin and a skin, meet.
void BodyContacts::find_near(const std::vector<Motion>& motions) {
  constexpr Real most = std::numeric_limits<Real>::infinity();
  places_.resize(motions.size()), room_.resize(motions.size());
  for (int i = 0; i < static_cast<int>(motions.size()); ++i) {
    const bool touches = model_.surfaces[index(i)] != no_surface &&
                         (radius_[index(i)] > 0 || std::holds_alternative<Sphere>(model_.shapes[index(i)]));
    const Vector3& p = places_[index(i)] = motions[index(i)].position;
    room_[index(i)] = radius_[index(i)] + margin_[index(i)] + skin * radius_[index(i)];
    const Vector3 r = Vector3::Constant(touches ? room_[index(i)] : -most);
    bounds_[index(i)] = {p - r, p + r};
  }
  near_.clear();
  for (const auto& [a, b] : broad_phase_.pairs(bounds_)) {
    const bool moves = !model_.bodies[index(a)].locked || !model_.bodies[index(b)].locked;
    if (moves && model_.may_touch(a, b)) near_.emplace_back(a, b);
  }
}

// Bodies whose bounding balls and boxes, each with its margin, meet; in ascending order.
void BodyContacts::find_pairs(const std::vector<Motion>& motions) {
  const auto reach = [&](int i) { return radius_[index(i)] + margin_[index(i)]; };
  bool holds = places_.size() == motions.size();
  for (int i = 0; holds && i < static_cast<int>(motions.size()); ++i)
    holds = (motions[index(i)].position - places_[index(i)]).norm() + reach(i) <= room_[index(i)];
  if (!holds) find_near(motions);
  for (std::size_t i = 0; i < motions.size(); ++i)
    bounds_[i] = seen_from(Pose(), pose(motions[i]), boxes_[i].all(), margin_[i]);
  const auto meet = [](const Bounds& a, const Bounds& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
  };
  pairs_.clear();
  for (const auto& [a, b] : near_) {
    const Real far = reach(a) + reach(b);
    if ((motions[index(a)].position - motions[index(b)].position).squaredNorm() <= far * far &&
        meet(bounds_[index(a)], bounds_[index(b)]))
      pairs_.emplace_back(a, b);
  }
}

BodyContacts::Found BodyContacts::now(const std::vector<Motion>& motions, int a, int b, int plane) const {
  const Motion& m = motions[index(a)];
  const Quaternion back = m.orientation.conjugate();
  if (b != fixed_world)
    return {
        a, b, plane, back * motions[index(b)].orientation, back * (motions[index(b)].position - m.position),
        0};
  const Plane& p = model_.planes[index(plane)];
  return {a, b, plane, back, {p.normal.dot(m.position) - p.offset, 0, 0}, 0};
}

// Whether what was found before holds for `margin` now: with contacts, where the two have hardly moved against
// each other; without, where they cannot have come within the margin.
bool BodyContacts::holds(const Found& before, const Found& now, Real margin, bool any) const {
  if (margin > before.margin) return false;
  const Real radius =
      now.b == fixed_world ? radius_[index(now.a)] : std::max(radius_[index(now.a)], radius_[index(now.b)]);
  const Real turn = std::min((now.turn.coeffs() - before.turn.coeffs()).norm(),
                             (now.turn.coeffs() + before.turn.coeffs()).norm());
  const Real way = (now.shift - before.shift).norm() + 2 * radius * turn;
  // The point of a round body does not turn with it: kept, it would have a lever that drives the body.
  const bool round = round_[index(now.a)] || (now.b != fixed_world && round_[index(now.b)]);
  return way <= before.margin - margin && (!any || (!round && way <= still * radius));
}

// The same contacts again: their points are fixed to the bodies, the normals to a.
void BodyContacts::keep(const std::vector<Motion>& motions, const Found& found, std::size_t from,
                        std::size_t to, std::vector<Block>& blocks) {
  if (from == to) return;
  const Matrix3 turn_a = rotation_matrix(motions[index(found.a)].orientation);
  const bool two = found.b != fixed_world;
  const Matrix3 turn_b =
      two ? rotation_matrix(motions[index(found.b)].orientation) : Matrix3(Matrix3::Identity());
  for (std::size_t k = from; k < to; ++k) {
    blocks.push_back(old_[k]);
    Block& block = blocks.back();
    if (two) block.normal = turn_a * block.own_normal;
    block.arm = turn_a * block.anchor;
    if (two) block.to_arm = turn_b * block.to_anchor;
    block.impact = false, block.target = 0;
  }
}

void BodyContacts::touch(const std::vector<Motion>& motions, int a, int b, int plane, Real margin,
                         std::vector<Block>& blocks) {
  // The old blocks are in the same order; planes come after bodies.
  const auto before = [&](const auto& x) {
    const int kind = x.b == fixed_world ? 1 : 0, mine = b == fixed_world ? 1 : 0;
    if (kind != mine) return kind < mine;
    return kind == 0 ? std::pair(x.a, x.b) < std::pair(a, b) : std::pair(x.a, x.plane) < std::pair(a, plane);
  };
  const auto same_pair = [&](const auto& x) { return x.a == a && x.b == b && x.plane == plane; };
  const std::vector<Block>& old = old_;
  std::size_t& next = next_;
  while (next < old.size() && old[next].kind == Block::Kind::contact && before(old[next])) ++next;
  if (persistent_) {
    Found where = now(motions, a, b, plane);
    while (next_found_ < old_found_.size() && before(old_found_[next_found_])) ++next_found_;
    std::size_t to = next;
    while (to < old.size() && old[to].kind == Block::Kind::contact && same_pair(old[to])) ++to;
    if (next_found_ < old_found_.size() && same_pair(old_found_[next_found_]) &&
        holds(old_found_[next_found_], where, margin, to > next)) {
      found_.push_back(old_found_[next_found_]);
      return keep(motions, found_.back(), next, to, blocks);
    }
    margin += spare_margin * radius_[index(a)];
    where.margin = margin;
    found_.push_back(where);
  }
  find_points(motions, a, b, plane, margin);
  const Material& material =
      model_.material(model_.surfaces[index(a)],
                      b == fixed_world ? model_.plane_surfaces[index(plane)] : model_.surfaces[index(b)]);
  const Quaternion back = motions[index(a)].orientation.conjugate();
  const std::size_t first = blocks.size();
  std::vector<const Block*>& matched = matched_;
  matched.clear();
  for (const PartManifold& found : points_) {
    const Vector3& normal = found.manifold.normal;
    const Vector3 own_normal = back * normal;
    for (int k = 0; k < found.manifold.count; ++k) {
      const ContactPoint& contact = found.manifold.points[index(k)];
      Block block;
      block.a = a, block.b = b, block.plane = plane;
      block.normal = normal, block.own_normal = own_normal;
      block.gap = contact.gap, block.feature = contact.feature;
      block.friction = material.friction, block.restitution = material.restitution;
      block.arm = contact.position - motions[index(a)].position;
      block.anchor = back * block.arm;
      block.to_anchor = contact.position;
      if (b != fixed_world) {
        block.to_arm = contact.position - motions[index(b)].position;
        block.to_anchor = motions[index(b)].orientation.conjugate() * block.to_arm;
      }
      // The same feature, or else the nearest point: corners that coincide take turns in naming a place.
      const Block* same = nullptr;
      Real nearest = radius_[index(a)] / 16;
      for (std::size_t m = next; m < old.size() && same_pair(old[m]); ++m) {
        if (old[m].kind != Block::Kind::contact) break;
        const Real distance =
            old[m].feature == block.feature ? Real(-1) : (old[m].anchor - block.anchor).norm();
        if (distance < nearest) same = &old[m], nearest = distance;
      }
      if (same) {
        const Real along = block.normal.dot(same->impulse);
        block.impulse = same->impulse + (std::max(along, Real(0)) - along) * block.normal;
        block.past = same->past;
        block.past.known &= nearest < 0 || are_one_place(*same, block);
      }
      matched.push_back(same);
      blocks.push_back(block);
    }
  }
  std::size_t end = next;
  while (end < old.size() && old[end].kind == Block::Kind::contact && same_pair(old[end])) ++end;
  const auto count = static_cast<std::ptrdiff_t>(end - next);
  if (points_.size() == 1 && points_[0].manifold.count > most_unique && count > 0 &&
      !is_one_to_one(matched, count))
    share_evenly(old.data() + next, old.data() + end, blocks.data() + first, blocks.data() + blocks.size());
}

// At one place of either body, whichever is named first.
bool BodyContacts::are_one_place(const Block& old, const Block& now) const {
  const Real on_a = (old.anchor - now.anchor).norm();
  if (now.b == fixed_world) return on_a <= one_place * radius_[index(now.a)];
  const Real on_b = (old.to_anchor - now.to_anchor).norm();
  return std::min(on_a, on_b) <= one_place * std::min(radius_[index(now.a)], radius_[index(now.b)]);
}

// Fills points_ with where two bodies touch, or one and a plane.
void BodyContacts::find_points(const std::vector<Motion>& motions, int a, int b, int plane, Real margin) {
  const Shape& shape = model_.shapes[index(a)];
  const Pose at = pose(motions[index(a)]);
  if (b == fixed_world) {
    points_.assign(1, {0, 0, manifold(shape, at, model_.planes[index(plane)], margin, &travel_[index(a)])});
  } else {
    manifolds(shape, boxes_[index(a)], at, model_.shapes[index(b)], boxes_[index(b)], pose(motions[index(b)]),
              margin, points_);
    for (PartManifold& found : points_) leave_out_inside(motions, a, b, found);
    const bool on_a = radius_[index(a)] <= radius_[index(b)];
    join_faces(points_, on_a ? at : pose(motions[index(b)]));
  }
  for (const PartManifold& found : points_) {
    if (found.manifold.thinned) log_.note(DiagnosticKind::points_left_out, now_, Manifold::capacity);
    if (found.manifold.unsettled > 0)
      log_.note(DiagnosticKind::facets_unsettled, now_, Facetted::most_rounds,
                static_cast<double>(found.manifold.unsettled));
  }
  for (PartManifold& found : points_) leave_out_between(found.manifold, spare_distance * radius_[index(a)]);
}

// Leaves out points on what is no surface, as shapes beside it cover it.
void BodyContacts::leave_out_inside(const std::vector<Motion>& motions, int a, int b,
                                    PartManifold& found) const {
  Manifold& m = found.manifold;
  const auto centre = [&](int body, int part) -> Vector3 {
    const Motion& motion = motions[index(body)];
    const auto* compound = std::get_if<Compound>(&model_.shapes[index(body)]);
    if (compound == nullptr) return motion.position;
    return motion.position + motion.orientation * compound->parts[index(part)].position;
  };
  const Vector3 centre_a = centre(a, found.part), centre_b = centre(b, found.other_part);
  const auto covered = [&](int on, int part, int by, const Vector3& from, const ContactPoint& contact,
                           Real side) {
    return seams_.covers(on, part, by, motions[index(on)],
                         contact.position - side * contact.gap / 2 * m.normal, side * m.normal, from);
  };
  const auto end = std::remove_if(m.points.begin(), m.points.begin() + m.count, [&](const ContactPoint& p) {
    return covered(b, found.other_part, a, centre_a, p, 1) || covered(a, found.part, b, centre_b, p, -1);
  });
  m.count = static_cast<int>(end - m.points.begin());
}

namespace {

// q' = gearing n.u  with n the axis; the arms of a displacement end at one point, that of `body`, as its row's do.
Block block_along(const CoordinateLaw& law, const std::vector<Body>& bodies,
                  const std::vector<Motion>& motions) {
  const Coordinate& at = law.at;
  const Row row = row_of(at, bodies, motions.data());
  Block block;
  block.a = at.body, block.b = at.to;
  block.angular = at.is_angle();
  block.normal = block.angular ? row.lever : row.direction;
  if (at.kind == Coordinate::Kind::azimuth) block.gearing = block.normal.norm(), block.normal.normalize();
  if (block.angular) return block;
  block.arm = point(at.anchor, at.body, motions) - motions[index(at.body)].position;
  if (at.to != fixed_world)
    block.to_arm = motions[index(at.body)].position + block.arm - motions[index(at.to)].position;
  return block;
}

}  // namespace

void place_hold(const Joint& joint, Block& block, const std::vector<Motion>& motions) {
  const bool slides =
      joint.type.place == Joint::Place::along_axis || joint.type.place == Joint::Place::in_plane;
  if (slides && block.b != fixed_world)
    block.to_arm = motions[index(block.a)].position + block.arm - motions[index(block.b)].position;
}

// Between the point on `to` and that on `body` is what turns about the axis of each.  A force along the axis h of `to` passes
// through the point on `body`, else it would turn that about the other axis; what is square to h passes through the point on
// `to`: two parts, each of one point.  Requires the arms of the joint's own points; the first is left in `block`.
Block split_at_offset(const Joint& joint, Block& block, const std::vector<Motion>& motions) {
  const Vector3 h = orientation_of(joint.to, motions) * joint.to_axis;
  const Motion& body = motions[index(joint.body)];
  block.offset = true;
  Block along = block;
  along.space = h * h.transpose();
  if (joint.to != fixed_world) along.to_arm = body.position + block.arm - motions[index(joint.to)].position;
  block.space = Matrix3::Identity() - along.space;
  block.arm = point(joint.to_anchor, joint.to, motions) - body.position;
  return along;
}

// A block for the place of each joint, two where it has an offset, one for its turn where it is not free, and one for what a
// screw couples; then those of laws on coordinates of joints: a stiff force, dry friction, and each limit.
void BodyContacts::add_joints(const std::vector<Motion>& motions, const std::vector<Block>& old,
                              std::vector<Block>& blocks) const {
  std::size_t next = 0;
  while (next < old.size() && old[next].kind == Block::Kind::contact) ++next;
  const auto add = [&](Block block) {
    if (next < old.size()) {
      const Block& same = old[next++];
      block.impulse = same.impulse, block.past = same.past;
    }
    blocks.push_back(block);
  };
  for (const Joint& joint : model_.joints) {
    Block block;
    block.kind = Block::Kind::hold;
    block.a = joint.body, block.b = joint.to;
    block.anchor = joint.anchor, block.to_anchor = joint.to_anchor;
    block.arm = point(joint.anchor, joint.body, motions) - motions[index(joint.body)].position;
    if (joint.to != fixed_world)
      block.to_arm = point(joint.to_anchor, joint.to, motions) - motions[index(joint.to)].position;
    if (joint.type.place == Joint::Place::along_normal) {
      add(split_at_offset(joint, block, motions));
    } else {
      place_hold(joint, block, motions);
      block.space = misfit_of_place(joint, offset(block, motions), orientation_of(joint.to, motions)).space;
    }
    add(block);
    if (!joint.type.twists()) continue;
    Block turn = block;
    turn.angular = true;
    turn.space =
        misfit_of_turn(joint, orientation_of(joint.body, motions), orientation_of(joint.to, motions)).space;
    add(turn);
    if (!joint.type.couples) continue;
    const Vector3 axis = orientation_of(joint.to, motions) * joint.to_axis;
    block.space = axis * axis.transpose(), block.pitch = joint.pitch;
    add(block);
  }
  for (std::size_t i = 0; i < model_.forces.coordinate_laws.size(); ++i) {
    const CoordinateLaw& law = model_.forces.coordinate_laws[i];
    if (law.friction == 0 && !law.is_limited() && !law.held) continue;
    const auto add_along = [&](Block block) {
      if ((block.kind != Block::Kind::soft || law.armature != 0) && next < old.size())
        block.past = old[next].past;
      block.impulse = next < old.size() ? Vector3(block.normal.dot(old[next++].impulse) * block.normal)
                                        : Vector3(Vector3::Zero());
      blocks.push_back(block);
    };
    Block block = block_along(law, model_.bodies, motions);
    block.law = static_cast<int>(i);
    if (law.held) {
      block.kind = Block::Kind::soft;
      add_along(block);
    }
    if (law.friction != 0) {
      block.kind = Block::Kind::rub, block.friction = block.gearing * law.friction;
      add_along(block);
    }
    block.kind = Block::Kind::stop, block.friction = 0, block.restitution = law.restitution;
    if (law.has_lower()) add_along(block);
    block.upper = true, block.normal = -block.normal;
    if (law.has_upper()) add_along(block);
  }
}

void BodyContacts::find(const std::vector<Motion>& motions, const std::vector<Mover>& movers,
                        const Vector3& common, Time now, Time span, std::vector<Block>& blocks) {
  now_ = now;
  const Real h = static_cast<Real>(span), fall = gravity_ * h * h;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Vector3 v = movers[i].v - common;
    travel_[i] = {h * v, h * movers[i].w, fall};
    margin_[i] = (v.norm() + radius_[i] * movers[i].w.norm()) * h + fall + radius_[i] / 256;
  }
  std::swap(blocks, old_), std::swap(found_, old_found_);
  blocks.clear(), found_.clear();
  next_ = next_found_ = 0;
  find_pairs(motions);
  for (const auto& [a, b] : pairs_)
    if (movers[index(a)].inverse_mass > 0 || movers[index(b)].inverse_mass > 0 ||
        !movers[index(a)].inverse_inertia.isZero(0) || !movers[index(b)].inverse_inertia.isZero(0))
      touch(motions, a, b, -1, margin_[index(a)] + margin_[index(b)], blocks);
  for (int i = 0; i < static_cast<int>(motions.size()); ++i) {
    if (model_.surfaces[index(i)] == no_surface || model_.bodies[index(i)].locked) continue;
    for (int k = 0; k < static_cast<int>(model_.planes.size()); ++k) {
      const Plane& plane = model_.planes[index(k)];
      if (model_.plane_surfaces[index(k)] == no_surface || !model_.may_touch_plane(i, k)) continue;
      if (plane.normal.dot(motions[index(i)].position) - plane.offset > radius_[index(i)] + margin_[index(i)])
        continue;
      touch(motions, i, fixed_world, k, margin_[index(i)], blocks);
    }
  }
  add_joints(motions, old_, blocks);
}

}  // namespace cylon::engine::pile
