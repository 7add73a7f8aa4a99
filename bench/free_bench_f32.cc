#include "bench/free_bench.h"

int main(int, char** argv) { return cylon::bench::free_bench(argv[0]); }
