// The console: what a person must be able to read off it, on any terminal, whatever an engine printed.
#include "reports/console.h"
#include "reports/text.h"
#include "reports/verdict_matrix.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cylon::reports {
namespace {

using results::Status;
using results::Verdict;

const ConsoleOptions plain{.width = 100, .utf8 = true, .colour = false};
const ConsoleOptions ascii{.width = 100, .utf8 = false, .colour = false};

Verdict make(const std::string& scenario, const std::string& engine, Status status, double measured = 1) {
  Verdict v;
  v.scenario = scenario;
  v.engine = engine;
  v.version = "3.24";
  v.claim = "energy";
  v.unit = "J";
  v.dt_text = "1/60";
  v.measured = measured;
  v.allowed = 0.01;
  v.status = v.expected = status;
  v.reproduce = "cylon run " + scenario + "/" + engine;
  return v;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) out.push_back(line);
  return out;
}

TEST(Matrix, CellShowsWorstClaimAndFewestDigits) {
  const std::vector<Verdict> verdicts = {make("top", "bullet", Status::pass, 1e-5),
                                         make("top", "bullet", Status::fail, 10),
                                         make("top", "bullet", Status::low_quality, 0.05)};
  const Matrix matrix = fold(verdicts);
  ASSERT_EQ(matrix.scenarios, std::vector<std::string>{"top"});
  ASSERT_EQ(matrix.engines, std::vector<std::string>{"bullet"});
  EXPECT_EQ(matrix.cells[0][0].worst, Status::fail);
  EXPECT_DOUBLE_EQ(matrix.cells[0][0].digits, -3);
  EXPECT_TRUE(contains(draw(matrix, plain), "✗ -3.0"));
  EXPECT_TRUE(contains(draw(matrix, ascii), "X -3.0"));
}

TEST(Matrix, EveryStatusHasItsSignAndItsMeaning) {
  const std::vector<std::pair<Status, std::pair<std::string, std::string>>> signs = {
      {Status::pass, {"✓ -2.0", "ok -2.0"}},
      {Status::low_quality, {"~ -2.0", "~ -2.0"}},
      {Status::fail, {"✗ -2.0", "X -2.0"}},
      {Status::undecided, {"? -2.0", "? -2.0"}},
      {Status::unsupported, {"–", "-"}},
      {Status::crash, {"☠ crash", "crash"}},
      {Status::timeout, {"⌛ timeout", "timeout"}},
      {Status::non_finite, {"∞ non-finite", "non-finite"}},
      {Status::protocol, {"‽ protocol", "protocol"}}};
  for (const auto& [status, sign] : signs) {
    const Matrix matrix = fold({make("top", "bullet", status)});
    EXPECT_EQ(lines(draw(matrix, plain))[1], "top  " + sign.first);
    EXPECT_EQ(lines(draw(matrix, ascii))[1], "top  " + sign.second);
    EXPECT_FALSE(contains(draw(matrix, plain), "!"));
    EXPECT_FALSE(legend(matrix, plain).empty());
  }
}

// Counted by itself and shown, and no difference where a pass is expected.
TEST(Console, UndecidedVerdictIsCountedAndShown) {
  Verdict open = make("swing", "ode", Status::undecided, 0.02);
  open.expected = Status::pass;
  open.interval = results::Bounds{0.005, 0.035};
  const std::vector<Verdict> verdicts = {make("swing", "bullet", Status::pass), open};
  EXPECT_EQ(summary(verdicts), "2 verdicts: 1 pass, 0 as expected, 1 undecided, 0 differ\n");
  EXPECT_EQ(summary({make("swing", "ode", Status::pass)}), "1 verdict: 1 pass, 0 as expected, 0 differ\n");
  const std::string text = console_matrix(verdicts, plain);
  EXPECT_TRUE(contains(text, "\nUndecided:\n")) << text;
  EXPECT_TRUE(contains(text, "measured 0.02 [0.005, 0.035] J, allowed 0.01 J")) << text;
  EXPECT_FALSE(contains(text, "Not as expected")) << text;
  EXPECT_FALSE(contains(text, "(as expected)")) << text;
  open.expected = Status::crash;
  EXPECT_TRUE(contains(summary({open}), "1 differs (1 undecided)"));
}

TEST(Matrix, SaysWhereAnEngineTakesNoSteps) {
  Verdict v = make("ball", "in-house", Status::pass);
  EXPECT_EQ(legend(fold({v}), plain).find("closed form"), std::string::npos);
  v.closed_form = true;
  const Matrix matrix = fold({v, make("ball", "bullet", Status::pass)});
  EXPECT_TRUE(cell_text(matrix.cells[0][0], plain).ends_with(" =")) << cell_text(matrix.cells[0][0], plain);
  EXPECT_FALSE(cell_text(matrix.cells[0][1], plain).ends_with("="));
  EXPECT_NE(legend(matrix, plain).find("=: no steps"), std::string::npos);
}

TEST(Matrix, SaysHowManySubstepsAStepHas) {
  Verdict v = make("ball", "rapier", Status::pass);
  EXPECT_EQ(legend(fold({v}), plain).find("substeps"), std::string::npos);
  EXPECT_EQ(console_details({v}, plain).find("substeps"), std::string::npos);
  v.substeps = 4;
  EXPECT_NE(
      legend(fold({v, make("ball", "ode", Status::pass)}), plain).find("rapier: 4 substeps in each step"),
      std::string::npos);
  EXPECT_NE(console_details({v}, plain).find(", step 1/60 s (4 substeps)"), std::string::npos);
}

TEST(Matrix, MarksCellsThatDiffer) {
  Verdict v = make("top", "bullet", Status::pass);
  v.expected = Status::fail;  // an unexpected pass differs too
  EXPECT_TRUE(contains(draw(fold({v}), plain), "✓ -2.0 !"));
  EXPECT_TRUE(contains(legend(fold({v}), plain), "! differs from expected"));
}

TEST(Matrix, SeveralStepsAndIntegratorsGetRowsAndColumnsOfTheirOwn) {
  Verdict a = make("top", "in-house", Status::pass), b = a, c = a;
  a.integrator = b.integrator = "rk4";
  b.dt_text = "1/240";
  c.integrator = "euler";
  const Matrix matrix = fold({a, b, c, make("ball", "bullet", Status::pass)});
  EXPECT_EQ(matrix.scenarios, (std::vector<std::string>{"top 1/60 s", "top 1/240 s", "ball"}));
  EXPECT_EQ(matrix.engines, (std::vector<std::string>{"in-house rk4", "in-house euler", "bullet"}));
  EXPECT_TRUE(matrix.cells[1][1].empty);
}

// As bullet/path=as-expert does: its matrix had two columns with holes.
TEST(Matrix, AnIntegratorChosenBySceneIsNoColumn) {
  Verdict top = make("top", "bullet", Status::pass), ball = make("ball", "bullet", Status::pass);
  top.integrator = "runge-kutta-4", ball.integrator = "semi-implicit-euler";
  const Matrix matrix = fold({top, ball});
  EXPECT_EQ(matrix.engines, std::vector<std::string>{"bullet"});
  EXPECT_FALSE(matrix.cells[0][0].empty || matrix.cells[1][0].empty);
}

// It cannot name the integrator that it would have run.
TEST(Matrix, UnsupportedSceneAddsNoColumn) {
  Verdict v = make("rocket", "bullet", Status::unsupported);
  v.integrator = "";
  Verdict ran = make("top", "bullet", Status::pass);
  ran.integrator = "semi-implicit-euler";
  const Matrix matrix = fold({v, ran});
  ASSERT_EQ(matrix.engines, std::vector<std::string>{"bullet"});
  EXPECT_EQ(matrix.cells[0][0].worst, Status::unsupported);
  EXPECT_EQ(fold({v}).engines.size(), 1u) << "nor where it could take none";
}

TEST(Matrix, RefusalIsAvoidableWhereAnotherEnginePasses) {
  const auto of = [](const char* engine, Status status) { return make("rocket", engine, status, 1e-3); };
  const auto matrix = [&](Status other) {
    return fold({of("bullet", Status::unsupported), of("ode", other), make("top", "ode", Status::pass)});
  };
  EXPECT_EQ(cell_text(matrix(Status::pass).cells[0][0], plain), "– avoidable");
  EXPECT_EQ(refusals(matrix(Status::pass), plain),
            "scenes supported: bullet 0 of 1, ode 2 of 2\n"
            "refused, though another engine passes:\n  bullet: rocket, which ode passes\n");
  EXPECT_TRUE(
      contains(legend(matrix(Status::pass), plain), "avoidable: refused, though another engine passes"));
  for (const Status other : {Status::low_quality, Status::fail, Status::unsupported, Status::crash}) {
    EXPECT_EQ(cell_text(matrix(other).cells[0][0], plain), "–");
    EXPECT_FALSE(contains(refusals(matrix(other), plain), "refused"));
  }
  EXPECT_EQ(refusals(fold({of("bullet", Status::fail), of("ode", Status::pass)}), plain),
            "scenes supported: all 1 by each of 2 engines\n");
  EXPECT_TRUE(contains(console_matrix({of("bullet", Status::unsupported), of("ode", Status::pass)}, plain),
                       "scenes supported: bullet 0 of 1, ode 1 of 1\n"));
}

// Rows are scenes at a step, columns engines with an integrator: both were counted.
TEST(Matrix, ScenesAndEnginesAreCountedOnce) {
  const auto of = [](const char* engine, const char* integrator, const char* step, Status status) {
    Verdict v = make("top", engine, status, 1e-3);
    v.integrator = integrator, v.dt_text = step;
    return v;
  };
  const auto said = [](const std::vector<Verdict>& verdicts) { return refusals(fold(verdicts), plain); };
  std::vector<Verdict> runs;
  for (const char* integrator : {"rk4", "euler"})
    for (const char* step : {"1/60", "1/120", "1/240"})
      runs.push_back(of("in-house", integrator, step, Status::pass));
  EXPECT_EQ(said(runs), "scenes supported: in-house 1 of 1\n");
  runs.push_back(of("ode", "euler", "1/60", Status::pass));
  EXPECT_EQ(said(runs), "scenes supported: all 1 by each of 2 engines\n");
  runs[4].status = Status::unsupported;  // at one step, with one integrator
  EXPECT_EQ(said(runs),
            "scenes supported: in-house 0 of 1, ode 1 of 1\nrefused, though another engine passes:\n"
            "  in-house euler: top 1/120 s, which in-house rk4 passes\n");
}

TEST(Matrix, ErrorOfNothingIsExact) {
  const struct {
    double measured;
    const char *cell, *digits;
  } rows[] = {{0, "✓ exact", "exact"}, {1e-5, "✓ +3.0", "+3.0 digits"}, {1e-300, "✓ exact", "exact"}};
  for (const auto& row : rows) {
    const Verdict v = make("top", "bullet", Status::pass, row.measured);
    EXPECT_EQ(cell_text(fold({v}).cells[0][0], plain), row.cell);
    Verdict unforeseen = v;
    unforeseen.expected = Status::fail;
    const std::string text = console_matrix({unforeseen}, plain);
    EXPECT_TRUE(contains(text, std::string("allowed 0.01 J, ") + row.digits + "\n")) << text;
  }
}

// An engine that tells no contact forces runs the scene all the same.
TEST(Matrix, ClaimWithoutAnswerIsNoRefusal) {
  const auto of = [](Status status) { return make("slab", "bullet", status, 1e-3); };
  for (const Status other : {Status::pass, Status::low_quality, Status::fail, Status::crash}) {
    EXPECT_EQ(fold({of(Status::unsupported), of(other)}).cells[0][0].worst, other);
    EXPECT_EQ(fold({of(other), of(Status::unsupported)}).cells[0][0].worst, other);
  }
  EXPECT_EQ(fold({of(Status::unsupported), of(Status::unsupported)}).cells[0][0].worst, Status::unsupported);
}

TEST(Matrix, FitsTerminalAndShowsAllEngines) {
  std::vector<Verdict> verdicts;
  for (int engine = 0; engine < 12; ++engine)
    for (int scenario = 0; scenario < 4; ++scenario)
      verdicts.push_back(make("a_scenario_with_a_long_name_" + std::to_string(scenario) + "_日本語",
                              "engine-" + std::to_string(engine) + "/gyro=none",
                              static_cast<Status>((engine + scenario) % 9)));
  for (const int width : {40, 57, 80, 120, 1000}) {
    for (const bool utf8 : {true, false}) {
      const std::string text = draw(fold(verdicts), {.width = width, .utf8 = utf8, .colour = false});
      for (const std::string& line : lines(text)) EXPECT_LE(display_width(line), width) << line;
      for (int engine = 0; engine < 12; ++engine)
        EXPECT_TRUE(contains(text, "engine-" + std::to_string(engine) + "/gyro=none"));
    }
  }
}

TEST(Console, ColourIsOptionalAndRedundant) {
  const std::vector<Verdict> verdicts = {make("top", "bullet", Status::fail)};
  EXPECT_FALSE(contains(console_matrix(verdicts, plain), "\x1b"));
  std::string colored = console_matrix(verdicts, {.width = 100, .utf8 = true, .colour = true});
  EXPECT_TRUE(contains(colored, "\x1b[31m"));
  for (const std::string code : {"\x1b[31m", "\x1b[0m"})
    for (std::size_t at = 0; (at = colored.find(code)) != std::string::npos;) colored.erase(at, code.size());
  EXPECT_EQ(colored, console_matrix(verdicts, plain));
}

TEST(Console, SummaryCountsAddUp) {
  EXPECT_EQ(summary({}), "0 verdicts: 0 pass, 0 as expected, 0 differ\n");
  Verdict crash = make("top", "ode", Status::crash), pass = make("ball", "ode", Status::pass);
  crash.expected = Status::pass;
  EXPECT_EQ(summary({crash}), "1 verdict: 0 pass, 0 as expected, 1 differs (1 crash)\n");
  EXPECT_EQ(
      summary({pass, pass, make("a", "b", Status::fail), make("a", "c", Status::unsupported), crash, crash}),
      "6 verdicts: 2 pass, 2 as expected (1 fail, 1 unsupported), 2 differ (2 crash)\n");
}

// A misspelt option of an engine was told for every claim, twice.
TEST(Console, RunWithoutMeasurementIsToldOnce) {
  std::vector<Verdict> rows;
  for (const char* claim : {"energy", "momentum", "position"}) {
    rows.push_back(make("top", "ode", Status::unsupported));
    rows.back().claim = claim, rows.back().expected = Status::pass, rows.back().detail = "no option 'x'";
  }
  const auto told = [](const std::string& text) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find("no option 'x'", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  for (const std::string& text : {console_details(rows, plain), console_summary(rows, plain)}) {
    EXPECT_EQ(told(text), 1u) << text;
    EXPECT_TRUE(contains(text, "energy and 2 more claims")) << text;
  }
  EXPECT_TRUE(contains(console_summary(rows, plain), "3 differ (3 unsupported)"));
  rows[1].detail = "another reason";  // no more than neighbours that end alike
  EXPECT_TRUE(contains(console_details(rows, plain), "momentum "));
  EXPECT_EQ(told(console_summary(rows, plain)), 2u);
  for (Verdict& row : rows) row.status = Status::fail;  // each has a measurement of its own
  EXPECT_FALSE(contains(console_details(rows, plain), "more claims"));
}

TEST(Console, DifferenceNamesCellClaimAmountAndCommand) {
  Verdict v = make("top", "bullet", Status::fail, 2.5);
  v.expected = Status::low_quality;
  v.expected_reason = "first order";
  v.tolerance_reason = "truncation: RK4";
  const std::string text = console_matrix({v, make("top", "ode", Status::pass)}, plain);
  for (const char* part :
       {"top × bullet 3.24, step 1/60 s: energy", "measured 2.5 J, allowed 0.01 J, -2.4 digits",
        "fail (expected low-quality)", "expected.toml: first order", "tolerance: truncation: RK4",
        "repeat with: cylon run top/bullet"})
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  EXPECT_FALSE(contains(text, "cylon run top/ode"));  // as expected: not repeated
}

TEST(Console, WarnsOncePerUnlistedVersion) {
  Verdict v = make("top", "bullet", Status::pass);
  v.version = "3.99";
  v.version_listed = false;
  const std::string text = unlisted({v, v, make("top", "ode", Status::pass)}, plain);
  EXPECT_EQ(lines(text).size(), 1u);
  EXPECT_TRUE(contains(text, "no row for") && contains(text, "bullet 3.99"));
  EXPECT_TRUE(contains(console_matrix({v}, plain), text));
}

TEST(Console, DetailsListEveryClaimUnderItsRun) {
  Verdict a = make("top", "bullet", Status::pass, 1e-4),
          b = make("top", "bullet", Status::non_finite, std::nan(""));
  b.claim = "axis";
  b.detail = "not finite from step 12";
  a.path = "rigid";
  a.settings = {{"erp2", "0"}};
  a.unforceable = {"the angle per step is clamped"};
  const std::string text = console_details({a, b}, plain);
  for (const char* part : {"path: rigid", "settings: erp2 = 0", "known limit: the angle", "0.0001 J", "+2.0",
                           "axis", "non-finite", "not finite from step 12"})
    EXPECT_TRUE(contains(text, part)) << part << "\n" << text;
  EXPECT_FALSE(contains(text, "nan"));
  EXPECT_EQ(console_details({}, plain), "");
}

// What did not run had "allowed 0 J".
TEST(Console, DetailsLeaveAllowedBlankWhereNothingWasMeasured) {
  for (const auto& [status, shows] : {std::pair{Status::pass, true},
                                      {Status::undecided, true},
                                      {Status::non_finite, true},
                                      {Status::unsupported, false},
                                      {Status::crash, false},
                                      {Status::timeout, false},
                                      {Status::protocol, false}}) {
    Verdict v = make("top", "bullet", status);
    v.allowed = 0.25;
    const std::string text = console_details({v}, plain);
    EXPECT_EQ(contains(text, "0.25 J"), shows) << text;
  }
}

TEST(Console, SaysWhichCostIsNotVerified) {
  Verdict v = make("top", "bullet", Status::pass);
  v.cpu_seconds = 3e-5, v.body_steps = 100;
  const std::string label = "300 ns each; not verified";
  EXPECT_TRUE(contains(console_details({v}, plain), label));
  v.cpu_verified = true;
  EXPECT_TRUE(contains(console_details({v}, plain), "300 ns each\n"));
}

TEST(Console, SummaryHasNoMatrix) {
  const std::vector<Verdict> verdicts = {make("top", "bullet", Status::pass),
                                         make("top", "ode", Status::fail)};
  const std::string text = console_summary(verdicts, plain), whole = console_matrix(verdicts, plain);
  EXPECT_TRUE(whole.ends_with("\n" + text));
  EXPECT_FALSE(contains(text, "✓"));
  EXPECT_TRUE(text.ends_with("0 differ\n")) << text;
}

TEST(Console, EscapesControlSequences) {
  const std::vector<std::string> hostile = {"\x1b[2J\x1b]0;owned\x07",
                                            "\x9b"
                                            "31m",
                                            "\xc2\x9b"
                                            "31m",
                                            "a\rb\bc",
                                            std::string("nul\0", 4),
                                            "\xff\xfe",
                                            "\u202eevil",
                                            "\u200b",
                                            "\x7f"};
  for (const std::string& text : hostile) {
    Verdict v = make("top", "bullet", Status::crash);
    v.expected = Status::pass;
    v.version_listed = false;
    for (std::string* field : {&v.scenario, &v.engine, &v.version, &v.claim, &v.unit, &v.detail,
                               &v.complaints, &v.integrator, &v.dt_text, &v.tolerance_reason,
                               &v.expected_reason, &v.reproduce, &v.path, &v.gyroscopic, &v.sampling})
      *field = text;
    v.settings = {{text, text}};
    v.unforceable = {text};
    for (const ConsoleOptions& options : {plain, ascii}) {
      std::string out = console_matrix({v}, options) + console_details({v}, options);
      std::string_view rest = out;
      while (!rest.empty()) {
        const Symbol symbol = take_symbol(rest);
        EXPECT_TRUE(symbol.valid);
        EXPECT_TRUE(symbol.code == '\n' || (options.utf8 ? is_printable : is_printable_ascii)(symbol.code));
      }
    }
  }
}

TEST(Console, ShortensLongStderrToItsEnd) {
  Verdict v = make("top", "ode", Status::crash);
  v.expected = Status::pass;
  v.complaints = std::string(5 << 20, 'x') + "\nLCP internal error\n";
  v.detail = std::string(5 << 20, 'y');
  const std::string text = difference(v, plain);
  EXPECT_LT(text.size(), 4000u);
  EXPECT_TRUE(contains(text, "    | LCP internal error"));
}

TEST(Console, ReportsNoVerdicts) {
  EXPECT_EQ(console_matrix({}, plain), "0 verdicts: 0 pass, 0 as expected, 0 differ\n");
}

TEST(Text, DecodesUtf8AsInStandard) {
  const auto keep_all = [](char32_t) { return true; };
  EXPECT_EQ(escaped("aé日😀", keep_all), "aé日😀");
  EXPECT_EQ(escaped("\xc0\xaf", keep_all), "\\xc0\\xaf");                    // overlong
  EXPECT_EQ(escaped("\xe0\x80\xaf", keep_all), "\\xe0\\x80\\xaf");           // overlong
  EXPECT_EQ(escaped("\xed\xa0\x80", keep_all), "\\xed\\xa0\\x80");           // surrogate
  EXPECT_EQ(escaped("\xf4\x90\x80\x80", keep_all), "\\xf4\\x90\\x80\\x80");  // above U+10FFFF
  EXPECT_EQ(escaped("\xe2\x82", keep_all), "\\xe2\\x82");                    // cut off
  EXPECT_EQ(escaped("a\nb\tc\x01", is_printable), "a\\nb\\tc\\x01");
  EXPECT_EQ(escaped("é", is_printable_ascii), "\\u{00e9}");
}

TEST(Text, WidthsAndCuts) {
  EXPECT_EQ(display_width("abc"), 3);
  EXPECT_EQ(display_width("日本"), 4);
  EXPECT_EQ(display_width("e\u0301"), 1);
  EXPECT_EQ(display_width("⌛"), 2);
  EXPECT_EQ(fitted("日本語", 4, "…"), "日… ");
  EXPECT_EQ(fitted("ab", 4, "…"), "ab  ");
  EXPECT_EQ(head("日本語", 4), "日 [6 more bytes]");
  EXPECT_EQ(tail("日本語", 4), "[6 bytes before] 語");
  EXPECT_EQ(head("ab", 2), "ab");
}

}  // namespace
}  // namespace cylon::reports
