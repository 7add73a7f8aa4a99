#include "engine/plan.h"

#include "engine/ballistic/ballistic.h"
#include "engine/free_bodies.h"
#include "engine/joint.h"
#include "engine/joint_rank.h"
#include "engine/methods.h"
#include "engine/normal_modes.h"
#include "engine/reduce.h"
#include "engine/trees.h"
#include "engine/turning.h"

#include <algorithm>
#include <optional>

namespace cylon::engine {

namespace {

// More moving bodies than this that can touch are stepped, not followed event by event: spheres, and others.
// Two boxes that settle on one another and on a plane bounce thousands of times in a step of 10 ms: 22 s of
// work.
constexpr std::size_t most_followed = 8, most_followed_others = 1;

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

bool has_friction(const Model& model) {
  return any(model.materials, [](const Material& m) { return m.friction > 0; });
}

// What the features do not say of a path: numbers of bodies, values, what the integrator is.
struct Situation {
  const Model& model;
  const Options& options;
  Features required;
};

struct Candidate {
  Path path;
  Method method;
  bool (*fits)(const Situation&);
};

bool always(const Situation&) { return true; }
bool has_contacts(const Situation& s) { return s.required.has(Feature::contact); }
bool followed(const Situation& s) {
  return has_contacts(s) && (s.required.has(Feature::path_events) || few_touch(s.model));
}
// More bodies than are followed fast, and nothing but these that steps do not have: slowly rather than not at all.
bool only_smooth_parts_hinder(const Situation& s) {
  const Features beyond = s.required - supports(Method::body_steps);
  constexpr Features smooth = {Feature::joint_couples, Feature::user_force,
                               Feature::user_force_of_velocities};
  return has_contacts(s) && (beyond - smooth).empty();
}
bool flies(const Situation& s) { return has_contacts(s) && ballistic_applies(s.model); }
bool oscillates(const Situation& s) { return normal_modes(s.model).why_not.empty(); }
bool many_fly(const Situation& s) {
  return s.model.bodies.size() > many_free && s.required.has(Feature::chosen_integrator) &&
         FreeBodies::not_free(s.model, *find_integrator(s.options.integrator)).empty();
}

// In order of preference: the first that supports all that is required, and fits, is taken.
constexpr Candidate candidates[] = {
    {Path::ballistic, Method::ballistic, flies},
    {Path::events, Method::events, followed},
    {Path::stepping, Method::body_steps, has_contacts},
    {Path::events, Method::events, only_smooth_parts_hinder},
    {Path::exact, Method::exact, always},
    {Path::modes, Method::modes, oscillates},
    {Path::free, Method::free, many_fly},
    {Path::points, Method::points, always},
    {Path::bodies, Method::bodies, always},
};

std::optional<Path> path_of(const Model& model, const Options& options, Features also = {}) {
  const Situation situation{model, options, required(model, options) | also};
  for (const Candidate& c : candidates)
    if ((situation.required - supports(c.method)).empty() && c.fits(situation)) return c.path;
  return std::nullopt;
}

// Why path_of() finds none.
std::string no_path(const Model& model, const Options& options) {
  if (options.integrator != "auto") {
    Options own = options;
    own.integrator = "auto";
    if (path_of(model, own) == Path::stepping)
      return "the stepping path has its own integrator: " + options.integrator + " is for the path events";
  }
  const Features all = required(model, options);
  Features nowhere = all;
  for (const Candidate& c : candidates) nowhere = nowhere - supports(c.method);
  return nowhere.empty() ? "no path of the engine supports all of this together: " + names(all)
                         : "not modelled: " + names(nowhere);
}

bool is_closed(Path path) { return path == Path::exact || path == Path::modes || path == Path::ballistic; }

// How many of a list act as forces: limits and dry friction of a joint have stages of their own.
template <class Kind>
std::size_t acting(const std::vector<Kind>& list) {
  if constexpr (std::is_same_v<Kind, CoordinateLaw>)
    return static_cast<std::size_t>(std::ranges::count_if(list, &CoordinateLaw::has_smooth_force));
  else
    return list.size();
}

// The stages of a model, a line each.
class Stages {
 public:
  Stages(const Model& model, const Options& options, const Plan& plan)
      : model_(model), options_(options), plan_(plan) {}

  std::vector<Stage> list() {
    const bool contact = can_touch(model_);
    freedom();
    rotation();
    const bool own = model_.has_own_gravity();
    add("gravity", own || !model_.forces.gravity.isZero(0),
        own ? "bodies have a gravity of their own" : "uniform gravity acts", "no uniform gravity");
    each_force_list(model_.forces,
                    [&]<class Kind>(const std::vector<Kind>& list) { count(Kind::stage, acting(list)); });
    add("variable mass", any(model_.bodies, [](const Body& b) { return b.mass_rate != 0; }),
        "a body gains or loses mass", "all masses are constant");
    add("turning frame", model_.frame.has_value(), "the scene is given in a rotating frame",
        "the frame is inertial");
    joints();
    const std::vector<CoordinateLaw>& laws = model_.forces.coordinate_laws;
    add("limits of joints", any(laws, [](const CoordinateLaw& law) { return law.is_limited(); }),
        "a coordinate of a joint has a limit", "no joint has a limit");
    add("dry friction in joints", any(laws, [](const CoordinateLaw& law) { return law.friction != 0; }),
        "a coordinate of a joint has dry friction", "no joint has dry friction");
    add("rotors on joints", any(laws, [](const CoordinateLaw& law) { return law.armature != 0; }),
        "a coordinate of a joint drives a rotor", "no joint drives a rotor");
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

  // 6 n - rank; a locked body has none, a point 3.
  void freedom() {
    int freedom = 0, points = 0, locked = 0;
    const std::vector<char> turns = bodies_that_turn(model_);
    for (std::size_t i = 0; i < model_.bodies.size(); ++i) {
      const bool point = !turns[i];
      freedom += model_.bodies[i].locked ? 0 : point ? 3 : 6;
      points += point && !model_.bodies[i].locked;
      locked += model_.bodies[i].locked;
    }
    int rows = 0;
    for (const Joint& j : model_.joints) rows += row_count(j.type);
    const std::optional<int> rank = joint_rank(model_);
    const int m = rank.value_or(rows);
    std::string reason = std::to_string(freedom - m) + " = " + std::to_string(freedom) + " of " +
                         std::to_string(model_.bodies.size()) +
                         (model_.bodies.size() == 1 ? " body - " : " bodies - ") + std::to_string(m) +
                         " by joints";
    if (!rank) reason += ", if no two of them say the same";
    if (m < rows) reason += "; " + std::to_string(rows - m) + " conditions of joints follow from the others";
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
    if (plan_.integrator && plan_.path == Path::bodies &&
        Trees::applies(model_, options_, *plan_.integrator)) {
      add("reduced coordinates", true, "joints hang bodies from each other as trees", "");
      add("joint constraints", false, "", "reduced coordinates satisfy all joints");
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

const char* name_of(Path path) {
  switch (path) {
    case Path::exact:
    case Path::modes:
    case Path::ballistic:
      return "closed form";
    case Path::free:
    case Path::points:
    case Path::bodies:
      return "integration";
    case Path::events:
      return "events";
    case Path::stepping:
      return "fixed steps with impulses";
  }
  return "";
}

const char* const path_rule =
    "For each part of a scene that moves by itself. events: impacts and contact changes are located in time; "
    "used if at most 8 moving bodies can touch "
    "anything and at most 1 of them is not a sphere, or if only spheres in uniform gravity move. stepping: "
    "fixed steps with impulses; used otherwise.";

Real default_tolerance() { return sizeof(Real) == 8 ? Real(1e-10) : Real(1e-4); }

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
  if (integrator && integrator->kind == Kind::splitting)
    if (const Features beyond = required(model) & not_affine; !beyond.empty())
      return std::string(integrator->name) + " cannot integrate " + engine::names(beyond) +
             ": its kicks are exact for forces that are affine in the momenta";
  if (integrator && integrator->kind == Kind::splitting && required(model).has(Feature::joint_rotor))
    return std::string(integrator->name) + " cannot integrate " + engine::names({Feature::joint_rotor}) +
           ": no part of the motion is theirs alone";
  const std::optional<Path> path = path_of(model, options);
  if (!path) return no_path(model, options);
  return options.force ? "" : unresolved(model, *path, names);
}

Plan make_plan(const Model& model, const Options& options, Features also) {
  Plan plan;
  plan.path = path_of(model, options, also).value();
  const bool no_integrator = is_closed(plan.path) || plan.path == Path::stepping;
  plan.verified = !no_integrator && options.integrator == "auto";
  if (!no_integrator) plan.integrator = find_integrator(plan.verified ? "dop853" : options.integrator);
  const bool drags = model.forces.read_velocities();
  if (plan.integrator) plan.order = drags ? plan.integrator->drag_order : plan.integrator->order;
  if (plan.path == Path::stepping) plan.order = 1;
  plan.stages = Stages(model, options, plan).list();
  return plan;
}

}  // namespace cylon::engine
