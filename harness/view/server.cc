#include "harness/view/server.h"

#include "harness/core/input_error.h"
#include "harness/view/command.h"
#include "harness/view/gate.h"
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

constexpr int most_streams = 4;

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
    rules.admit = [this](const Head& head) { return refusal_of(head, port, token); };
    rules.serve = [this](const Head& head, const std::string& body) { return serve(head, body); };
    try {
      listener = std::make_unique<http::Listener>(wanted, std::move(rules));
    } catch (const std::exception&) {
      throw core::InputError(
          fmt::format("--port {}: cannot listen on this port; is another viewer running?", wanted));
    }
    port = listener->port();
  }

  Answer serve(const Head& head, const std::string& body) try {
    const std::string& path = head.path;  // one of those that refusal_of() lets pass
    if (path == "/") return {200, "text/html; charset=utf-8", page(), {}};
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
std::string Server::address() const { return fmt::format("{}#token={}", url(), token()); }
std::string Server::url() const { return fmt::format("http://{}:{}/", loopback, parts_->port.load()); }

}  // namespace cylon::view
