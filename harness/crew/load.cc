#include "harness/core/input_error.h"
#include "harness/crew/crew.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace cylon::crew {

std::unique_ptr<Crew> load(const std::string& folder, const std::string& brought_by) {
  const auto refuse = [&](const std::string& why) {
    return core::InputError(fmt::format(
        "cylon farm needs MPI, and this cylon has it not ({}); it comes with: {}", why, brought_by));
  };
  const std::string file = folder + "/libcylon-mpi.so";
  // Global, because Open MPI loads parts of itself that look for its symbols.
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!library) throw refuse(::dlerror());  // NOLINT(concurrency-mt-unsafe): before any thread
  using Start = Crew* (*)();
  const auto start = reinterpret_cast<Start>(::dlsym(library, "cylon_crew"));
  if (!start) throw refuse(file + " is of another cylon");
  std::unique_ptr<Crew> crew(start());
  if (!crew) throw refuse("MPI cannot be called from several threads");
  return crew;
}

}  // namespace cylon::crew
