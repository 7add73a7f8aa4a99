#include "harness/view/gate.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>

namespace cylon::view {
namespace {

using http::Answer;
using http::Head;

constexpr std::size_t largest_command = std::size_t{64} << 10,
                      largest_frame = std::size_t{32} << 20;  // [bytes]

struct Route {
  std::string_view method, path;
  std::size_t most;  ///< Of the body [bytes].
};
constexpr Route routes[] = {
    {"GET", "/", 0},
    {"GET", "/api/session", 0},
    {"GET", "/api/stream", 0},
    {"POST", "/api/command", largest_command},
    {"POST", "/api/frame", largest_frame},
};

// Without a hint, by the time it takes, of how much of it was right.
bool same(std::string_view a, std::string_view b) {
  unsigned char difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    difference |=
        static_cast<unsigned char>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

}  // namespace

Answer json_answer(int status, const nlohmann::json& body) {
  return {
      status, "application/json", body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), {}};
}

Answer refusal(int status, const std::string& why) { return json_answer(status, {{"error", why}}); }

// Who asks, and whether for this server by its name; then whether there is such a thing, of that size.
std::optional<Answer> refusal_of(const Head& head, int port, std::string_view token) {
  const std::string host_name = head.header("host");
  if (host_name != fmt::format("{}:{}", loopback, port) && host_name != fmt::format("localhost:{}", port))
    return refusal(403, "not for you");
  if (head.headers.contains("origin") && head.header("origin") != "http://" + host_name)
    return refusal(403, "not for you");
  const Route* wanted = std::ranges::find_if(
      routes, [&](const Route& one) { return one.method == head.method && one.path == head.path; });
  const bool there = wanted != std::end(routes);
  if (there && wanted->path != "/" && !same(head.header("x-cylon-token"), token))
    return refusal(403, "not for you");
  if (!there) return refusal(404, "not found");
  if (head.length > wanted->most)
    return refusal(413, fmt::format("a body here has at most {} bytes", wanted->most));
  return std::nullopt;
}

}  // namespace cylon::view
