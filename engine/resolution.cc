#include "engine/resolution.h"

#include "engine/geometry/pose.h"
#include "engine/plan.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <vector>

namespace cylon::engine {

namespace {

constexpr const char* precision = sizeof(Real) == 4 ? "single precision" : "double precision";

[[gnu::format(printf, 1, 2)]] std::string text(const char* format, ...) {
  char buffer[400];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(buffer, sizeof buffer, format, values);
  va_end(values);
  return buffer;
}

// From |x| to the next number.
Real unit_in_last_place(Real x) {
  return std::nextafter(std::abs(x), std::numeric_limits<Real>::infinity()) - std::abs(x);
}
Vector3 units(const Vector3& p) { return p.unaryExpr(&unit_in_last_place); }
Real largest_coordinate(const Vector3& p) { return p.cwiseAbs().maxCoeff(); }

// Who is so far out [m] that a length [m] is known to `error` [m]; a length of 0 says nothing.
std::string lost(const std::string& who, Real far, Real error, const char* what, Real length) {
  if (!(length > 0) || !(error > largest_error * length)) return "";
  return who + text(
                   " is %.6g m from the origin, where %s knows distances to %.3g m: more than a tenth of %s, "
                   "%.6g m",
                   static_cast<double>(far), precision, static_cast<double>(error), what,
                   static_cast<double>(length));
}

class Places {
 public:
  Places(const Model& model, const Names& names) : model_(model), names_(names) {}

  std::string coarse() const {
    std::string reason = can_touch(model_) ? touching() : "";
    each_force(model_.forces, [&](const auto& force) {
      const std::optional<Ends> ends = force.ends();
      if (!ends || !reason.empty()) return;
      const Vector3 from = point(ends->body, ends->anchor), to = point(ends->to, ends->to_anchor);
      reason = link(force.one, ends->body, from, to, std::max(ends->rest_length, (to - from).norm()));
    });
    for (const Joint& j : model_.joints) {
      if (!reason.empty()) return reason;
      const Real other = j.to == fixed_world ? 0 : j.to_anchor.norm();
      reason = link("a joint", j.body, point(j.body, Vector3::Zero()), point(j.to, j.to_anchor),
                    std::max({j.length, j.anchor.norm(), other, spread(j.body), spread(j.to)}));
    }
    return reason;
  }

 private:
  std::string touching() const {
    const auto touches = [&](std::size_t i) { return model_.surfaces[i] != no_surface; };
    std::size_t several = 0;
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) several += touches(i);
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      if (!touches(i)) continue;
      std::string reason = several > 1 ? beside_bodies(i) : "";
      if (reason.empty() && !model_.bodies[i].locked) reason = beside_planes(i);
      if (!reason.empty()) return reason;
    }
    return "";
  }

  std::string of_body(std::size_t i, Real error) const {
    return lost(names_(Thing::body, static_cast<int>(i)), largest_coordinate(model_.motions[i].position),
                error, "its half-width", half_width(model_.shapes[i]));
  }

  std::string beside_bodies(std::size_t i) const {
    return of_body(i, units(model_.motions[i].position).norm());
  }

  std::string beside_planes(std::size_t i) const {
    const Vector3 unit = units(model_.motions[i].position);
    for (std::size_t k = 0; k < model_.planes.size(); ++k) {
      const Plane& plane = model_.planes[k];
      const Real place = plane.normal.cwiseAbs().dot(unit) / 2, offset = unit_in_last_place(plane.offset) / 2;
      const std::string reason =
          place >= offset
              ? of_body(i, place + offset)
              : lost(names_(Thing::plane, static_cast<int>(k)), std::abs(plane.offset), place + offset,
                     "the half-width of a body that may touch it", half_width(model_.shapes[i]));
      if (!reason.empty()) return reason;
    }
    return "";
  }

  std::string link(const char* kind, int body, const Vector3& from, const Vector3& to, Real length) const {
    const Real far = std::max(largest_coordinate(from), largest_coordinate(to));
    return lost(std::string(kind) + " of " + names_(Thing::body, body), far,
                (units(from) + units(to)).norm() / 2, "its length", length);
  }

  // sqrt(sum of m r^2 / m): how far the mass of a body that turns is from its centre.
  Real spread(int body) const {
    if (body == fixed_world || model_.bodies[index(body)].locked) return 0;
    const Body& b = model_.bodies[index(body)];
    return b.mass > 0 ? std::sqrt(b.inertia.trace() / (2 * b.mass)) : Real(0);
  }

  Vector3 point(int body, const Vector3& anchor) const {
    if (body == fixed_world) return anchor;
    const Motion& m = model_.motions[index(body)];
    return m.position + m.orientation * anchor;
  }

  const Model& model_;
  const Names& names_;
};

std::string outweighed(const Model& model, int light, int heavy, const Names& names) {
  const Real ratio = model.bodies[index(heavy)].mass / model.bodies[index(light)].mass;
  if (!(epsilon / 2 * ratio > largest_error)) return "";
  return names(Thing::body, heavy) + text(" weighs %.3g times as much as ", static_cast<double>(ratio)) +
         names(Thing::body, light) +
         text(
             ", which may carry it; above a ratio of %.4g, %s knows the heavier one's part of the sum of the "
             "reciprocal masses to no better than a tenth",
             static_cast<double>(2 * largest_error / epsilon), precision);
}

// The lightest and the heaviest of the moving bodies that may touch.
std::string touching_masses(const Model& model, const Names& names) {
  int light = -1, heavy = -1;
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
    const Body& body = model.bodies[index(i)];
    if (body.locked || model.surfaces[index(i)] == no_surface) continue;
    if (light < 0 || body.mass < model.bodies[index(light)].mass) light = i;
    if (heavy < 0 || body.mass > model.bodies[index(heavy)].mass) heavy = i;
  }
  return light < 0 ? "" : outweighed(model, light, heavy, names);
}

std::string jointed_masses(const Model& model, const Names& names) {
  std::vector<int> joints(model.bodies.size(), 0);
  const auto each_end = [&](const Joint& j, auto use) {
    use(j.body, j.to);
    if (j.to != fixed_world) use(j.to, j.body);
  };
  for (const Joint& j : model.joints) each_end(j, [&](int end, int) { ++joints[index(end)]; });
  for (const Joint& j : model.joints) {
    std::string reason;
    each_end(j, [&](int light, int heavy) {
      const bool both_move =
          heavy != fixed_world && !model.bodies[index(light)].locked && !model.bodies[index(heavy)].locked;
      if (reason.empty() && both_move && joints[index(light)] > 1)
        reason = outweighed(model, light, heavy, names);
    });
    if (!reason.empty()) return reason;
  }
  return "";
}

}  // namespace

std::string numbered(Thing thing, int index) {
  return (thing == Thing::body ? "body " : "plane ") + std::to_string(index);
}

std::string unresolved(const Model& model, Path path, const Names& names) {
  std::string reason = Places(model, names).coarse();
  const bool presses = !model.forces.only_gravity() || model.strongest_gravity() > 0 || !model.joints.empty();
  const bool by_events = path == Path::events || path == Path::ballistic;
  if (reason.empty() && by_events && presses && can_touch(model)) reason = touching_masses(model, names);
  // A pile's impulses go from body to body, by the mass of each alone: the ratio is in no sum.
  if (reason.empty() && path != Path::stepping) reason = jointed_masses(model, names);
  return reason;
}

}  // namespace cylon::engine
