// One fault of one engine, as small as it gets: what a maintainer is handed.
#pragma once

#include "harness/hunt/oracle.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cylon::hunt {

/// What another engine does with the card's scene.
struct Opinion {
  std::string engine;
  bool refuses = false;
  bool faulty = false;  ///< It has the same fault.
};

struct Card {
  std::string engine, version;
  std::string signature;  ///< Oracle, and what the least scene needs: "energy: box, gravity, hinge".
  Trial trial;            ///< The least one.
  Fault fault;
  std::string family;  ///< Of the scene in which it was found.
  std::uint64_t seed = 0, number = 0;
  std::size_t hits = 1;  ///< Scenes that were found with it.
  std::vector<Opinion> opinions;

  /// A name for files: "bullet-energy-1f03".  From the signature.
  std::string file_stem() const;
};

/// "energy: 2 boxes, gravity, hinge": the oracle, then the kinds of parts in the scene.
std::string signature(const Fault&, const core::Scene&);

/// What a card's file says of itself, in its tags.
struct Kept {
  Trial trial;
  std::string engine, oracle;
  double measured = 0;  ///< At the card's own step.
};

/// Reads a card's scenario file.  Throws core::InputError for what is none.
Kept read_card(const std::string& file);

/// The scenario file: a comment that says what it shows, and the claim that fails.
std::string scenario_toml(const Card&);

/// The same for a person: what should happen, what happens at each step, who else does it, and the command.
std::string markdown(const Card&);

}  // namespace cylon::hunt
