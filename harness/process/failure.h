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

/// A scene that the engine cannot express: the worker is well, and may be asked for another.
struct Refused : Failure {
  explicit Refused(const std::string& reason) : Failure(results::Status::unsupported, reason) {}
};

}  // namespace cylon::process
