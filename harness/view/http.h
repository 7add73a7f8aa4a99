// A server for a page on this machine: GET and POST, a body with a stated length, answers whole or as a
// stream. No ranges, no encodings, no folders.  Who asks is admitted by the head of the request alone, before
// its body is read; every request has a deadline for all of it.
//
// The parser, the limits and the deadlines are Boost.Beast's.  cpp-httplib 0.11 (Debian 12) has a deadline
// for each read of a socket but none for a whole request, so that clients who send a byte now and then hold
// its threads.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace cylon::view::http {

struct Head {
  std::string method, path, query;             ///< "GET", "/api/frame", "n=17"
  std::map<std::string, std::string> headers;  ///< Names in lower case; no name twice.
  std::size_t length = 0;                      ///< Of the body [bytes].

  /// "" where it is absent.
  std::string header(const std::string& lower_name) const;
};

struct Answer {
  int status = 200;
  std::string type, body;
  /// Gives the next piece of a stream that has no end of its own; "" ends it.  Where it is set, `body` is not
  /// sent.
  std::function<std::string()> stream = {};
};

struct Rules {
  std::vector<std::pair<std::string, std::string>> headers;      ///< What every answer bears.
  std::function<std::optional<Answer>(const Head&)> admit;       ///< An answer is a refusal.
  std::function<Answer(const Head&, const std::string&)> serve;  ///< May throw; that is a 500.
};

/// Listens on 127.0.0.1 from its construction to stop().  Refuses: heads over 16 KiB or 100 lines, HTTP other
/// than 1.1, doubled headers, any Transfer-Encoding or Content-Encoding, a POST without its length.  Closes
/// the connection of who does not send a head in 3 s, a body in 20 s, or take an answer in 5 s.
class Listener {
 public:
  /// `port` 0: any that is free.  Throws std::exception where it is taken.
  Listener(int port, Rules);
  ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  int port() const;
  /// Closes all connections.  Streams must be about to end.
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace cylon::view::http
