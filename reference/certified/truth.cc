#include "reference/certified/truth.h"

#include "reference/certified/cache.h"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>

namespace cylon::certified {

Solution solution(const core::Scene& scene, double horizon, double most_work) {
  const std::string key = key_of(scene, horizon);
  auto dense = std::make_shared<Dense>();
  if (auto known = load(key); known && known->bodies == scene.bodies.size()) {
    *dense = std::move(*known);
  } else {
    *dense = make_dense(scene, horizon, most_work);
    keep(key, *dense);
  }
  require_work(dense->work, most_work, horizon);  // the same answer with a cache and without
  Solution result;
  result.truth.error = dense->error;
  result.truth.horizon = dense->horizon;
  result.truth.source = "certified: Taylor series in ball arithmetic, with remainder";
  result.truth.state = [dense](double t) {
    if (!(t >= 0) || t > dense->horizon * (1 + 1e-12))
      throw std::invalid_argument(
          fmt::format("the certified truth is known over [0, {}] s, not at {} s", dense->horizon, t));
    return dense->at(t);
  };
  result.ulp = dense->ulp;
  result.lost = dense->lost;
  result.work = dense->work;
  return result;
}

}  // namespace cylon::certified
