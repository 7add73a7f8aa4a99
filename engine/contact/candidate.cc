#include "engine/contact/candidate.h"

#include "engine/geometry/core.h"
#include "engine/geometry/hull.h"
#include "engine/geometry/manifold.h"

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace cylon::engine {

namespace {

using Balls = std::vector<std::pair<Vector3, Real>>;

// Balls whose hull is the shape: what can touch a plane.
Balls corners(const Shape& shape);

// Of points the corners of their hull; where a part is rounded all that its parts have.
Balls corners(const Compound& compound) {
  Balls balls;
  for (const ShapePart& part : compound.parts)
    for (const auto& [centre, radius] : corners(part.shape))
      balls.emplace_back(part.position + part.rotation * centre, radius);
  if (std::any_of(balls.begin(), balls.end(), [](const auto& ball) { return ball.second > 0; })) return balls;
  std::vector<Vector3> points;
  for (const auto& ball : balls) points.push_back(ball.first);
  try {
    points = make_hull(points).vertices;
  } catch (const std::invalid_argument&) {  // in a plane
    return balls;
  }
  balls.clear();
  for (const Vector3& point : points) balls.emplace_back(point, 0);
  return balls;
}

Balls corners(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape)) return corners(*compound);
  Balls result;
  if (const auto box = rounded_box(shape)) {
    const auto ends = [&](int axis) {
      const Real half = box->half_extents[axis];
      return half > 0 ? std::vector{-half, half} : std::vector{Real(0)};
    };
    for (const Real x : ends(0))
      for (const Real y : ends(1))
        for (const Real z : ends(2)) result.emplace_back(Vector3(x, y, z), box->radius);
    return result;
  }
  const Core core(shape);
  for (int i = 0; i < core.vertex_count; ++i) result.emplace_back(core.vertices[i], core.radius);
  return result;
}

bool is_sphere(const Shape& s) { return std::holds_alternative<Sphere>(s); }

// The point of a box nearest to x, body axes, which axes it is free to slide along, and the radius around it.
struct Foot {
  Vector3 point;
  Vector3 free;  // 1 along a free axis, else 0
  Real radius;
};

Foot foot_of(const RoundedBox& box, const Vector3& x) {
  Foot foot{Vector3::Zero(), Vector3::Zero(), box.radius};
  const Vector3& half = box.half_extents;
  for (Eigen::Index i = 0; i < 3; ++i) {
    foot.point[i] = std::clamp(x[i], -half[i], half[i]);
    foot.free[i] = std::abs(x[i]) < half[i] ? Real(1) : Real(0);
  }
  return foot;
}

TouchPoint corner_touch(const Candidate& c, const Model& model, const Motion* motion) {
  const Plane& plane = model.planes[index(c.plane)];
  const Motion& m = motion[index(c.body)];
  const Body& body = model.bodies[index(c.body)];
  TouchPoint touch;
  const Vector3 arm = m.orientation.toRotationMatrix() * c.centre;
  const Vector3 w = spin_of(body, m);
  touch.normal = plane.normal;
  touch.gap = plane.normal.dot(m.position + arm) - plane.offset - c.radius;
  touch.position = m.position + arm - (c.radius + touch.gap / 2) * plane.normal;
  touch.path = velocity(body, m) + w.cross(arm);
  touch.curvature = plane.normal.dot(w.cross(w.cross(arm)));
  return touch;
}

TouchPoint round_touch(const Candidate& c, const Model& model, const Motion* motion) {
  const Motion &a = motion[index(c.body)], &b = motion[index(c.other)];
  const Body &body = model.bodies[index(c.body)], &other = model.bodies[index(c.other)];
  const Matrix3 rotation = b.orientation.toRotationMatrix();
  const Foot foot =
      foot_of(*rounded_box(model.shapes[index(c.other)]), rotation.transpose() * (a.position - b.position));
  const Vector3 arm = rotation * foot.point;
  const Vector3 d = a.position - b.position - arm;
  const Real s = d.norm();
  const Vector3 w = spin_of(other, b);
  TouchPoint touch;
  touch.normal = s > 0 ? Vector3(d / s) : Vector3(Vector3::UnitY());
  touch.gap = s - c.radius - foot.radius;
  touch.position = a.position - (c.radius + touch.gap / 2) * touch.normal;
  const Vector3 v = velocity(body, a) - velocity(other, b) - w.cross(arm);
  // n' = W x n + what the nearest point's freedom leaves of v across n, over s
  const Vector3 seen = rotation.transpose() * (v - w.cross(d));  // of a's centre, from b that turns
  Vector3 across = rotation * (Vector3::Ones() - foot.free).cwiseProduct(seen);
  across -= touch.normal.dot(across) * touch.normal;
  touch.turning = w.cross(touch.normal);
  if (s > 0) touch.turning += across / s;
  touch.path = velocity(body, a) - c.radius * touch.turning;
  touch.curvature =
      -touch.normal.dot(w.cross(w.cross(arm))) + 2 * touch.turning.dot(v) - s * touch.turning.squaredNorm();
  return touch;
}

// A coordinate at a limit, g = q - lower or upper - q, or with dry friction.
TouchPoint joint_touch(const Candidate& c, const Model& model, const Motion* motion) {
  const CoordinateLaw& law = model.forces.coordinate_laws[index(c.law)];
  TouchPoint touch;
  touch.normal = Vector3::UnitX();
  touch.row = row_of(law.at, model.bodies, motion);
  if (c.kind == Candidate::Kind::dry) {
    touch.axis = 1;
    touch.bound = law.friction;
    return touch;
  }
  touch.restitution = law.restitution;
  touch.gap = touch.row->offset - law.lower;
  if (c.kind == Candidate::Kind::lower) return touch;
  touch.gap = law.upper - touch.row->offset;
  Row& row = *touch.row;
  row.direction = -row.direction, row.lever = -row.lever, row.to_lever = -row.to_lever, row.bias = -row.bias;
  return touch;
}

void add_joints(const Model& model, int pair, std::vector<Candidate>& candidates) {
  for (std::size_t k = 0; k < model.forces.coordinate_laws.size(); ++k) {
    const CoordinateLaw& law = model.forces.coordinate_laws[k];
    const auto add = [&](Candidate::Kind kind) {
      Candidate c;
      c.kind = kind;
      c.body = law.at.body, c.other = law.at.to;
      c.law = static_cast<int>(k);
      c.pair = pair++;
      c.material = {law.restitution, kind == Candidate::Kind::dry ? law.friction : 0};
      candidates.push_back(c);
    };
    if (law.has_lower()) add(Candidate::Kind::lower);
    if (law.has_upper()) add(Candidate::Kind::upper);
    if (law.friction > 0) add(Candidate::Kind::dry);
  }
}

}  // namespace

std::vector<Candidate> find_candidates(const Model& model, const std::vector<std::size_t>& given) {
  std::vector<Candidate> result;
  std::vector<std::size_t> bodies(model.bodies.size());  // in the order of the list
  std::vector<char> locked;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[given.empty() ? i : given[i]] = i;
  for (const std::size_t i : bodies) locked.push_back(model.bodies[i].locked);
  const auto touchable = [&](std::size_t i) {
    return i < model.surfaces.size() && model.surfaces[i] != no_surface &&
           !std::holds_alternative<std::monostate>(model.shapes[i]);
  };
  int pair = 0;
  for (std::size_t m = 0; m < bodies.size(); ++m) {
    const std::size_t i = bodies[m];
    if (!touchable(i)) continue;
    for (std::size_t p = 0; p < model.planes.size() && !model.bodies[i].locked; ++p) {
      if (!model.may_touch_plane(static_cast<int>(i), static_cast<int>(p))) continue;
      for (const auto& [centre, radius] : corners(model.shapes[i])) {
        Candidate c;
        c.body = static_cast<int>(i);
        c.plane = static_cast<int>(p);
        c.pair = pair;
        c.centre = centre;
        c.radius = radius;
        c.reach = bounding_radius(model.shapes[i]);
        c.material = model.material(model.surfaces[i], model.plane_surfaces[p]);
        result.push_back(c);
      }
      ++pair;
    }
    for (std::size_t k = m + 1; k < bodies.size(); ++k) {
      if (locked[m] && locked[k]) continue;
      const std::size_t j = bodies[k];
      if (!touchable(j) || !model.may_touch(static_cast<int>(i), static_cast<int>(j))) continue;
      Candidate c;
      const bool swap = !is_sphere(model.shapes[i]) && is_sphere(model.shapes[j]);
      const std::size_t a = swap ? j : i, b = swap ? i : j;
      c.kind = is_sphere(model.shapes[a]) && rounded_box(model.shapes[b]) ? Candidate::Kind::round
                                                                          : Candidate::Kind::general;
      c.body = static_cast<int>(a);
      c.other = static_cast<int>(b);
      c.pair = pair++;
      if (c.kind == Candidate::Kind::round) c.radius = std::get<Sphere>(model.shapes[a]).radius;
      c.reach = bounding_radius(model.shapes[a]);
      c.other_reach = bounding_radius(model.shapes[b]);
      c.material = model.material(model.surfaces[a], model.surfaces[b]);
      result.push_back(c);
    }
  }
  add_joints(model, pair, result);
  return result;
}

TouchPoint touch_at(const Candidate& c, const Model& model, const Motion* motion) {
  TouchPoint touch = is_of_joint(c)                      ? joint_touch(c, model, motion)
                     : c.kind == Candidate::Kind::corner ? corner_touch(c, model, motion)
                                                         : round_touch(c, model, motion);
  touch.body = c.body;
  touch.other = c.other;
  touch.pair = c.pair;
  if (is_of_joint(c)) return touch;
  touch.restitution = c.material.restitution;
  touch.friction = c.material.friction;
  return touch;
}

Real gap_of(const Candidate& c, const Model& model, const Motion* motion) {
  if (c.kind != Candidate::Kind::general) return touch_at(c, model, motion).gap;
  return separation(model.shapes[index(c.body)], pose(motion[index(c.body)]), model.shapes[index(c.other)],
                    pose(motion[index(c.other)]))
      .gap;
}

Real core_radius(const Shape& shape) {
  const auto box = rounded_box(shape);
  return box ? box->radius : Core(shape).radius;
}

bool touches_of(const Candidate& c, const Model& model, const Motion* motion, Real margin,
                std::vector<TouchPoint>& touches) {
  const Motion &a = motion[index(c.body)], &b = motion[index(c.other)];
  const Manifold found =
      manifold(model.shapes[index(c.body)], pose(a), model.shapes[index(c.other)], pose(b), margin);
  const Vector3 w = spin_of(model.bodies[index(c.other)], b);
  for (int i = 0; i < found.count; ++i) {
    const ContactPoint& point = found.points[static_cast<std::size_t>(i)];
    TouchPoint touch;
    touch.body = c.body;
    touch.other = c.other;
    touch.pair = c.pair;
    touch.restitution = c.material.restitution;
    touch.friction = c.material.friction;
    touch.position = point.position;
    touch.normal = found.normal;
    touch.gap = point.gap;
    touch.turning = w.cross(found.normal);  // as a face of `other` under a point of `body`
    touch.path = matter_velocity(model.bodies[index(c.body)], a, point.position);
    touches.push_back(touch);
  }
  return found.thinned;
}

Real gap_scale(const Candidate& c, const Model& model, const Motion* motion) {
  if (is_of_joint(c)) {
    const Row row = row_of(model.forces.coordinate_laws[index(c.law)].at, model.bodies, motion);
    return std::abs(row.offset) + row.rounding / (4 * epsilon);
  }
  Real scale = motion[index(c.body)].position.norm() + c.reach;
  if (c.other != fixed_world) return scale + motion[index(c.other)].position.norm() + c.other_reach;
  return scale + std::abs(model.planes[index(c.plane)].offset);
}

}  // namespace cylon::engine
