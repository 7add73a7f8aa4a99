#include "reference/exact/wide.h"

namespace cylon::exact {

WideQuaternion turn_between(const WideVector& from, const WideVector& to) {
  return WideQuaternion::FromTwoVectors(from, to);
}

}  // namespace cylon::exact
