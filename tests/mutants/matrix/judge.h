// Who judges: a column of the kill matrix.  Nothing here knows who the subject is.
#pragma once

#include "tests/mutants/matrix/subject.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace cylon::mutants {

/// One claim's outcome.
struct Finding {
  std::string claim;
  double measured = 0;
  double allowed = 0;

  bool guilty() const;
  /// log10(measured / allowed), within [-99, 99]: > 0 where guilty.
  double margin() const;
};

struct Judge {
  std::string name;
  std::string asks;  ///< One line.
  /// Nothing where the subject cannot express the scene.
  std::function<std::optional<std::vector<Finding>>(const Subject&)> findings;
};

std::vector<Judge> scene_judges();
std::vector<Judge> relation_judges();

/// All columns, scenes first.
const std::vector<Judge>& judges();

}  // namespace cylon::mutants
