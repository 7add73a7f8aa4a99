// What the tables of keys are written with: a row for each shape of key, and the tables themselves.
#pragma once

#include "harness/scenario/keys.h"

#include <string>
#include <vector>

namespace cylon::scenario {

using core::any, core::positive, core::not_negative, core::unit_interval;

/// A text, one of `choices` where there are any.
Key word(std::string name, std::string meaning, std::vector<std::string> choices = {});

/// The words of an enumeration of core, from its first value to `last`: choices.
template <class Enum>
std::vector<std::string> words(Enum last) {
  std::vector<std::string> result;
  for (int i = 0; i <= static_cast<int>(last); ++i) result.emplace_back(name(static_cast<Enum>(i)));
  return result;
}

/// A kind that has neither unit nor range.
Key plain(std::string name, Kind, std::string meaning);

/// A time in seconds, of which the kind says what else it may be.
Key seconds(std::string name, Kind, std::string meaning);

/// A number, a whole number, a vector whose numbers lie in the range.
Key real(std::string name, std::string unit, std::string meaning, Range = any);
Key integer(std::string name, std::string meaning, Range);
Key arrow(std::string name, std::string unit, std::string meaning, Range = any);

/// A table, or tables, with keys of their own.
Key nested(std::string name, Kind, const Spec* (*spec)(), std::string meaning);

/// The same, and an error where it is absent; or with what it means then.
Key required(Key);
Key absent(std::string means, Key);

/// The tables of a scenario file, by what they are about.
const Spec* body_spec();
const Spec* lattice_spec();
const Spec* cloud_spec();
const Spec* joint_spec();
const Spec* claim_spec();
const Spec* theory_spec();

/// The words of Theory::Forces.
const std::vector<std::string>& forces_of_theory();

}  // namespace cylon::scenario
