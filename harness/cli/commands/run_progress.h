// How far a run is.
#pragma once

#include "harness/results/verdict.h"
#include "harness/study/cell.h"

#include <cstddef>
#include <vector>

namespace cylon::cli {

/// On one line that is written over, on a terminal; nothing elsewhere.
class Progress {
 public:
  Progress(bool on, std::size_t total) : on_(on), total_(total) {}
  void done(const study::Cell&, const std::vector<results::Verdict>& rows);
  void clear() const;

 private:
  bool on_;
  std::size_t total_, finished_ = 0;
};

}  // namespace cylon::cli
