#include "reference/simulators/mujoco/mujoco_world.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace cylon::simulators {

// An error may not return (mujoco/mujoco.h:51): what called it goes on otherwise.
void mujoco_handle_errors() {
  mju_user_error = [](const char* text) {
    std::fprintf(stderr, "MuJoCo: %s\n", text);
    std::abort();
  };
  mju_user_warning = [](const char* text) { std::fprintf(stderr, "MuJoCo: %s\n", text); };
}

MujocoWorld mujoco_compile(const std::string& xml) {
  constexpr const char* name = "scene.xml";
  const auto close = [](mjVFS* files) {
    mj_deleteVFS(files);
    delete files;
  };
  std::unique_ptr<mjVFS, decltype(close)> files(new mjVFS, close);
  mj_defaultVFS(files.get());
  const int size = static_cast<int>(xml.size());
  if (static_cast<std::size_t>(size) != xml.size() || mj_makeEmptyFileVFS(files.get(), name, size) != 0)
    throw std::runtime_error(fmt::format("MuJoCo takes no text of {} bytes", xml.size()));
  std::memcpy(files->filedata[mj_findFileVFS(files.get(), name)], xml.data(), xml.size());

  MujocoWorld world;
  std::array<char, 1000> error{};
  world.model.reset(mj_loadXML(name, files.get(), error.data(), static_cast<int>(error.size())));
  if (!world.model) throw std::runtime_error(fmt::format("MuJoCo refuses the scene: {}", error.data()));
  world.data.reset(mj_makeData(world.model.get()));
  if (!world.data) throw std::runtime_error("MuJoCo could not allocate its data");
  return world;
}

}  // namespace cylon::simulators
