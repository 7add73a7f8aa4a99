// Before it had looked at Host and token, the viewer's server read chunked bodies without end, inflated a
// gzip bomb, built answers of gigabytes for a Range header, and eight connections that sent a byte now and
// then blocked it. Now the head alone decides, it has a deadline, and there are no encodings and no ranges.
#include "harness/view/http.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <chrono>
#include <string>
#include <vector>

namespace cylon::view::http {
namespace {

class Raw {
 public:
  explicit Raw(int port) : fd_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(fd_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    const timeval patience = {20, 0};
    ::setsockopt(fd_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~Raw() { ::close(fd_); }
  Raw(const Raw&) = delete;
  Raw& operator=(const Raw&) = delete;

  void send(const std::string& bytes) const { ::send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  /// All that comes until the other side closes.
  std::string rest() const {
    std::string text;
    char piece[4096];
    for (ssize_t n = 0; (n = ::recv(fd_, piece, sizeof piece, 0)) > 0;)
      text.append(piece, static_cast<std::size_t>(n));
    return text;
  }

 private:
  int fd_;
};

// Admits who knows the word, and bodies of ten bytes.
Rules rules() {
  Rules result;
  result.admit = [](const Head& head) -> std::optional<Answer> {
    if (head.header("x-word") != "friend") return Answer{403, "text/plain", "who", {}};
    if (head.length > 10) return Answer{413, "text/plain", "long", {}};
    return std::nullopt;
  };
  result.serve = [](const Head& head, const std::string& body) {
    if (head.path == "/throw") throw std::runtime_error("x");
    return Answer{200, "text/plain", head.path + " " + head.query + " " + body, {}};
  };
  return result;
}

std::string ask(int port, const std::string& bytes) {
  const Raw raw(port);
  raw.send(bytes);
  return raw.rest();
}

TEST(ViewerBeforeTheToken, AnswersByTheHeadAlone) {
  const Listener listener(0, rules());
  const std::string word = "X-Word: friend\r\n", close = "Connection: close\r\n\r\n";
  const struct {
    std::string request, starts, holds;
  } rows[] = {
      {"GET /a?n=1 HTTP/1.1\r\n" + word + close, "HTTP/1.1 200 ", "/a n=1 "},
      {"POST /a HTTP/1.1\r\nContent-Length: 3\r\n" + word + close + "xyz", "HTTP/1.1 200 ", "/a  xyz"},
      {"GET /throw HTTP/1.1\r\n" + word + close, "HTTP/1.1 500 ", "the server failed"},
      // Without the word nothing of the body is waited for.
      {"POST /a HTTP/1.1\r\nContent-Length: 1000000000\r\n\r\n", "HTTP/1.1 403 ", "who"},
      {"POST /a HTTP/1.1\r\nContent-Length: 1000000000\r\n" + word + "\r\n", "HTTP/1.1 413 ", "long"},
      {"POST /a HTTP/1.1\r\nTransfer-Encoding: chunked\r\n" + word + "\r\nfffffff\r\n", "HTTP/1.1 501 ", ""},
      {"POST /a HTTP/1.1\r\nContent-Length: 3\r\nContent-Encoding: gzip\r\n" + word + "\r\nxyz",
       "HTTP/1.1 501 ", ""},
      {"POST /a HTTP/1.1\r\n" + word + "\r\n", "HTTP/1.1 411 ", ""},
      {"POST /a HTTP/1.1\r\nContent-Length: -3\r\n" + word + "\r\nxyz", "HTTP/1.1 400 ", ""},
      {"POST /a HTTP/1.1\r\nContent-Length: 3\r\ncontent-length: 4\r\n" + word + "\r\nxyz", "HTTP/1.1 400 ",
       ""},
      {"GET /a HTTP/1.1\r\nRange: bytes=0-,0-,0-,0-\r\n" + word + close, "HTTP/1.1 200 ", "/a  "},
      {"GET /a HTTP/1.1\nX-Word: friend\n\n\r\n\r\n", "HTTP/1.1 400 ", ""},
      {"GET /a HTTP/1.1\r\n folded: x\r\n\r\n", "HTTP/1.1 400 ", ""},
      {"GET http://evil/ HTTP/1.1\r\n" + word + close, "HTTP/1.1 400 ", ""},
      {std::string(20000, 'x'), "HTTP/1.1 431 ", ""},
  };
  for (const auto& row : rows) {
    const std::string answer = ask(listener.port(), row.request);
    EXPECT_TRUE(answer.starts_with(row.starts)) << row.request.substr(0, 200) << "\n"
                                                << answer.substr(0, 300);
    EXPECT_NE(answer.find(row.holds), std::string::npos) << answer.substr(0, 300);
    EXPECT_LT(answer.size(), 500u);
  }
}

TEST(ViewerBeforeTheToken, SlowHeadsBlockNobody) {
  const Listener listener(0, rules());
  std::vector<std::unique_ptr<Raw>> slow;
  for (int i = 0; i < 60; ++i) {
    slow.push_back(std::make_unique<Raw>(listener.port()));
    slow.back()->send("GET / HTTP/1.1\r\nX-");
  }
  const std::string answer =
      ask(listener.port(), "GET /a HTTP/1.1\r\nX-Word: friend\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 200 ")) << answer;
  EXPECT_EQ(slow.back()->rest(), "");  // closed at its deadline, though it never ended
}

// A refusal to who asked to close held the connection until the time to ask again was over, 5 s.
TEST(ViewerBeforeTheToken, ClosesAfterARefusal) {
  const Listener listener(0, rules());
  const auto start = std::chrono::steady_clock::now();
  const std::string answer = ask(listener.port(), "GET /a HTTP/1.1\r\nConnection: close\r\n\r\n");
  EXPECT_TRUE(answer.starts_with("HTTP/1.1 403 ")) << answer;
  EXPECT_NE(answer.find("Connection: close"), std::string::npos) << answer;
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
}

// One request behind another on one connection, and the second's head split anywhere.
TEST(ViewerBeforeTheToken, KeepsConnectionsAlive) {
  const Listener listener(0, rules());
  const std::string first = "POST /a HTTP/1.1\r\nContent-Length: 3\r\nX-Word: friend\r\n\r\none";
  const std::string second =
      "POST /b HTTP/1.1\r\nContent-Length: 3\r\nX-Word: friend\r\nConnection: close\r\n\r\ntwo";
  for (std::size_t split = 0; split < second.size(); split += 13) {
    const Raw raw(listener.port());
    raw.send(first + second.substr(0, split));
    ::usleep(1000);
    raw.send(second.substr(split));
    const std::string answer = raw.rest();
    EXPECT_NE(answer.find("/a  one"), std::string::npos) << answer;
    EXPECT_NE(answer.find("/b  two"), std::string::npos) << answer;
  }
}

}  // namespace
}  // namespace cylon::view::http
