#include "harness/cli/app.h"

int main(int argc, char** argv) { return cylon::cli::main(argc, argv); }
