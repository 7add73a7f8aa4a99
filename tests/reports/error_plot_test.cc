// Errors over time as pictures: what is drawn is what was measured.
#include "reports/error_plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace cylon::reports {
namespace {

reports::ErrorCurve growing(const std::string& claim, double most, double allowed) {
  reports::ErrorCurve curve{claim, "m", allowed, {}, {}, {}};
  for (int i = 0; i <= 200; ++i) {
    curve.time.push_back(0.05 * i);
    curve.value.push_back(most * std::pow(10, 4.0 * (i / 200.0 - 1)));
    if (!curve.first_violation && curve.value.back() > allowed)
      curve.first_violation = {curve.time.back(), std::int64_t{5} * i, curve.value.back()};
  }
  return curve;
}

std::vector<std::string> lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(in, line);) all.push_back(line);
  return all;
}

// A straight line on a logarithmic axis, from the lower left to the upper right.
TEST(ErrorChart, AnExponentialIsAStraightLine) {
  const auto rows = lines(error_chart(growing("position", 1, 1e-2), {.width = 60, .utf8 = false}));
  ASSERT_EQ(rows.size(), 9u);
  EXPECT_EQ(rows[0], "position, allowed 0.01 m: first exceeded at t = 5.05 s, step 505");
  EXPECT_EQ(rows[1].substr(0, 9), "    1e0 |");
  EXPECT_EQ(rows[7].substr(0, 9), "   1e-4 |");
  EXPECT_EQ(rows[4].substr(0, 9), "allowed |") << "1e-2 is half-way between 1e-4 and 1";
  std::size_t last = std::string::npos;
  for (std::size_t row = 1; row <= 7; ++row) {  // downward: ever further to the left
    const std::size_t first = rows[row].find('*'), end = rows[row].rfind('*');
    ASSERT_NE(first, std::string::npos) << rows[row];
    EXPECT_LE(end, last) << rows[row];  // npos at first, the largest
    last = first;
  }
  EXPECT_EQ(rows[7].find('*'), 9u);
  EXPECT_EQ(rows[1].rfind('*'), 9u + 49);
  EXPECT_NE(rows[8].find("10 s"), std::string::npos);
}

TEST(ErrorChart, BrailleAndAsciiAreAsWideAsTheTerminalAllows) {
  for (const int width : {10, 40, 100, 400})
    for (const bool utf8 : {false, true})
      for (const std::string& row : lines(error_chart(growing("x", 3, 1), {.width = width, .utf8 = utf8})))
        if (row.find("allowed 1") == std::string::npos) {
          std::size_t columns = 0;
          for (const char c : row) columns += (c & 0xc0) != 0x80;
          EXPECT_LE(columns, static_cast<std::size_t>(std::max(30, width))) << row;
        }
}

TEST(ErrorChart, NonFiniteValuesLeaveGap) {
  reports::ErrorCurve curve = growing("position", 1, 1e-2);
  for (std::size_t i = 100; i < curve.value.size(); ++i) curve.value[i] = NAN;
  const auto rows = lines(error_chart(curve, {.width = 60, .utf8 = false}));
  for (std::size_t row = 1; row <= 7; ++row)
    EXPECT_EQ(rows[row].find('*', 9 + 26), std::string::npos) << rows[row];
  for (double& value : curve.value) value = 0;
  EXPECT_NE(error_chart(curve, {}).find("no error to plot"), std::string::npos);
}

TEST(ErrorChart, EscapesControlSequencesInNames) {
  EXPECT_EQ(error_chart(growing("\x1b[2J", 1, 1), {}).find('\x1b'), std::string::npos);
}

TEST(ErrorPlot, ShowsWorstClaim) {
  reports::Trace good, bad;
  good.scenario = bad.scenario = "top", good.engine = "in-house", bad.engine = "ode";
  good.dt_text = bad.dt_text = "0.01";
  good.errors = {growing("energy", 1e-9, 1e-3), growing("axis", 1e-6, 1e-2)};
  bad.errors = {growing("energy", 1e-4, 1e-3), growing("axis", 0.5, 1e-2)};
  const std::vector<const reports::Trace*> runs = {&good, &bad};
  const Plot plot = error_plot(runs);
  EXPECT_EQ(plot.title, "top: axis");
  EXPECT_EQ(plot.line, 1e-2);
  ASSERT_EQ(plot.curves.size(), 2u);
  EXPECT_EQ(plot.curves[1].name, "ode, 10 ms");
  EXPECT_EQ(plot.curves[1].points.size(), 201u);
  const std::string svg = to_svg(plot);
  EXPECT_NE(svg.find(">10</text>"), std::string::npos) << "seconds, not decades";
  EXPECT_NE(svg.find(">1e-2</text>"), std::string::npos);
  // Eight marks or so on a curve of 201 points, and one in the legend.
  std::size_t marks = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at + 1))
    ++marks;
  EXPECT_GE(marks, 8u);
  EXPECT_LE(marks, 12u);
}

TEST(ErrorPlot, NoCurvesGiveEmptyPlot) {
  EXPECT_TRUE(error_plot({}).curves.empty());
  EXPECT_NE(to_svg(error_plot({})).find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace cylon::reports
