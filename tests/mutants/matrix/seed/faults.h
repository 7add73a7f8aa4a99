// The seed's engine with at most one of its errata left in.
#pragma once

namespace cylon::mutants::seed {

/// faulty(n): whether erratum n is left in.
struct Faults {
  int erratum = 0;  ///< 0: none.
  bool operator()(int n) const { return erratum == n; }
};

}  // namespace cylon::mutants::seed
