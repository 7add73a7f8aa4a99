// Random scenes that are valid by construction: bodies do not overlap, joints are closed, numbers have three
// digits.  Seed and number are the scene's name.  Of sixteen scenes one is of the unusual families, and one is of another size,
// with another mass and another step.
#pragma once

#include "harness/hunt/trial.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace cylon::hunt {

class Dice;

/// A kind of scene.
struct Family {
  std::string_view name;    ///< "mechanism"
  std::string_view says;    ///< What it makes, one clause.
  int weight;               ///< How often, among the sum of all.
  std::uint64_t long_runs;  ///< One scene in so many has 1000 steps, for what is slow to show; 0: none.
  void (*make)(Dice&, core::Scene&);
  bool unusual = false;  ///< Of every sixteenth scene alone.
};

std::span<const Family> families();

struct Generated {
  Trial trial;
  std::string family;
};

/// Scene n of a seed.
Generated generate(std::uint64_t seed, std::uint64_t n);

}  // namespace cylon::hunt
