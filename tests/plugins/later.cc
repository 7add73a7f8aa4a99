// A plug-in that was compiled with another version of cylon/force.h.
#include "cylon/force.h"

namespace {
const cylon_plugin_table table = {CYLON_FORCE_VERSION + 1, 0, nullptr};
}

const cylon_plugin_table* cylon_plugin(void) { return &table; }
