// Claims on events and with constants of theory as a user writes them: what they become, and what is refused.
#include "harness/core/input_error.h"
#include "harness/scenario/recorded_truth.h"
#include "harness/scenario/scenario.h"

#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace {

using namespace cylon;

// Two bodies on a general orbit about each other.
const std::string orbit =
    "duration = 4.0\nstep = 0.01\n"
    "[[body]]\nname = \"bob\"\nmass = 1\ninertia = [1, 2, 3]\nposition = [1.5, 0, 0]\nvelocity = [0, 3, 0]\n"
    "[[body]]\nname = \"other\"\nmass = 2\nposition = [9, 0, 0]\nvelocity = [0, 1, 0]\n"
    "[[spring]]\nbody = \"bob\"\npin = [0, 0, 0]\nstiffness = 50\nrest_length = 1\n"
    "[[spring]]\nbody = \"other\"\npin = [8, 0, 0]\nstiffness = 20\nrest_length = 0.5\n";
const std::string event = "[[claim]]\nfollows = \"spring_orbit\"\nobservable = \"event\"\n";
const std::string within = "tolerance = { relative = 1e-3, reason = \"r\" }\n";

TEST(EventClaims, NameEventAndQuantity) {
  const auto s = scenario::parse(
      orbit + event + "event = \"apsis\"\nbody = \"bob\"\nindex = 3\nquantity = \"period\"\n" + within +
          event + "event = \"apsis\"\nbody = \"bob\"\nto = \"other\"\nquantity = \"distance\"\n" + within +
          event + "event = \"turn\"\nbody = \"bob\"\nindex = 2\nquantity = \"height\"\n" + within,
      "events.toml");
  ASSERT_EQ(s.claims.size(), 3u);
  EXPECT_EQ(s.claims[0].label, "event follows spring_orbit, apsis 3 period, bob");
  EXPECT_EQ(s.claims[1].label, "event follows spring_orbit, apsis 1 distance, bob, to other");
  EXPECT_EQ(s.claims[2].label, "event follows spring_orbit, turn 2 height, bob");
  EXPECT_EQ(s.claims[1].observable.to, 1);
  for (const core::Claim& claim : s.claims) {
    EXPECT_FALSE(claim.truth->events.empty()) << claim.label;
    EXPECT_GT(claim.truth_error, 0) << claim.label;
    EXPECT_LT(claim.truth_error, 1e-10) << claim.label;
  }
}

TEST(TheoryClaims, HaveConstantsByOrder) {
  const auto s = scenario::parse(orbit +
                                     "[[claim]]\nfollows = \"spring_orbit\"\nobservable = "
                                     "\"position\"\ntolerance = { order = true, constants = { "
                                     "1 = 4.9, 4 = 0.25 }, reason = \"r\" }\n",
                                 "theory.toml");
  EXPECT_EQ(s.claims.at(0).tolerance.constants, (std::map<int, double>{{1, 4.9}, {4, 0.25}}));
}

struct Bad {
  const char* name;
  std::string text, message;
};
void PrintTo(const Bad& bad, std::ostream* out) { *out << bad.name; }

const std::string conserves = "[[claim]]\nfollows = \"spring_orbit\"\nobservable = \"position\"\n";
const Bad bad[] = {
    {"kind", event + "event = \"apsids\"\n" + within, "event = 'apsids' is unknown, did you mean 'apsis'?"},
    {"quantity", event + "event = \"apsis\"\nquantity = \"speed\"\n" + within,
     "quantity = 'speed', but event = 'apsis' has none; valid: time, distance, period"},
    {"even_period", event + "event = \"apsis\"\nbody = \"bob\"\nindex = 4\nquantity = \"period\"\n" + within,
     "index = 4: the period is a mean over whole periods of two"},
    {"no_index", event + "event = \"apsis\"\nbody = \"bob\"\nquantity = \"period\"\n" + within,
     "index = 1: the period"},
    {"index", event + "event = \"apsis\"\nbody = \"bob\"\nindex = 0\n" + within, "count from 1"},
    {"beyond", event + "event = \"apsis\"\nbody = \"bob\"\nindex = 99\n" + within,
     "'spring_orbit' has no apsis 99 with a time up to 4 s"},
    {"to", event + "event = \"turn\"\nto = \"other\"\n" + within, "to belongs to event = \"apsis\""},
    {"to_and_about", event + "event = \"apsis\"\nto = \"other\"\nabout = [1, 0, 0]\n" + within,
     "about does not go with 'to'"},
    {"to_itself", event + "event = \"apsis\"\nbody = \"bob\"\nto = \"bob\"\n" + within,
     "has no distance from itself"},
    {"no_axle", event + "event = \"swing\"\nbody = \"bob\"\n" + within,
     "body 'bob' has no joint that lets it turn about one axis"},
    {"no_axis", event + "event = \"nutation\"\nbody = \"bob\"\n" + within,
     "body 'bob' has no axis of symmetry"},
    {"no_water", event + "event = \"crossing\"\n" + within, "the scene has no water"},
    {"no_touch", event + "event = \"bounce\"\nquantity = \"order\"\n" + within,
     "no two things in the scene may touch"},
    {"not_an_event", conserves + "quantity = \"order\"\n" + within,
     "quantity belongs to observable = \"event\""},
    {"both_constants",
     conserves + "tolerance = { order = true, constant = 2, constants = { 1 = 2 }, reason = \"r\" }\n",
     "one of the two"},
    {"no_constants", conserves + "tolerance = { order = true, constants = { }, reason = \"r\" }\n",
     "constants = {}"},
    {"constant_sign", conserves + "tolerance = { order = true, constants = { 1 = -2 }, reason = \"r\" }\n",
     "1 = -2, but must be > 0"},
    {"constant_order", conserves + "tolerance = { order = true, constants = { 13 = 2 }, reason = \"r\" }\n",
     "'13'"},
    {"constants_alone", conserves + "tolerance = { absolute = 1, constants = { 1 = 2 }, reason = \"r\" }\n",
     "belong together"},
};

class RefusesEvents : public testing::TestWithParam<Bad> {};

TEST_P(RefusesEvents, WithPlaceAndReason) {
  try {
    scenario::parse(orbit + GetParam().text, "bad.toml");
    FAIL() << "accepted";
  } catch (const core::InputError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("bad.toml:")) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
  }
}

INSTANTIATE_TEST_SUITE_P(Claims, RefusesEvents, testing::ValuesIn(bad),
                         [](const auto& row) { return std::string(row.param.name); });

// Recorded data may hold events; a number that it does not hold is not claimed.
TEST(RecordedEvents, AreReadAndChecked) {
  const core::Scene scene = scenario::parse(orbit, "a.toml").scene;
  const auto data = [](const std::string& events) {
    return R"({"schema":"truth/1","bodies":[{"id":"bob"},{"id":"other"}],"t":["0","1"],"trajectory":{)"
           R"("bob":{"position":[["0","0","0"],["0","0","0"]]},"other":{"position":[["0","0","0"],["0","0","0"]]}},)"
           R"("events":)" +
           events + "}";
  };
  const core::Truth truth = scenario::parse_truth(
      data(
          R"([{"kind":"turn","body":"bob","time":"0.25"},{"kind":"apsis","body":"bob","to":"other","time":"0.5",)"
          R"("distance":"2.5"},{"kind":"turn","body":"bob","time":"0.75"}])"),
      "d.json", scene);
  ASSERT_EQ(truth.events.size(), 3u);
  EXPECT_EQ(truth.events[2].index, 2);
  EXPECT_EQ(truth.events[1].pair, (core::Pair{0, 1, -1}));
  EXPECT_EQ(core::quantity(truth.events, truth.events[1], core::EventQuantity::distance), 2.5);
  EXPECT_FALSE(core::quantity(truth.events, truth.events[0], core::EventQuantity::height));

  const auto refusal = [&](const std::string& events) {
    try {
      scenario::parse_truth(data(events), "d.json", scene);
      return std::string("accepted");
    } catch (const core::InputError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(refusal("{}").find("'events' must be an array"), std::string::npos);
  EXPECT_NE(
      refusal(R"([{"kind":"trun","body":"bob","time":"1"}])").find("kind = \"trun\", valid: bounce, apex"),
      std::string::npos);
  EXPECT_NE(refusal(R"([{"kind":"turn","body":"bop","time":"1"}])").find("did you mean 'bob'?"),
            std::string::npos);
  EXPECT_NE(refusal(R"([{"kind":"turn","body":"bob"}])").find("needs 'time'"), std::string::npos);
  EXPECT_NE(refusal(R"([{"kind":"turn","body":"bob","time":"1"},{"kind":"turn","body":"bob","time":"0.5"}])")
                .find("comes after"),
            std::string::npos);
}

}  // namespace
