// libFuzzer's entry to the target that CMake names (cmake/fuzz.cmake).
#include "tests/fuzz/targets/targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

// What the target throws ends the process: libFuzzer then keeps the bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  cylon::fuzz::CYLON_FUZZ_TARGET({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
