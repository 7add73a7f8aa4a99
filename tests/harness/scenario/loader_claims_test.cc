// Claims against exact and recorded truths, expectations, suites, the schema.
#include "harness/core/input_error.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/scenario/glob.h"
#include "harness/scenario/input.h"
#include "harness/scenario/recorded_truth.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/suite.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <toml++/toml.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace cylon;
using scenario::glob_match;
using scenario::parse;

const fs::path root = source_dir;
const std::string head =
    "duration = 0.8\nstep = 0.025\ngravity = [0, -9.81, 0]\n[[body]]\nname = \"body\"\nmass = 1\n"
    "position = [0, 1, 0]\nvelocity = [3, 4, 0.5]\n";

TEST(Claims, LabelsNameTheClaim) {
  const std::string t = "tolerance = { absolute = 1, reason = \"r\" }\n";
  const auto s = parse(head + "[[claim]]\nconserves = \"linear_momentum\"\ncomponent = \"horizontal\"\n" + t +
                           "[[claim]]\nfollows = \"projectile\"\nobservable = \"position\"\nbody = "
                           "\"body\"\nmeasure = \"end\"\nuntil = 0.5\nsample = \"step\"\n" +
                           t +
                           "[[claim]]\nfollows = \"projectile\"\nobservable = \"position\"\ntolerance = { "
                           "order = true, constant = 2, reason = \"r\" }\n",
                       "labels.toml");
  ASSERT_EQ(s.claims.size(), 3u);
  EXPECT_EQ(s.claims[0].label, "linear_momentum conserved, horizontal");
  EXPECT_EQ(s.claims[0].observable.component, core::Component::horizontal);
  EXPECT_FALSE(s.claims[0].truth);
  EXPECT_FALSE(s.claims[0].sample);
  EXPECT_EQ(s.claims[1].label, "position follows projectile, body, until 0.5, end");
  EXPECT_EQ(s.claims[1].reduction, core::Reduction::end);
  EXPECT_EQ(*s.claims[1].sample, 0);
  EXPECT_GT(s.claims[1].truth_error, 0);
  EXPECT_EQ(s.claims[2].label, "position follows projectile, order");
  EXPECT_EQ(s.claims[2].tolerance.constant, 2);
}

TEST(Claims, LeastChangeIsOneSided) {
  const std::string t = "tolerance = { relative = 0.1, reason = \"r\" }\n";
  const auto s =
      parse(head + "[[claim]]\nchanges = \"position\"\nat_least = 2.5\nbody = \"body\"\nuntil = 0.4\n" + t,
            "changes.toml");
  EXPECT_EQ(s.claims[0].label, "position changes, body, until 0.4");
  EXPECT_EQ(s.claims[0].at_least, 2.5);
  EXPECT_EQ(core::scale(s.claims[0], s.scene, s.duration), 2.5);
  for (const char* wrong : {"changes = \"position\"\n", "at_least = 1\nconserves = \"position\"\n",
                            "changes = \"event\"\nat_least = 1\n", "changes = \"position\"\nat_least = 0\n",
                            "changes = \"position\"\nat_least = 1\nconserves = \"position\"\n",
                            "changes = \"position\"\nat_least = 1\nmeasure = \"end\"\n"})
    EXPECT_THROW(parse(fmt::format("{}[[claim]]\n{}{}", head, wrong, t), "wrong.toml"), core::InputError)
        << wrong;
}

std::string error_of(const std::string& scene, const std::string& file = "wrong.toml") {
  try {
    parse(scene, file);
  } catch (const core::InputError& e) {
    return e.what();
  }
  return "";
}

// All that is required may not be allowed to be missing.
TEST(Claims, LeastChangeLeavesSomethingToChange) {
  const auto error = [](const std::string& keys, const std::string& tolerance) {
    return error_of(head + "shape = { type = \"sphere\", radius = 0.5 }\n[[claim]]\nchanges = " + keys +
                    "\nbody = \"body\"\ntolerance = { " + tolerance + ", reason = \"r\" }\n");
  };
  const std::string position = "\"position\"\nat_least = 0.5", axis = "\"orientation\"\nat_least = ";
  EXPECT_EQ(error(position, "absolute = 0.4"), "");
  EXPECT_NE(error(position, "absolute = 0.5").find("no motion at all would pass"), std::string::npos);
  EXPECT_NE(error(position, "relative = 1").find("no motion at all would pass"), std::string::npos);
  EXPECT_NE(error(axis + "3.2", "absolute = 0.1").find("at most pi"), std::string::npos);
}

// Infinitely many bounces have no count; nor has a recording without events one.
TEST(Claims, CountsNeedAllEvents) {
  const std::string start =
      "duration = 2\nstep = 0.01\ngravity = [0, -10, 0]\n[[body]]\nname = \"body\"\nmass = 1\n"
      "position = [0, 0.6, 0]\nshape = { type = \"sphere\", radius = 0.1 }\ncollide = true\n"
      "[[plane]]\nname = \"floor\"\n[[material]]\nbetween = [\"*\", \"*\"]\nfriction = 0\n";
  const auto error = [&](const std::string& restitution, const std::string& until) {
    return error_of(start + "restitution = " + restitution +
                    "\n[[claim]]\nfollows = \"bouncing_sphere\"\nobservable = \"event\"\nevent = \"bounce\"\n"
                    "quantity = \"count\"\nbody = \"body\"\n" +
                    until + "tolerance = { absolute = 0, reason = \"r\" }\n");
  };
  // It rests at sqrt(2 h/g) (1 + e)/(1 - e) = 0.949 s.
  EXPECT_NE(error("0.5", "").find("tells its events up to 0.948"), std::string::npos) << error("0.5", "");
  EXPECT_EQ(error("0.5", "until = 0.9\n"), "");
  EXPECT_EQ(error("1", ""), "");
}

// A recording without velocities holds those of the start, which are no truth.
TEST(Claims, RecordedDataMustHaveWhatIsClaimed) {
  const TemporaryFolder own;
  const fs::path& folder = own.path();
  const std::string fall = R"("trajectory":{"body":{"position":[["0","1","0"],["3","0","1"]])";
  std::ofstream(folder / "positions.json")
      << R"({"schema":"truth/1","bodies":[{"id":"body"}],"t":["0","0.8"],)" << fall << "}}}";
  std::ofstream(folder / "both.json") << R"({"schema":"truth/1","bodies":[{"id":"body"}],"t":["0","0.8"],)"
                                      << fall << R"(,"velocity":[["3","4","0"],["3","-4","0"]]}}})";
  const auto error = [&](const std::string& file, const std::string& observable) {
    return error_of(head + "[[claim]]\nfollows = { file = \"" + file + "\" }\nobservable = \"" + observable +
                        "\"\ntolerance = { absolute = 1, reason = \"r\" }\n",
                    (folder / "scene.toml").string());
  };
  EXPECT_EQ(error("positions.json", "position"), "");
  for (const char* needs : {"velocity", "linear_momentum", "kinetic_energy", "energy", "angular_momentum"}) {
    EXPECT_NE(error("positions.json", needs).find("needs 'velocity', which the file"), std::string::npos)
        << needs;
    EXPECT_EQ(error("both.json", needs), "") << needs;
  }
}

// Every engine failed, by 100 m, before its first step.
TEST(Claims, RecordedDataStartsWhereTheSceneDoes) {
  const TemporaryFolder own;
  std::ofstream(own.path() / "elsewhere.json")
      << R"({"schema":"truth/1","bodies":[{"id":"body"}],"t":["0","0.8"],)"
      << R"("trajectory":{"body":{"position":[["0","101","0"],["3","0","1"]]}}})";
  const auto error = [&](const std::string& allowed) {
    return error_of(head + "[[claim]]\nfollows = { file = \"elsewhere.json\" }\nobservable = \"position\"\n" +
                        "tolerance = { absolute = " + allowed + ", reason = \"r\" }\n",
                    (own.path() / "scene.toml").string());
  };
  EXPECT_NE(error("1").find("follows: elsewhere.json starts 10"), std::string::npos) << error("1");
  EXPECT_EQ(error("110"), "");
}

TEST(Claims, OneSidedMeasuresAreOfNumbers) {
  const std::string t = "tolerance = { relative = 0.1, reason = \"r\" }\n";
  const auto s = parse(head + "[[claim]]\nconserves = \"energy\"\nmeasure = \"increase\"\n" + t +
                           "[[claim]]\nconserves = \"velocity\"\nbody = \"body\"\ncomponent = \"y\"\n"
                           "measure = \"decrease\"\n" +
                           t,
                       "one_sided.toml");
  EXPECT_EQ(s.claims[0].label, "energy never rises");
  EXPECT_EQ(s.claims[1].label, "velocity never falls, body, y");
  EXPECT_EQ(s.claims[1].reduction, core::Reduction::decrease);
  for (const char* wrong :
       {"conserves = \"velocity\"\nmeasure = \"increase\"\n",
        "conserves = \"velocity\"\ncomponent = \"horizontal\"\nmeasure = \"increase\"\n",
        "follows = \"projectile\"\nobservable = \"velocity\"\ncomponent = \"x\"\nmeasure = \"decrease\"\n",
        "changes = \"energy\"\nat_least = 1\nmeasure = \"increase\"\n"})
    EXPECT_THROW(parse(fmt::format("{}[[claim]]\n{}{}", head, wrong, t), "wrong.toml"), core::InputError)
        << wrong;
}

// The last sample of a mean square has no weight, and at the start nothing deviates: any motion passed.
TEST(Claims, MeanSquareOfTheStartAloneIsRefused) {
  const auto claim = [](std::string_view measure, std::string_view when) {
    return fmt::format(
        "{}[[claim]]\nfollows = \"projectile\"\nobservable = \"velocity\"\nmeasure = \"{}\"\n{}\n"
        "tolerance = {{ absolute = 1, reason = \"r\" }}\n",
        head, measure, when);
  };
  for (const char* wrong :
       {"sample = 0.8", "until = 0.4\nsample = 0.4", "until = 0.4\nsample = 0.25", "until = 0.025"})
    EXPECT_THROW(parse(claim("mean_square", wrong), "wrong.toml"), core::InputError) << wrong;
  for (const char* right : {"", "sample = 0.4", "sample = 0.5", "until = 0.4\nsample = 0.2", "until = 0.05"})
    EXPECT_NO_THROW(parse(claim("mean_square", right), "right.toml")) << right;
  EXPECT_NO_THROW(parse(claim("rate", "sample = 0.8"), "right.toml"));
}

// A force that turns once in each of the parts that means are taken over was none, and the tolerance 1e-5 of itself.
TEST(Claims, ScaleOfAForceThatTurnsFastIsItsSize) {
  const double w = 2 * 3.14159265358979323846 * 25.6;
  const auto s = parse(
      fmt::format(
          "duration = 10\nstep = \"1/4096\"\n[[body]]\nname = \"b\"\nmass = 1\ninertia = [0.01, 0.01, 0.01]\n"
          "position = [0.1, 0, 0]\nvelocity = [0, {}, 0]\nangular_velocity = [0, 0, {}]\n"
          "[[joint]]\nname = \"h\"\ntype = \"hinge\"\nbody = \"b\"\npoint = [0, 0, 0]\naxis = [0, 0, 1]\n"
          "[[claim]]\nfollows = \"physical_pendulum\"\nobservable = \"joint_force\"\njoint = \"h\"\n"
          "tolerance = {{ relative = 1e-2, reason = \"r\" }}\n",
          0.1 * w, w),
      "rotor.toml");
  EXPECT_NEAR(core::scale(s.claims[0], s.scene, s.duration), 0.1 * w * w, 1e-3 * w * w);
}

TEST(Claims, ExpectationsHaveALevel) {
  std::string gas =
      "duration = 1\nstep = 0.01\n[[cloud]]\nname = \"ball\"\nmass = 1\ncount = 20\nlow = [-0.9, -0.9, "
      "-0.9]\n"
      "high = [0.9, 0.9, 0.9]\nspeed = 1\nshape = { type = \"sphere\", radius = 0.05 }\n"
      "[[material]]\nbetween = [\"*\", \"*\"]\nrestitution = 1\nfriction = 0\n";
  for (const char* n : {"[1, 0, 0]", "[-1, 0, 0]", "[0, 1, 0]", "[0, -1, 0]", "[0, 0, 1]", "[0, 0, -1]"})
    gas += fmt::format("[[plane]]\nname = \"wall {}\"\nnormal = {}\noffset = -1\n", n, n);
  const auto claim = [&](const std::string& keys, const std::string& tolerance) {
    return gas + "[[claim]]\n" + keys + "\ntolerance = { " + tolerance + ", reason = \"r\" }\n";
  };
  const std::string share = "expects = \"energy_share\"", level = "level = 1e-4";
  const auto s = parse(claim(share + "\ncomponent = \"y\"\nuntil = 0.5", level), "gas.toml");
  EXPECT_EQ(s.claims[0].label, "energy_share as expected, y, until 0.5");
  EXPECT_EQ(s.claims[0].reduction, core::Reduction::end);
  EXPECT_EQ(core::scale(s.claims[0], s.scene, s.duration), 1);
  const std::pair<std::string, std::string> wrong[] = {
      {claim(share, "absolute = 0.1"), "needs 'level'"},
      {claim(share, level + ", absolute = 0.1"), "do not go with"},
      {claim("conserves = \"energy\"", level), "belongs to 'expects'"},
      {claim("conserves = \"energy_share\"", level), "belongs to 'expects'"},
      {claim("changes = \"energy_share\"\nat_least = 0.1", level), "belongs to 'expects'"},
      {claim("expects = \"energy\"", level), "does not belong"},
      {claim(share + "\nmeasure = \"max\"", level), "looks at the end"},
      {claim(share + "\nsample = \"step\"", level), "looks at the end"},
      {claim(share + "\nobservable = \"energy\"", level), "names it already"},
      {claim(share, "level = 1e-18"), "no value is that unlikely"},
      {claim(share, "level = 0.6"), "level"},
      {head + "[[claim]]\n" + share + "\ntolerance = { " + level + ", reason = \"r\" }\n", "no sphere"}};
  for (const auto& [text, why] : wrong) {
    const std::string said = error_of(text);
    EXPECT_NE(said.find(why), std::string::npos) << why << ": " << said;
  }
}

TEST(Claims, TheoryStatesARate) {
  const auto s =
      parse(head + "[theory]\nrate = 3\nuntil = 0.4\nforces = \"jumping\"\nreason = \"r\"\n", "t.toml");
  ASSERT_TRUE(s.theory);
  EXPECT_EQ(s.theory->rate, 3);
  EXPECT_EQ(s.theory->until, 0.4);
  EXPECT_EQ(s.theory->magnification, 1);
  EXPECT_EQ(s.theory->forces, scenario::Theory::Forces::jumping);
  EXPECT_FALSE(parse(head, "none.toml").theory);
  EXPECT_EQ(parse(head + "[theory]\nrate = 3\nreason = \"r\"\n", "t.toml").theory->until, 0.8);
  for (const char* wrong :
       {"rate = 0\nreason = \"r\"\n", "rate = 3\n", "reason = \"r\"\n",
        "rate = 3\nuntil = 0.9\nreason = \"r\"\n", "rate = 3\nuntil = 0.41\nreason = \"r\"\n",
        "rate = 3\nmagnification = 0.5\nreason = \"r\"\n", "rate = 3\nforces = \"wild\"\nreason = \"r\"\n"})
    EXPECT_THROW(parse(head + "[theory]\n" + wrong, "wrong.toml"), core::InputError) << wrong;
}

TEST(Claims, RecordedDataIsComparedAtItsTimes) {
  const auto s = parse(head +
                           "[[claim]]\nfollows = { file = \"truth/projectile.json\" }\nobservable = "
                           "\"position\"\nuntil = 0.4\n"
                           "tolerance = { absolute = 1e-9, reason = \"r\" }\n",
                       (root / "tests/data/recorded.toml").string());
  const core::Claim& claim = s.claims[0];
  EXPECT_EQ(claim.label, "position follows truth/projectile.json, until 0.4");
  ASSERT_EQ(claim.truth->times.size(), 17u);  // 0, 0.025, …, 0.4
  EXPECT_EQ(claim.truth->times[1], 0.025);
  EXPECT_EQ(claim.truth->state(0.025)[0].position, core::Vector3(0.075, 1.096934375, 0.0125));
  EXPECT_THROW(claim.truth->state(0.03), std::invalid_argument);
  EXPECT_LT(claim.truth_error, 1e-15);
}

// The recorded and the computed truth are independent; both belong to the shipped scene.
TEST(Claims, ShippedScenesAgreeWithRecordedTruths) {
  for (const char* name : {"projectile", "bouncing_sphere", "two_sphere_oblique", "spring_zero_length",
                           "spring_orbit", "free_symmetric_top", "dzhanibekov"}) {
    const auto s = scenario::load(root / "scenarios" / (std::string(name) + ".toml"));
    const fs::path file = root / "tests/data/truth" / (std::string(name) + ".json");
    const core::Truth recorded = scenario::parse_truth(scenario::read_file(file), file.string(), s.scene);
    EXPECT_EQ(recorded.horizon, s.duration) << name;
    for (const double t : recorded.times) {
      const core::State want = recorded.state(t), got = s.claims[0].truth->state(t);
      for (std::size_t i = 0; i < want.size(); ++i) {
        EXPECT_LT((want[i].position - got[i].position).norm(), 1e-11) << name << " at " << t;
        EXPECT_LT(want[i].orientation.angularDistance(got[i].orientation), 1e-7) << name << " at " << t;
      }
    }
  }
}

TEST(Claims, BadRecordedData) {
  const core::Scene scene = parse(head, "a.toml").scene;
  const auto refusal = [&](const std::string& json) {
    try {
      scenario::parse_truth(json, "d.json", scene);
      return std::string();
    } catch (const core::InputError& error) {
      return std::string(error.what());
    }
  };
  const std::string start = R"({"schema":"truth/1","bodies":[{"id":"body"}],)";
  EXPECT_EQ(refusal(start + R"("t":["0"],"trajectory":{"body":{"position":[["0","1e-400","2"]]}}})"), "");
  EXPECT_EQ(refusal("{"), "d.json: not JSON at byte 2");
  EXPECT_NE(refusal("[]").find("needs 'schema'"), std::string::npos);
  EXPECT_NE(refusal(R"({"schema":"truth/2"})").find("valid: \"truth/1\""), std::string::npos);
  EXPECT_NE(refusal(start + R"("t":["1","0"],"trajectory":{}})").find("times must ascend"),
            std::string::npos);
  EXPECT_NE(refusal(start + R"("t":["0"],"trajectory":{}})").find("needs 'body'"), std::string::npos);
  EXPECT_NE(refusal(start + R"("t":["0"],"trajectory":{"body":{"position":[["0","x","2"]]}}})")
                .find("no finite number"),
            std::string::npos);
  EXPECT_NE(
      refusal(start + R"("t":["0","1"],"trajectory":{"body":{"position":[["0","1","2"]]}}})").find("2 rows"),
      std::string::npos);
}

// A negative bound counted by its absolute value, and keys that were misspelt were ignored.
TEST(Claims, RecordedDataHasNoUnknownKeysAndNoNegativeBound) {
  const core::Scene scene = parse(head, "a.toml").scene;
  const auto refusal = [&](const std::string& more, const std::string& columns = "") {
    try {
      scenario::parse_truth(
          R"({"schema":"truth/1","bodies":[{"id":"body","mass":"1"}],"t":["0"],"name":"n",)" + more +
              R"("trajectory":{"body":{"position":[["0","1","2"]])" + columns + "}}}",
          "d.json", scene);
      return std::string();
    } catch (const core::InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(refusal(R"("agreement":{"max_abs_diff":"1e-9","digits":9},)"), "");
  EXPECT_EQ(refusal(R"("agreement":{"max_abs_diff":0},"events":[{"type":"note","t":"0"}],)"), "");
  EXPECT_EQ(refusal(R"("agreement":{"max_abs_diff":"-1e-9"},)"),
            "d.json: agreement.max_abs_diff = \"-1e-9\" must be >= 0");
  EXPECT_EQ(refusal(R"("agreement":1e-9,)"), "d.json: agreement = 1e-09 must be an object");
  const struct {
    std::string more, columns, says;
  } cases[] = {
      {R"("agrement":{},)", "",
       "d.json: unknown key 'agrement' = an object of 0 keys, did you mean 'agreement'?"},
      {R"("agreement":{"max_abs_dif":1},)", "",
       "d.json: unknown key 'agreement.max_abs_dif' = 1, did you mean"},
      {R"("events":[{"kind":"turn","body":"body","time":0,"sped":1}],)", "",
       "d.json: unknown key 'events.sped' = 1, did you mean 'speed'?"},
      {"", R"(,"velocty":[])", "d.json: unknown key 'trajectory.body.velocty' = an array of 0, did you mean"},
      {R"("events":[{"kind":"turn","body":"body","time":-1}],)", "",
       "d.json: events: time = -1 is not within [0, 0] s, the times of the file"},
      {R"("events":[{"kind":"turn","body":"body","time":2}],)", "",
       "d.json: events: time = 2 is not within [0, 0] s, the times of the file"},
      {R"("agreement":{"max_abs_diff":5,"max_abs_diff":0},)", "",
       R"(d.json: the key "max_abs_diff" twice in one object)"},
      {"", R"(,"velocity":[[1,null,2]])", "d.json: trajectory.body.velocity[0] holds null"},
      {"", R"(},"other":{)", "d.json: unknown key 'trajectory.other': 'bodies' has no such id"},
  };
  for (const auto& c : cases)
    EXPECT_EQ(refusal(c.more, c.columns).find(c.says), 0u) << c.says << '\n' << refusal(c.more, c.columns);
}

TEST(Glob, StarsAndQuestionMarks) {
  EXPECT_TRUE(glob_match("*", ""));
  EXPECT_TRUE(glob_match("bullet*", "bullet-float"));
  EXPECT_TRUE(glob_match("*/gyro=?one", "bullet/gyro=none"));
  EXPECT_TRUE(glob_match("a*b*c", "a-b-b-c"));
  EXPECT_TRUE(glob_match("ball[0]", "ball[0]"));
  EXPECT_FALSE(glob_match("bullet", "bullet-float"));
  EXPECT_FALSE(glob_match("?", ""));
  EXPECT_FALSE(glob_match("a*b", "a-b-c"));
  EXPECT_FALSE(glob_match("", "a"));
  EXPECT_FALSE(glob_match("*a*a*a*a*a*a*a*a*a*a*a*a*b", std::string(5000, 'a')));  // at once
}

TEST(Suite, SimBenchmarkHasThePublishedTable) {
  const auto suite = scenario::load_suite(root / "scenarios/suites/simbenchmark.toml");
  EXPECT_EQ(suite.name, "simbenchmark");
  ASSERT_EQ(suite.published.size(), 10u);
  EXPECT_EQ(suite.published[0].engine, "ode/erp=0,cfm=0");
  EXPECT_EQ(suite.published[0].dt, "0.001");
  EXPECT_EQ(suite.published[0].value, "185.027");
  EXPECT_EQ(suite.published[9].value, "7.67704e8");
  const auto scenario = scenario::load(root / "scenarios" / (suite.scenarios.at(0) + ".toml"));
  ASSERT_EQ(scenario.scene.bodies.size(), 49u);
  EXPECT_TRUE(glob_match(suite.claim, scenario.claims.at(0).label));
  EXPECT_THROW(
      scenario::parse_suite("scenarios = [\"*\"]\nengines = [\"a\"]\nsteps = [1]\n[[published]]\nengine = "
                            "\"b\"\ndt = 1\nvalue = \"1\"\nsource = \"s\"\n",
                            "s.toml"),
      core::InputError);
}

// Whether a table's keys are all known to an object schema, below it as well.
bool known(const toml::table& table, const nlohmann::json& schema);

bool known(const toml::node& node, const nlohmann::json& schema) {
  for (const char* choice : {"oneOf", "anyOf"}) {
    if (!schema.contains(choice)) continue;
    return std::any_of(schema[choice].begin(), schema[choice].end(),
                       [&](const auto& variant) { return known(node, variant); });
  }
  if (const auto* table = node.as_table()) return known(*table, schema);
  const auto* array = node.as_array();
  if (!array) return schema.value("type", "") != "object";
  for (const toml::node& entry : *array)
    if (!known(entry, schema["items"])) return false;
  return true;
}

bool known(const toml::table& table, const nlohmann::json& schema) {
  if (!schema.contains("properties")) return false;
  for (auto&& [key, node] : table)
    if (!schema["properties"].contains(std::string(key.str())) ||
        !known(node, schema["properties"][std::string(key.str())]))
      return false;
  return true;
}

TEST(Schema, KnowsTheKeysOfEveryShippedScenarioAndNoOther) {
  const auto schema = nlohmann::json::parse(scenario::schema_json());
  EXPECT_EQ(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
  for (const char* folder : {"scenarios", "scenarios/extremes"})
    for (const auto& entry : fs::directory_iterator(root / folder))
      if (entry.path().extension() == ".toml" && entry.path().stem() != "expected") {
        EXPECT_TRUE(known(toml::parse_file(entry.path().string()), schema)) << entry.path();
      }
  EXPECT_FALSE(known(toml::parse("[[body]]\nmasss = 1"), schema));
  EXPECT_FALSE(known(toml::parse("[[body]]\nshape = { type = \"sphere\", radios = 1 }"), schema));
}

}  // namespace
