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

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr const char* precision = sizeof(Real) == 4 ? "single precision" : "double precision";

std::size_t index(int i) { return static_cast<std::size_t>(i); }

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
Real largest_coordinate(const Vector3& p) { return p.cwiseAbs().maxCoeff(); }

// A length [m] and how far out [m] it is to be told; a length of 0 says nothing.
std::string lost(const std::string& who, Real far, const char* what, Real length) {
  const Real unit = unit_in_last_place(far);
  if (!(length > 0) || !(unit > coarsest_place * length)) return "";
  return who +
         text(" is %.6g m from the origin, where one ulp of %s is %.3g m: more than 1/%.0f of %s, %.6g m",
              static_cast<double>(far), precision, static_cast<double>(unit),
              1 / static_cast<double>(coarsest_place), what, static_cast<double>(length));
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
                    std::max({j.length, j.anchor.norm(), other}));
    }
    return reason;
  }

 private:
  std::string touching() const {
    Real least = std::numeric_limits<Real>::infinity();
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      if (model_.surfaces[i] == no_surface) continue;
      const Real half = half_width(model_.shapes[i]);
      if (half > 0 && !model_.bodies[i].locked) least = std::min(least, half);
      const Real far = largest_coordinate(model_.motions[i].position);
      const std::string reason = lost(names_(Thing::body, static_cast<int>(i)), far, "its half-width", half);
      if (!reason.empty()) return reason;
    }
    if (std::isinf(least)) return "";
    for (std::size_t i = 0; i < model_.planes.size(); ++i) {
      const std::string reason =
          lost(names_(Thing::plane, static_cast<int>(i)), std::abs(model_.planes[i].offset),
               "the smallest half-width of a body that may touch it", least);
      if (!reason.empty()) return reason;
    }
    return "";
  }

  std::string link(const char* kind, int body, const Vector3& from, const Vector3& to, Real length) const {
    const Real far = std::max(largest_coordinate(from), largest_coordinate(to));
    return lost(std::string(kind) + " of " + names_(Thing::body, body), far, "its length", length);
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
  if (!(epsilon * ratio > coarsest_mass)) return "";
  return names(Thing::body, heavy) + text(" weighs %.3g times as much as ", static_cast<double>(ratio)) +
         names(Thing::body, light) +
         text(
             ", which may carry it; above a ratio of %.4g, %s loses too many digits of the heavier mass in "
             "the sum of the reciprocal masses",
             static_cast<double>(coarsest_mass / epsilon), precision);
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
  const bool presses =
      !model.forces.only_gravity() || !model.forces.gravity.isZero(0) || !model.joints.empty();
  const bool by_events = path == Path::events || path == Path::ballistic;
  if (reason.empty() && by_events && presses) reason = touching_masses(model, names);
  // A pile's impulses go from body to body, by the mass of each alone: the ratio is in no sum.
  if (reason.empty() && path != Path::stepping) reason = jointed_masses(model, names);
  return reason;
}

}  // namespace cylon::engine
