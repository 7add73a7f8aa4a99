// The hunt: scenes that are valid by construction, oracles that accuse no right engine, a shrinker that keeps the
// fault, and cards.
#include "harness/hunt/hunt.h"

#include "harness/core/input_error.h"
#include "harness/core/observable.h"
#include "harness/core/size.h"
#include "harness/hunt/dice.h"
#include "harness/hunt/oracle.h"
#include "harness/hunt/recorded.h"
#include "harness/hunt/sensitivity.h"
#include "harness/hunt/shrink.h"
#include "harness/process/engine_table.h"
#include "harness/process/sandbox.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/writer.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <set>

namespace cylon::hunt {
namespace {

process::EngineChoice engine(const std::string& id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

Quarry quarry(const std::string& id, int jobs = 2, Memory* memory = nullptr) {
  return {engine(id), {.run_seconds = 20}, jobs, memory};
}

// From this scene of seed 1 on, some of 8 show that Bullet has no gyroscopic term.
constexpr std::uint64_t first_faulty = 10;

std::function<bool(std::uint64_t)> scenes(std::uint64_t count) {
  return [=](std::uint64_t begun) { return begun < count; };
}

// ---- Scenes -----------------------------------------------------------------------------------------------

TEST(HuntedScenes, AreAcceptedByTheReader) {
  std::map<std::string, int, std::less<>> seen;
  for (std::uint64_t n = 0; n < 4000; ++n) {
    const Generated made = generate(3, n);
    ++seen[made.family];
    const std::string text = to_toml(made.trial, "");
    ASSERT_NO_THROW(static_cast<void>(scenario::parse(text, "hunted.toml"))) << n << '\n' << text;
  }
  for (const Family& family : families()) EXPECT_GT(seen[std::string(family.name)], 50) << family.name;
}

// Bodies begin apart from each other and from planes, or lie on what is below them.
TEST(HuntedScenes, BeginWithoutOverlap) {
  int asked = 0;
  for (std::uint64_t n = 0; n < 800; ++n) {
    const Generated made = generate(4, n);
    const core::Scene& scene = made.trial.scene;
    const core::State start = core::initial_state(scene);
    for (const core::Pair& pair : core::touching_pairs(scene)) {
      if (core::gap_undefined(scene, pair)) continue;
      const double size = core::size(scene.bodies[static_cast<std::size_t>(pair.body)]);
      EXPECT_GE(core::gap(scene, pair, start), -1e-9 * size) << made.family << ' ' << n;
      ++asked;
    }
  }
  EXPECT_GT(asked, 800);
}

// Lengths from a tenth of a millimetre to a kilometre, and steps that fit them.
TEST(HuntedScenes, AreFarFromOneNowAndThen) {
  double smallest = 1, largest = 1;
  for (std::uint64_t n = 0; n < 400; ++n) {
    const Trial trial = generate(6, n).trial;
    for (const core::Body& body : trial.scene.bodies) {
      smallest = std::min(smallest, core::size(body)), largest = std::max(largest, core::size(body));
    }
  }
  EXPECT_LT(smallest, 1e-3);
  EXPECT_GT(largest, 100);
}

TEST(HuntedScenes, AreFunctionsOfSeedAndNumber) {
  const auto text = [](std::uint64_t seed, std::uint64_t n) { return to_toml(generate(seed, n).trial, ""); };
  EXPECT_EQ(text(1, 5), text(1, 5));
  std::set<std::string> different;
  for (std::uint64_t seed = 0; seed < 10; ++seed)
    for (std::uint64_t n = 0; n < 10; ++n) different.insert(text(seed, n));
  EXPECT_EQ(different.size(), 100u);
}

// mt19937_64 is in the standard to the last bit, and so are these.
TEST(HuntedScenes, AreTheSameOnEveryMachine) {
  Dice dice(1, 0);
  std::vector<double> numbers;
  for (int i = 0; i < 4; ++i) numbers.push_back(dice.between(-1, 1));
  Dice again(1, 0);
  for (const double x : numbers) {
    EXPECT_EQ(again.between(-1, 1), x);
    EXPECT_EQ(rounded(x, 3), x);
  }
  EXPECT_EQ(rounded(0.0123456, 3), 0.0123);
  EXPECT_EQ(rounded(-98765, 1), -100000);
  EXPECT_EQ(rounded(0, 2), 0);
}

// ---- Oracles ----------------------------------------------------------------------------------------------

// A claim that the reader refuses is left out of every scene, and with it those beside it: angles with a relative tolerance once
// were, so that no scene was held against its certified solution.
TEST(HuntOracles, AreClaimsThatTheReaderTakes) {
  for (const Oracle& oracle : oracles()) {
    if (oracle.claim.empty()) continue;
    int defined = 0, taken = 0;
    for (std::uint64_t n = 0; n < 400 && taken < 3; ++n) {
      const Trial trial = generate(5, n).trial;
      if (oracle.undefined_in(trial.scene)) continue;
      ++defined;
      try {
        scenario::Scenario scenario = scenario::read(to_toml(trial, claim_of(oracle)), "hunted.toml");
        taken += scenario::prepare_soon(scenario);
      } catch (const core::InputError& error) {
        EXPECT_EQ(std::string(error.what()).find("tolerance"), std::string::npos)
            << oracle.name << ": " << error.what();
      }
    }
    EXPECT_EQ(taken, 3) << oracle.name << ", of " << defined << " scenes";
  }
}

// The oracle of locked bodies never spoke: no scene had one.
TEST(HuntOracles, HaveSomethingToSayOfSomeScene) {
  for (const Oracle& oracle : oracles()) {
    bool defined = false;
    for (std::uint64_t n = 0; n < 400 && !defined; ++n)
      defined = !oracle.undefined_in(generate(5, n).trial.scene);
    EXPECT_TRUE(defined) << oracle.name;
  }
}

TEST(Hunt, AccusesNoRightEngine) {
  const Found found = search(Source(11), 0, quarry("in-house"), scenes(120));
  EXPECT_EQ(found.scenes, 120u);
  for (const Hit& hit : found.hits)
    ADD_FAILURE() << "scene " << hit.number << " (" << hit.family << "): " << hit.broken[0].oracle;
}

std::string told(const Found& found) {
  std::string text = std::to_string(found.scenes) + '\n';
  for (const Hit& hit : found.hits) {
    text += std::to_string(hit.number);
    for (const Broken& one : hit.broken) text += fmt::format(" {} {}", one.oracle, name(one.kind));
    text += '\n';
  }
  return text;
}

TEST(Hunt, FindsTheSameForAnyNumberOfJobs) {
  const auto found = [](int jobs) {
    return told(search(Source(1), first_faulty, quarry("bullet/gyro=none", jobs), scenes(8)));
  };
  const std::string one = found(1);
  EXPECT_NE(one, "8\n");
  EXPECT_EQ(found(3), one);
}

// What --minutes does: whatever stops it, the scenes that were asked have no gap, and give the findings of --count.
TEST(Hunt, EndsAtASceneAndLeavesNoGap) {
  std::uint64_t most = 0;
  const Found found =
      search(Source(1), first_faulty, quarry("bullet/gyro=none", 3), [&](std::uint64_t begun) {
        most = std::max(most, begun);
        return begun < 5;
      });
  EXPECT_EQ(most, 5u);
  EXPECT_EQ(told(found), told(search(Source(1), first_faulty, quarry("bullet/gyro=none", 1), scenes(5))));
}

// Remembers, and counts what it is told.
class Notes final : public Memory {
 public:
  std::optional<Hit> asked(std::uint64_t number) override {
    const auto at = hits.find(number);
    return at == hits.end() ? std::nullopt : std::optional(at->second);
  }
  void note(const Hit& hit) override { EXPECT_TRUE(hits.emplace(hit.number, hit).second) << hit.number; }
  std::optional<Trial> least(const std::string& group) override {
    const auto at = trials.find(group);
    return at == trials.end() ? std::nullopt : std::optional(at->second);
  }
  void note(const std::string& group, const Trial& least) override {
    EXPECT_TRUE(trials.emplace(group, least).second);
  }
  std::map<std::uint64_t, Hit> hits;
  std::map<std::string, Trial> trials;
};

TEST(Hunt, AsksNoSceneTwice) {
  Notes notes;
  const std::string whole =
      told(search(Source(1), first_faulty, quarry("bullet/gyro=none", 2, &notes), scenes(8)));
  EXPECT_EQ(notes.hits.size(), 8u);
  notes.hits.erase(first_faulty + 1), notes.hits.erase(first_faulty + 7);
  EXPECT_EQ(told(search(Source(1), first_faulty, quarry("bullet/gyro=none", 2, &notes), scenes(8))), whole);
  EXPECT_EQ(notes.hits.size(), 8u);  // note() fails where a scene comes again
}

// Scenes are run one after another in one process: what an engine makes of a second one is no fault of the scene.
TEST(Hunt, SeesHitsAgainInProcessesOfTheirOwn) {
  Quarry once = quarry("in-house", 1);
  once.engine.id = "once";
  once.engine.row.command.insert(once.engine.row.command.begin(),
                                 {"python3", std::string(source_dir) + "/tests/harness/hunt/once_worker.py"});
  const Found found = search(Source(11), 0, once, scenes(1));
  EXPECT_EQ(told(found), "1\n");
  EXPECT_EQ(found.after_others, (std::vector<std::uint64_t>{0}));
  EXPECT_TRUE(search(Source(11), 0, quarry("in-house", 1), scenes(1)).after_others.empty());
}

Trial sliding_box() {
  Trial trial;
  core::Body box;
  box.name = "b1", box.shape = core::Box{{0.3, 0.2, 0.25}}, box.mass = 2, box.collide = true;
  box.inertia = core::Vector3(0.0683, 0.102, 0.0867).asDiagonal();
  box.initial.position = {0, 0.2, 0}, box.initial.velocity = {1.5, 0, 0.9};
  trial.scene.bodies = {box};
  trial.scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
  trial.scene.planes = {core::Plane{"floor", {0, 1, 0}, 0, {}, {}}};
  core::Material all;
  all.between[0] = all.between[1] = "*", all.friction = 0.3;
  trial.scene.materials = {all};
  trial.step = 0.005, trial.steps = 60;
  return trial;
}

// Rotation about an axis that is none of inertia's, without the gyroscopic term: angular momentum turns with the body.
TEST(Hunt, FindsTheGyroscopicTermThatBulletLeavesOut) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.mass = 1, body.shape = core::Box{{0.1, 0.3, 0.2}};
  body.inertia = core::Vector3(0.0433, 0.0167, 0.0333).asDiagonal();
  body.initial.angular_velocity = {1, 6, 2};
  trial.scene.bodies = {body};
  std::set<std::string> broken;
  for (const Fault& fault : examine(trial, engine("bullet/gyro=none"), {}).faults)
    broken.insert(fault.oracle);
  EXPECT_TRUE(broken.contains("angular momentum"));
  EXPECT_TRUE(examine(trial, engine("in-house"), {}).faults.empty());
}

// A body that falls through the floor, which is not in its mask: in steps of 0.02 s it and its copy far away may meet, and the
// in-house engine says that it moves them in steps of order 1 from then on.
TEST(Hunt, HoldsNoPromiseThatTheEngineTakesBack) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.shape = core::Cylinder{0.0895, 0.179}, body.mass = 21.9, body.collide = true;
  body.inertia = core::Vector3(0.10233, 0.087712, 0.10233).asDiagonal();
  body.initial.position = {0, 1.385, 0}, body.initial.velocity = {0.343, -0.929, -0.797};
  body.initial.orientation = core::Quaternion(-0.381, -0.152, -0.831, -0.377).normalized();
  body.initial.angular_velocity = {-3.94, -2.09, 3.98};
  body.collision_groups = body.collision_mask = {"one"};
  trial.scene.bodies = {body};
  core::Plane floor;
  floor.name = "floor", floor.collision_groups = {"two"};
  trial.scene.planes = {floor};
  trial.scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
  trial.scene.materials = {core::Material{{"*", "*"}, 0.9, 1}};
  trial.step = 0.02, trial.steps = 40;
  for (const Fault& fault : examine(trial, engine("in-house"), {}).faults) ADD_FAILURE() << fault.oracle;
}

TEST(Hunt, BrakesWhatSlidesByFriction) {
  Trial trial = sliding_box();
  trial.scene.materials[0].friction = 0.3;
  EXPECT_TRUE(examine(trial, engine("in-house"), {}).faults.empty());
  // A motion with another coefficient, read in this scene.
  const auto end = [&](double friction) {
    Trial other = trial;
    other.scene.materials[0].friction = friction;
    process::RunRequest request;
    request.scene = &other.scene, request.setup.dt = trial.step, request.steps = trial.steps;
    return process::run(engine("in-house"), request).recording.value();
  };
  const Reading right = read_slide(trial.scene, end(0.3)).value(),
                wrong = read_slide(trial.scene, end(0.31)).value();
  EXPECT_LT(right.measured, 1e-6 * right.scale);
  EXPECT_GT(wrong.measured, 1e-2 * wrong.scale);
}

TEST(Hunt, LeavesWhatAnEngineRefuses) {
  Trial trial = sliding_box();
  trial.scene.bodies[0].shape = core::Disc{0.2};
  trial.scene.frame = core::Frame{{}, {0, 1, 0}};
  const Examined examined = examine(trial, engine("ode"), {});
  EXPECT_TRUE(examined.refused);
  EXPECT_TRUE(examined.faults.empty());
  EXPECT_FALSE(examine(sliding_box(), engine("ode"), {}).refused);
}

// Simbody puts velocities on a joint within its own tolerance, so that the second half of a split run begins with others by
// 1e-8 than the first half ended with: it was a fault of the relation.
TEST(Hunt, LeavesARestatementThatStartsFromAnotherState) {
  const process::EngineChoice simbody = engine("simbody");
  if (process::missing(simbody.row)) GTEST_SKIP() << *process::missing(simbody.row);
  Trial trial;
  for (const core::Vector3& at :
       {core::Vector3(-0.5899625060150177, -0.6333066901304067, -0.5008661275556068),
        core::Vector3(-0.6418905232033393, 0.057687642176343035, -1.221858716803817)}) {
    core::Body body;
    body.name = fmt::format("b{}", trial.scene.bodies.size() + 1);
    body.shape = core::Sphere{0.3}, body.inertia = 0.036 * core::Matrix3::Identity();
    body.initial.position = at;
    trial.scene.bodies.push_back(body);
  }
  core::Joint hinge, distance;
  hinge.type = core::JointType::hinge, hinge.body = 0, hinge.point = {0, 0, -1}, hinge.axis = {1, 0, 0};
  distance.type = core::JointType::distance, distance.body = 1, distance.to = 0, distance.length = 1;
  trial.scene.joints = {hinge, distance};
  trial.scene.forces = {core::UniformGravity{{0, -10, 0}}};
  trial.step = 0.02, trial.steps = 12;
  for (const Fault& fault : examine(trial, simbody, {}).faults)
    ADD_FAILURE() << fault.oracle << ": " << fault.detail;
}

// Scenes that an engine refuses were counted as asked: "0 of 300 scenes with a fault" of an engine that was asked 137.
TEST(Hunt, CountsWhatAnEngineRefuses) {
  std::uint64_t refused = 0;
  for (std::uint64_t n = 0; n < 48; ++n)
    refused += examine(Source(1).scene(n).trial, engine("ode"), {}).refused;
  const Found found = search(Source(1), 0, quarry("ode"), scenes(48));
  EXPECT_GT(refused, 0u);
  EXPECT_LT(refused, found.scenes);
  EXPECT_EQ(found.refused, refused);
}

// Truncation falls with the step and is no fault, however large: a first-order engine on a fast spring.
TEST(Hunt, TakesTruncationForNoFault) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.mass = 1, body.shape = core::Sphere{0.2};
  body.inertia = 0.016 * core::Matrix3::Identity();
  body.initial.position = {1, 0.3, 0}, body.initial.velocity = {0, 1, 0.4};
  trial.scene.bodies = {body};
  trial.scene.forces = {core::Spring{0, {0, 0, 0}, core::world, {0, 0, 0}, 100, 0.4, 0}};
  trial.step = 0.01, trial.steps = 100;
  for (const char* id :
       {"bullet", "ode", "in-house/integrator=lie-trotter", "in-house/integrator=explicit-euler"})
    for (const Fault& fault : examine(trial, engine(id), {}).faults)
      ADD_FAILURE() << id << ": " << fault.oracle;
}

// A scheme of first order lets the energy of a spring swing; a damper takes more than that at half the step, where no rise is
// left: no error of an order falls so fast, and none of it is the coarse step's fault.
TEST(Hunt, TakesARiseThatADamperOutweighsForNoFault) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.shape = core::Sphere{0.4}, body.inertia = 0.064 * core::Matrix3::Identity();
  trial.scene.bodies = {body};
  trial.scene.forces = {core::Spring{0, {0, 0, 0}, core::world, {1, 0, 0}, 40, 0, 0.1}};
  trial.step = 0.01, trial.steps = 40;
  for (const char* id : {"bullet", "ode"})
    for (const Fault& fault : examine(trial, engine(id), {}).faults)
      ADD_FAILURE() << id << ": " << fault.oracle << ' ' << name(fault.kind);
}

// Nothing moves and nothing acts: the rounding of a joint is no speed from nowhere.
TEST(Hunt, TakesRoundingOfWhatRestsForNoFault) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.shape = core::Sphere{0.5}, body.inertia = 0.1 * core::Matrix3::Identity();
  body.initial.orientation = core::Quaternion(-0.23, 0.639, -0.355, -0.642).normalized();
  core::Joint joint;
  joint.type = core::JointType::ball, joint.body = 0, joint.point = {0, 0, 1};
  trial.scene.bodies = {body}, trial.scene.joints = {joint};
  trial.step = 0.1, trial.steps = 1;
  EXPECT_TRUE(examine(trial, engine("ode"), {}).faults.empty());
  core::Recording moved;
  moved.dt = trial.step, moved.steps = {0, 1}, moved.states.assign(2, core::initial_state(trial.scene));
  moved.states[1][0].velocity.x() = 1;
  const Reading pushed = read_speed(trial.scene, moved).value();
  EXPECT_GT(pushed.measured, 1e-2 * pushed.scale);  // a push from nowhere is one
}

// ODE loses the phase of a fast spin at first order, by a radian at dt/16, and by half of it at dt/64: truncation.
TEST(Hunt, TakesALostPhaseForNoFault) {
  Trial trial;
  core::Body body;
  body.name = "b1", body.shape = core::Box{{0.157, 0.143, 0.325}};
  body.inertia = core::Vector3(0.042025, 0.043425, 0.015033).asDiagonal();
  body.initial.orientation = core::Quaternion(-0.454, 0.566, 0.2377, -0.6459).normalized();
  body.initial.angular_velocity = {0, 0, -40};
  trial.scene.bodies = {body};
  trial.step = 0.01, trial.steps = 100;
  for (const Fault& fault : examine(trial, engine("ode"), {}).faults)
    EXPECT_EQ(fault.kind, Kind::slow) << fault.oracle << ' ' << name(fault.kind);
}

TEST(Hunt, KnowsASensitiveMotion) {
  EXPECT_LT(sensitivity(sliding_box(), engine("in-house"), {}), 100);
  // A ball onto the edge of another: a millionth becomes anything.
  Trial trial;
  for (int i = 0; i < 3; ++i) {
    core::Body ball;
    ball.name = "b" + std::to_string(i + 1), ball.shape = core::Sphere{0.02}, ball.collide = true;
    ball.inertia = 0.00016 * core::Matrix3::Identity();
    ball.initial.position = {i == 2 ? -1.0 : 0.0, i == 2 ? 0.0 : 0.021 - 0.042 * i, 0};
    if (i == 2) ball.initial.velocity = {4, 0, 0};
    trial.scene.bodies.push_back(ball);
  }
  core::Material all;
  all.between[0] = all.between[1] = "*", all.restitution = 1;
  trial.scene.materials = {all};
  trial.step = 0.01, trial.steps = 60;
  EXPECT_GT(sensitivity(trial, engine("in-house"), {}), 100);
}

// ---- Shrinking and cards ------------------------------------------------------------------------------------

TEST(Shrink, KeepsTheFaultAndNothingElse) {
  // The fault: a body heavier than 2 kg, and gravity.
  const auto faulty = [](const Trial& trial) {
    return core::gravity(trial.scene).norm() > 0.5 &&
           std::ranges::any_of(trial.scene.bodies, [](const core::Body& b) { return b.mass > 2; });
  };
  int tried = 0;
  for (std::uint64_t n = 0; n < 300 && tried < 20; ++n) {
    const Trial trial = generate(9, n).trial;
    if (!faulty(trial)) continue;
    ++tried;
    const Trial least = shrink(trial, faulty);
    EXPECT_TRUE(faulty(least));
    EXPECT_EQ(least.scene.bodies.size(), 1u);
    EXPECT_EQ(least.scene.forces.size(), 1u);
    EXPECT_TRUE(least.scene.joints.empty() && least.scene.planes.empty() && least.scene.materials.empty());
    EXPECT_EQ(least.steps, 1);
    EXPECT_TRUE(least.scene.bodies[0].initial.velocity.isZero(0));
    EXPECT_TRUE(std::holds_alternative<core::Sphere>(least.scene.bodies[0].shape));
    EXPECT_EQ(to_toml(shrink(least, faulty), ""), to_toml(least, ""));  // nothing is left to do
  }
  EXPECT_EQ(tried, 20);
}

bool accepted(const Trial& trial) {
  try {
    static_cast<void>(scenario::parse(to_toml(trial, ""), "shrunk.toml"));
  } catch (const core::InputError&) {
    return false;
  }
  return true;
}

TEST(Shrink, TakesAFrameAwayThatDoesNothing) {
  Trial trial = generate(9, 0).trial;
  trial.scene.frame = core::Frame{{}, {0, 1, 0}};
  const auto any = [](const Trial&) { return true; };
  EXPECT_FALSE(shrink(trial, any).scene.frame);
}

TEST(Shrink, ReferencesFollowTheirBodies) {
  // The fault: a spring between the heaviest bodies.
  for (std::uint64_t n = 0; n < 200; ++n) {
    const Generated made = generate(6, n);
    if (made.family != "springs" || made.trial.scene.bodies.size() < 4) continue;
    const auto faulty = [](const Trial& trial) {
      for (const core::Force& force : trial.scene.forces)
        if (const auto* s = std::get_if<core::Spring>(&force); s && s->to != core::world && s->stiffness > 10)
          return accepted(trial);
      return false;
    };
    if (!faulty(made.trial)) continue;
    const Trial least = shrink(made.trial, faulty);
    EXPECT_EQ(least.scene.bodies.size(), 2u) << n;
    EXPECT_EQ(least.scene.forces.size(), 1u) << n;
  }
}

// A card's command started a stranger's engine outside of the sandbox in which its fault was found.
TEST(Cards, AreAskedAgainInTheSandbox) {
  Card card;
  card.engine = "mine";
  for (const char* oracle : {"relation mirror", "energy"})
    for (const char* claim : {"", "conserves = \"energy\""}) {
      card.fault.oracle = oracle, card.fault.claim = claim;
      EXPECT_FALSE(command(card, "card.toml").starts_with("cylon --sandbox "));
      process::sandboxing() = true;
      EXPECT_TRUE(command(card, "card.toml").starts_with("cylon --sandbox ")) << command(card, "card.toml");
      process::sandboxing() = false;
    }
}

TEST(Cards, AreScenariosWhoseClaimFails) {
  const std::string subject = "bullet/gyro=none";
  const process::EngineChoice bullet = engine(subject);
  const Source source(1);
  const Found found = search(source, first_faulty, quarry(subject), scenes(8));
  Notes notes;
  const auto made = cards(source, found.hits, quarry(subject, 2, &notes), {engine("in-house")}, {});
  ASSERT_FALSE(made.empty());
  std::set<std::string> signatures;
  for (const Card& card : made) {
    EXPECT_TRUE(signatures.insert(card.signature).second) << card.signature;
    const std::string text = scenario_toml(card);
    const scenario::Scenario scenario = scenario::parse(text, "card.toml");
    EXPECT_LE(scenario.scene.bodies.size(), 3u) << text;
    const TemporaryFolder folder;
    const std::string file = folder.path() / (card.file_stem() + ".toml");
    std::ofstream(file) << text;
    const Kept kept = read_card(file);
    EXPECT_EQ(kept.engine, subject);
    EXPECT_EQ(kept.oracle, card.fault.oracle);
    EXPECT_EQ(kept.kind, card.fault.kind);
    EXPECT_EQ(kept.trial.steps, card.trial.steps);
    EXPECT_EQ(replay(kept, bullet, {}).what, Replayed::What::still_there);
    EXPECT_EQ(replay(kept, engine("in-house"), {}).what, Replayed::What::fixed);
    ASSERT_EQ(card.opinions.size(), 1u);
    EXPECT_FALSE(card.opinions[0].faulty) << text;
    EXPECT_FALSE(card.opinions[0].version.empty());
    for (const char* part : {"What should happen", "in-house", "```toml", "cylon "})
      EXPECT_NE(markdown(card).find(part), std::string::npos) << part;
  }
  // Shrunk scenes are remembered.
  const auto again = cards(source, found.hits, quarry(subject, 2, &notes), {}, {});
  ASSERT_EQ(again.size(), made.size());
  for (std::size_t i = 0; i < made.size(); ++i) EXPECT_EQ(scenario_toml(again[i]), scenario_toml(made[i]));
}

}  // namespace
}  // namespace cylon::hunt
