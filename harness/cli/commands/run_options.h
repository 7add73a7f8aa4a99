// What `cylon run` is asked for.
#pragma once

#include "harness/cli/options.h"
#include "harness/cli/selection.h"
#include "harness/cli/shard.h"
#include "harness/cli/traces.h"

#include <memory>
#include <string>

namespace cylon::cli {

struct RunOptions {
  Request request;
  std::string json, junit, csv, html, traces, plots;
  Trajectories trajectories = Trajectories::all;
  ShardOptions shard;
  int jobs = 0;
  double timeout = 60, memory = 4;
  bool rerun_failed = false, resume = false, verbose = false, brief = false, charts = false;

  bool wants_traces() const { return charts || !html.empty() || !traces.empty() || !plots.empty(); }
};

/// Adds them to the command.
void add_options(App&, const std::shared_ptr<RunOptions>&);

/// What a row needs to come out again, besides the cell: limits that are not the usual ones.
std::string unusual_limits(const RunOptions&);

}  // namespace cylon::cli
