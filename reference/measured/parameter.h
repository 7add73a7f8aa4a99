// What of a model may be fitted to measured motions: kinds of parameters, each a row that says what it changes.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace cylon::measured {

struct Experiment;

/// One number of an experiment's model, with where it may lie.
struct Parameter {
  std::string name;  ///< The user's.
  std::string kind;  ///< One of parameter_kinds().
  std::string body;  ///< Of the scene, where the kind is of one; empty: all that were measured.
  double low = 0, start = 0, high = 0;  ///< low <= start <= high, low < high.
};

struct ParameterKind {
  std::string name, meaning;
  double least = 0;  ///< Below this there is no such thing.
  double most = 0;   ///< Above this neither.
  void (*apply)(Experiment&, const Parameter&, double value);
};

const std::vector<ParameterKind>& parameter_kinds();

/// The experiment with those values: its scene and, where lengths are scaled, its data.  As many values as parameters.
Experiment with_values(const Experiment&, std::span<const Parameter>, std::span<const double> values);

}  // namespace cylon::measured
