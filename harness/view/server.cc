#include "harness/view/server.h"

#include "harness/core/input_error.h"
#include "harness/view/command.h"
#include "harness/view/page.h"

#include <fmt/format.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <sys/socket.h>

#include <atomic>
#include <charconv>
#include <string_view>
#include <thread>

namespace cylon::view {
namespace {

using httplib::Request;
using httplib::Response;

constexpr const char* loopback = "127.0.0.1";
constexpr std::size_t largest_command = std::size_t{64} << 10,
                      largest_frame = std::size_t{32} << 20;  // [bytes]
constexpr std::size_t connections = 8, most_headers = 100;
constexpr int most_streams = 4;

void answer(Response& response, int status, const nlohmann::json& body) {
  response.status = status;
  response.set_content(body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                       "application/json");
}
void refuse(Response& response, int status, const std::string& why) {
  answer(response, status, {{"error", why}});
}

// Without a hint, by the time it takes, of how much of it was right.
bool same(std::string_view a, std::string_view b) {
  unsigned char difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i)
    difference |=
        static_cast<unsigned char>(static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]));
  return difference == 0;
}

// The port is ours alone, and no child inherits the socket.
void socket_options(socket_t socket) {
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  ::fcntl(socket, F_SETFD, FD_CLOEXEC);
}

std::int64_t frame_number(const Request& request) {
  const std::string text = request.get_param_value("n");
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
  httplib::Server http;
  std::string token = random_token();
  int port = 0;
  std::atomic<int> streams = 0;
  std::thread thread;

  Parts(Host& h, Frames* f) : host(h), frames(f) {}

  void listen(int wanted) {
    http.set_socket_options(socket_options);
    http.set_tcp_nodelay(true);
    http.new_task_queue = [] { return new httplib::ThreadPool(connections); };  // the server deletes it
    http.set_keep_alive_max_count(1000);
    http.set_keep_alive_timeout(1);
    http.set_read_timeout(5);
    http.set_write_timeout(5);  // a reader who takes nothing for so long is gone
    http.set_payload_max_length(largest_frame);
    http.set_default_headers({{"Content-Security-Policy", security_policy()},
                              {"X-Content-Type-Options", "nosniff"},
                              {"X-Frame-Options", "DENY"},
                              {"Referrer-Policy", "no-referrer"},
                              {"Cross-Origin-Resource-Policy", "same-origin"},
                              {"Cache-Control", "no-store"}});
    http.set_exception_handler([](const Request&, Response& response, const std::exception_ptr&) {
      refuse(response, 500, "the server failed");
    });
    routes();
    port = wanted == 0 ? http.bind_to_any_port(loopback) : wanted;
    if (wanted != 0 ? !http.bind_to_port(loopback, wanted) : port <= 0)
      throw core::InputError(
          fmt::format("--port {}: cannot listen on this port; is another viewer running?", wanted));
    thread = std::thread([this] { http.listen_after_bind(); });
  }

  // Who asks, and whether for this server by its name: 0, or the status of the refusal.
  int refusal(const Request& request, bool api) const {
    if (request.headers.size() > most_headers) return 431;
    const std::string host_name = request.get_header_value("Host");
    const std::string by_number = fmt::format("{}:{}", loopback, port),
                      by_name = fmt::format("localhost:{}", port);
    if (request.get_header_value_count("Host") != 1 || (host_name != by_number && host_name != by_name))
      return 403;
    if (request.has_header("Origin") && request.get_header_value("Origin") != "http://" + host_name)
      return 403;
    if (api && !same(request.get_header_value("X-Cylon-Token"), token)) return 403;
    return 0;
  }

  template <class Handler>
  httplib::Server::Handler guarded(bool api, Handler handler) {
    return [this, api, handler](const Request& request, Response& response) {
      if (const int status = refusal(request, api)) return refuse(response, status, "not for you");
      try {
        handler(request, response);
      } catch (const BadCommand& error) {
        refuse(response, 400, error.what());
      }
    };
  }

  void routes() {
    http.Get("/", guarded(false, [this](const Request&, Response& response) {
               response.set_content(page(token), "text/html; charset=utf-8");
             }));
    http.Get("/api/session", guarded(true, [this](const Request&, Response& response) {
               response.set_content(host.session_json(), "application/json");
             }));
    http.Get("/api/stream", guarded(true, [this](const Request&, Response& response) { stream(response); }));
    http.Post("/api/command", guarded(true, [this](const Request& request, Response& response) {
                if (request.body.size() > largest_command)
                  return refuse(response, 413,
                                fmt::format("a command has at most {} bytes", largest_command));
                host.command(request.body);
                answer(response, 200, nlohmann::json::object());
              }));
    http.Post("/api/frame", guarded(true, [this](const Request& request, Response& response) {
                if (!frames) throw BadCommand("no frames are kept: start with --record FOLDER/");
                frames->keep(frame_number(request), request.body);
                answer(response, 200, nlohmann::json::object());
              }));
    http.set_error_handler([](const Request&, Response& response) {
      if (response.body.empty()) refuse(response, response.status, "not found");
    });
  }

  void stream(Response& response) {
    if (++streams > most_streams) {
      --streams;
      return refuse(response, 503, fmt::format("{} streams are open already", most_streams));
    }
    const auto seen = std::make_shared<Seen>();
    response.set_chunked_content_provider(
        "application/octet-stream",
        [this, seen](std::size_t, httplib::DataSink& sink) {
          const std::string message = host.newer(*seen);
          if (message.empty()) {
            sink.done();
            return true;
          }
          return sink.write(message.data(), message.size());
        },
        [this](bool) { --streams; });
  }
};

Server::Server(Host& host, Frames* frames, int port) : parts_(std::make_unique<Parts>(host, frames)) {
  parts_->listen(port);
}

Server::~Server() { stop(); }

void Server::stop() {
  if (!parts_->thread.joinable()) return;
  while (!parts_->http.is_running()) std::this_thread::yield();  // it has just been started
  parts_->http.stop();
  parts_->thread.join();
}

int Server::port() const { return parts_->port; }
const std::string& Server::token() const { return parts_->token; }
std::string Server::url() const { return fmt::format("http://{}:{}/", loopback, parts_->port); }

}  // namespace cylon::view
