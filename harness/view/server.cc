#include "harness/view/server.h"

#include "harness/core/input_error.h"
#include "harness/view/command.h"
#include "harness/view/http.h"
#include "harness/view/page.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <charconv>
#include <string_view>

namespace cylon::view {
namespace {

using http::Answer;
using http::Head;

constexpr const char* loopback = "127.0.0.1";
constexpr std::size_t largest_command = std::size_t{64} << 10,
                      largest_frame = std::size_t{32} << 20;  // [bytes]
constexpr int most_streams = 4;

Answer json_answer(int status, const nlohmann::json& body) {
  return {
      status, "application/json", body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace), {}};
}
Answer refusal(int status, const std::string& why) { return json_answer(status, {{"error", why}}); }

// Without a hint, by the time it takes, of how much of it was right.
bool same(std::string_view a, std::string_view b) {
  unsigned char difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    difference |=
        static_cast<unsigned char>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

std::int64_t frame_number(const Head& head) {
  const std::string text = head.query.starts_with("n=") ? head.query.substr(2) : "";
  std::int64_t n = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc{} || end != text.data() + text.size())
    throw BadCommand(fmt::format("n = '{}': must be a whole number", text.substr(0, 40)));
  return n;
}

}  // namespace

struct Server::Parts {
  Host& host;
  Frames* frames;
  std::string token = random_token();
  std::atomic<int> port = 0;
  std::atomic<int> streams = 0;
  std::unique_ptr<http::Listener> listener;

  Parts(Host& h, Frames* f) : host(h), frames(f) {}

  void listen(int wanted) {
    http::Rules rules;
    rules.headers = {{"Content-Security-Policy", security_policy()},
                     {"X-Content-Type-Options", "nosniff"},
                     {"X-Frame-Options", "DENY"},
                     {"Referrer-Policy", "no-referrer"},
                     {"Cross-Origin-Resource-Policy", "same-origin"},
                     {"Cache-Control", "no-store"}};
    rules.admit = [this](const Head& head) { return admit(head); };
    rules.serve = [this](const Head& head, const std::string& body) { return serve(head, body); };
    try {
      listener = std::make_unique<http::Listener>(wanted, std::move(rules));
    } catch (const std::exception&) {
      throw core::InputError(
          fmt::format("--port {}: cannot listen on this port; is another viewer running?", wanted));
    }
    port = listener->port();
  }

  struct Route {
    std::string_view method, path;
    std::size_t most;  ///< Of the body [bytes].
  };
  static constexpr Route routes[] = {
      {"GET", "/", 0},
      {"GET", "/api/session", 0},
      {"GET", "/api/stream", 0},
      {"POST", "/api/command", largest_command},
      {"POST", "/api/frame", largest_frame},
  };

  static const Route* route(const Head& head) {
    for (const Route& one : routes)
      if (one.method == head.method && one.path == head.path) return &one;
    return nullptr;
  }

  // Who asks, and whether for this server by its name; then whether there is such a thing, of that size.
  std::optional<Answer> admit(const Head& head) const {
    const std::string host_name = head.header("host");
    if (host_name != fmt::format("{}:{}", loopback, port.load()) &&
        host_name != fmt::format("localhost:{}", port.load()))
      return refusal(403, "not for you");
    if (head.headers.contains("origin") && head.header("origin") != "http://" + host_name)
      return refusal(403, "not for you");
    const Route* wanted = route(head);
    if (wanted && wanted->path != "/" && !same(head.header("x-cylon-token"), token))
      return refusal(403, "not for you");
    if (!wanted) return refusal(404, "not found");
    if (head.length > wanted->most)
      return refusal(413, fmt::format("a body here has at most {} bytes", wanted->most));
    return std::nullopt;
  }

  Answer serve(const Head& head, const std::string& body) try {
    const std::string_view path = route(head)->path;
    if (path == "/") return {200, "text/html; charset=utf-8", page(token), {}};
    if (path == "/api/session") return {200, "application/json", host.session_json(), {}};
    if (path == "/api/stream") return stream();
    if (path == "/api/command") {
      host.command(body);
    } else {
      if (!frames) throw BadCommand("no frames are kept: start with --record FOLDER/");
      frames->keep(frame_number(head), body);
    }
    return json_answer(200, nlohmann::json::object());
  } catch (const BadCommand& error) {
    return refusal(400, error.what());
  }

  Answer stream() {
    // Counted as long as somebody holds it.
    struct Place {
      std::atomic<int>& count;
      bool free;
      explicit Place(std::atomic<int>& c) : count(c), free(++c <= most_streams) {}
      Place(const Place&) = delete;
      Place& operator=(const Place&) = delete;
      ~Place() { --count; }
    };
    const auto place = std::make_shared<Place>(streams);
    if (!place->free) return refusal(503, fmt::format("{} streams are open already", most_streams));
    const auto seen = std::make_shared<Seen>();
    return {200, "application/octet-stream", "", [this, place, seen] { return host.newer(*seen); }};
  }
};

Server::Server(Host& host, Frames* frames, int port) : parts_(std::make_unique<Parts>(host, frames)) {
  parts_->listen(port);
}

Server::~Server() { stop(); }

void Server::stop() { parts_->listener->stop(); }

int Server::port() const { return parts_->port; }
const std::string& Server::token() const { return parts_->token; }
std::string Server::url() const { return fmt::format("http://{}:{}/", loopback, parts_->port.load()); }

}  // namespace cylon::view
