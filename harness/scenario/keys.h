// The keys that a scenario file may hold: one table for the reader's checks and for the JSON Schema.
// Knows the words and their ranges, not what becomes of them.
#pragma once

#include "harness/core/range.h"

#include <string>
#include <string_view>
#include <vector>

namespace cylon::scenario {

/// What a key's value looks like in the file; in words: form_of().
enum class Kind {
  text,        ///< "…", one of `choices` where there are any.
  number,      ///< 0.5 or 3
  whole,       ///< 3
  boolean,     ///< true or false
  vector,      ///< [x, y, z]
  counts,      ///< [3, 3, 1], whole numbers
  quaternion,  ///< [w, x, y, z]
  moments,     ///< Three numbers, or nine.
  numbers,     ///< [0, 0.5, …]
  points,      ///< [[x, y, z], …]
  triangles,   ///< [[0, 1, 2], …]
  texts,       ///< ["…", …]
  named,       ///< { k = 0.5, … }
  pair,        ///< ["…", "…"]
  step,        ///< 0.001 or "1/60"
  steps,       ///< [0.001, "1/60"]
  sample,      ///< 0.1 or "step"
  until,       ///< 4.5 or "horizon"
  table,       ///< One table of `spec`.
  tables,      ///< An array of tables of `spec`.
  text_or_table
};

using core::Range;

struct Spec;

struct Key {
  std::string name;
  Kind kind = Kind::text;
  std::string meaning = {};  ///< For people: the schema's description.
  std::string unit = {};
  std::string absent = {};  ///< What an absent key means: a value as in the file, or words; empty: nothing.
  bool required = false;
  std::string_view worker = {};  ///< Workers get the key "always" or "optional"; empty: never.
  Range range = {};
  std::vector<std::string> choices = {};
  const Spec* (*spec)() = nullptr;  ///< Of a table.
};

/// The keys of one table.  Where `tag` is set, its value selects one of the variants, whose keys come on top.
struct Spec {
  struct Variant {
    std::string name;
    std::vector<Key> keys;
  };
  std::string label;  ///< As in the file: "[[body]]".
  std::vector<Key> keys;
  std::string tag = {};
  std::vector<Variant> variants = {};
};

/// "a number", "three numbers [x, y, z]".
std::string_view form_of(Kind);

/// "> 0 kg", "in [0, 1]", ">= 0 N/m".
std::string describe(const Range&, const std::string& unit);

/// The whole scenario file; all else hangs from it.
const Spec& scenario_keys();

/// Of `tolerance.constants`: 1 to this.
inline constexpr int highest_order = 12;

/// scenarios/expected.toml, scenarios/data/expected_rows.toml and scenarios/suites/*.toml.
const Spec& expected_keys();
const Spec& expected_row_keys();
const Spec& suite_keys();

}  // namespace cylon::scenario
