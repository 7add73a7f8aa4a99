// What MuJoCo allocates: a compiled model and its data.  Included by the adapter's own sources only.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>

namespace cylon::simulators {

struct DeleteModel {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DeleteData {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

struct MujocoWorld {
  std::unique_ptr<mjModel, DeleteModel> model;
  std::unique_ptr<mjData, DeleteData> data;
};

/// Errors of MuJoCo end the process, with their text on stderr; warnings go there as well, and not to a file in
/// the working directory.  Once per process, before anything else.
void mujoco_handle_errors();

/// Compiles a text.  Throws std::runtime_error with MuJoCo's own words where it refuses.
MujocoWorld mujoco_compile(const std::string& xml);

}  // namespace cylon::simulators
