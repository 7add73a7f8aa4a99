// An engine in C++: bodies that fall freely.
#include <cylon/worker.h>

#include <stdexcept>

using namespace cylon::core;

class MyEngine final : public Simulator {
 public:
  const Engine& engine() const override { return about_; }

  std::optional<std::string> unsupported(const Scene& scene, const Setup&) const override {
    for (const Force& force : scene.forces)
      if (!std::holds_alternative<UniformGravity>(force)) return "no forces but gravity";
    for (const Body& body : scene.bodies)
      if (!body.initial.angular_velocity.isZero(0)) return "no rotation, but '" + body.name + "' spins";
    if (!scene.joints.empty()) return "no joints";
    if (!touching_pairs(scene).empty()) return "no contacts";
    if (scene.frame) return "no frame but the inertial one";
    return std::nullopt;
  }

  Terms load(const Scene& scene, const Setup& setup) override {
    const std::string name = setup.integrator.empty() ? about_.integrators[0].name : setup.integrator;
    chosen_ = about_.integrator(name);
    if (!chosen_) throw std::invalid_argument("no integrator '" + name + "': 'verlet' and 'euler' are here");
    if (!setup.path.empty() || !setup.options.empty()) throw std::invalid_argument("no paths, no options");
    scene_ = scene, state_ = initial_state(scene), dt_ = setup.dt;
    return {.integrator = name, .order = chosen_->order};
  }

  // x += v dt + a dt^2/2;  v += a dt.  Explicit Euler leaves the second term out.
  void step() override {
    for (std::size_t i = 0; i < state_.size(); ++i) {
      if (scene_.bodies[i].locked) continue;
      const Vector3 a = gravity_of(scene_, scene_.bodies[i]);
      state_[i].position += state_[i].velocity * dt_;
      if (chosen_->order == 2) state_[i].position += a * (dt_ * dt_ / 2);
      state_[i].velocity += a * dt_;
    }
  }

  void read(State& state) const override { state = state_; }

 private:
  Engine about_{.name = "my-engine",
                .version = "1.0",
                .precision = "double",
                .integrators = {{"verlet", 2, "energy"}, {"euler", 1, ""}},
                .knows = {"body_gravity"}};
  const Integrator* chosen_ = nullptr;
  Scene scene_;
  State state_;
  double dt_ = 0;
};

int main() { return cylon::worker::run<MyEngine>(); }
