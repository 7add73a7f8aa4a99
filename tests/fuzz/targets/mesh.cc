#include "tests/fuzz/targets/folder.h"
#include "tests/fuzz/targets/scenario_read.h"
#include "tests/fuzz/targets/targets.h"

#include <fstream>

namespace cylon::fuzz {

void mesh(std::string_view bytes) {
  std::ofstream(folder() / "m.obj", std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  // With the inertia stated and without: the second is computed from the mesh.
  for (const char* inertia : {"", "inertia = [1, 1, 1]\n"})
    read_scenario(
        std::string("duration = 1\nstep = 0.1\n[[body]]\nname = \"a\"\nmass = 1\ncollide = false\n") +
            inertia + "shape = { type = \"mesh\", file = \"m.obj\" }\n",
        folder() / "f.toml");
}

}  // namespace cylon::fuzz
