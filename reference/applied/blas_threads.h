// The threads of OpenBLAS below an engine.  By default it has as many as the machine has processors, and divides sums among
// them: the last bits of a motion then depend on the machine, and threads wait for each other over matrices of a few rows.
#pragma once

extern "C" void openblas_set_num_threads(int) __attribute__((weak));  // another BLAS has none

namespace cylon::applied {

/// Of this process, from now on.
inline void use_one_blas_thread() {
  if (openblas_set_num_threads) openblas_set_num_threads(1);
}

}  // namespace cylon::applied
