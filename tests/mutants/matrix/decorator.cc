#include "tests/mutants/matrix/decorator.h"

#include <atomic>
#include <optional>
#include <string>
#include <variant>

namespace cylon::mutants {
namespace {

class Masked final : public core::Simulator {
 public:
  explicit Masked(Mask mask) : mask_(std::move(mask)), inner_(core::make_simulator()) {}

  const core::Engine& engine() const override { return inner_->engine(); }

  std::optional<std::string> unsupported(const core::Scene& scene, const core::Setup& setup) const override {
    if (mask_.tampers && !scene.joints.empty()) return "a joint does not start again";
    if (mask_.tampers)
      for (const core::Force& force : scene.forces)
        if (std::holds_alternative<core::Drive>(force) || std::holds_alternative<core::Water>(force) ||
            std::holds_alternative<core::Thrust>(force))
          return "a force with a clock does not start again";
    return inner_->unsupported(given(scene), asked(setup));
  }

  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    static std::atomic<std::int64_t> runs = 0;
    run_ = ++runs;
    step_ = 0;
    scene_ = scene;
    setup_ = setup;
    core::Terms terms = inner_->load(given(scene), asked(setup));
    if (mask_.terms) mask_.terms(terms);
    inner_->read(now_);
    before_ = now_;
    return terms;
  }

  void step() override {
    ++step_;
    if (!mask_.skips || !mask_.skips(step_)) inner_->step();
    if (!mask_.reading && !mask_.tampers) return;
    before_ = now_;
    inner_->read(now_);
    if (mask_.tampers && mask_.tampers(moment(), now_)) inner_->load(from(now_), asked(setup_));
  }

  void read(core::State& state) const override {
    inner_->read(state);
    if (mask_.reading) mask_.reading(moment(), state);
  }

  std::vector<std::string> remarks() const override { return inner_->remarks(); }
  std::vector<told::Diagnostic> diagnostics() const override { return inner_->diagnostics(); }

  void keep_contacts(bool keep) override { inner_->keep_contacts(keep); }
  std::vector<core::Contact> contacts() const override {
    std::vector<core::Contact> told = inner_->contacts();
    if (mask_.telling)
      for (core::Contact& contact : told) mask_.telling(contact);
    return told;
  }
  std::optional<std::vector<core::Reaction>> reactions() const override {
    std::optional<std::vector<core::Reaction>> told = inner_->reactions();
    if (mask_.reacting && told)
      for (core::Reaction& reaction : *told) mask_.reacting(reaction);
    return told;
  }

 private:
  Moment moment() const { return {scene_, before_, step_, setup_.dt, run_}; }

  core::Scene given(core::Scene scene) const {
    if (mask_.scene) mask_.scene(scene);
    return scene;
  }
  core::Setup asked(core::Setup setup) const {
    if (mask_.setup) mask_.setup(setup);
    return setup;
  }

  core::Scene from(const core::State& start) const {
    core::Scene scene = given(scene_);
    for (std::size_t i = 0; i < start.size(); ++i) scene.bodies[i].initial = start[i];
    return scene;
  }

  Mask mask_;
  std::unique_ptr<core::Simulator> inner_;
  core::Scene scene_;
  core::Setup setup_;
  core::State now_, before_;
  std::int64_t step_ = 0, run_ = 0;
};

}  // namespace

std::unique_ptr<core::Simulator> masked(const Mask& mask) { return std::make_unique<Masked>(mask); }

}  // namespace cylon::mutants
