#include "harness/cli/commands/app.h"

int main(int argc, char** argv) { return cylon::cli::main(argc, argv); }
