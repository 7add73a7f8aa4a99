// Scenario x engine: the rows folded into one cell each.
#pragma once

#include "harness/results/verdict.h"
#include "reports/console_options.h"

#include <string>
#include <vector>

namespace cylon::reports {

/// All claims of one scenario at one step by one engine and integrator.
struct Cell {
  /// By pass < undecided < low-quality < fail < non-finite < timeout < crash < protocol; unsupported only where all claims are.
  results::Status worst = results::Status::pass;
  double digits = 99;        ///< Least over the measured claims.
  bool differs = false;      ///< Some claim is not as expected.
  bool closed_form = false;  ///< The engine took no steps.
  int substeps = 1;          ///< That the engine made of each step.
  bool empty = true;
  std::vector<std::string>
      passed_by;  ///< Of a refusal: the columns that pass the same row, so that it is avoidable.
};

/// A row per scenario (and step, where a scenario was run at several), a column per engine (and integrator,
/// where an engine ran several), both in order of first appearance.
struct Matrix {
  std::vector<std::string> scenarios, engines;
  std::vector<std::vector<Cell>> cells;  ///< [scenario][engine]
  std::vector<std::string> scene_of;     ///< Of each row.
  std::vector<std::string> engine_of;    ///< Of each column.
};

Matrix fold(const std::vector<results::Verdict>&);

/// A cell as text: "✓ +3.2", "✗ -1.0 !", "✓ +12.1 =", "– avoidable"; "" for an empty one.
std::string cell_text(const Cell&, const ConsoleOptions&);

/// The matrix as text; where the terminal is too narrow for all engines, in blocks of columns.
std::string draw(const Matrix&, const ConsoleOptions&);

/// How many scenes each engine runs at every step and with every integrator that was asked, and each refusal of a row that another engine passes: an engine
/// that refuses has not passed.
std::string refusals(const Matrix&, const ConsoleOptions&);

/// What the glyphs in this matrix mean.
std::string legend(const Matrix&, const ConsoleOptions&);

}  // namespace cylon::reports
