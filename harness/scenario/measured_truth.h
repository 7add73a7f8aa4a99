// `follows = { measured = "…", run = "…" }`: what reads it knows scenarios, so that it gives itself in.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/content_hash.h"
#include "harness/scenario/reader.h"

#include <filesystem>
#include <functional>

namespace cylon::scenario {

/// The truth of such a table, whose files are named relative to the folder, of that scene; adds what it reads to the hash.
/// Fails at the table's keys.
using MeasuredReader = core::MeasuredTruth(const Table& follows, const std::filesystem::path& folder,
                                           const core::Scene&, core::ContentHash&);

/// reference/measured sets it at the start of a program; without it such claims are refused.
std::function<MeasuredReader>& measured_reader();

}  // namespace cylon::scenario
