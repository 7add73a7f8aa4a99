// Work that several processes share: which part of it is this one's.
//
// A unit of work is named by what is asked and keyed by its content, so that every machine which has the same
// files and engines divides the same work in the same way, without talking to the others.
#pragma once

#include "harness/cli/parser.h"

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace cylon::cli {

class Farm;

/// What is done, or not, as a whole: a cell of `run`, a scenario of `trade` and `matrix`, a search of `limits`, some
/// scenes of `hunt`.
struct Unit {
  std::string key;   ///< Of all that decides its result.
  std::string name;  ///< As the user names it.
  friend bool operator==(const Unit&, const Unit&) = default;
};

/// One of several equal parts, or what a rank of a farm gets, unit by unit.
struct Shard {
  std::size_t index = 1, count = 1;  ///< 1 <= index <= count.
  bool by_time = false;              ///< Parts of equal durations; else of equal chances.
  std::string said_by;               ///< "--shard", or the variable of the environment.
  Farm* farm = nullptr;              ///< That hands out the units; then index - 1 is the rank.

  /// "2-of-8", "rank-2-of-8"
  std::string label() const;
};

/// --shard and --shard-by as they were given.
struct ShardOptions {
  std::string shard;
  bool by_time = false;
  friend bool operator==(const ShardOptions&, const ShardOptions&) = default;
};

/// `units` says what is shared out: "cells".
void add_shard_options(App&, ShardOptions&, const std::string& units);

/// A farm's where there is one, else the shard that the option asks for.  Without it, that of GTEST_SHARD_INDEX, TEST_SHARD_INDEX (Bazel) or
/// SLURM_ARRAY_TASK_ID with the variables beside them, where one of them is set; a file that tells the test
/// runner so is touched.  Nothing: all the work is this process's.  Throws core::InputError for what is no
/// shard, for half of a runner's variables and for those that contradict each other, for a job array with gaps, and
/// for --shard in a farm.
std::optional<Shard> shard_asked(const ShardOptions&, Farm* = nullptr);

/// Seconds that units took before, by name.
using Durations = std::map<std::string, double>;

/// The order in which units that are handed out one by one end first: the longest first (Graham 1969: at most 4/3 of
/// the best); a unit of unknown duration counts as the mean of the known.
std::vector<std::size_t> longest_first(std::span<const Unit>, const Durations&);

/// Whether each unit is this shard's.  Every unit belongs to exactly one of the `count` shards, and which does
/// not depend on the order of the units.
///
/// By hash: FNV-1a of the key, modulo count.  By time: the longest first, each to the shard that has least.
std::vector<bool> part_of(const Shard&, std::span<const Unit>, const Durations&);

}  // namespace cylon::cli
