#include "engine/plan.h"

#include "engine/ballistic/ballistic.h"
#include "engine/free_bodies.h"
#include "engine/normal_modes.h"
#include "engine/points.h"
#include "engine/reduce.h"
#include "engine/turning.h"

#include <algorithm>

namespace cylon::engine {

namespace {

// More moving bodies than this that can touch are stepped, not followed event by event: spheres, and others.
// Two boxes that project on one another and on a plane bounce thousands of times in a step of 10 ms: 22 s of
// work.
constexpr std::size_t most_followed = 8, most_followed_others = 1;

// More bodies than this that move freely are stepped side by side.
constexpr std::size_t many_free = 64;

template <class Range, class Predicate>
bool any(const Range& range, Predicate predicate) {
  return std::any_of(range.begin(), range.end(), predicate);
}

bool touches(const Model& model, std::size_t body) {
  return !model.surfaces.empty() && model.surfaces[body] != no_surface;
}

std::size_t touching_bodies(const Model& model) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) count += touches(model, i) && !model.bodies[i].locked;
  return count;
}

bool few_touch(const Model& model) {
  std::size_t others = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    others +=
        touches(model, i) && !model.bodies[i].locked && !std::holds_alternative<Sphere>(model.shapes[i]);
  return touching_bodies(model) <= most_followed && others <= most_followed_others;
}

// Whether every body moves as if it were alone in uniform gravity.
bool moves_freely(const Model& model) {
  return !can_touch(model) && model.forces.only_gravity() && model.joints.empty() && !model.frame &&
         !any(model.bodies, [](const Body& body) { return body.mass_rate != 0; });
}

bool has_friction(const Model& model) {
  return any(model.materials, [](const Material& m) { return m.friction > 0; });
}

Path path_of(const Model& model, const Options& options) {
  const bool chosen = options.integrator != "auto";
  if (can_touch(model) || (options.full && options.path.empty() && !model.frame)) {
    if (options.path == "stepping") return Path::stepping;
    if (!chosen && !options.full && options.path.empty() && ballistic_applies(model)) return Path::ballistic;
    if (options.path == "events" || few_touch(model)) return Path::events;
    return Path::stepping;
  }
  if (options.full) return Path::bodies;
  if (!chosen && !options.account && moves_freely(model)) return Path::exact;
  if (!chosen && !options.account && normal_modes(model).why_not.empty()) return Path::modes;
  if (chosen && !options.account && model.bodies.size() > many_free &&
      FreeBodies::not_free(model, *find_integrator(options.integrator)).empty())
    return Path::free;
  if (!options.account && not_points(model).empty()) return Path::points;
  return Path::bodies;
}

bool is_closed(Path path) {
  return path == Path::exact || path == Path::modes || path == Path::ballistic;
}

// What would have to know that the world turns; null: nothing.
const char* not_in_a_turning_frame(const Model& model) {
  if (!model.frame) return nullptr;
  const auto& f = model.forces;
  if (can_touch(model)) return "contacts in a rotating frame are not modelled";
  if (any(model.joints, [](const Joint& j) { return j.body == fixed_world || j.to == fixed_world; }))
    return "joints to the world in a rotating frame are not modelled";
  if (any(f.springs, [](const Spring& s) { return s.damping != 0 && s.to == fixed_world; }) ||
      !f.drags.empty() || !f.waters.empty())
    return "drag in a rotating frame is not modelled";
  return nullptr;
}

// The stages of a model, a line each.
class Stages {
 public:
  Stages(const Model& model, const Options& options, const Plan& plan)
      : model_(model), options_(options), plan_(plan) {}

  std::vector<Stage> list() {
    const Forces& f = model_.forces;
    const bool contact = can_touch(model_);
    freedom();
    rotation();
    add("gravity", !f.gravity.isZero(0), "uniform gravity acts", "no uniform gravity");
    count("springs", f.springs.size());
    count("drag", f.drags.size());
    count("thrust", f.thrusts.size());
    count("drive", f.drives.size());
    count("attraction", f.attractions.size());
    count("water", f.waters.size());
    add("variable mass", any(model_.bodies, [](const Body& b) { return b.mass_rate != 0; }),
        "a body gains or loses mass", "all masses are constant");
    add("turning frame", model_.frame.has_value(), "the scene is given in a rotating frame",
        "the frame is inertial");
    joints();
    add("broad phase", broad(), "many bodies can touch: a grid finds the pairs",
        contact ? "few bodies can touch" : nothing);
    add("detection", contact || options_.full, contact ? "surfaces can touch" : "option model = full",
        nothing);
    add("impacts", contact, "surfaces can collide", nothing);
    add("friction", contact && has_friction(model_), "at least one pair of surfaces has friction",
        contact ? "no pair of surfaces has friction" : nothing);
    add("contact solving", contact, "contacts can persist", nothing);
    add("event location", plan_.path == Path::events || plan_.path == Path::ballistic,
        "impacts and contact changes are located in time, not at the end of a step",
        plan_.path == Path::stepping ? "contacts are resolved over whole steps" : nothing);
    add("integration", plan_.integrator != nullptr,
        plan_.integrator ? "integrator " + std::string(plan_.integrator->name) : std::string(),
        plan_.path == Path::stepping ? "the stepping path has its own integrator"
                                     : "the motion is in closed form");
    add("closed form", is_closed(plan_.path),
        plan_.path == Path::exact   ? "every body moves freely"
        : plan_.path == Path::modes ? "all springs are linear: normal modes"
                                    : "spheres move freely between impacts",
        "forces, joints, contacts or the chosen integrator need integration");
    add("error control", plan_.verified, "two solutions must agree within the tolerance",
        plan_.path == Path::stepping ? "stepping uses a fixed step: its error is not controlled"
        : plan_.integrator && plan_.integrator->kind == Kind::adaptive
            ? "the integrator controls the error of each step only"
        : plan_.integrator ? "the integrator has a fixed step"
                           : "the error of a closed form is rounding");
    return std::move(stages_);
  }

 private:
  static constexpr const char* nothing = "no bodies can touch";

  void add(const char* name, bool in, const std::string& why_in, const std::string& why_out) {
    stages_.push_back({name, in, in ? why_in : why_out});
  }
  void count(const char* name, std::size_t n) {
    add(name, n > 0, std::to_string(n) + (n == 1 ? " acts" : " act"), "none in the scene");
  }
  bool broad() const { return plan_.path == Path::stepping || (can_touch(model_) && !few_touch(model_)); }

  // 6 n - m; a locked body has none, a point 3.
  void freedom() {
    constexpr int taken[] = {3, 5, 1, 6};
    int freedom = 0, points = 0, locked = 0;
    const std::vector<char> turns = bodies_that_turn(model_);
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      const bool point = !turns[i];
      freedom += model_.bodies[i].locked ? 0 : point ? 3 : 6;
      points += point && !model_.bodies[i].locked;
      locked += model_.bodies[i].locked;
    }
    int m = 0;
    for (const Joint& j : model_.joints) m += taken[static_cast<std::size_t>(j.type)];
    std::string reason = std::to_string(freedom - m) + " = " + std::to_string(freedom) + " of " +
                         std::to_string(model_.bodies.size()) + " bodies - " + std::to_string(m) +
                         " by joints";
    if (points > 0) reason += "; points: " + std::to_string(points);
    if (locked > 0) reason += "; locked: " + std::to_string(locked);
    add("degrees of freedom", true, reason, "");
  }

  void rotation() {
    const std::vector<char> turning = bodies_that_turn(model_);
    const bool turns = options_.full || any(turning, [](char turns_too) { return turns_too != 0; });
    add("rotation", turns, options_.full ? "option model = full" : "bodies spin or torques can act",
        "no body spins and no torque acts");
  }

  void joints() {
    if (model_.joints.empty()) {
      add("reduced coordinates", false, "", "no joints");
      add("joint constraints", false, "", "no joints");
      return;
    }
    const Reduced reduced = reduce(model_);
    std::string pinned;
    for (const std::string& line : reduced.pinned) pinned += (pinned.empty() ? "" : ", ") + line;
    add("reduced coordinates", !reduced.pinned.empty(), pinned, "no body is jointed to the world only");
    const std::size_t kept = reduced.model.joints.size();
    add("joint constraints", kept > 0, std::to_string(kept) + (kept == 1 ? " joint" : " joints"),
        "reduced coordinates satisfy all joints");
  }

  const Model& model_;
  const Options& options_;
  const Plan& plan_;
  std::vector<Stage> stages_;
};

}  // namespace

const char* const path_rule =
    "events: impacts and contact changes are located in time; used if at most 8 moving bodies can touch "
    "anything and at most 1 of them is not a sphere, or if only spheres in uniform gravity move. stepping: "
    "fixed steps with impulses; used otherwise.";

Real default_tolerance() { return sizeof(Real) == 8 ? Real(1e-10) : Real(1e-4); }

bool can_touch(const Model& model) {
  std::size_t moving = 0, all = 0;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!touches(model, i)) continue;
    ++all;
    moving += !model.bodies[i].locked;
  }
  return moving > 0 && (all > 1 || !model.planes.empty());
}

std::string unsupported(const Model& given, const Options& options, const Names& names) {
  Model model = given;
  model.reduce_joints = model.reduce_joints && !options.constraints;
  const Integrator* integrator = find_integrator(options.integrator);
  if (options.integrator != "auto" && !integrator)
    return "there is no integrator '" + options.integrator + "'";
  if (!options.path.empty() && options.path != "events" && options.path != "stepping")
    return "there is no path '" + options.path + "'";
  if (integrator && !integrator->constraints && integrator->kind == Kind::splitting &&
      !model.joints.empty() && !reduce(model).model.joints.empty()) {
    return std::string(integrator->name) +
           " cannot integrate joints: only compositions of RATTLE steps keep the constraints";
  }
  const bool stepping = can_touch(model) && path_of(model, options) == Path::stepping;
  if (stepping && options.integrator != "auto")
    return "the stepping path has its own integrator: " + options.integrator + " is for the path events";
  if (const char* reason = not_in_a_turning_frame(model)) return reason;
  for (const Water& water : model.forces.waters) {
    if (water.mode != WaterMode::volume) continue;
    for (std::size_t i = 0; i < water.shapes.size(); ++i) {
      if (std::holds_alternative<Capsule>(water.shapes[i]) && !model.bodies[i].locked)
        return "the volume of a capsule below a water surface is not modelled";
    }
  }
  return unresolved(model, path_of(model, options), names);
}

Plan make_plan(const Model& model, const Options& options) {
  Plan plan;
  plan.path = path_of(model, options);
  const bool no_integrator = is_closed(plan.path) || plan.path == Path::stepping;
  plan.verified = !no_integrator && options.integrator == "auto";
  if (!no_integrator) plan.integrator = find_integrator(plan.verified ? "dop853" : options.integrator);
  const bool drags = model.forces.read_velocities();
  if (plan.integrator) plan.order = drags ? plan.integrator->drag_order : plan.integrator->order;
  plan.stages = Stages(model, options, plan).list();
  return plan;
}

}  // namespace cylon::engine
