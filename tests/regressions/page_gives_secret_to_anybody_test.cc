// The viewer's page held the token, and GET / asked for none: any user of the machine had it by `curl`, and with it all
// of the viewer.  It also would have stood on the browser's command line.  Now no answer holds it, the terminal has it, and
// a browser gets it by a file that its owner alone can read.
#include "tests/harness/cli/fixture.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

// All that the server answers until it closes.
std::string ask(int port, const std::string& request) {
  const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  const timeval patience = {20, 0};
  ::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::send(fd, request.data(), request.size(), MSG_NOSIGNAL);
  std::string text;
  char piece[4096];
  for (ssize_t n = 0; (n = ::recv(fd, piece, sizeof piece, 0)) > 0;)
    text.append(piece, static_cast<std::size_t>(n));
  ::close(fd);
  return text;
}

class PageGivesSecretToAnybody : public CommandLine {
 protected:
  // The address that the program has printed by now: http://127.0.0.1:PORT/#token=SECRET.
  std::string address() const {
    const std::string out = read(".out");
    const std::size_t start = out.find("http://127.0.0.1:"), end = out.find('\n', start);
    return start == std::string::npos || end == std::string::npos ? "" : out.substr(start, end - start);
  }
  // Runs the viewer with a desktop whose browser is this script; `then` once that has run.
  Ran view(const std::string& browser, const std::function<void()>& then) const {
    fs::create_directory(folder / "bin");
    write("bin/xdg-open", "#!/bin/sh\n" + browser + "\ntouch opened\n");
    return shell(
        "chmod +x bin/xdg-open; export DISPLAY=:9 PATH=\"$PWD/bin:$PATH\" TMPDIR=\"$PWD\"; exec cylon view "
        "projectile "
        "--engine in-house --paused --for 60",
        [&] {
          if (address().empty() || !fs::exists(folder / "opened")) return false;
          then();
          return true;
        });
  }
};

TEST_F(PageGivesSecretToAnybody, NoAnswerHoldsIt) {
  std::string page, refused, obeyed, token;
  const Ran ran = view("true", [&] {
    const std::string shown = address();
    const int port = std::stoi(shown.substr(shown.rfind(':') + 1));
    token = shown.substr(shown.find("#token=") + 7);
    const std::string host =
        " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\nConnection: close\r\n";
    page = ask(port, "GET /" + host + "\r\n");
    refused = ask(port, "GET /api/session" + host + "\r\n");
    obeyed = ask(port, "POST /api/command" + host + "Content-Length: 14\r\nX-Cylon-Token: " + token +
                           "\r\n\r\n{\"do\": \"play\"}");
  });
  EXPECT_EQ(ran.code, 0) << ran.err;
  ASSERT_EQ(token.size(), 32u);
  EXPECT_TRUE(page.starts_with("HTTP/1.1 200 ")) << page.substr(0, 300);
  EXPECT_NE(page.find("data-page=\"view\""), std::string::npos);
  EXPECT_EQ(page.find(token), std::string::npos) << "the page has the secret for whoever asks";
  EXPECT_TRUE(refused.starts_with("HTTP/1.1 403 ")) << refused.substr(0, 300);
  EXPECT_EQ(refused.find(token), std::string::npos);
  EXPECT_TRUE(obeyed.starts_with("HTTP/1.1 200 ")) << obeyed.substr(0, 300);
  EXPECT_EQ(obeyed.find(token), std::string::npos);
}

TEST_F(PageGivesSecretToAnybody, ABrowserGetsItByAPrivateFile) {
  std::string shown;
  const Ran ran = view(
      "tr '\\0' ' ' </proc/$$/cmdline >words; stat -c '%a' \"$1\" \"$(dirname \"$1\")\" >modes; cp \"$1\" "
      "page",
      [&] { shown = address(); });
  EXPECT_EQ(ran.code, 0) << ran.err;
  const std::string token = shown.substr(shown.find("#token=") + 7);
  ASSERT_EQ(token.size(), 32u);
  EXPECT_EQ(read("words").find(token), std::string::npos) << read("words");
  EXPECT_EQ(read("modes"), "600\n700\n");
  EXPECT_NE(read("page").find("content=\"0; url=" + shown + "\""), std::string::npos) << read("page");
  for (const auto& entry : fs::directory_iterator(folder))  // and nothing of it stays
    EXPECT_FALSE(entry.path().filename().string().starts_with("cylon-view-")) << entry.path();
}

}  // namespace
}  // namespace cylon::cli
