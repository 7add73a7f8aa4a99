#include "reference/applied/parts.h"

#include "harness/core/overloaded.h"

namespace cylon::applied {

std::vector<core::Part> parts_of(const core::Shape& shape) {
  const auto alone = [](const auto& primitive) { return std::vector{core::Part{.shape = primitive}}; };
  return std::visit(core::Overloaded{[](const core::Compound& compound) { return compound.parts; }, alone},
                    shape);
}

}  // namespace cylon::applied
