// A worker's failure that is a verdict of its row.
#pragma once

#include "harness/results/verdict.h"

#include <stdexcept>
#include <string>

namespace cylon::process {

/// The child failed in a way that is a verdict: unsupported (it cannot start), crash, timeout or protocol.
struct Failure : std::runtime_error {
  Failure(results::Status s, const std::string& reason) : std::runtime_error(reason), status(s) {}
  results::Status status;
};

}  // namespace cylon::process
