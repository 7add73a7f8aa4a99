// `cylon fit` and `cylon predict` on a small data set of its own: a pendulum of small swings, of which the motion can be written
// down, seen with noise.
#include "harness/validation/normal.h"
#include "tests/harness/cli/fixture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cylon::cli {
namespace {

using nlohmann::json;

constexpr const char* model = R"(title = "A pendulum"
story = "A small one."
duration = 1.0
step = "1/1000"
gravity = [0, -9.81, 0]

[[body]]
name = "arm"
mass = 0.5
inertia = [2e-3, 2e-3, 2e-3]
shape = { type = "box", half_extents = [0.01, 0.2, 0.01] }
position = [0, -0.2, 0]
collide = false

[[joint]]
type = "hinge"
body = "arm"
point = [0, 0, 0]
axis = [0, 0, 1]
)";

constexpr const char* description = R"(title = "Swings of </script><b>an arm</b>"
source = "made for a test"
licence = "none"
instrument = "a formula"
known = ["it is <i>synthetic</i>"]
data = "swings.csv"
model = "pendulum.toml"
bodies = ["arm"]
rate = 100

[columns]
run = "run"
angles = ["angle"]
rates = ["rate"]

[uncertainty]
angle_noise = 0.0005
angle = 0.0005
rate = 0.005

[fit]
horizon = 0.4

[[parameter]]
name = "inertia"
kind = "inertia"
low = 0.3
start = 1
high = 5

[[parameter]]
name = "mass"
kind = "mass"
low = 0.3
start = 1
high = 3
)";

class PredictCommand : public CommandLine {
 protected:
  void SetUp() override {
    write("pendulum.toml", model), write("swings.toml", description), write("swings.csv", swings(1));
  }
  static std::string swings(std::uint64_t seed) {
    // Of an arm whose inertia is 1.3 times the model's: a'' = -(m g l/(I + m l^2)) a.
    const double w = std::sqrt(0.5 * 9.81 * 0.2 / (1.3 * 2e-3 + 0.5 * 0.04));
    std::string table = "run,angle,rate\n";
    for (std::uint64_t run = 0; run < 6; ++run) {
      validation::Normal normal(seed, run, 0);
      const double a = 0.05 + normal(0.01), b = normal(0.1);
      for (int i = 0; i < 90; ++i) {
        const double t = 0.01 * i;
        table += fmt::format("{},{:.9g},{:.9g}\n", run,
                             a * std::cos(w * t) + b / w * std::sin(w * t) + normal(0.0005),
                             b * std::cos(w * t) - a * w * std::sin(w * t) + normal(0.005));
      }
    }
    return table;
  }
  json document(const std::string& file) const { return json::parse(read(file)); }
};

TEST_F(PredictCommand, TakesAFitToTheRunsThatItDidNotSee) {
  const Ran fitted = cylon("fit swings.toml --engine ode --parameters inertia --json fit.json");
  ASSERT_EQ(fitted.code, 0) << fitted.err;
  const json fit = document("fit.json")["fits"][0];
  EXPECT_NEAR(fit["parameters"][0]["value"].get<double>(), 1.3, 0.1);
  EXPECT_NEAR(std::sqrt(fit["covariance"][0][0].get<double>()), fit["parameters"][0]["error"].get<double>(),
              1e-12);

  const Ran ran = cylon("predict swings.toml --fit fit.json --json p.json --html p.html --curves 2");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json after = document("p.json"), &engine = after["engines"][0];
  EXPECT_EQ(after["engines"].size(), 1u);
  EXPECT_EQ(engine["engine"], "ode");
  EXPECT_EQ(after["fitted"], true);
  ASSERT_EQ(engine["each"].size(), fit["judged_on"].size());
  std::set<std::string> predicted;
  for (const json& run : engine["each"]) predicted.insert(run["run"].get<std::string>());
  EXPECT_EQ(predicted, fit["judged_on"].get<std::set<std::string>>());
  EXPECT_EQ(engine["drawn"].size(), 2u);
  EXPECT_EQ(after["drawn"]["runs"][0]["run"], engine["drawn"][0]["run"]);
  const auto inside = engine["covered"]["value"].get<double>();
  EXPECT_GT(inside, 0.8);

  // Before the fit an arm of another inertia is predicted, and its band is too narrow.
  ASSERT_EQ(cylon("predict swings.toml --engine ode --json b.json").code, 0);
  const json before = document("b.json");
  EXPECT_EQ(before["fitted"], false);
  EXPECT_LT(before["engines"][0]["covered"]["value"].get<double>(), inside - 0.2);
  EXPECT_EQ(before["experiment"], after["experiment"]);

  const std::string page = read("p.html");
  EXPECT_EQ(page.find("<b>an arm"), std::string::npos);
  EXPECT_NE(page.find("&lt;b&gt;an arm"), std::string::npos);
  const Ran report = cylon("report p.json b.json fit.json --html all.html");
  EXPECT_EQ(report.code, 0) << report.err;
  EXPECT_NE(read("all.html").find("<th scope=\"row\">ode</th>"), std::string::npos);
}

// Nothing was written of what was done, and hours of it were lost to a look.
TEST_F(PredictCommand, InterruptionKeepsEnginesThatAreDone) {
  const std::string slow = " --engine ode --engine slow --worker 'slow=python3 " + std::string(source_dir) +
                           "/tests/harness/process/scripted_worker.py says_and_loops_in_load'";
  const auto at_work = [&] { return std::filesystem::exists(folder / "at_work"); };
  const Ran predicted =
      shell("exec cylon predict swings.toml --members 0 --json p.json --html p.html" + slow, at_work);
  EXPECT_EQ(predicted.code, 130) << predicted.err;
  EXPECT_TRUE(predicted.err.ends_with("interrupted: what is written holds the engines that are done\n"))
      << predicted.err;
  const json predictions = document("p.json");
  ASSERT_EQ(predictions["engines"].size(), 1u);
  EXPECT_EQ(predictions["engines"][0]["engine"], "ode");
  EXPECT_EQ(predictions["interrupted"], true);
  EXPECT_NE(read("p.html").find("(interrupted: not all is predicted)"), std::string::npos);

  std::filesystem::remove(folder / "at_work");
  const Ran fitted = shell("exec cylon fit swings.toml --parameters inertia --json fit.json" + slow, at_work);
  EXPECT_EQ(fitted.code, 130) << fitted.err;
  EXPECT_NE(fitted.err.find("interrupted: what is written holds the fits that are done"), std::string::npos)
      << fitted.err;
  const json fits = document("fit.json");
  ASSERT_EQ(fits["fits"].size(), 1u);
  EXPECT_EQ(fits["fits"][0]["engine"], "ode");
  EXPECT_EQ(fits["interrupted"], true);
  const Ran of_done = cylon("predict swings.toml --fit fit.json --members 0");
  EXPECT_EQ(of_done.code, 0) << of_done.err;
}

TEST_F(PredictCommand, JudgesEachRunByTheFoldThatLeftItOut) {
  ASSERT_EQ(cylon("fit swings.toml --engine ode --parameters inertia --folds 3 --json fit.json").code, 0);
  ASSERT_EQ(cylon("predict swings.toml --fit fit.json --members 0 --json p.json").code, 0);
  EXPECT_EQ(document("p.json")["engines"][0]["each"].size(), 6u);
}

// Data of the same form that no fit saw are predicted whole, even where runs have the same names; what it saw is known again in another
// file, under another title.  It was not: the hash of the whole experiment decided.
TEST_F(PredictCommand, TakesAFitToOtherData) {
  ASSERT_EQ(cylon("fit swings.toml --engine ode --parameters inertia --on all --json fit.json").code, 0);
  const auto predicted = [&] {
    const Ran ran = cylon("predict swings.toml --fit fit.json --members 0 --json p.json");
    EXPECT_TRUE(ran.code == 0 || ran.err.find("saw every run") != std::string::npos) << ran.err;
    return ran.code == 0 ? document("p.json")["engines"][0]["each"].size() : 0;
  };
  EXPECT_EQ(predicted(), 0u);
  write("swings.toml", replaced(description, "an arm", "another arm"));
  EXPECT_EQ(predicted(), 0u);
  std::string renamed = swings(1);
  while (renamed.find("\n3,") != std::string::npos) renamed = replaced(renamed, "\n3,", "\nthird,");
  write("swings.csv", renamed);
  EXPECT_EQ(predicted(), 0u);
  write("swings.csv", swings(1) + "7,0.01,0\n7,0.0098,-0.03\n7,0.0093,-0.06\n");
  EXPECT_EQ(predicted(), 1u);
  write("swings.csv", swings(2));
  EXPECT_EQ(predicted(), 6u);
}

// Of data that the engine itself made, its band holds what it should; another seed makes other data.
TEST_F(PredictCommand, PredictsWhatAnEngineMade) {
  const auto made = [&](const std::string& more) {
    const Ran ran = cylon("predict swings.toml --engine ode --synthetic ode --json p.json " + more);
    EXPECT_EQ(ran.code, 0) << ran.err;
    EXPECT_NE(ran.out.find("synthetic: made by ode with the stated errors, seed"), std::string::npos)
        << ran.out;
    return document("p.json")["engines"][0]["covered"]["value"].get<double>();
  };
  const double one = made("--seed 1"), two = made("--seed 2");
  EXPECT_GT(one, 0.85);
  EXPECT_GT(two, 0.85);
  EXPECT_NE(one, two);
  EXPECT_EQ(document("p.json")["synthetic"], "ode");
  EXPECT_EQ(cylon("predict swings.toml --engine ode --synthetic odd").code, 2);
}

TEST_F(PredictCommand, TellsWhichColumnsDoNotGoTogether) {
  const std::string wrong = "they do not go together; check columns, units, axes and rate";
  const Ran right = cylon("predict swings.toml --engine ode --members 0 --json p.json --html p.html");
  EXPECT_EQ(right.out.find(wrong), std::string::npos) << right.out;
  EXPECT_NE(read("p.html").find("Columns against each other"), std::string::npos);
  EXPECT_EQ(read("p.html").find("<strong>" + wrong), std::string::npos);
  EXPECT_EQ(document("p.json")["kinematics"]["spin"]["goes_together"], "yes");
  write("swings.toml", replaced(description, "rate = 100", "rate = 50"));
  const Ran ran = cylon("predict swings.toml --engine ode --members 0 --json p.json --html p.html");
  EXPECT_NE(ran.out.find(wrong), std::string::npos) << ran.out;
  EXPECT_NE(read("p.html").find("<strong>" + wrong), std::string::npos);
  EXPECT_EQ(document("p.json")["kinematics"]["spin"]["goes_together"], "no");
  const Ran fitted = cylon("fit swings.toml --engine ode --parameters inertia --runs 2");
  EXPECT_NE(fitted.out.find(wrong), std::string::npos) << fitted.out << fitted.err;
  EXPECT_NE(fitted.out.find("judged on 1 run: "), std::string::npos) << fitted.out;
}

TEST_F(PredictCommand, StatesTheDiscrepancyOfItsBand) {
  EXPECT_EQ(cylon("predict swings.toml --engine ode --discrepancy").code, 2);  // [fit] states no degrees
  write("swings.toml", replaced(description, "horizon = 0.4", "horizon = 0.4\ndegrees = 4"));
  const Ran with = cylon("predict swings.toml --engine ode --discrepancy --json p.json");
  ASSERT_EQ(with.code, 0) << with.err;
  EXPECT_NE(with.out.find("discrepancy of 4 degrees"), std::string::npos) << with.out;
  const auto covered = [&] { return document("p.json")["engines"][0]["covered"]["value"].get<double>(); };
  const double wide = covered();
  ASSERT_EQ(cylon("predict swings.toml --engine ode --json p.json").code, 0);
  EXPECT_GT(wide, covered());
}

TEST_F(PredictCommand, TakesTheFirstRuns) {
  ASSERT_EQ(cylon("predict swings.toml --engine ode --members 0 --runs 2 --json p.json").code, 0);
  const json few = document("p.json")["engines"][0]["each"];
  ASSERT_EQ(cylon("fit swings.toml --engine ode --parameters inertia --runs 2 --json f.json").code, 0);
  const json fit = document("f.json")["fits"][0];
  ASSERT_EQ(few.size(), 2u);
  std::set<std::string> names{few[0]["run"], few[1]["run"]};
  EXPECT_EQ(names, (std::set<std::string>{fit["fitted_on"][0], fit["judged_on"][0]}));
  EXPECT_NE(cylon("predict swings.toml --engine ode --runs 7").err.find("--runs 7: swings.toml has 6 runs"),
            std::string::npos);
}

TEST_F(PredictCommand, DocumentsGoToStdoutAlone) {
  const Ran ran = cylon("predict swings.toml --engine ode --members 0 --json -");
  ASSERT_EQ(ran.code, 0);
  EXPECT_EQ(json::parse(ran.out)["format"], "cylon-prediction/1");
  EXPECT_NE(ran.err.find("within 0.1 rad"), std::string::npos);
}

// Of nine members a band of 80 % was held against 90 to 98 %.
TEST_F(PredictCommand, JudgesNoBandOfAnotherLevel) {
  const Ran few = cylon("predict swings.toml --engine ode --members 9 --json p.json");
  ASSERT_EQ(few.code, 0) << few.err;
  EXPECT_NE(few.out.find("inside the 80 % band"), std::string::npos) << few.out;
  EXPECT_NE(few.out.find("not judged: 90 to 98 % is asked of 39 members"), std::string::npos) << few.out;
  EXPECT_EQ(document("p.json")["engines"][0]["band"], "undecided");
  const Ran usual = cylon("predict swings.toml --engine ode");
  EXPECT_NE(usual.out.find("; 90 to 98 %: "), std::string::npos) << usual.out;
}

// The cube hardly leaves the table; of a chain nothing is said of touches.
TEST_F(PredictCommand, TellsOfWhichTouchesTheDataTellTheLoss) {
  const std::string cubes = std::string(source_dir) + "/scenarios/measured/cube_tosses/tosses.toml";
  const Ran ran = cylon("predict " + cubes + " --engine ode --members 0 --runs 40 --json p.json");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const json touches = document("p.json")["touches"], engine = document("p.json")["engines"][0];
  const auto flights = touches[0]["flights"].get<int>(), known = touches[0]["known"].get<int>();
  EXPECT_GT(flights, known);
  const std::string line = fmt::format(
      "touch 1                {} of 40 runs fly after it, and {} tell its loss\n", flights, known);
  EXPECT_NE(ran.out.find(line), std::string::npos) << ran.out;
  for (std::size_t k = 0; k < engine["touch_losses"].size(); ++k)
    EXPECT_LE(engine["touch_losses"][k]["runs"].get<int>(), touches[k]["known"].get<int>());
  const Ran swung = cylon("predict swings.toml --engine ode --members 0 --json p.json");
  EXPECT_EQ(swung.out.find("touch"), std::string::npos) << swung.out;
  EXPECT_FALSE(document("p.json").contains("touches"));
}

TEST_F(PredictCommand, RefusesValuesThatItCannotTake) {
  const std::pair<const char*, const char*> cases[] = {
      {"nosuch", "--set nosuch: must be NAME=VALUE"},
      {"inertia", "--set inertia: must be NAME=VALUE"},
      {"inerta=1", "has no parameter 'inerta', did you mean 'inertia'?"},
      {"inertia=", "a number in [0.3, 5] must follow '='"},
      {"inertia=9", "a number in [0.3, 5] must follow '='"}};
  for (const auto& [value, why] : cases) {
    const Ran ran = cylon(std::string("predict swings.toml --set ") + value);
    EXPECT_EQ(ran.code, 2) << value << ran.out;
    EXPECT_NE(ran.err.find(why), std::string::npos) << value << ran.err;
  }
}

TEST_F(PredictCommand, RefusesFitsThatItCannotTake) {
  const std::string good =
      R"({"format":"cylon-fit/1","experiment":"x","fits":[{"engine":"ode","failure":"","fitted_on":[],"fitted_data":[],
    "parameters":[{"name":"inertia","value":1.3,"error":0.1}],"covariance":[[0.01]]}]})";
  const auto said = [&](const std::string& text, const std::string& more = "") {
    write("fit.json", text);
    const Ran ran = cylon("predict swings.toml --fit fit.json --members 3 " + more);
    EXPECT_EQ(ran.code, 2) << ran.out;
    return ran.err;
  };
  write("fit.json", good);
  ASSERT_EQ(cylon("predict swings.toml --fit fit.json --members 3").code, 0);
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"{", "not JSON"},
      {"[]", "not a file of cylon fit"},
      {replaced(good, "cylon-fit/1", "cylon-trade/1"), "not a file of cylon fit"},
      {replaced(good, "\"inertia\"", "\"inerta\""), "did you mean 'inertia'"},
      {replaced(good, "1.3", "9"), "outside [0.3, 5]"},
      {replaced(good, "1.3", "\"1.3\""), "not as cylon fit --json writes it"},
      {replaced(good, "0.1}", "null}"), "cannot tell apart 'inertia'"},
      {replaced(good, "[[0.01]]", "[[0.01, 0]]"), "another size"},
      {replaced(good, "[[0.01]]", "[[-0.01]]"), "negative eigenvalue"},
      {replaced(good, ",\"covariance\":[[0.01]]", ""), "covariance"},
      {replaced(good, "\"fits\":[{", "\"fits\":[],\"none\":[{"), "it has no fit"}};
  for (const auto& [text, why] : cases)
    EXPECT_NE(said(text).find(why), std::string::npos) << why << ": " << text;
  EXPECT_NE(said(good, "--engine bullet").find("no fit of bullet"), std::string::npos);
  EXPECT_NE(said(good, "--set inertia=1").find("--set"), std::string::npos);
  // Without a band the covariance is not asked for.
  write("fit.json", replaced(good, "0.1}", "null}"));
  EXPECT_EQ(cylon("predict swings.toml --fit fit.json --members 0").code, 0);
}

}  // namespace
}  // namespace cylon::cli
