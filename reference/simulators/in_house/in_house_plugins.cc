#include "reference/simulators/in_house/in_house_plugins.h"

#include "cylon/force.h"
#include "engine/scratch.h"
#include "harness/core/input_error.h"
#include "harness/core/simulator.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::PluginForce;
using core::Scene;

// ---- The library ------------------------------------------------------------------------------------

std::variant<const cylon_plugin_table*, NoLaw> table_of(const std::string& name, const std::string& file) {
  // Never closed: laws of it are in models.
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) return fmt::format("plug-in '{}' cannot be loaded: {}", name, ::dlerror());
  const auto entry = reinterpret_cast<const cylon_plugin_table* (*)()>(::dlsym(library, "cylon_plugin"));
  if (!entry) return fmt::format("plug-in '{}': {} has no function cylon_plugin (cylon/force.h)", name, file);
  const cylon_plugin_table* table = entry();
  if (!table) return fmt::format("plug-in '{}': cylon_plugin returns NULL", name);
  if (table->version != CYLON_FORCE_VERSION)
    return fmt::format("plug-in '{}' was compiled with version {} of cylon/force.h, and this engine takes {}",
                       name, table->version, CYLON_FORCE_VERSION);
  return table;
}

// What is wrong with a law that the library shows; "" where nothing is.
std::string fault(const cylon_law& law) {
  if (!law.name) return "a law has no name";
  if (!law.apply) return fmt::format("law '{}' has no function apply", law.name);
  if (law.parameters > 0 && !law.parameter)
    return fmt::format("law '{}' has no list of parameters", law.name);
  for (const cylon_law_parameter& p : std::span(law.parameter, law.parameters))
    if (!p.name) return fmt::format("a parameter of law '{}' has no name", law.name);
  return "";
}

// ---- What a scene asks of it ------------------------------------------------------------------------

std::variant<const cylon_law*, NoLaw> find_law(const cylon_plugin_table& table, const PluginForce& force) {
  std::vector<std::string> names;
  for (const cylon_law& law : std::span(table.law, table.law ? table.laws : 0)) {
    if (const std::string wrong = fault(law); !wrong.empty())
      return fmt::format("plug-in '{}': {}", force.plugin, wrong);
    if (law.name == force.law) return &law;
    names.emplace_back(law.name);
  }
  return fmt::format("plug-in '{}' has no law '{}'{} (it has {})", force.plugin, force.law,
                     core::did_you_mean(force.law, names), fmt::join(names, ", "));
}

std::string called(const PluginForce& force) {
  return fmt::format("law '{}' of plug-in '{}'", force.law, force.plugin);
}

// In the order of the law.
std::variant<std::vector<double>, NoLaw> values_of(const cylon_law& law, const PluginForce& force) {
  const std::span parameters(law.parameter, law.parameters);
  std::vector<std::string> names;
  for (const cylon_law_parameter& p : parameters) names.emplace_back(p.name);
  for (const auto& [name, value] : force.parameters)
    if (std::ranges::find(names, name) == names.end())
      return fmt::format("{} has no parameter '{}'{} (it has {})", called(force), name,
                         core::did_you_mean(name, names), fmt::join(names, ", "));
  std::vector<double> values;
  for (const cylon_law_parameter& p : parameters) {
    const auto stated = force.parameters.find(p.name);
    const double value = stated == force.parameters.end() ? p.absent : stated->second;
    if (std::isnan(value)) return fmt::format("{} needs the parameter '{}'", called(force), p.name);
    if (value < p.least || value > p.most)
      return fmt::format("{}: {} = {}, but must be in [{}, {}]", called(force), p.name, value, p.least,
                         p.most);
    values.push_back(value);
  }
  return values;
}

template <class V>
void put(const V& vector, double* to) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<double>(vector[i]);
}

cylon_seen_body seen(double mass, const core::Matrix3& inertia, const core::Vector3& position,
                     const core::Quaternion& q, const core::Vector3& velocity, const core::Vector3& turn) {
  cylon_seen_body body = {mass, {}, {}, {q.w(), q.x(), q.y(), q.z()}, {}, {}};
  for (int i = 0; i < 9; ++i) body.inertia[i] = inertia(i / 3, i % 3);
  put(position, body.position), put(velocity, body.velocity), put(turn, body.angular_velocity);
  return body;
}

class PluginLaw final : public engine::UserLaw {
 public:
  PluginLaw(const cylon_law& law, std::vector<double> values, const Scene& scene, const PluginForce& force)
      : law_(law), values_(std::move(values)), called_(called(force)) {
    for (const int body : force.bodies) bodies_.push_back(scene.bodies[static_cast<std::size_t>(body)]);
  }

  bool reads_velocities() const override { return law_.reads_velocities != 0; }
  bool reads_time() const override { return law_.reads_time != 0; }

  /// Why it does not take this start; "" where it does.
  std::string refusal() const {
    if (!law_.refuses) return "";
    std::vector<cylon_seen_body> start;
    for (const core::Body& b : bodies_)
      start.push_back(seen(b.mass, b.inertia, b.initial.position, b.initial.orientation, b.initial.velocity,
                           b.initial.angular_velocity));
    const char* reason = law_.refuses(values_.data(), start.data(), start.size());
    return reason ? fmt::format("{}: {}", called_, reason) : "";
  }

  void apply(engine::Time t, std::span<const engine::SeenBody> bodies,
             std::span<engine::Load> loads) const override {
    engine::Scratch<cylon_seen_body> now;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      const engine::SeenBody& b = bodies[i];
      now->push_back(seen(static_cast<double>(b.mass), bodies_[i].inertia, b.position.cast<double>(),
                          b.orientation.cast<double>().normalized(), b.velocity.cast<double>(),
                          b.angular_velocity.cast<double>()));
    }
    engine::Scratch<cylon_load> scratch;
    std::vector<cylon_load>& found = *scratch;
    found.assign(bodies.size(), cylon_load{});
    law_.apply(values_.data(), t, now->data(), now->size(), found.data());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const core::Vector3 force(found[i].force), torque(found[i].torque);
      if (!force.allFinite() || !torque.allFinite())
        throw core::GaveUp(fmt::format("{} gives no finite {} on body '{}' at t = {} s", called_,
                                       force.allFinite() ? "torque" : "force", bodies_[i].name, t));
      loads[i] = {force.cast<engine::Real>(), torque.cast<engine::Real>()};
    }
  }

 private:
  const cylon_law& law_;
  std::vector<double> values_;
  std::vector<core::Body> bodies_;
  std::string called_;
};

}  // namespace

void Plugins::admit(const std::string& name, const std::string& file) {
  if (!files_.emplace(name, file).second)
    throw std::invalid_argument(fmt::format("two plug-ins are named '{}'", name));
}

std::variant<std::shared_ptr<const engine::UserLaw>, NoLaw> Plugins::law(const Scene& scene,
                                                                         const PluginForce& force) const {
  const auto admitted = files_.find(force.plugin);
  if (admitted == files_.end())
    return fmt::format(
        "the scene asks for plug-in '{0}', which is code that runs: if you trust it, let it take part by "
        "--plugin {0}=FILE",
        force.plugin);
  const auto table = table_of(force.plugin, admitted->second);
  if (const auto* reason = std::get_if<NoLaw>(&table)) return *reason;
  const auto law = find_law(*std::get<const cylon_plugin_table*>(table), force);
  if (const auto* reason = std::get_if<NoLaw>(&law)) return *reason;
  const cylon_law& found = *std::get<const cylon_law*>(law);
  const std::size_t bodies = force.bodies.size();
  if (bodies < found.least_bodies || (found.most_bodies > 0 && bodies > found.most_bodies))
    return fmt::format("{} acts on {}, not on {}", called(force),
                       found.most_bodies == 0 ? fmt::format("{} bodies or more", found.least_bodies)
                       : found.most_bodies == found.least_bodies
                           ? fmt::format("{} bodies", found.least_bodies)
                           : fmt::format("{} to {} bodies", found.least_bodies, found.most_bodies),
                       bodies);
  auto values = values_of(found, force);
  if (const auto* reason = std::get_if<NoLaw>(&values)) return *reason;
  const auto made = std::make_shared<const PluginLaw>(found, std::move(std::get<std::vector<double>>(values)),
                                                      scene, force);
  if (std::string reason = made->refusal(); !reason.empty()) return reason;
  return std::shared_ptr<const engine::UserLaw>(made);
}

}  // namespace cylon::simulators
