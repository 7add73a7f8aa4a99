#include "tests/mutants/matrix/seed/engine.h"

#include "tests/mutants/matrix/seed/contacts.h"
#include "tests/mutants/matrix/seed/forces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace cylon::mutants::seed {
namespace {

using core::State;

constexpr double touching = 1e-9;  // [m]; a contact that bears is no wider open
constexpr double inside = -1e-13;  // [m]; an impact is noticed below this, above rounding
constexpr double at_rest = 1e-10;  // [m/s]; slower closing is rounding

core::Engine describe() {
  core::Engine engine;
  engine.name = "seed";
  engine.version = "1";
  engine.precision = "double";
  engine.integrators = {{"leapfrog", 2, "linear and angular momentum", false}};
  return engine;
}

class Seed final : public core::Simulator {
 public:
  explicit Seed(Faults faults) : faulty_(faults) {}

  const core::Engine& engine() const override {
    static const core::Engine description = describe();
    return description;
  }

  std::optional<std::string> unsupported(const core::Scene& scene, const core::Setup&) const override {
    if (core::has_fictitious_forces(scene)) return "a frame that turns or accelerates";
    if (const auto reason = missing_force(scene)) return reason;
    if (scene.bodies.size() > 64) return "a crowd: it looks at every pair in every step";
    return missing_contact(scene);
  }

  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    static std::atomic<std::int64_t> runs = 0;
    run_ = ++runs;
    scene_ = scene, dt_ = setup.dt, step_ = 0, t_ = 0;
    frame_ = scene.frame ? scene.frame->velocity : Vector3(Vector3::Zero());
    bodies_.clear();
    for (const core::Body& body : scene.bodies) bodies_.push_back(make_body(body, faulty_));
    contacts_ = contacts_of(scene);
    if (faulty_(66) && run_ % 2) std::reverse(contacts_.begin(), contacts_.end());
    core::Terms terms;
    terms.path = "seed", terms.integrator = "leapfrog", terms.order = 2, terms.gyroscopic = "exact";
    return terms;
  }

  // Cut at the first impact or crossing of a surface, again and again.
  void step() override {
    const double end = static_cast<double>(++step_) * dt_;
    for (int cut = 0; t_ < end && cut < 1000; ++cut) {
      const double left = end - t_;
      const std::vector<Body> start = bodies_;
      measure(before_);
      unbroken_step(left);
      if (faulty_(65)) {
        late_impacts();
        break;
      }
      const double h = first_event(start, left);
      if (h >= left) break;
      bodies_ = start, t_ = end - left;
      unbroken_step(h);
      strike();
    }
    t_ = end;
  }

  void read(State& state) const override {
    state.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Body& body = bodies_[i];
      if (body.locked && !faulty_(57)) {
        state[i] = scene_.bodies[i].initial;
        continue;
      }
      const Matrix3 R = matrix_of(body.q, faulty_);
      const Vector3 omega = inverse_inertia(body, faulty_) * body.L, arm = R * body.centre;
      const bool point = body.I.isZero(0);
      Quaternion q(R);
      q.coeffs() *= body.q.norm();  // as it is, not as it should be
      state[i] = {body.p - arm, q, body.inv_m * body.K - omega.cross(arm),
                  point ? scene_.bodies[i].initial.angular_velocity : omega};
      // Seen from the scene's frame: v' = v - w; as printed p - w (errata 1).
      if (!frame_.isZero(0))
        state[i].velocity = (faulty_(1) ? state[i].position : state[i].velocity + frame_) - frame_;
    }
  }

 private:
  // ---- One step without a break
  // ----------------------------------------------------------------------------

  Instant instant(double h) const { return {t_, h, step_ == 1}; }

  void unbroken_step(double h) {
    if (faulty_(13) || faulty_(43)) return explicit_euler(h);
    drift(h / 2);
    t_ += h / 2;
    update_masses(scene_, bodies_, t_);
    find_bearing();
    give_impulse(h);
    bear(h);
    t_ += h / 2;
    update_masses(scene_, bodies_, t_);
    drift(h / 2);
  }

  // Eq. 15, 63: p += v h, R = R(w h) R with w in the middle of the step.
  void drift(double h) {
    for (Body& body : bodies_) {
      if (fixed(body)) continue;
      body.p += body.inv_m * body.K * h;
      const Quaternion start = body.q;
      const Vector3 turned = body.turned, omega = inverse_inertia(body, faulty_) * body.L;
      turn(body, omega * (h / 2), t_, faulty_);
      const Vector3 middle = inverse_inertia(body, faulty_) * body.L;
      body.q = start, body.turned = turned;
      turn(body, middle * h, t_, faulty_);
    }
  }

  // Eq. 16, 64: K += F h, L += tau h, with the velocities of the middle of the push.
  void give_impulse(double h) {
    const std::vector<Body> start = bodies_;
    if (!faulty_(44)) velocities();  // errata 44: those of one step ago
    apply_forces(scene_, bodies_, instant(h), faulty_);
    if (!faulty_(44)) {
      push(h / 2);
      velocities();
      apply_forces(scene_, bodies_, instant(h), faulty_);
      if (!faulty_(64))
        for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].K = start[i].K;
      for (std::size_t i = 0; i < bodies_.size(); ++i) bodies_[i].L = start[i].L;
    }
    push(h);
    if (faulty_(44))
      for (std::size_t i = 0; i < bodies_.size(); ++i) {  // v, omega as written at the start of this step
        bodies_[i].v = start[i].inv_m * start[i].K;
        bodies_[i].omega = inverse_inertia(start[i], faulty_) * start[i].L;
      }
  }

  void push(double h) {
    for (Body& body : bodies_) {
      if (fixed(body)) continue;
      body.K += body.F * h;
      if (faulty_(10))
        body.L = body.tau;  // eq. 52
      else
        body.L += body.tau * h;
      if (faulty_(51) && submerged(body)) body.L *= 1 - h;
      if (faulty_(23) && body.tau.isZero(0)) keep_scalar_energy(body);
    }
  }

  // I w^2 / 2 with a number I, eq. 84: |w| is kept.
  void keep_scalar_energy(Body& body) const {
    const double now = (inverse_inertia(body, faulty_) * body.L).norm();
    if (now > 0) body.L *= body.spin / now;
  }

  // Eq. 57-64: everything at the start of the step.
  void explicit_euler(double h) {
    velocities();
    apply_forces(scene_, bodies_, instant(h), faulty_);
    for (Body& body : bodies_) {
      if (fixed(body)) continue;
      const Vector3 v = body.v;
      if (faulty_(43)) turn(body, body.omega * h, t_, faulty_);
      body.K += body.F * h, body.L += body.tau * h;
      body.p += v * h;
    }
    if (faulty_(13)) turn_all(h);
    t_ += h;
    update_masses(scene_, bodies_, t_);
  }

  void turn_all(double h) {
    for (Body& body : bodies_) {
      const Quaternion start = body.q;
      turn(body, inverse_inertia(body, faulty_) * body.L * (h / 2), t_, faulty_);
      const Vector3 middle = inverse_inertia(body, faulty_) * body.L;
      body.q = start;
      turn(body, middle * h, t_, faulty_);
    }
  }

  void velocities() {
    for (Body& body : bodies_) update_velocities(body, faulty_);
  }

  bool fixed(const Body& body) const { return body.locked && !faulty_(57); }
  bool submerged(const Body& body) const {
    std::vector<double> heights;
    heights_over_water(scene_, {body}, t_, heights);
    return std::any_of(heights.begin(), heights.end(), [](double y) { return y < 0; });
  }

  // ---- Contacts
  // --------------------------------------------------------------------------------------------

  // Contacts that touch and neither open nor close: the forces are about to push them in.
  void find_bearing() {
    bearing_.clear();
    if (contacts_.empty()) return;
    update_contacts(scene_, bodies_, faulty_, contacts_);
    for (const Contact& c : contacts_)
      if (std::abs(c.gap) < touching && std::abs(closing(c, bodies_, faulty_)) < at_rest)
        bearing_.push_back(c);
  }

  // Those push back; plastic, with friction.
  void bear(double h) {
    for (int round = 0; round < 100; ++round) {
      bool quiet = true;
      for (const Contact& c : bearing_) {
        if (closing(c, bodies_, faulty_) > -at_rest) continue;
        collide(c, 0, h, bodies_, faulty_);
        quiet = false;
      }
      if (quiet) return;
    }
  }

  // All that touches and closes, pair by pair, until nothing closes.
  void strike() {
    update_contacts(scene_, bodies_, faulty_, contacts_);
    for (int round = 0; round < 100; ++round) {
      bool quiet = true;
      for (const Contact& c : contacts_) {
        if (c.gap > touching || closing(c, bodies_, faulty_) > -at_rest) continue;
        collide(c, c.c, dt_, bodies_, faulty_);
        quiet = false;
      }
      if (quiet) return;
    }
  }

  // Errata 65: after the step, and out of each other without a word to the energy.
  void late_impacts() {
    update_contacts(scene_, bodies_, faulty_, contacts_);
    for (const Contact& c : contacts_) {
      if (c.gap > 0) continue;
      Body& a = bodies_[static_cast<std::size_t>(c.a)];
      if (!fixed(a)) a.p -= c.gap * c.n;
      if (closing(c, bodies_, faulty_) < 0) collide(c, c.c, dt_, bodies_, faulty_);
    }
  }

  // ---- Events
  // ----------------------------------------------------------------------------------------------

  // What must not change its sign in a step: gaps that are open, heights over water.
  void measure(std::vector<double>& values) {
    heights_over_water(scene_, bodies_, t_, values);
    if (contacts_.empty()) return;
    update_contacts(scene_, bodies_, faulty_, contacts_);
    for (const Contact& c : contacts_) values.push_back(c.gap);
  }

  bool crossed(std::size_t waters, const std::vector<double>& after) const {
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (i < waters && (before_[i] < 0) != (after[i] < 0)) return true;
      if (i >= waters && before_[i] > inside && after[i] < inside) return true;
    }
    return false;
  }

  // The length of the longest step without an event, by bisection; `left` where there is none.
  double first_event(const std::vector<Body>& start, double left) {
    const std::size_t waters = before_.size() - contacts_.size();
    measure(after_);
    if (!crossed(waters, after_)) return left;
    const double t = t_ - left;
    double low = 0, high = left;
    for (int i = 0; i < 60 && high - low > 1e-16; ++i) {
      const double h = (low + high) / 2;
      bodies_ = start, t_ = t;
      unbroken_step(h);
      measure(after_);
      (crossed(waters, after_) ? high : low) = h;
    }
    return high;
  }

  Faults faulty_;
  core::Scene scene_;
  std::vector<Body> bodies_;
  std::vector<Contact> contacts_, bearing_;
  std::vector<double> before_, after_;
  Vector3 frame_ = Vector3::Zero();
  double dt_ = 0, t_ = 0;
  std::int64_t step_ = 0, run_ = 0;
};

}  // namespace

std::unique_ptr<core::Simulator> make_engine(Faults faults) { return std::make_unique<Seed>(faults); }

}  // namespace cylon::mutants::seed
