// Lines in, bytes out, over two file descriptors.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace cylon::process {

/// The other end of the output is closed.
struct Abandoned {};

class Pipes {
 public:
  Pipes(int in, int out) : in_(in), out_(out) {}

  /// The next line without its end, or nothing at the end of input.
  std::optional<std::string> read_line();

  /// Writes all of it.  Throws Abandoned.
  void write(std::string_view bytes);
  void write(const nlohmann::json& message);

 private:
  int in_, out_;
  std::string pending_;
};

}  // namespace cylon::process
