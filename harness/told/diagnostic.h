// What an engine says, as data, of how a run of it went: one entry for each part of the scene and each matter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cylon::told {

struct Diagnostic {
  std::string kind;  ///< A word of the engine's; docs/in-house.md lists those of the in-house engine.
  std::vector<std::string> bodies;  ///< Of the part: the first of them; none: the whole scene.
  std::size_t body_count = 0;       ///< How many there are.
  std::string method;               ///< How the part moves, in words: "events by dop853"; "": not told.
  int order = 0;                    ///< Of the method; 0: none, or not told.
  double since = 0;                 ///< When it was first so [s].
  std::optional<double> until;      ///< When the part ended that it was of [s].
  std::int64_t count = 1;           ///< How often.
  std::optional<double> limit;      ///< What was asked for (a tolerance), or the cap that was hit.
  std::string limit_unit;           ///< "1": a pure number; "": there is no limit.
  std::optional<double> reached;    ///< The worst that came of it (an error, a residual); absent: not known.
  std::string unit;                 ///< Of what was reached.
  std::string text;                 ///< One sentence that says it all.

  bool operator==(const Diagnostic&) const = default;
};

/// Kind, sentence, method and order: "tolerance-missed: from t = … [events by dop853, order 8]".
std::string in_words(const Diagnostic&);

}  // namespace cylon::told
