// `follows = "certified"` and `until = "horizon"`.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/reader.h"
#include "reference/certified/truth.h"

#include <map>
#include <string_view>

namespace cylon::scenario {

/// The name that a claim follows it by.
inline constexpr std::string_view certified_name = "certified";

/// The certified solutions of one scene, each made once per horizon, within a budget for all of them.
class CertifiedTruths {
 public:
  explicit CertifiedTruths(double most_work) : most_work_(most_work) {}

  /// Over [0, horizon], or less where chaos takes the meaning from it.  Fails at the claim's `follows` where
  /// the scene is not smooth or budget::truth_work is spent.  Throws certified::TooMuchWork where a smaller
  /// budget is.
  const certified::Solution& at(const Table& claim, const core::Scene&, double horizon);

 private:
  std::map<double, certified::Solution> known_;
  double most_work_, work_ = 0;
};

/// Fails unless the solution reaches the claim's whole horizon.
void require_whole(const Table& claim, const certified::Solution&, double horizon);

/// The last of 200 even times of the duration up to which an error of one unit in the last place of the
/// initial state (certified::Amplified) stays below a tenth of what the claim's tolerance allows.  Fails at
/// `until` where there is none.
double predictable(const Table&, const core::Claim&, const core::Scene&, const certified::Solution&,
                   double duration);

}  // namespace cylon::scenario
