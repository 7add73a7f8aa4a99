// expected.toml: causes, the rows measured from them, and what a verdict is compared with.
#include "harness/scenario/expected.h"

#include "harness/core/input_error.h"
#include "harness/scenario/input.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

namespace cylon {
namespace {

using results::Status;
using results::Verdict;
using scenario::Expectations;

const std::string causes = R"([versions]
"bullet*" = ["3.24"]
"in-house" = ["*"]
[[cause]]
name = "late"
mechanism = "the contact is found late"
source = ["bullet: world.cpp:7"]
law = "u dt"
power = 1
within = 2
[[cause.explains]]
engine = "bullet*"
scenario = "ball"
claim = "position*"
[[cause.counterfactual]]
scenario = "ball"
claim = "position*"
engine = "bullet"
other_dt = "1/120"
at_most = 0.6
[[cause]]
name = "soft"
mechanism = "the joint gives"
source = ["ode: joint.cpp:8"]
law = "none"
[[cause.explains]]
engine = "bullet:ode"
scenario = "*"
[[cause.counterfactual]]
scenario = "rod"
claim = "gap"
engine = "ode"
other_engine = "ode/erp=0.8"
becomes = "pass"
)";

std::string row(const std::string& cause, const std::string& engine, const std::string& claim,
                const std::string& rest) {
  return "[[row]]\ncause = \"" + cause + "\"\nscenario = \"ball\"\nengine = \"" + engine +
         "\"\ndt = \"1/60\"\nclaim = \"" + claim + "\"\n" + rest + "\n";
}

std::string refusal(const std::string& causes_text, const std::string& rows_text) {
  try {
    Expectations::parse(causes_text, "e.toml", rows_text, "rows.toml");
    return "";
  } catch (const core::InputError& error) {
    return error.what();
  }
}

TEST(Expected, RowsAreOfExactCellsAndSteps) {
  const std::string rows = row("late", "bullet", "position follows x", "status = \"fail\"\nmeasured = 0.5") +
                           row("soft", "ode", "energy", "status = \"crash\"");
  const auto e = Expectations::parse(causes, "e.toml", rows, "rows.toml");
  const auto late = e.find("ball", "bullet", 1.0 / 60, "position follows x");
  EXPECT_EQ(late.status, Status::fail);
  EXPECT_EQ(late.size, 0.5);
  EXPECT_EQ(late.within, 2);
  EXPECT_EQ(late.reason, "late: the contact is found late");
  EXPECT_EQ(e.find("ball", "ode", 1.0 / 60, "energy").status, Status::crash);
  EXPECT_FALSE(e.find("ball", "ode", 1.0 / 60, "energy").size);
  EXPECT_EQ(e.find("ball", "bullet", 1.0 / 120, "position follows x").status, Status::pass) << "another step";
  EXPECT_EQ(e.find("ball", "bullet/erp=0", 1.0 / 60, "position follows x").status, Status::pass);
  EXPECT_EQ(e.find("ball", "bullet-float", 1.0 / 60, "position follows x").status, Status::pass);
  EXPECT_TRUE(e.unused().empty());
  EXPECT_TRUE(e.version_listed("bullet-multibody/gyro=none", "3.24"));
  EXPECT_FALSE(e.version_listed("bullet", "3.25"));
  EXPECT_FALSE(e.version_listed("ode", "3.24"));
  EXPECT_TRUE(e.version_listed("in-house/x=1", "0.1.0"));
}

TEST(Expected, TheFirstCauseThatMatchesExplains) {
  const auto e = Expectations::parse(causes, "e.toml", "", "rows.toml");
  EXPECT_EQ(e.explain("ball", "bullet", "position follows x")->name, "late");
  EXPECT_EQ(e.explain("ball", "bullet", "energy")->name, "soft");
  EXPECT_EQ(e.explain("ball", "bullet-float", "energy"), nullptr);
  ASSERT_EQ(e.unused().size(), 2u);
  EXPECT_EQ(e.unused()[0], "late: engine 'bullet*', scenario 'ball', claim 'position*'");
  const auto& pair = e.causes()[0].counterfactuals.at(0);
  EXPECT_EQ(pair.other_engine, "bullet") << "what is not said stays";
  EXPECT_EQ(pair.other_dt, "1/120");
  EXPECT_EQ(pair.high, 0.6);
  EXPECT_EQ(pair.place, "e.toml:15");
}

TEST(Expected, BadCausesAndRows) {
  const auto without = [](const std::string& line) {
    std::string text = causes;
    text.erase(text.find(line), line.size() + 1);
    return refusal(text, "");
  };
  EXPECT_NE(without("source = [\"bullet: world.cpp:7\"]").find("[[cause]] needs 'source'"),
            std::string::npos);
  EXPECT_NE(without("at_most = 0.6").find("either 'becomes', or 'at_least' and 'at_most'"),
            std::string::npos);
  EXPECT_NE(without("other_dt = \"1/120\"").find("what is changed"), std::string::npos);
  const std::size_t pair = causes.find("[[cause.counterfactual]]"), next = causes.find("[[cause]]", pair);
  EXPECT_NE(refusal(causes.substr(0, pair) + causes.substr(next), "").find("was not tested"),
            std::string::npos);
  EXPECT_NE(refusal(causes + causes.substr(causes.find("[[cause]]")), "").find("a second cause 'late'"),
            std::string::npos);
  EXPECT_NE(refusal("[versions]\node = 3\n", "").find("must be an array of strings"), std::string::npos);
  EXPECT_NE(refusal(causes, row("late", "bullet", "position", "status = \"failed\""))
                .find("rows.toml:7:10: status = 'failed' is unknown, did you mean 'fail'?"),
            std::string::npos);
  EXPECT_NE(refusal(causes, row("soft", "bullet", "position", "status = \"fail\""))
                .find("is explained by 'late', not by 'soft'"),
            std::string::npos);
  EXPECT_NE(refusal(causes, row("late", "nobody", "position", "status = \"fail\"")).find("no cause"),
            std::string::npos);
}

TEST(Expected, ShippedFileIsRead) {
  const auto e = Expectations::load(std::filesystem::path(source_dir) / "scenarios/expected.toml");
  EXPECT_GT(e.rows().size(), 900u);
  for (const std::string& symptoms : e.unused()) ADD_FAILURE() << "explains nothing: " << symptoms;
}

TEST(Expected, CounterfactualsCanBeRefuted) {
  scenario::Counterfactual pass{.becomes = Status::pass}, half{.becomes = {}, .low = 0.45, .high = 0.55};
  Verdict first, other;
  first.status = Status::fail, first.measured = 20, first.allowed = 1;
  other.status = Status::low_quality, other.measured = 10, other.allowed = 1;
  EXPECT_NE(refutation(pass, first, other).find("becomes low-quality"), std::string::npos);
  EXPECT_EQ(refutation(half, first, other), "");
  other.measured = 12;
  EXPECT_NE(refutation(half, first, other).find("0.6 times as much"), std::string::npos);
  other.measured = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refutation(half, first, other), "");
  other.status = Status::pass, other.measured = 0.5;
  EXPECT_EQ(refutation(pass, first, other), "");
  first.status = Status::pass;
  EXPECT_NE(refutation(pass, first, other).find("no symptom"), std::string::npos);
}

// What is not known contradicts nothing that is said of a measured run; it is no pass either, nor what comes of a crash.
TEST(Expected, UndecidedContradictsNothingThatIsMeasured) {
  Verdict v;
  for (const Status open : {Status::undecided, Status::pass})
    for (int i = 0; i <= static_cast<int>(Status::protocol); ++i) {
      v.status = open, v.expected = static_cast<Status>(i);
      const bool same = v.expected == open;
      EXPECT_EQ(v.as_expected(), same || (open == Status::undecided && results::is_measured(v.expected)))
          << results::name(open) << ", expected " << results::name(v.expected);
    }
  v.status = Status::undecided, v.expected = Status::fail, v.expected_size = 30, v.measured = 0.1;
  EXPECT_TRUE(v.as_expected());
}

// What is far worse or far better than its cause explains differs, whatever its status.
TEST(Expected, SizesAreComparedAndNotStatusesAlone) {
  Verdict v;
  v.allowed = 1, v.expected = Status::fail, v.expected_size = 30, v.expected_within = 2;
  const auto as_expected = [&](double measured, Status status) {
    v.measured = measured, v.status = status;
    return v.as_expected();
  };
  EXPECT_TRUE(as_expected(30, Status::fail));
  EXPECT_TRUE(as_expected(16, Status::fail));
  EXPECT_FALSE(as_expected(14, Status::fail)) << "far better";
  EXPECT_FALSE(as_expected(61, Status::fail)) << "far worse";
  EXPECT_FALSE(as_expected(0.5, Status::pass));
  EXPECT_FALSE(as_expected(30, Status::crash));
  EXPECT_FALSE(as_expected(std::numeric_limits<double>::quiet_NaN(), Status::non_finite));
  v.expected_size = 9;  // at a border of two statuses the size decides
  EXPECT_TRUE(as_expected(11, Status::fail));
  v.expected_within = 1e9;
  EXPECT_TRUE(as_expected(1e7, Status::fail)) << "anything may come of it";
  EXPECT_FALSE(as_expected(9, Status::low_quality)) << "but no better verdict";
  EXPECT_FALSE(as_expected(1e-3, Status::pass)) << "nor a pass";
  v.expected_size = 0.9;
  EXPECT_TRUE(as_expected(1e-9, Status::pass)) << "both are a pass";
  v.expected_size.reset();
  EXPECT_FALSE(as_expected(30, Status::low_quality));
  EXPECT_TRUE(as_expected(30, Status::fail));
}

}  // namespace
}  // namespace cylon
