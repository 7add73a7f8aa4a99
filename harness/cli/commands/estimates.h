// Scores of predictions as text and JSON, for the commands that make them.
#pragma once

#include "harness/tracking/statistics/bootstrap.h"
#include "harness/validation/horizon.h"
#include "harness/validation/score.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cylon::cli {

/// "12.3 mm [10.1, 14.0]", or "not known".
std::string shown(const validation::Estimate&, double scale, const char* unit, int digits = 1);

/// A number, or null where it is not finite.
nlohmann::ordered_json number(double);
nlohmann::ordered_json numbers(const std::vector<double>&);

nlohmann::ordered_json to_json(const validation::Estimate&);
nlohmann::ordered_json to_json(const validation::RunScore&);
nlohmann::ordered_json to_json(const validation::Summary&);

nlohmann::ordered_json to_json(const validation::Horizon&);
nlohmann::ordered_json to_json(const validation::HorizonSummary&);

/// A line for each score; that of the band where it has members.
std::string told(const validation::Summary&, int members);
std::string told(const validation::HorizonSummary&, int members);

/// Whether the columns of places and of velocities go together, a line for each pair.
std::string told_kinematics(const measured::Experiment&);

/// In how many runs the body flies after a touch, and in how many the energy lost in it is known: a line for each touch, and as JSON.
std::string told_touches(const measured::Experiment&);
nlohmann::ordered_json touches_json(const measured::Experiment&);

/// --dt of an experiment's model; empty: its own.  Throws core::InputError where a frame is no whole number of steps.
void set_step(measured::Experiment&, const std::string& step);

/// --runs N of an experiment: the first by the hashes of their names; 0: all.  Throws core::InputError where it has fewer.
measured::Experiment first_runs(const measured::Experiment&, int count);

/// The experiment with "NAME=VALUE" of its parameters.  Throws core::InputError for a name that it has not, what is no number, or a
/// value outside the parameter's range.
measured::Experiment set_values(const measured::Experiment&, const std::vector<std::string>& values);

}  // namespace cylon::cli
