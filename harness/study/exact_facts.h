// What a run of a deterministic engine repeats bit for bit.
#pragma once

#include "harness/core/recording.h"

#include <cstdint>
#include <string>

namespace cylon::study {

struct ExactFacts {
  std::string state_hash;   ///< FNV-1a 64 of the steps kept and the bits of all their states, 16 hex digits.
  std::int64_t events = 0;  ///< Of every kind, of the pairs that the claims watch.
  std::int64_t contacts = 0;  ///< Bounces among them.
};

ExactFacts exact_facts(const core::Recording&);

}  // namespace cylon::study
