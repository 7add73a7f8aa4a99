// A worker: the one engine build that is linked here, behind the protocol.
#include "cylon/worker.h"

int main() { return cylon::worker::run(cylon::core::make_simulator); }
