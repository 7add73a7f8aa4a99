#include "harness/scenario/measured_truth.h"

namespace cylon::scenario {

std::function<MeasuredReader>& measured_reader() {
  static std::function<MeasuredReader> reader;
  return reader;
}

}  // namespace cylon::scenario
