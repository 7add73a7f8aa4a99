#include "reference/certified/cache.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

void cache(std::string_view bytes) {
  const auto dense = certified::parse_body(bytes);
  if (!dense) return;
  const volatile bool lost = dense->lost;  // a load that UndefinedBehaviorSanitizer looks at
  static_cast<void>(lost);
  for (const double t : {0.0, dense->horizon / 2, dense->horizon})
    if (dense->at(t).size() != dense->bodies) throw Broken("a solution has a state of all bodies");
}

}  // namespace cylon::fuzz
