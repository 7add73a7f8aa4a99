// Pinned binaries: an engine as it was, to which the times of every recording are held, so that a machine
// that becomes faster or slower changes no ratio.
#pragma once

#include "harness/process/engines.h"
#include "harness/study/cell.h"
#include "harness/tracking/store/store.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cylon::tracking {

struct PinnedEngine {
  std::string name;  ///< Of the anchor.
  process::EngineRow row;
};

/// The anchors of a store, ready to run: those that this user pinned.  Of others, whose program may be
/// anything, stderr says that they are left out.  Throws core::InputError for one whose binary is gone or
/// another than the one that was pinned, and for one that was pinned under --sandbox where there is no sandbox now.
std::vector<PinnedEngine> pinned_engines(const store::Store&, const std::filesystem::path& store_file);

/// The anchor in place of a cell's engine: with its variant where it is the same engine, else as it is.
process::EngineChoice in_place_of(const process::EngineChoice&, const PinnedEngine&);

}  // namespace cylon::tracking
