// Every coordinate that a joint leaves free, and each law along it, on every engine, against the exact motion of one freedom.
// What an engine refuses is a table: a refusal that is new, gone or has another reason fails.
#include "harness/core/joint_coordinates.h"
#include "tests/conformance/adapters_joint_bounds.h"
#include "tests/conformance/adapters_joint_cases.h"

#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <sstream>
#include <utility>

namespace cylon::conformance {
namespace {

using core::JointType;
using core::Ordinal;

class JointCoordinates : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, JointCoordinates, testing::ValuesIn(subjects_with_dart()), test_name);

// ---- Coordinates --------------------------------------------------------------------------------------

enum class End {
  world,
  body,
  locked
};  // of what the joint holds its body to; locked: the joint's body is, and `to` moves

struct Place {
  JointType type;
  bool angle;
  Ordinal which;
  End end;
};

std::vector<Place> places() {
  constexpr Ordinal ordinals[] = {Ordinal::first, Ordinal::second, Ordinal::third};
  std::vector<Place> all;
  for (const core::JointKind& kind : core::joint_kinds)
    for (const End end : {End::world, End::body, End::locked}) {
      for (int k = 0; k < kind.displacements(); ++k) all.push_back({kind.type, false, ordinals[k], end});
      for (int k = 0; k < kind.angles(); ++k) all.push_back({kind.type, true, ordinals[k], end});
    }
  return all;
}

const char* words_of(End end) {
  return end == End::world ? "to the world" : end == End::body ? "to a body" : "from a locked body";
}
std::string name_of_place(const Place& place) {
  constexpr const char* ordinals[] = {"first", "second", "third"};
  return fmt::format("{} {} of a {} joint {}", ordinals[static_cast<int>(place.which)],
                     place.angle ? "angle" : "displacement", core::kind_of(place.type).name,
                     words_of(place.end));
}

// Round bodies whose centres of mass lie where the joint holds them, at rest but for the coordinate, which has the rate v: it
// moves as  q'' = Q w,  and nothing else does.
core::Scene along_one_freedom(const Place& place, double v) {
  core::Scene scene = at_rest(2);
  scene.forces.clear();
  const bool alone = place.end == End::world, reversed = place.end == End::locked;
  core::Joint joint = joint_of(place.type, alone ? 0 : 1, alone ? core::world : 0);
  if (place.type == JointType::gimbal) joint.axis_2 = axis_2;  // each angle is about one axis alone
  const Vector3 far = core::held_point_of_body(joint);
  for (core::Body& one : scene.bodies)
    one.inertia = one.inertia(0, 0) * core::Matrix3::Identity(), one.initial.position = point;
  scene.bodies[alone ? 0 : 1].initial.position = far;
  scene.bodies[1].locked = reversed;
  scene.joints = {joint};
  if (alone) scene.bodies.pop_back();
  core::BodyState& moves = scene.bodies[place.end == End::body ? 1 : 0].initial;
  const double rate = reversed ? -v : v;
  if (!place.angle) {
    moves.velocity = rate * core::direction_of(joint, place.which);
    return scene;
  }
  const bool second = place.which == Ordinal::second;
  const Vector3 about = second ? *joint.axis_2 : place.which == Ordinal::third ? axis.cross(axis_2) : axis;
  moves.angular_velocity = rate * about;
  moves.velocity = moves.angular_velocity.cross(moves.position - (second ? far : point));
  if (place.type == JointType::screw) moves.velocity = joint.pitch * moves.angular_velocity;
  return scene;
}

// w: the sum of the inverse masses, or moments, of the two ends.  A screw moves both; where the two axes of a universal joint
// are apart, one end turns about the centre of mass of the other.
double inverse_inertia_of(const Place& place, const core::Scene& scene) {
  const auto sum = [&](auto size) {
    double all = 0;
    for (const core::Body& one : scene.bodies)
      if (!one.locked) all += 1 / size(one);
    return all;
  };
  const double by_mass = sum([](const core::Body& one) { return one.mass; });
  const double by_moment = sum([](const core::Body& one) { return one.inertia(0, 0); });
  const core::Joint& joint = scene.joints[0];
  if (!place.angle) return by_mass;
  if (place.type == JointType::screw) return 1 / (1 / by_moment + joint.pitch * joint.pitch / by_mass);
  if (place.type != JointType::offset_universal) return by_moment;
  const bool first = place.which == Ordinal::first;
  const double arm = joint.length * joint.length / by_mass;
  const auto moment = [&](std::size_t body) { return scene.bodies[body].inertia(0, 0); };
  if (place.end != End::body) return 1 / (moment(0) + ((place.end == End::world) == first ? arm : 0));
  const std::size_t turns = first ? 1 : 0;
  return 1 / (moment(turns) + arm) + 1 / moment(1 - turns);
}

std::pair<double, double> value_and_rate(const Place& place, const core::Scene& scene,
                                         const core::State& state) {
  const core::HeldJoint joint = core::held_joint(scene, scene.joints[0]);
  if (place.angle)
    return {core::joint_angle(joint, place.which, state), core::joint_angle_rate(joint, place.which, state)};
  return {core::joint_displacement(joint, place.which, state),
          core::joint_displacement_rate(joint, place.which, state)};
}

// ---- Laws ---------------------------------------------------------------------------------------------

// Coordinate and rate.
using Point = std::array<double, 2>;

struct Law {
  std::string_view name;
  double v;                                      // rate at the start
  double end;                                    // [s]
  core::JointCoordinate (*acts)(double);         // of 1/w
  Point (*exact)(double);                        // since the start, of t
  void (*opposite)(core::JointCoordinate&);      // the law on its head
  double (*allowed)(const Subject&, double dt);  // at stops and of dry friction; null: smooth
};

constexpr double begin = 0.3;  // the coordinate as the scene counts it
constexpr double pull = 7, way = 0.35, after = 0.4, little_after = 0.06, part = 0.6;  // of stops
const double hit = std::sqrt(2 * way / pull), speed = pull * hit;
constexpr double brake = 2.6, slip = 1.3;   // of dry friction
constexpr double tempo = 3.1, reach = 0.4;  // of springs: rad/s, and from the rest value
constexpr double loss = 1.9, shove = 1.1;   // of dampers: 1/s and 1/m, and a rate
constexpr double beat = 4.3, swing = 0.3, phase = 0.7, ease = 0.4;  // of servos; ease: their damping ratio
constexpr double smooth_end = 0.6;

core::JointCoordinate stop(double inertia, double side, double e) {
  core::JointCoordinate c{.start = begin, .restitution = e, .force = side * pull * inertia};
  c.lower = begin - (side < 0 ? way : 1.4), c.upper = begin + (side > 0 ? way : 1.4);
  return c;
}

// Forced by  u = W^2 target + 2 d W target',  d = ease, W = tempo:  q = Re(X e^{i(B t + phase)}) - the same at rest, of
// e^{-d W t}.  From rest at 0 where the target is  swing cos(B t + phase).
Point of_servo(double t) {
  const double d = ease * tempo, w = std::sqrt(tempo * tempo - d * d);
  // X = S (W^2 + 2 i d B)/(W^2 - B^2 + 2 i d B)
  const double re = tempo * tempo - beat * beat, im = 2 * d * beat, size = re * re + im * im;
  const double x = swing * (tempo * tempo * re + im * im) / size,
               y = swing * (im * re - tempo * tempo * im) / size;
  const auto steady = [&](double at) {
    const double c = std::cos(beat * at + phase), s = std::sin(beat * at + phase);
    return Point{x * c - y * s, -beat * (x * s + y * c)};
  };
  const Point now = steady(t), first = steady(0);
  // What is left falls as  e^{-d t} (a cos w t + b sin w t),  -first at t = 0.
  const double a = -first[0], b = (-first[1] + d * a) / w;
  const double c = std::cos(w * t), s = std::sin(w * t), falls = std::exp(-d * t);
  return {now[0] + falls * (a * c + b * s), now[1] + falls * ((b * w - d * a) * c - (a * w + d * b) * s)};
}

double at_a_stop(const Subject& subject, double e, double s, double dt) {
  const double grid = locates_events(subject) ? 0 : on_the_grid(e, speed, pull, s, dt) + (1 + e) * pull * dt;
  return grid + (is_soft(subject) ? soft_stop(pull) : 0);
}

const Law laws[] = {
    {"stop", 0, hit + after, [](double inertia) { return stop(inertia, 1, 0); },
     [](double) {
       return Point{way, 0};
     },
     [](core::JointCoordinate& c) { c.upper = begin + 1.4; },
     [](const Subject& subject, double dt) { return at_a_stop(subject, 0, after, dt); }},
    {"bounce", 0, hit + little_after, [](double inertia) { return stop(inertia, -1, part); },
     [](double) {
       const double s = little_after;
       return Point{-way + part * speed * s - pull * s * s / 2, part * speed - pull * s};
     },
     [](core::JointCoordinate& c) { c.restitution = 1 - part; },
     [](const Subject& subject, double dt) { return at_a_stop(subject, part, little_after, dt); }},
    {"friction", slip, 2 * slip / brake,
     [](double inertia) { return core::JointCoordinate{.start = begin, .friction = brake * inertia}; },
     [](double) {
       return Point{slip * slip / (2 * brake), 0};
     },
     [](core::JointCoordinate& c) { c.friction *= 0.8; },
     [](const Subject& subject, double dt) {
       double all = left_out(subject, brake, dt) + slow_friction(subject, dt);
       if (!locates_events(subject)) all += slip * dt / 2;
       if (is_soft(subject)) all += soft_friction(brake);
       return all;
     }},
    {"spring", 0, smooth_end,
     [](double inertia) {
       return core::JointCoordinate{
           .start = begin, .stiffness = tempo * tempo * inertia, .target = begin - reach};
     },
     [](double t) {
       return Point{reach * (std::cos(tempo * t) - 1), -reach * tempo * std::sin(tempo * t)};
     },
     [](core::JointCoordinate& c) { c.target = begin + reach; }, nullptr},
    {"damper", shove, smooth_end,
     [](double inertia) { return core::JointCoordinate{.start = begin, .damping = loss * inertia}; },
     [](double t) {
       return Point{shove / loss * (1 - std::exp(-loss * t)), shove * std::exp(-loss * t)};
     },
     [](core::JointCoordinate& c) { c.damping = 0; }, nullptr},
    {"quadratic", -shove, smooth_end,
     [](double inertia) {
       return core::JointCoordinate{.start = begin, .quadratic_damping = loss * inertia};
     },
     [](double t) {
       return Point{-std::log(1 + loss * shove * t) / loss, -shove / (1 + loss * shove * t)};
     },
     [](core::JointCoordinate& c) { c.quadratic_damping = 0; }, nullptr},
    {"motor", 0, smooth_end,
     [](double inertia) { return core::JointCoordinate{.start = begin, .force = -pull / 4 * inertia}; },
     [](double t) {
       return Point{-pull / 8 * t * t, -pull / 4 * t};
     },
     [](core::JointCoordinate& c) { c.force = -c.force; }, nullptr},
    {"servo", 0, smooth_end,
     [](double inertia) {
       return core::JointCoordinate{.start = begin,
                                    .stiffness = tempo * tempo * inertia,
                                    .damping = 2 * ease * tempo * inertia,
                                    .target = begin,
                                    .target_amplitude = swing,
                                    .target_frequency = beat,
                                    .target_phase = phase};
     },
     of_servo, [](core::JointCoordinate& c) { c.target_amplitude = -swing; }, nullptr},
};

core::Scene scene_of(const Place& place, const Law& law, bool on_its_head = false) {
  core::Scene scene = along_one_freedom(place, law.v);
  core::JointCoordinate c = law.acts(1 / inverse_inertia_of(place, scene));
  c.which = place.which;
  if (on_its_head) law.opposite(c);
  if (place.angle)
    scene.joints[0].angles = {{c}};
  else
    scene.joints[0].displacements = {{c}};
  return scene;
}

// Fewer in Node, where they take long.
std::int64_t steps_of(const Subject& subject, const Law& law) {
  constexpr std::string_view in_node[] = {"jolt", "rapier", "mujoco3", "crashcat", "physx"};
  const bool slow = std::ranges::any_of(
      in_node, [&](std::string_view id) { return std::string_view(subject.id).starts_with(id); });
  return std::llround(law.end * (slow ? 400 : 1000));
}

// The largest size of the k-th time derivative of an exact motion, by differences.
double derivative(const Law& law, int k) {
  constexpr int points = 60;
  std::vector<Point> d;
  for (int i = 0; i <= points; ++i) d.push_back(law.exact(law.end * i / points));
  for (int i = 0; i < k; ++i) {
    for (std::size_t j = 0; j + 1 < d.size(); ++j)
      for (std::size_t n = 0; n < 2; ++n) d[j][n] = (d[j + 1][n] - d[j][n]) * points / law.end;
    d.pop_back();
  }
  double most = 0;
  for (const Point& one : d) most = std::max(most, std::hypot(one[0], one[1]));
  return most;
}

// As adapters_joint_laws_test.cc: a step of a scheme of order p adds  dt^(p+1) |y^(p+1)|/(p+1)!  at most where y is its Taylor
// polynomial, ten times that where the scheme is Runge-Kutta's.
double allowed_of(const Subject& subject, const Law& law) {
  const double dt = law.end / static_cast<double>(steps_of(subject, law));
  // Rates are compared as well, and reach `speed` at a stop: a rounding is of the largest number.
  const double largest = law.allowed ? speed : std::max(1.0, derivative(law, 0));
  double allowed = largest * event_rounding(subject, 2 * steps_of(subject, law));
  // DART takes a turn from a matrix by an arc cosine, which small angles lose to the root of a rounding.
  if (std::string_view(subject.id) == "dart") allowed += 4 * std::sqrt(2 * subject.unit());
  if (law.allowed) return allowed + law.allowed(subject, dt);
  const int p = subject.order;
  const double taylor = law.end * std::pow(dt, p) * derivative(law, p + 1) / std::tgamma(p + 2);
  return allowed + (p > 1 ? 10 * taylor : taylor);
}

// ---- Refusals -----------------------------------------------------------------------------------------

// Engines, kinds of joints or their coordinates, laws and ends, in words; none are all.  The first row that holds says what is
// refused, and why.
struct Row {
  std::string_view engines, joints, laws, ends;
  std::string_view reason;  // a part of it
};

constexpr std::string_view held = "stop bounce friction";
constexpr std::string_view of_rigid = "bullet bullet-float";
constexpr std::string_view of_multibody = "bullet-multibody bullet-multibody-float";
constexpr std::string_view in_node =
    "jolt rapier rapier-deterministic rapier-simd crashcat physx";  // and MuJoCo 3, which is as MuJoCo

constexpr Row refused[] = {
    {"simbody", "", "stop bounce", "", "(joint_limits)"},
    {"simbody", "", "friction", "", "(joint_friction)"},
    {"ode ode-quick", "planar", "", "", "(planar_joints)"},
    {"rapier rapier-deterministic rapier-simd", "universal", "", "", "(universal_joints)"},
    {"ode ode-quick mujoco mujoco3", "screw", "", "", "(screw_joints)"},
    {of_rigid, "screw", "", "", "(screw_joints)"},
    {of_multibody, "screw", "", "", "(screw_joints)"},
    {in_node, "screw", "", "", "(screw_joints)"},
    {"simbody ode ode-quick dart", "rectangular", "", "", "(rectangular_joints)"},
    {"simbody ode ode-quick dart", "offset_universal", "", "", "(offset_universal_joints)"},
    {of_rigid, "offset_universal", "", "", "(offset_universal_joints)"},
    {of_multibody, "offset_universal", "", "", "(offset_universal_joints)"},
    {in_node, "offset_universal", "", "", "(offset_universal_joints)"},

    {"ode ode-quick", "gimbal", held, "", "ODE's ball has no limits and no friction"},

    {of_rigid, "gimbal", held, "", "which Bullet holds as a ball"},
    {of_rigid, "planar rectangular", "", "body", "pushes each of two moving bodies at its own point"},
    {of_rigid, "planar-displacement rectangular-displacement", held, "locked",
     "the stops and the friction of the"},
    {of_multibody, "cylindrical rectangular universal", "", "",
     "btMultiBody has no joint of these two freedoms"},
    {of_multibody, "planar gimbal", held, "", "limits and motors are of joints with one freedom"},
    {of_multibody, "", "bounce", "", "btMultiBody's limits have no restitution"},

    {"dart", "cylindrical", "", "", "DART has no joint that turns about an axis and slides along it"},
    {"dart", "", "bounce", "", "DART has no restitution there"},
    {"dart", "planar-displacement", "stop friction", "locked",
     "hangs 'a' from it, and the displacements that DART holds are of the parent's axes"},

    {"mujoco", "", "bounce", "", "MuJoCo has no coefficient of restitution"},
    {"mujoco3", "", "bounce", "", "MuJoCo has no restitution of limits"},
    {"mujoco mujoco3", "planar rectangular", "", "locked",
     "hangs 'a' from it, and MuJoCo's displacements are of the parent's axes"},

    {in_node, "", "bounce", "", "has no restitution of limits"},
    {in_node, "cylindrical planar universal gimbal rectangular", "stop", "",
     "has limits, which this adapter gives"},
    {in_node, "cylindrical planar universal gimbal rectangular", "friction", "",
     "has dry friction, which this adapter gives"},
};

bool among(std::string_view word, std::string_view words) {
  if (words.empty()) return true;
  std::istringstream all{std::string(words)};
  for (std::string one; all >> one;)
    if (one == word) return true;
  return false;
}

const Row* row_of(const Subject& subject, const Place& place, const Law& law) {
  const std::string_view id = subject.id, kind = core::kind_of(place.type).name;
  constexpr std::string_view ends[] = {"world", "body", "locked"};
  const std::string part_of_joint = fmt::format("{}-{}", kind, place.angle ? "angle" : "displacement");
  for (const Row& row : refused)
    if (among(id.substr(0, id.find('/')), row.engines) &&
        (among(kind, row.joints) || among(part_of_joint, row.joints)) && among(law.name, row.laws) &&
        among(ends[static_cast<int>(place.end)], row.ends))
      return &row;
  return nullptr;
}

// ---- Tests --------------------------------------------------------------------------------------------

// Springs, dampers and motors are the same force of most adapters, whose ends take turns; stops and dry friction are the
// engine's own.
bool is_looked_at(const Place& place, std::size_t law) {
  if (laws[law].allowed) return true;
  const std::size_t turn = law + static_cast<std::size_t>(place.which) + static_cast<std::size_t>(place.type);
  return turn % 3 == static_cast<std::size_t>(place.end);
}

// The state at the end, or why there is none.
struct Outcome {
  std::optional<core::State> last;
  std::string reason;
};
Outcome outcome_of(const Subject& subject, const core::Engine& engine, const core::Scene& scene,
                   const Law& law) {
  if (const auto reason = core::not_known(engine, scene)) return {{}, *reason};
  process::RunRequest request;
  request.scene = &scene;
  request.steps = request.every = steps_of(subject, law);
  request.setup.dt = law.end / static_cast<double>(request.steps);
  const process::RunOutcome outcome = process::run(subject.choice(), request, limits);
  if (!outcome.recording) return {{}, outcome.reason};
  return {outcome.recording->states.back(), ""};
}

double off(const Place& place, const Law& law, const core::Scene& scene, const core::State& state) {
  const auto [value, rate] = value_and_rate(place, scene, state);
  const Point exact = law.exact(law.end);
  return std::max(std::abs(value - exact[0]), std::abs(rate - exact[1]));
}

TEST_P(JointCoordinates, FollowEachLaw) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  for (std::size_t i = 0; i < std::size(laws); ++i) {
    const Law& law = laws[i];
    const double allowed = allowed_of(subject(), law);
    for (const Place& place : places()) {
      if (!is_looked_at(place, i)) continue;
      const std::string what = fmt::format("{}, {}, {}", law.name, name_of_place(place), subject().id);
      const core::Scene scene = scene_of(place, law);
      const Row* row = row_of(subject(), place, law);
      const Outcome one = outcome_of(subject(), engine, scene, law);
      if (row)
        EXPECT_TRUE(!one.last && one.reason.find(row->reason) != std::string::npos)
            << what << ": " << (one.last ? "not refused" : one.reason);
      else
        EXPECT_TRUE(one.last) << what << ": " << one.reason;
      if (one.last) expect_within(what, off(place, law, scene, *one.last), allowed);
    }
  }
}

// The same with a law on its head is told from it: another side, sign, size or none.
TEST_P(JointCoordinates, FollowNoOtherLaw) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  for (std::size_t i = 0; i < std::size(laws); ++i)
    for (const Place& place : places()) {
      const bool first = place.which == Ordinal::first && place.end == End::locked;
      if (!first || (i + static_cast<std::size_t>(place.type)) % 2 != 0) continue;
      const Law& law = laws[i];
      if (row_of(subject(), place, law)) continue;
      const core::Scene scene = scene_of(place, law, true);
      const Outcome one = outcome_of(subject(), engine, scene, law);
      ASSERT_TRUE(one.last) << one.reason;
      EXPECT_GT(off(place, law, scene, *one.last), 10 * allowed_of(subject(), law))
          << law.name << ", " << name_of_place(place) << ", " << subject().id;
    }
}

TEST(JointCoordinatesAlone, EachRowOfRefusalsHolds) {
  std::set<const Row*> hold;
  for (const Subject& subject : subjects_with_dart())
    for (const Place& place : places())
      for (std::size_t i = 0; i < std::size(laws); ++i)
        if (is_looked_at(place, i)) hold.insert(row_of(subject, place, laws[i]));
  for (const Row& row : refused) EXPECT_TRUE(hold.contains(&row)) << row.engines << ": " << row.reason;
}

// The scenes are what they say.
TEST(JointCoordinatesAlone, BeginAtTheRateOfTheLaw) {
  for (const Law& law : laws)
    for (const Place& place : places()) {
      const core::Scene scene = scene_of(place, law);
      const auto [value, rate] = value_and_rate(place, scene, core::initial_state(scene));
      EXPECT_NEAR(value, 0, 1e-15) << name_of_place(place);
      EXPECT_NEAR(rate, law.v, 1e-14) << law.name << ", " << name_of_place(place);
      if (law.allowed) continue;
      // q' is the rate of q.
      const double t = law.end, h = 1e-5;
      EXPECT_NEAR((law.exact(t + h)[0] - law.exact(t - h)[0]) / (2 * h), law.exact(t)[1], 1e-9) << law.name;
      EXPECT_NEAR(law.exact(0)[0], 0, 1e-15) << law.name;
      EXPECT_NEAR(law.exact(0)[1], law.v, 1e-15) << law.name;
    }
}

}  // namespace
}  // namespace cylon::conformance
