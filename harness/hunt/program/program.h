// A program of some forty lines of its own against an engine's API that shows a card's fault without Cylon.
#pragma once

#include "harness/hunt/card.h"

#include <optional>
#include <string>

namespace cylon::hunt {

struct Program {
  std::string file;  ///< Its name: the card's, with the ending of its language.
  std::string text;
  std::string needs;    ///< Installs what it needs.
  std::string command;  ///< Compiles and runs it, in its folder.
  double prints = 0;    ///< The number that it must print, as Cylon's own run of the scene gives it.
  std::string unit;     ///< Of that.
};

/// The program, or why there is none: an engine, a part of the scene, a setting or an oracle without a row.
struct Written {
  std::optional<Program> program;
  std::string none;
};

/// Runs the engine for what the program must print.  Throws what process::run throws.
Written write_program(const Card&, const process::EngineChoice&, const process::Limits&);

/// For the card's page: the program with its command, or the reason.
std::string markdown(const Written&);

}  // namespace cylon::hunt
