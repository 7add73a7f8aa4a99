#include "engine/pile/sphere_pile.h"

#include "engine/pile/islands.h"
#include "engine/pile/sphere_alone.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace cylon::engine::pile {
namespace {

constexpr int steps_between_orders = 32, most_parts = 16;

int blocks_of(const Model& model) {
  return static_cast<int>(model.bodies.size()) / SphereContacts::block_size + 1;
}

}  // namespace

SpherePile::SpherePile(const Model& model, Time dt, const PileSettings& settings, std::int64_t first)
    : model_(model),
      dt_(dt),
      settings_(settings),
      threads_(settings.threads),
      spheres_(model, blocks_of(model)),
      found_(model_, threads_),
      impacts_found_(model, settings.substeps),
      first_(first),
      steps_(first),
      alone_(isolated(model)),
      gravity_(pressing_gravity(model)) {
  for (int i = 0; i < spheres_.count; ++i) {
    const Real r = spheres_.p(i)[3];
    if (r > 0) smallest_ = smallest_ > 0 ? std::min(smallest_, r) : r;
    largest_ = std::max(largest_, r);
  }
  set_kick();
}

// Sweeps are measured in the last of so many steps, and after the last of all: in every step that would cost a tenth of it.
std::vector<Diagnostic> SpherePile::diagnostics() const {
  DiagnosticLog log = log_;
  if ((steps_ - first_) % steps_between_orders != 0) note_sweep(log);
  return log.all();
}

// Of the step before now.
void SpherePile::note_sweep(DiagnosticLog& log) const {
  Real fastest = 0;
  for (int i = 0; i < spheres_.count; ++i)
    for (int c = 0; c < 3; ++c) fastest = std::max(fastest, std::abs(spheres_.v(i)[c]));
  fastest += gravity_ * static_cast<Real>(dt_);
  if (const Real off = unmet(); off > 1024 * epsilon * fastest)
    log.note(DiagnosticKind::contacts_swept, static_cast<Time>(steps_ - 1) * dt_, settings_.substeps,
             static_cast<double>(off));
}

// Impacts that share a body and an instant, though they should have been resolved at once.
void SpherePile::note_order() {
  if (model_.impacts != Impacts::simultaneous) return;
  for (std::size_t i = 0; i < impacts_.size(); ++i)
    for (std::size_t k = i + 1; k < impacts_.size() && impacts_[k].time - impacts_[i].time < 1e-9 * dt_;
         ++k) {
      const auto in_first = [&](int body) {
        return body != fixed_world && (body == impacts_[i].body || body == impacts_[i].other);
      };
      if (in_first(impacts_[k].body) || in_first(impacts_[k].other))
        return log_.note(DiagnosticKind::solved_in_turn, impacts_[k].time);
    }
}

// What still meets within the part, faster than gravity makes it: pairs with restitution have been parted.  The first is told.
void SpherePile::note_blows(Time now, Time span) {
  if (alone_ || spheres_.count <= SphereContacts::most_that_pass_on || log_.has(DiagnosticKind::blows_swept))
    return;
  const Real h = static_cast<Real>(span), slow = 2 * gravity_ * h;
  bool any = false;
  const auto row = [](const Real* x) { return Vector3(x[0], x[1], x[2]); };
  found_.each([&](const auto& batch) {
    for (int lane = 0; lane < lane_count; ++lane) {
      const int a = batch.a[lane], b = batch.b[lane];
      if (any || a >= spheres_.count) continue;
      const Vector3 n(batch.normal.x[lane], batch.normal.y[lane], batch.normal.z[lane]);
      Real speed = n.dot(row(spheres_.v(a))), gap = n.dot(row(spheres_.p(a))) - spheres_.p(a)[3];
      if constexpr (std::remove_cvref_t<decltype(batch)>::plane) {
        gap -= batch.offset[lane];
      } else {
        speed -= n.dot(row(spheres_.v(b)));
        gap -= n.dot(row(spheres_.p(b))) + spheres_.p(b)[3];
      }
      any = speed < -slow && gap + speed * h < 0;
    }
  });
  if (any) log_.note(DiagnosticKind::blows_swept, now, SphereContacts::most_that_pass_on);
}

void SpherePile::order_bodies() {
  const std::vector<int> order = order_in_space(spheres_, largest_ > 0 ? 2 * largest_ : 1);
  spheres_.reorder(order);
  std::vector<int> position(order.size());
  for (std::size_t k = 0; k < order.size(); ++k)
    position[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
  found_.reorder(position);
}

// g for what can move.
void SpherePile::set_kick() {
  for (int i = 0; i < spheres_.count; ++i)
    for (int c = 0; c < 3; ++c)
      spheres_.kick[static_cast<std::size_t>(velocity_stride * i + c)] =
          spheres_.v(i)[3] > 0
              ? model_.gravity_of(static_cast<std::size_t>(spheres_.id[static_cast<std::size_t>(i)]))[c]
              : 0;
}

// As of all bodies (BodyPile): of an isolated model.
Vector3 SpherePile::common_velocity() const {
  Vector3 momentum = Vector3::Zero();
  if (!alone_) return momentum;
  Real mass = 0;
  for (int i = 0; i < spheres_.count; ++i) {
    const Real* v = spheres_.v(i);
    momentum += Vector3(v[0], v[1], v[2]) / v[3], mass += 1 / v[3];
  }
  return momentum / mass;
}

// So many that no body moves farther than half the smallest radius in a part.
int SpherePile::parts_of_step() const {
  const Vector3 common = common_velocity();
  Real fastest = 0;
  for (int i = 0; i < spheres_.count; ++i) {
    const Real* v = spheres_.v(i);
    fastest = std::max(fastest, (Vector3(v[0], v[1], v[2]) - common).squaredNorm());
  }
  if (smallest_ == 0) return 1;
  const Real parts = std::ceil(2 * std::sqrt(fastest) * static_cast<Real>(dt_) / smallest_);
  return static_cast<int>(std::min(std::max(parts, Real(1)), Real(most_parts + 1)));
}

void SpherePile::step() {
  if ((steps_ - first_) % steps_between_orders == 0) order_bodies();
  impacts_.clear(), contacts_.clear();
  int parts = parts_of_step();
  if (parts > most_parts) {
    parts = most_parts;
    log_.note(DiagnosticKind::too_fast, static_cast<Time>(steps_) * dt_, most_parts);
  }
  for (int k = 0; k < parts; ++k)
    advance_part(static_cast<Time>(steps_) * dt_ + k * dt_ / parts, dt_ / parts);
  std::stable_sort(impacts_.begin(), impacts_.end(),
                   [](const Impact& a, const Impact& b) { return a.time < b.time; });
  note_order();
  ++steps_;
  if ((steps_ - first_) % steps_between_orders == 0) note_sweep(log_);
}

void SpherePile::advance_part(Time now, Time span) {
  const int n = settings_.substeps;
  const Time h = span / n;
  part_ = h;
  found_.find(spheres_, span, gravity_);
  work_ += n * static_cast<std::int64_t>(static_cast<std::size_t>(spheres_.count) + found_.rows());
  if (!impacts_found_.resolve(found_.approaching(), spheres_, now, span, impacts_,
                              keep_ ? &contacts_ : nullptr))
    log_.note(DiagnosticKind::approaching, now, most_impact_sweeps);
  note_blows(now, span);
  if (alone_) {
    advance_alone(span);  // impacts alone: nothing rests on anything
    turn(span);
    return;
  }

  Real* const velocity = spheres_.velocity.data();
  Real* const before = spheres_.before.data();
  Real* const place = spheres_.place.data();
  const Real* const kick = spheres_.kick.data();
  const std::size_t numbers = static_cast<std::size_t>(velocity_stride * spheres_.count);
  const Lanes inverse_h = spread(static_cast<Real>(1 / h));
  const Real hr = static_cast<Real>(h);

  set_smooth(hr);
  std::copy_n(velocity, spheres_.velocity.size(), before);
  for (std::size_t k = 0; k < numbers; ++k) velocity[k] += hr * kick[k];
  found_.sweep([&](const auto& batch) { warm_start(batch, velocity); });
  if (keep_) pressed_.assign(found_.rows(), {});
  for (int part = 0; part < n; ++part) {
    found_.sweep([&](auto& batch) { solve(batch, velocity, place, inverse_h); });
    if (keep_) add_pressed();
    drift(hr, part + 1 < n);
  }
  const Lanes share = spread(settings_.relaxation), slop = spread(settings_.slop * smallest_);
  found_.sweep([&](auto& batch) { separate(batch, velocity, place, share, slop); });
  found_.remember();
  turn(span);
  if (keep_) note_pressed();
}

// By how much another sweep would change a velocity at a contact at most [m/s], with the bodies where they are now.
// Alone nothing rests on anything: impulses begin at none in each part, and there is no law that lasts.
Real SpherePile::unmet() const {
  Real worst = 0;
  if (alone_ || steps_ == first_) return worst;
  const Lanes inverse_h = spread(static_cast<Real>(1 / part_));
  found_.each([&](const auto& batch) {
    const Lanes off = pile::unmet(batch, spheres_.velocity.data(), spheres_.place.data(), inverse_h);
    for (int lane = 0; lane < lane_count; ++lane)
      if (batch.a[lane] < spheres_.count) worst = std::max(worst, off[lane]);
  });
  return worst;
}

bool SpherePile::presses() const {
  bool any = false;
  found_.each([&](const auto& batch) {
    for (int lane = 0; lane < lane_count; ++lane)
      any = any || (batch.a[lane] < spheres_.count && batch.impulse[lane] > 0);
  });
  return any;
}

// The impulses of one part of the step.
void SpherePile::add_pressed() {
  found_.each([&](const auto& batch) {
    for (int lane = 0; lane < lane_count; ++lane) {
      Pressed& row = pressed_[static_cast<std::size_t>(batch.pair[lane])];
      row.normal += batch.impulse[lane];
      row.friction += Vector3(batch.tangential.x[lane], batch.tangential.y[lane], batch.tangential.z[lane]);
    }
  });
}

// Bodies where they are by now, normals as they were found.
void SpherePile::note_pressed() {
  found_.each([&](const auto& batch) {
    for (int lane = 0; lane < lane_count; ++lane) {
      const Pressed& row = pressed_[static_cast<std::size_t>(batch.pair[lane])];
      const int a = batch.a[lane], b = batch.b[lane];
      if (a >= spheres_.count || !(row.normal > 0)) continue;
      const Vector3 n(batch.normal.x[lane], batch.normal.y[lane], batch.normal.z[lane]);
      const Real* p = spheres_.p(a);
      const auto id = [&](int i) { return spheres_.id[static_cast<std::size_t>(i)]; };
      Contact contact{id(a), fixed_world, -1,          Vector3(p[0], p[1], p[2]) - p[3] * n,
                      n,     row.normal,  row.friction};
      if (batch.plane)
        contact.plane = b;
      else
        contact.other = id(b);
      contacts_.push_back(contact);
    }
  });
}

// Each part begins without impulses: those of the part before belong to where the bodies were, and nothing
// rests on anything here.  Half of what gravity does in a part comes before the bodies move, so that free fall is exact.
void SpherePile::advance_alone(Time span) {
  const int n = settings_.substeps;
  const Real h = static_cast<Real>(span / n);
  Real* const velocity = spheres_.velocity.data();
  Real* const place = spheres_.place.data();
  const Lanes inverse_h = spread(1 / h);
  const auto kick = [&] {
    for (std::size_t k = 0; k < spheres_.velocity.size(); ++k) velocity[k] += h / 2 * spheres_.kick[k];
  };
  for (int part = 0; part < n; ++part) {
    kick();
    found_.sweep([&](const auto& batch) { solve_alone(batch, velocity, place, inverse_h); });
    drift_alone(h);
    kick();
  }
  const Lanes share = spread(settings_.relaxation), slop = spread(settings_.slop * smallest_);
  found_.sweep([&](const auto& batch) { separate_alone(batch, velocity, place, share, slop); });
}

// p += h v
void SpherePile::drift_alone(Real h) {
  for (int i = 0; i < spheres_.count; ++i)
    for (int c = 0; c < 3; ++c)
      spheres_.place[static_cast<std::size_t>(place_stride * i + c)] += h * spheres_.v(i)[c];
}

// Of spheres that are near one plane: its normal, and what their velocity changes by in a part of length h, at
// most, where gravity and that plane alone change it.
void SpherePile::set_smooth(Real h) {
  const auto at = [&](int i) -> Smooth& { return smooth_[static_cast<std::size_t>(i)]; };
  smooth_.assign(static_cast<std::size_t>(spheres_.count), Smooth{Row{}, Real(1.5) * gravity_ * h});
  found_.each([&](const auto& batch) {
    for (int lane = 0; lane < lane_count; ++lane) {
      if (batch.a[lane] >= spheres_.count) continue;
      Smooth& a = at(batch.a[lane]);
      const bool first = a.normal[0] == 0 && a.normal[1] == 0 && a.normal[2] == 0;
      if (!batch.plane || !first) a.most = 0;
      if (!batch.plane) at(batch.b[lane]).most = 0;
      a.normal = Row{batch.normal.x[lane], batch.normal.y[lane], batch.normal.z[lane], 0};
    }
  });
}

// p += h (v_before + v)/2 of a sphere that nothing presses on, and along the plane on which it slides or rolls: its
// acceleration is constant, and its path of second order.  Else p += h v, which is what contacts are solved for.  Then, for the
// next part, the forces and this part's impulses again: v += v - v_before.
void SpherePile::drift(Real h, bool again) {
  auto* const place = reinterpret_cast<Row*>(spheres_.place.data());
  auto* const velocity = reinterpret_cast<Row*>(spheres_.velocity.data());
  auto* const before = reinterpret_cast<Row*>(spheres_.before.data());
  const auto* const kick = reinterpret_cast<const Row*>(spheres_.kick.data());
  const Row hs = {h, h, h, 0};
  const auto count = static_cast<std::size_t>(spheres_.count);
  const auto squared = [](const Row& x) {
    const Row y = x * x;
    return y[0] + y[1] + y[2];
  };
  constexpr Real same = 16 * epsilon;
  for (std::size_t i = 0; i < count; ++i) {
    const Row now = velocity[2 * i], then = before[2 * i], change = now - then;
    Row smooth = change;
    if (squared(change - hs * kick[2 * i]) > same * same * (squared(now) + squared(then))) {
      const auto& [normal, most] = smooth_[i];
      smooth = change <= most && change >= -most ? change : Row{};
      const Row along = smooth * normal;
      smooth -= (along[0] + along[1] + along[2]) * normal;
    }
    place[i] += hs * (now - smooth / 2);
  }
  if (!again) return;
  for (std::size_t k = 0; k < 2 * count; ++k) {
    const Row now = velocity[k];
    velocity[k] = now + (now - before[k]);
    before[k] = now;
  }
}

void SpherePile::turn(Time span) {
  const Real h = static_cast<Real>(span);
  for (int i = 0; i < spheres_.count; ++i) {
    const Vector3 spin = spheres_.spin(i);
    if (spin.isZero(0)) continue;
    Real* q = spheres_.orientation.data() + place_stride * i;
    const Quaternion next = turned(Quaternion(q[0], q[1], q[2], q[3]), h * spin);
    q[0] = next.w(), q[1] = next.x(), q[2] = next.y(), q[3] = next.z();
  }
}

}  // namespace cylon::engine::pile
