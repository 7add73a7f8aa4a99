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
  bool of_file() const;  ///< A claim as it stands in its file: neither by theory, nor a relation.
  bool of_relation() const;
  /// log10(measured / allowed), within [-99, 99]: > 0 where guilty.
  double margin() const;
};

struct Judge {
  std::string name;
  std::string asks;  ///< One line.
  bool shipped;      ///< A user who has the scenarios has this judge.
  /// Nothing where the subject cannot express the scene.
  std::function<std::optional<std::vector<Finding>>(const Subject&)> findings;
};

std::vector<Judge> scene_judges();
std::vector<Judge> relation_judges();
std::vector<Judge> shipped_relation_judges();  ///< study/relations.h, as `cylon run --metamorphic` asks.

/// All columns, scenes first.
const std::vector<Judge>& judges();

}  // namespace cylon::mutants
