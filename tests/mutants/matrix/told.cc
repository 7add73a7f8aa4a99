#include "tests/mutants/matrix/told.h"

#include <algorithm>
#include <utility>

namespace cylon::mutants {
namespace {

class Told final : public core::Simulator {
 public:
  explicit Told(std::function<core::State(double)> states) : states_(std::move(states)) {}

  const core::Engine& engine() const override { return engine_; }
  std::optional<std::string> unsupported(const core::Scene&, const core::Setup&) const override {
    return std::nullopt;
  }
  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    start_ = core::initial_state(scene);
    dt_ = setup.dt;
    step_ = 0;
    return {.path = "told", .integrator = "none"};
  }
  void step() override { ++step_; }
  void read(core::State& state) const override {
    state = step_ > 0 && states_ ? states_(static_cast<double>(step_ - 1) * dt_) : start_;
  }

 private:
  core::Engine engine_{
      .name = "told", .version = "1", .precision = "double", .integrators = {{.name = "none"}}};
  std::function<core::State(double)> states_;
  core::State start_;
  double dt_ = 0;
  std::int64_t step_ = 0;
};

Subject subject(const char* name, const char* fault, const std::function<core::State(double)>& states) {
  Subject result;
  result.name = name;
  result.fault = fault;
  result.make = [states] { return std::make_unique<Told>(states); };
  return result;
}

}  // namespace

Subject frozen() { return subject("frozen", "the state of the start for ever", nullptr); }

Subject one_step_late(const std::function<core::State(double t)>& states) {
  return subject("one step late", "the state of the step before", states);
}

Subject stopped(const core::State& first) {
  return subject("one step, then still", "the state after the first step for ever",
                 [first](double) { return first; });
}

}  // namespace cylon::mutants
