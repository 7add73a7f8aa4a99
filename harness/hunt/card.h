// One fault of one engine, as small as it gets: what a maintainer is handed.
#pragma once

#include "harness/hunt/examine.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::hunt {

/// What another engine does with the card's scene.
struct Opinion {
  std::string engine, version;
  bool refuses = false;
  bool faulty = false;  ///< It has the same fault.

  /// "refused", "the same fault", "no fault".
  std::string_view says() const { return refuses ? "refused" : faulty ? "the same fault" : "no fault"; }
};

struct Card {
  std::string engine, version;
  std::string signature;  ///< Oracle, and what the least scene needs: "energy: 1 body, gravity, hinge".
  Trial trial;            ///< The least one.
  Fault fault;
  std::string family;  ///< Of the scene in which it was found.
  std::string source;  ///< Source::name.
  std::uint64_t number = 0;
  std::size_t hits = 1;  ///< Scenes that were found with it.
  std::vector<Opinion> opinions;

  /// A name for files: "bullet-energy-1f03".  From the signature.
  std::string file_stem() const;
};

/// "energy: 2 bodies, box, gravity, hinge": the oracle, then the kinds of parts in the scene; and, where it is not at
/// every step, when.
std::string signature(const Fault&, const core::Scene&);

/// What a card's file says of itself, in its tags.
struct Kept {
  Trial trial;
  std::string engine, oracle;
  Kind kind = Kind::every_step;
  double measured = 0;  ///< At the card's own step.
};

/// The scenario files of a folder of cards, by name.  Throws core::InputError where it cannot be read.
std::vector<std::filesystem::path> card_files(const std::filesystem::path& folder);

/// Reads a card's scenario file.  Throws core::InputError for what is none.
Kept read_card(const std::string& file);

/// What became of a card's fault in an engine.
struct Replayed {
  enum class What { fixed, still_there, changed, refused } what = What::fixed;
  double measured = 0, allowed = 0;  ///< Now; 0 where it is fixed or refused.
  std::string unit;
};
/// "fixed", "still there", "changed", "refused".
std::string_view name(Replayed::What);
Replayed replay(const Kept&, const process::EngineChoice&, const process::Limits&);

/// "0.12 J at 0.01 s, 0.13 J at 0.005 s", or what an engine that did not end said.
std::string measured(const Card&);

/// Why it is no truncation, of its kind.
std::string reason(const Fault&);

/// The command that shows the fault of the card in `file`.
std::string command(const Card&, const std::string& file);

/// The scenario file: a comment that says what it shows, and the claim that fails.
std::string scenario_toml(const Card&);

/// The same for a person: what should happen, what happens at each step, who else does it, and the command.  `after` is
/// put before the scene.
std::string markdown(const Card&, const std::string& after = "");

}  // namespace cylon::hunt
