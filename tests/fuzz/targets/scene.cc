#include "tests/fuzz/targets/folder.h"
#include "tests/fuzz/targets/scenario_read.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

void scene(std::string_view bytes) {
  if (bytes.find("certified") != std::string_view::npos) return;  // seconds each: tests/hostile/corpus.py
  read_scenario(bytes, folder() / "f.toml");
}

}  // namespace cylon::fuzz
