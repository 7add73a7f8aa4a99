#include "harness/view/http.h"

#include "harness/view/http_head.h"

#include <boost/asio.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <list>
#include <mutex>
#include <thread>

namespace cylon::view::http {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
using beast::http::field;
using boost::system::error_code;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Nothing = asio::awaitable<void>;

constexpr std::size_t most_connections = 32;
constexpr auto time_for_head = seconds(3), time_for_body = seconds(20), time_for_answer = seconds(5),
               time_between = seconds(5);  // of the client: to send, to take, to ask again
// A stream keeps a thread while it waits for news; the viewer has four.
constexpr int threads = 8;

auto into(error_code& error) { return asio::redirect_error(asio::use_awaitable, error); }

struct Connection {
  explicit Connection(asio::ip::tcp::socket socket) : stream(std::move(socket)) {}
  beast::tcp_stream stream;  // on a strand of its own
  beast::flat_buffer pending{std::size_t{64} << 10};
  std::atomic<bool> waiting = true;  // for a request: the first to go where there are too many
};

}  // namespace

struct Listener::Parts {
  Rules rules;
  std::atomic<bool> stop = false;
  std::mutex mutex;
  std::list<std::shared_ptr<Connection>> connections;  // oldest first
  asio::io_context io{threads};                        // its end needs what stands above
  asio::ip::tcp::acceptor acceptor{io};
  std::vector<std::thread> pool;

  explicit Parts(Rules r) : rules(std::move(r)) {}
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() { end(); }

  void open(int port) {
    const asio::ip::tcp::endpoint place(asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port));
    acceptor.open(place.protocol());
    acceptor.set_option(asio::socket_base::reuse_address(true));
    acceptor.bind(place);
    acceptor.listen();
    asio::co_spawn(io, accept_all(), asio::detached);
    for (int i = 0; i < threads; ++i) pool.emplace_back([this] { io.run(); });
  }

  void end() {
    stop = true;
    io.stop();
    for (std::thread& thread : pool) thread.join();
    pool.clear();
    error_code ignored;
    acceptor.close(ignored);
    for (const auto& connection : connections) connection->stream.close();
    connections.clear();
  }

  Nothing accept_all() {
    for (;;) {
      error_code error;
      asio::ip::tcp::socket socket = co_await acceptor.async_accept(asio::make_strand(io), into(error));
      if (error) {  // no descriptor is left
        asio::steady_timer timer(io, milliseconds(50));
        co_await timer.async_wait(into(error));
        continue;
      }
      socket.set_option(asio::ip::tcp::no_delay(true), error);
      const auto connection = std::make_shared<Connection>(std::move(socket));
      asio::co_spawn(connection->stream.get_executor(),
                     has_room(connection) ? serve(connection) : turn_away(connection), asio::detached);
    }
  }

  // Who has not finished asking goes before who is served.
  bool has_room(const std::shared_ptr<Connection>& added) {
    const std::scoped_lock lock(mutex);
    if (connections.size() >= most_connections) {
      const auto idle = std::find_if(connections.begin(), connections.end(),
                                     [](const auto& connection) { return connection->waiting.load(); });
      if (idle == connections.end()) return false;
      asio::post((*idle)->stream.get_executor(), [connection = *idle] { connection->stream.close(); });
      connections.erase(idle);
    }
    connections.push_back(added);
    return true;
  }

  Nothing turn_away(std::shared_ptr<Connection> connection) {
    co_await send(*connection, plain(503, "too many connections"), true);
  }

  // Whether all of it went.
  asio::awaitable<bool> send(Connection& connection, const Answer& answer, bool last) const {
    beast::http::response<beast::http::string_body> response;
    response.version(11);
    response.result(static_cast<unsigned>(answer.status));
    for (const auto& [name, value] : rules.headers) response.set(name, value);
    response.set(field::content_type, answer.type);
    response.keep_alive(!last);
    error_code error;
    connection.stream.expires_after(time_for_answer);
    if (answer.stream) {
      response.chunked(true);
      beast::http::response_serializer<beast::http::string_body> head(response);
      co_await beast::http::async_write_header(connection.stream, head, into(error));
    } else {
      response.body() = answer.body;
      response.prepare_payload();
      co_await beast::http::async_write(connection.stream, response, into(error));
    }
    co_return !error;
  }

  Nothing stream(Connection& connection, const Answer& answer) const {
    error_code error;
    while (!stop && !error) {
      const std::string piece = answer.stream();
      connection.stream.expires_after(time_for_answer);
      if (piece.empty()) {
        co_await asio::async_write(connection.stream, beast::http::make_chunk_last(), into(error));
        co_return;
      }
      co_await asio::async_write(connection.stream, beast::http::make_chunk(asio::buffer(piece)),
                                 into(error));
    }
  }

  Answer answer(const Head& head, const std::string& body) const try {
    return rules.serve(head, body);
  } catch (const std::exception&) {
    return {500, "application/json", "{\"error\":\"the server failed\"}", {}};
  }

  // Requests one behind another, until the client closes or errs.
  Nothing ask_and_answer(Connection& connection) const {
    for (auto patience = time_for_head;; patience = time_between) {
      connection.waiting = true;
      Parser parser;
      set_limits(parser);
      error_code error;
      connection.stream.expires_after(patience);
      co_await beast::http::async_read_header(connection.stream, connection.pending, parser, into(error));
      if (error) {
        if (const auto complaint = answer_to(error)) co_await send(connection, *complaint, true);
        co_return;
      }
      Head head;
      std::optional<Answer> refusal = read_head(parser, head);
      const bool broken = refusal.has_value();
      if (!refusal) refusal = rules.admit(head);
      if (refusal) {  // what follows may be the body that nobody reads
        const bool last = broken || head.length > 0 || !parser.keep_alive();
        if (!co_await send(connection, *refusal, last) || last) co_return;
        continue;
      }
      connection.stream.expires_after(time_for_body);
      co_await beast::http::async_read(connection.stream, connection.pending, parser, into(error));
      if (error) co_return;
      connection.waiting = false;
      const Answer made = answer(head, parser.get().body());
      const bool last = !parser.get().keep_alive() || static_cast<bool>(made.stream);
      if (!co_await send(connection, made, last)) co_return;
      if (made.stream) co_await stream(connection, made);
      if (last) co_return;
    }
  }

  Nothing serve(std::shared_ptr<Connection> connection) {
    // Also where memory runs out on the way.
    const std::shared_ptr<void> leave(nullptr, [&](void*) {
      const std::scoped_lock lock(mutex);
      connections.remove(connection);
    });
    co_await ask_and_answer(*connection);
    error_code ignored;
    connection->stream.socket().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
    connection->stream.close();
  }
};

Listener::Listener(int port, Rules rules) : parts_(std::make_unique<Parts>(std::move(rules))) {
  parts_->open(port);
}

Listener::~Listener() = default;

void Listener::stop() { parts_->end(); }

int Listener::port() const { return parts_->acceptor.local_endpoint().port(); }

}  // namespace cylon::view::http
