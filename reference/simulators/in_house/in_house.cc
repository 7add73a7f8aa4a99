// The in-house engine behind the common interface.  It gets only a Scene and a Setup, like every other
// engine.
#include "engine/world.h"
#include "harness/core/input_error.h"
#include "harness/core/simulator.h"
#include "reference/simulators/in_house/in_house_model.h"
#include "reference/simulators/in_house/in_house_overlap.h"
#include "reference/simulators/in_house/in_house_slowdown.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace cylon::simulators {
namespace {

using Reason = std::optional<std::string>;

constexpr bool is_float = sizeof(engine::Real) == sizeof(float);
constexpr int closed_form_order = 8;  // of a motion in closed form: no lower than of the best scheme

// ---- What the engine says of itself ----------------------------------------------------------------

std::vector<core::Path> paths() {
  core::Path events{.name = "events",
                    .summary =
                        "Impacts and contact changes are located in time; between them a closed form or the "
                        "integrator gives the motion.",
                    .settings = {},
                    .unforceable = {"Infinitely many bounces in a finite time end in rest.",
                                    "A thin body cannot spin about an axis of zero inertia."}};
  core::Path stepping{
      .name = "stepping",
      .summary = "Fixed steps; sequential impulses solve the contacts at the end of each step.",
      .settings = {},
      .unforceable = {"A contact is detected at the end of a step.",
                      "A thin body cannot spin about an axis of zero inertia."}};
  return {events, stepping};
}

struct Switch {
  const char* name;
  const char *usual, *other;
  bool engine::Options::*on;
  bool is_other;  // what `on` is where the other value is asked for
  const char* meaning;
};

constexpr Switch switches[] = {
    {"model", "planned", "full", &engine::Options::full, true,
     "planned: only the stages that the scene needs; full: all stages"},
    {"joints", "reduced", "constraints", &engine::Options::constraints, true,
     "reduced: joints to the world leave coordinates out, and so do trees of joints where the integrator is "
     "no splitting; constraints: all are kept"},
    {"account", "no", "yes", &engine::Options::account, true,
     "yes: integrate the work of each force beside the motion"},
    {"sleeping", "on", "off", &engine::Options::sleeping, false,
     "path stepping: on: in large piles what has come to rest keeps its place until something touches it"}};

struct WholeNumber {
  const char* name;
  const char* usual;
  int least, most;
  int engine::Options::*to;
  const char* meaning;
};

constexpr WholeNumber whole_numbers[] = {
    {"sweeps", "10", 1, 1000, &engine::Options::sweeps, "path stepping: sweeps over the contacts in a step"},
    {"threads", "1", 1, 64, &engine::Options::threads,
     "threads for large piles in steps and for more than 64 free bodies, with the same bits"}};

core::Engine describe() {
  core::Engine engine;
  engine.name = "in-house";
  engine.version = CYLON_VERSION;
  engine.precision = is_float ? "float" : "double";
  engine.paths = paths();
  engine.default_path_rule = engine::path_rule;
  engine.integrators.push_back({"auto", closed_form_order,
                                "all conserved quantities to the tolerance; to rounding in closed forms",
                                true});
  for (const engine::Integrator& row : engine::integrators())
    engine.integrators.push_back(
        {std::string(row.name), row.order, std::string(row.conserves), row.kind == engine::Kind::adaptive});
  engine.knows = {"collision_filters",       "frame_acceleration", "body_gravity",
                  "slider_joints",           "cylindrical_joints", "planar_joints",
                  "universal_joints",        "gimbal_joints",      "rectangular_joints",
                  "offset_universal_joints", "screw_joints",       "joint_forces",
                  "joint_targets",           "joint_limits",       "joint_friction",
                  "joint_armature",          "plugin_forces"};
  for (const Switch& row : switches)
    engine.options.push_back({row.name, {row.usual, row.other}, row.usual, row.meaning});
  for (const WholeNumber& row : whole_numbers)
    engine.options.push_back(
        {row.name, {}, row.usual, fmt::format("{}, {} to {}", row.meaning, row.least, row.most)});
  return engine;
}

// ---- What a user asks for --------------------------------------------------------------------------

// Throws std::invalid_argument, naming the nearest, unless the word is one of the valid ones.
void require(std::string_view what, const std::string& word, const std::vector<std::string>& valid) {
  if (std::find(valid.begin(), valid.end(), word) != valid.end()) return;
  throw std::invalid_argument(fmt::format("in-house has no {} '{}'{} (valid: {})", what, word,
                                          core::did_you_mean(word, valid), fmt::join(valid, ", ")));
}

template <class Rows>
std::vector<std::string> names(const Rows& rows) {
  std::vector<std::string> result;
  for (const auto& row : rows) result.push_back(row.name);
  return result;
}

int number_of(const WholeNumber& row, const std::string& value) {
  int number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error != std::errc{} || end != value.data() + value.size() || number < row.least || number > row.most)
    throw std::invalid_argument(fmt::format("in-house: {} = '{}' is not a whole number in [{}, {}]", row.name,
                                            value, row.least, row.most));
  return number;
}

engine::Options options_of(const core::Engine& engine, const core::Setup& setup) {
  engine::Options options;
  if (!setup.path.empty()) require("path", setup.path, names(engine.paths));
  if (!setup.integrator.empty()) require("integrator", setup.integrator, names(engine.integrators));
  for (const auto& [name, value] : setup.options) {
    require("option", name, names(engine.options));
    for (const WholeNumber& row : whole_numbers)
      if (name == row.name) options.*row.to = number_of(row, value);
    for (const Switch& row : switches) {
      if (name != row.name) continue;
      require(name, value, {row.usual, row.other});
      options.*row.on = (value == row.other) == row.is_other;
    }
  }
  options.path = setup.path;
  if (!setup.integrator.empty()) options.integrator = setup.integrator;
  options.dt = setup.dt;
  options.force = setup.force;
  options.tolerance = static_cast<engine::Real>(setup.tolerance);
  return options;
}

// ---- The simulator ---------------------------------------------------------------------------------

class InHouse final : public core::Simulator {
 public:
  const core::Engine& engine() const override {
    static const core::Engine description = describe();
    return description;
  }

  void admit(const std::string& name, const std::string& file) override { plugins_.admit(name, file); }

  Reason unsupported(const core::Scene& scene, const core::Setup& setup) const override {
    const engine::Options options = options_of(engine(), setup);
    const InHouseModel translated = in_house_model(scene, plugins_);
    Reason reason = missing(scene, translated, options);
    return reason || setup.force ? reason : doubt(scene, translated, options);
  }

  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    const engine::Options options = options_of(engine(), setup);
    return start(scene, in_house_model(scene, plugins_), options);
  }

  core::Loaded load_if_supported(const core::Scene& scene, const core::Setup& setup) override {
    const engine::Options options = options_of(engine(), setup);
    InHouseModel translated = in_house_model(scene, plugins_);
    Reason reason = missing(scene, translated, options);
    if (!reason && !setup.force) reason = doubt(scene, translated, options);
    if (reason) return {.unsupported = std::move(reason)};
    return {.terms = start(scene, std::move(translated), options)};
  }

  void step() override {
    slowed([&] { world_->step(); });
  }
  void advance(std::int64_t n) override {
    slowed([&] { world_->advance(n); });
  }

  Reason kick(int body, const core::Vector3& impulse, const core::Vector3& angular_impulse) override {
    if (std::string reason = world_->no_kick(); !reason.empty()) return reason;
    world_->kick(body, impulse.cast<engine::Real>(), angular_impulse.cast<engine::Real>());
    return std::nullopt;
  }

  void read(core::State& state) const override {
    const auto& bodies = world_->bodies();
    const auto& motions = world_->motions();
    state.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      state[i] = {motions[i].position.cast<double>(), motions[i].orientation.cast<double>(),
                  engine::velocity(bodies[i], motions[i]).cast<double>(),
                  engine::angular_velocity(bodies[i], motions[i]).cast<double>()};
      if (bodies[i].locked || frame_.isZero(0)) continue;
      state[i].velocity -= frame_.cross(state[i].position);  // as the turning frame sees them
      state[i].angular_velocity -= frame_;
    }
  }

  std::vector<std::string> remarks() const override {
    std::vector<std::string> texts;
    for (told::Diagnostic& d : diagnostics()) texts.push_back(std::move(d.text));
    return texts;
  }

  std::vector<told::Diagnostic> diagnostics() const override {
    std::vector<told::Diagnostic> all;
    if (forced_) all.push_back(told(*forced_));
    for (const engine::Diagnostic& d : overlaps_) all.push_back(told(d));
    for (const engine::Diagnostic& d : world_->diagnostics()) all.push_back(told(d));
    return all;
  }

  std::vector<core::Work> works() const override {
    const engine::Real* joules = world_->works();
    std::vector<core::Work> all;
    for (std::size_t i = 0; joules && i < forces_.size(); ++i)
      all.push_back({forces_[i], static_cast<double>(joules[i])});
    return all;
  }

  void keep_contacts(bool keep) override { world_->keep_contacts(keep); }
  std::vector<core::Contact> contacts() const override {
    std::vector<core::Contact> contacts;
    for (const engine::Contact& c : world_->contacts()) {
      core::Contact told{{c.body, c.other, c.plane}, c.point.cast<double>(), c.normal.cast<double>(), {}, {}};
      if (c.impulse) told.impulse = static_cast<double>(*c.impulse);
      if (c.friction) told.friction = c.friction->cast<double>();
      contacts.push_back(told);
    }
    return contacts;
  }
  std::optional<std::vector<core::Reaction>> reactions() const override {
    const std::optional<std::vector<engine::Reaction>> found = world_->reactions();
    if (!found) return std::nullopt;
    std::vector<core::Reaction> told;
    for (const engine::Reaction& r : *found)
      told.push_back({r.joint, r.point.cast<double>(), r.impulse.cast<double>(), r.moment.cast<double>()});
    return told;
  }

 private:
  // What the engine cannot do, forced or not.
  static Reason missing(const core::Scene& scene, const InHouseModel& translated, engine::Options options) {
    if (translated.missing) return translated.missing;
    options.force = true;
    return told(engine::unsupported(translated.model, options, names_of(scene)));
  }

  // Why a scene is refused that the engine could run.
  static Reason doubt(const core::Scene& scene, const InHouseModel& translated, engine::Options options) {
    if (translated.lost) return translated.lost;
    options.force = false;
    return told(engine::unsupported(translated.model, options, names_of(scene)));
  }

  told::Diagnostic told(const engine::Diagnostic& d) const {
    const engine::DiagnosticRow& row = engine::row(d.kind);
    told::Diagnostic result;
    result.kind = row.name;
    for (const int body : d.island.bodies) result.bodies.push_back(names_[static_cast<std::size_t>(body)]);
    result.body_count = d.island.count;
    result.method = d.island.method, result.order = d.island.order;
    result.since = static_cast<double>(d.since), result.count = d.count;
    if (d.until) result.until = static_cast<double>(*d.until);
    result.limit = d.limit, result.limit_unit = row.limit_unit;
    result.reached = d.reached, result.unit = row.unit;
    result.text = sentence(d, names_in_words_);
    return result;
  }

  static Reason told(const std::string& reason) { return reason.empty() ? Reason() : Reason(reason); }

  static engine::Names names_of(const core::Scene& scene) {
    const auto list = [](const auto& things) {
      std::vector<std::string> names;
      for (const auto& thing : things) names.push_back(fmt::format("'{}'", thing.name));
      return names;
    };
    return [bodies = list(scene.bodies), planes = list(scene.planes)](engine::Thing thing, int i) {
      return (thing == engine::Thing::body ? bodies : planes)[static_cast<std::size_t>(i)];
    };
  }

  // In the order in which the engine accounts them.
  std::vector<std::string> forces_in_words(const engine::Model& model) const {
    std::vector<std::string> all = {"gravity"};
    engine::each_force(model.forces, [&](const auto& force) {
      std::vector<std::string> bodies;
      if (const auto acted = force.acts_on())
        for (const int body : *acted)
          if (body != engine::fixed_world) bodies.push_back(names_in_words_(engine::Thing::body, body));
      all.push_back(force.one);
      if (!bodies.empty()) all.back() += fmt::format(" on {}", fmt::join(bodies, ", "));
    });
    return all;
  }

  core::Terms start(const core::Scene& scene, InHouseModel translated, const engine::Options& options) {
    overlaps_ = settle_deep_overlaps(scene, translated.model);
    forced_.reset();
    if (const Reason doubtful = options.force ? doubt(scene, translated, options) : Reason())
      forced_ = engine::Diagnostic{.kind = engine::DiagnosticKind::forced, .cause = *doubtful};
    names_.clear();
    for (const core::Body& body : scene.bodies) names_.push_back(body.name);
    names_in_words_ = names_of(scene);
    forces_ = forces_in_words(translated.model);
    frame_ = translated.model.frame ? scene.frame->angular_velocity : core::Vector3(core::Vector3::Zero());
    world_.emplace(std::move(translated.model), options, names_in_words_);
    return terms(world_->plan(), options);
  }

  core::Terms terms(const engine::Plan& plan, const engine::Options& options) const {
    const bool stepping = plan.path == engine::Path::stepping;
    const core::Path& path = engine().paths[stepping ? 1 : 0];
    core::Terms terms;
    terms.path = path.name;
    terms.integrator = options.integrator;
    terms.order = stepping ? 1 : plan.integrator ? plan.order : closed_form_order;
    terms.gyroscopic = "exact";
    terms.closed_form = !stepping && !plan.integrator;
    if (plan.integrator && plan.integrator->kind == engine::Kind::adaptive) {
      const double own = engine::default_tolerance();
      const double used = options.tolerance > 0 ? static_cast<double>(options.tolerance) : own;
      terms.settings.push_back({plan.verified ? "tolerance" : "tolerance of a step",
                                fmt::format("{:g}", used), fmt::format("{:g}", own),
                                plan.verified
                                    ? "bound on the error at the samples, of the scales of the motion"
                                    : "bound on the error of each step, of the scales of the motion"});
    }
    const engine::Options usual;
    for (const WholeNumber& row : whole_numbers)
      if (const int number = options.*row.to; number != usual.*row.to)
        terms.settings.push_back({row.name, fmt::format("{}", number), row.usual, "asked for"});
    for (const Switch& row : switches)
      if (options.*row.on != usual.*row.on)
        terms.settings.push_back({row.name, row.other, row.usual, "asked for"});
    terms.unforceable = path.unforceable;
    for (const engine::Stage& stage : plan.stages) terms.plan.push_back({stage.name, stage.in, stage.reason});
    return terms;
  }

  Plugins plugins_;
  std::optional<engine::World> world_;
  core::Vector3 frame_ = core::Vector3::Zero();  // how fast the scene's frame turns
  std::optional<engine::Diagnostic> forced_;     // why the run would be refused if nobody forced it
  std::vector<engine::Diagnostic>
      overlaps_;                     // what the run leaves undefined, which is no reason to refuse it
  std::vector<std::string> names_;   // of the bodies
  std::vector<std::string> forces_;  // in words
  engine::Names names_in_words_;
};

}  // namespace
}  // namespace cylon::simulators

std::unique_ptr<cylon::core::Simulator> cylon::core::make_simulator() {
  return std::make_unique<simulators::InHouse>();
}
