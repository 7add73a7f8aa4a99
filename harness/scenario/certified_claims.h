// Claims that follow the certified truth.  It costs an integration, so that it is solved when it is first
// needed, and not when the file is read.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/reader.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cylon::scenario {

struct Scenario;

struct CertifiedClaim {
  std::size_t index;  ///< Among the scenario's claims.
  Table table;        ///< Where it is written.
};

class CertifiedClaims {
 public:
  /// The document holds what the tables point to.
  CertifiedClaims(std::shared_ptr<const Document> document, std::vector<CertifiedClaim> claims);

  /// The scenario's claims, with the truth, its error, until = "horizon" and the label of each of these.
  /// Throws core::InputError where the certified truth does not serve the scene, does not reach the claim's
  /// horizon, or is looser than a tenth of the tolerance; certified::TooMuchWork where `most_work` is less
  /// than budget::truth_work and is spent.
  std::vector<core::Claim> solved(const Scenario&, double most_work) const;

 private:
  std::shared_ptr<const Document> document_;
  std::vector<CertifiedClaim> claims_;
};

}  // namespace cylon::scenario
