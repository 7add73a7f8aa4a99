#include "cylon/c_engine.h"

#include "cylon/worker.h"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace cylon::worker {
namespace {

constexpr std::uint32_t all_parts = CYLON_ROTATION | CYLON_CONTACTS | CYLON_SPRINGS | CYLON_DRAGS |
                                    CYLON_DRIVES | CYLON_ATTRACTIONS | CYLON_JOINTS;

core::Engine introduced(const cylon_engine& table) {
  core::Engine about;
  about.name = table.name, about.version = table.engine_version, about.precision = table.precision;
  about.integrators = {{table.integrator, table.order, table.conserves ? table.conserves : "", false}};
  about.knows = {"collision_filters", "body_gravity"};  // pairs and each body's gravity are handed over ready
  return about;
}

void refuse_other_settings(const core::Engine& about, const core::Setup& setup) {
  if (!setup.path.empty()) throw std::invalid_argument("this engine has no paths");
  if (!setup.options.empty()) throw std::invalid_argument("this engine has no options");
  const std::string& only = about.integrators.front().name;
  if (!setup.integrator.empty() && setup.integrator != only)
    throw std::invalid_argument(
        fmt::format("no integrator '{}': this engine's is '{}'", setup.integrator, only));
}

// The one table of this process.  Made by a function without arguments (cylon/worker.h).
const cylon_engine* served = nullptr;

}  // namespace

std::optional<std::string> fault(const cylon_engine* table) {
  if (!table) return "there is no table";
  if (table->version != CYLON_ENGINE_VERSION)
    return fmt::format("version is {}, and this library's is {}", table->version, CYLON_ENGINE_VERSION);
  if (table->takes & ~all_parts) return "takes has bits that are no cylon_part";
  const struct {
    const char* member;
    bool there;
  } needed[] = {{"name", table->name != nullptr},
                {"engine_version", table->engine_version != nullptr},
                {"precision", table->precision != nullptr},
                {"integrator", table->integrator != nullptr},
                {"load", table->load != nullptr},
                {"step", table->step != nullptr},
                {"read", table->read != nullptr}};
  for (const auto& [member, there] : needed)
    if (!there) return fmt::format("{} is NULL", member);
  const std::string_view precision = table->precision;
  if (precision != "double" && precision != "float")
    return fmt::format("precision is '{}', neither 'double' nor 'float'", precision);
  if (table->order < 1) return fmt::format("order is {}, below 1", table->order);
  return std::nullopt;
}

CEngine::CEngine(const cylon_engine& table) : table_(table), about_(introduced(table)) {}

std::optional<std::string> CEngine::unsupported(const core::Scene& scene, const core::Setup&) const {
  return not_taken(scene, table_.takes);
}

core::Loaded CEngine::load_if_supported(const core::Scene& scene, const core::Setup& setup) {
  refuse_other_settings(about_, setup);
  if (auto reason = unsupported(scene, setup)) return {.unsupported = std::move(reason)};
  copy_ = scene;
  scene_ = CScene(copy_);
  view_ = scene_.view();
  if (const char* reason = table_.load(table_.self, &view_, setup.dt)) return {.unsupported = reason};
  core::Terms terms;
  terms.integrator = table_.integrator, terms.order = table_.order;
  return {.terms = terms};
}

core::Terms CEngine::load(const core::Scene& scene, const core::Setup& setup) {
  core::Loaded loaded = load_if_supported(scene, setup);
  if (loaded.unsupported) throw std::runtime_error(*loaded.unsupported);
  return loaded.terms;
}

void CEngine::read(core::State& state) const {
  std::vector<cylon_state> states(state.size());
  table_.read(table_.self, states.data());
  for (std::size_t i = 0; i < state.size(); ++i) {
    const cylon_state& s = states[i];
    state[i] = {core::Vector3(s.position),
                core::Quaternion(s.orientation[0], s.orientation[1], s.orientation[2], s.orientation[3]),
                core::Vector3(s.velocity), core::Vector3(s.angular_velocity)};
  }
}

}  // namespace cylon::worker

int cylon_worker_main(const cylon_engine* engine) {
  using namespace cylon::worker;
  if (const auto wrong = fault(engine)) {
    std::fprintf(stderr, "cylon_worker_main: cylon_engine: %s\n", wrong->c_str());
    return 2;
  }
  served = engine;
  return run([]() -> std::unique_ptr<cylon::core::Simulator> { return std::make_unique<CEngine>(*served); });
}
