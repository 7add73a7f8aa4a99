// Tolerances, plans and remarks travel through the protocol; workers that are older than these keys do not
// notice them.
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "tests/harness/process/fixture.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

using nlohmann::json;

TEST(Tolerance, IsSentOnlyWhenGiven) {
  const core::Scene scene = two_bodies();
  core::Setup setup;
  setup.dt = 0.01;
  EXPECT_FALSE(load_request(scene, setup).contains("tolerance"));
  EXPECT_FALSE(load_request(scene, setup).contains("force"));  // workers that are older than the key go on
  setup.force = true;
  EXPECT_TRUE(setup_from_json(load_request(scene, setup)).force);
  setup.force = false;
  EXPECT_FALSE(setup_from_json(load_request(scene, setup)).force);
  setup.tolerance = 3e-7;
  EXPECT_EQ(setup_from_json(load_request(scene, setup)).tolerance, 3e-7);
  for (const json& wrong : {json(0), json(-1e-6), json("small"), json(nullptr)}) {
    json request = load_request(scene, setup);
    request["tolerance"] = wrong;
    EXPECT_THROW(setup_from_json(request), std::runtime_error) << wrong;
  }
}

TEST(Tolerance, IntegratorsDeclareSupport) {
  Hello hello;
  hello.engine = {"x", "1", "double", {}, "", {{"a", 2, "", false}, {"b", 8, "all", true}}, {}};
  json message = hello_json(hello);
  const Hello back = hello_from_json(message);
  EXPECT_FALSE(back.engine.integrators[0].adaptive);
  EXPECT_TRUE(back.engine.integrators[1].adaptive);
  message["schemes"][1].erase("adaptive");  // an older worker
  EXPECT_FALSE(hello_from_json(message).engine.integrators[1].adaptive);
}

TEST(Plan, IsPartOfTheTerms) {
  core::Terms terms;
  terms.plan = {{"rotation", true, "a body spins"}, {"detection", false, "no bodies can touch"}};
  json message = terms_json(terms);
  const core::Terms back = terms_from_json(message);
  ASSERT_EQ(back.plan.size(), 2u);
  EXPECT_EQ(back.plan[0].name, "rotation");
  EXPECT_TRUE(back.plan[0].in);
  EXPECT_FALSE(back.plan[1].in);
  EXPECT_EQ(back.plan[1].reason, "no bodies can touch");
  message["plan"][0]["inn"] = true;
  EXPECT_THROW(terms_from_json(message), std::runtime_error);
  message.erase("plan");  // an older worker
  EXPECT_TRUE(terms_from_json(message).plan.empty());
}

TEST(Substeps, ArePartOfTheTermsAndOneWhereAWorkerTellsNone) {
  core::Terms terms;
  terms.substeps = 4;
  json message = terms_json(terms);
  EXPECT_EQ(terms_from_json(message).substeps, 4);
  for (const json& wrong : {json(0), json(-4), json(2.5), json("4"), json(nullptr)}) {
    message["substeps"] = wrong;
    EXPECT_THROW(terms_from_json(message), std::runtime_error) << wrong;
  }
  message.erase("substeps");  // an older worker
  EXPECT_EQ(terms_from_json(message).substeps, 1);
}

TEST(Remarks, ArriveWithEndOfRun) {
  Done done{7, 2, 5.0, 3.0, {"tolerance 1e-10 was not reached", "3e-9 was"}};
  json message = done_json(done);
  EXPECT_EQ(done_from_json(message).remarks, done.remarks);
  message["remarks"][1] = 3;
  EXPECT_THROW(done_from_json(message), std::runtime_error);
  message.erase("remarks");  // an older worker
  EXPECT_TRUE(done_from_json(message).remarks.empty());
  EXPECT_EQ(done_from_json(message).load_ns, 3.0);
  message.erase("load_ns");
  EXPECT_EQ(done_from_json(message).load_ns, 0.0);
  message["load_ns"] = -1;
  EXPECT_THROW(done_from_json(message), std::runtime_error);
}

told::Diagnostic missed() {
  return {.kind = "tolerance-missed",
          .bodies = {"ball"},
          .body_count = 1,
          .method = "events by dop853",
          .order = 8,
          .since = 0.25,
          .until = 0.75,
          .count = 3,
          .limit = 1e-10,
          .limit_unit = "1",
          .reached = 3e-9,
          .unit = "1",
          .text = "3e-9 was reached"};
}

TEST(Diagnostics, ArriveWithEndOfRun) {
  Done done{7, 2, 5.0, 3.0};
  told::Diagnostic bare;  // what a worker must tell at least
  bare.kind = "slow", bare.text = "it was slow";
  done.diagnostics = {missed(), bare};
  json message = done_json(done);
  EXPECT_EQ(done_from_json(message).diagnostics, done.diagnostics);
  message["diagnostics"][1] = {{"kind", "slow"}, {"text", "it was slow"}, {"reached", nullptr}};
  EXPECT_EQ(done_from_json(message).diagnostics, done.diagnostics);
  message.erase("diagnostics");  // an older worker
  EXPECT_TRUE(done_from_json(message).diagnostics.empty());
}

TEST(Diagnostics, AreRefusedWhereMalformed) {
  Done done{7, 2, 5.0, 3.0};
  done.diagnostics = {missed()};
  const json good = done_json(done);
  const std::pair<const char*, json> wrong[] = {{"kind", ""},
                                                {"kind", 1},
                                                {"bodies", "ball"},
                                                {"bodies", json::array({1})},
                                                {"body_count", 0},
                                                {"body_count", 1.5},
                                                {"method", 2},
                                                {"order", -1},
                                                {"since", -0.1},
                                                {"since", "0"},
                                                {"until", 0.1},
                                                {"count", 0},
                                                {"limit", "1e-10"},
                                                {"reached", json::array()},
                                                {"unit", 1},
                                                {"text", nullptr},
                                                {"text", std::string(5000, 'x')},
                                                {"strange", 1}};
  for (const auto& [key, value] : wrong) {
    json bad = good;
    bad["diagnostics"][0][key] = value;
    EXPECT_THROW(done_from_json(bad), MalformedMessage) << key << value;
  }
  for (const char* key : {"kind", "text"}) {
    json bad = good;
    bad["diagnostics"][0].erase(key);
    EXPECT_THROW(done_from_json(bad), MalformedMessage) << key;
  }
  json many = good;
  many["diagnostics"] = std::vector<json>(1001, good["diagnostics"][0]);
  EXPECT_THROW(done_from_json(many), MalformedMessage);
}

TEST(Tolerance, ReachesTheWorkerAndItsRemarksTheRecording) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 10);
  request.setup.tolerance = 0.25;
  request.setup.integrator = "controlled";
  const RunOutcome outcome = run(scripted("adaptive"), request);
  ASSERT_EQ(outcome.status, results::Status::pass) << outcome.reason;
  EXPECT_EQ(outcome.recording->remarks, std::vector<std::string>{"tolerance 0.25 was not reached: 0.5 was"});
  EXPECT_EQ(outcome.terms.plan.size(), 2u);
}

// Whatever a diagnostic names is in the scene.
TEST(Diagnostics, ReachTheRecordingOrAreRefused) {
  const core::Scene scene = two_bodies();
  const RunOutcome outcome = run(scripted("diagnoses"), request_of(scene, 10));
  ASSERT_EQ(outcome.status, results::Status::pass) << outcome.reason;
  ASSERT_EQ(outcome.recording->diagnostics.size(), 1u);
  const told::Diagnostic& told = outcome.recording->diagnostics[0];
  EXPECT_EQ(told.kind, "slow");
  EXPECT_EQ(told.bodies, std::vector<std::string>{scene.bodies[1].name});
  for (const char* mode : {"diagnoses_nobody", "diagnoses_too_many"}) {
    const RunOutcome refused = run(scripted(mode), request_of(scene, 10));
    EXPECT_EQ(refused.status, results::Status::protocol) << mode;
    EXPECT_NE(refused.reason.find("a diagnostic of"), std::string::npos) << refused.reason;
  }
}

TEST(Tolerance, IsRejectedWithoutErrorControl) {
  const core::Scene scene = two_bodies();
  const struct {
    const char *mode, *integrator, *says;
  } cases[] = {
      {"good", "", "engine 'test' has no integrator with error control"},
      {"adaptive", "", "its default integrator does not control its error"},
      {"adaptive", "stiff", "integrator 'stiff' does not control its error"},
      {"adaptive", "stiff", "(integrators that do: controlled)"},
  };
  for (const auto& c : cases) {
    RunRequest request = request_of(scene, 10);
    request.setup.tolerance = 1e-6;
    request.setup.integrator = c.integrator;
    try {
      run(scripted(c.mode), request);
      ADD_FAILURE() << c.mode << " " << c.integrator;
    } catch (const core::InputError& error) {
      EXPECT_NE(std::string(error.what()).find(c.says), std::string::npos) << error.what();
    }
    EXPECT_FALSE(has_children());
  }
  RunRequest request = request_of(scene, 10);
  request.setup.tolerance = std::nan("");
  EXPECT_THROW(run(scripted("adaptive"), request), std::invalid_argument);
}

}  // namespace
}  // namespace cylon::process
