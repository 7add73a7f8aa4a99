// What somebody asked of the viewer that cannot be.
#pragma once

#include <stdexcept>

namespace cylon::view {

/// what() is a sentence that names the key and the value; the page shows it.
struct BadCommand : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace cylon::view
