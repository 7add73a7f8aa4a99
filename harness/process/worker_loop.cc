#include "harness/process/worker_loop.h"

#include "harness/process/json_fields.h"
#include "harness/process/pipes.h"
#include "harness/process/worker_session.h"

#include <optional>
#include <string>

namespace cylon::process {

int serve(core::Simulator& simulator, int in_fd, int out_fd) {
  Pipes pipes(in_fd, out_fd);
  WorkerSession session(simulator, pipes);
  try {
    while (const std::optional<std::string> text = pipes.read_line()) {
      try {
        if (!session.obey(parse_object(*text))) break;
      } catch (const MalformedMessage& error) {
        pipes.write(nlohmann::json{{"error", error.what()}});
      }
    }
  } catch (const Abandoned&) {
    return 1;
  }
  return 0;
}

}  // namespace cylon::process
