// The viewer's server answers only the page that it served.
#include "harness/view/server.h"

#include "harness/core/input_error.h"
#include "harness/view/viewer_messages.h"
#include "tests/harness/view/fixture.h"

#include <httplib.h>
#include <nlohmann/json.hpp>

#include <arpa/inet.h>
#include <ifaddrs.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace cylon::view {
namespace {

using httplib::Headers;
using nlohmann::json;

class ServerTest : public testing::Test {
 protected:
  void SetUp() override {
    frames_.emplace(folder_);
    host_.emplace(std::make_unique<Session>(scenario(scene_), options("ode")), "", [](const std::string&) {});
    server_.emplace(*host_, &*frames_, 0);
  }
  void TearDown() override {
    host_->stop();
    server_.reset();
    host_.reset();
    std::filesystem::remove_all(folder_);
  }

  httplib::Client client() const {
    httplib::Client result("127.0.0.1", server_->port());
    result.set_read_timeout(5);
    return result;
  }
  Headers token() const { return {{"X-Cylon-Token", server_->token()}}; }
  int command(const std::string& body, const Headers& headers) const {
    return client().Post("/api/command", headers, body, "application/json")->status;
  }

  core::Scene scene_ = ball_on_floor(0.5, {0.1, 0, 0}, 0.8);
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("cylon-frames-" + std::to_string(::getpid()));
  std::optional<Frames> frames_;
  std::optional<Host> host_;
  std::optional<Server> server_;
};

/// Reads messages from a stream until `enough` says so; how many states came.
int read_stream(httplib::Client& client, const Headers& headers,
                const std::function<bool(int, const json&)>& enough) {
  std::string pending;
  int states = 0;
  client.Get("/api/stream", headers, [&](const char* data, std::size_t size) {
    pending.append(data, size);
    for (;;) {
      std::uint32_t sizes[2];
      if (pending.size() < sizeof sizes) return true;
      std::memcpy(sizes, pending.data(), sizeof sizes);
      const std::size_t whole = sizeof sizes + sizes[0] + sizes[1];
      if (pending.size() < whole) return true;
      const json header = json::parse(pending.substr(sizeof sizes, sizes[0]));
      pending.erase(0, whole);
      states += header["type"] == "state" ? 1 : 0;
      if (enough(states, header)) return false;
    }
  });
  return states;
}

// Whoever views a scene waits for the engines of its lanes alone: the others took 3 to 8 s.
TEST(Host, OffersEnginesAsTheyAnswer) {
  SessionOptions settings = options("ode");
  std::erase_if(settings.rows, [](const process::EngineRow& row) {
    return row.id != "in-house" && row.id != "ode" && row.id != "bullet";
  });
  for (process::EngineRow& row : settings.rows)
    if (row.id == "bullet") row.command = {"/no/such/worker"};
  auto session =
      std::make_unique<Session>(scenario(ball_on_floor(0.5, {0.1, 0, 0}, 0.8)), std::move(settings));
  Host host(std::move(session), "", [](const std::string&) {});
  const auto ids = [&] {
    std::vector<std::string> found;
    const json told = json::parse(host.session_json());
    for (const json& engine : told["engines"]) {
      EXPECT_FALSE(engine["integrators"].empty());
      found.push_back(engine["id"]);
    }
    return found;
  };
  EXPECT_EQ(ids(), std::vector<std::string>{"ode"});
  host.ask_engines();
  for (int i = 0; i < 500 && ids().size() < 2; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  host.stop();
  EXPECT_EQ(ids(), (std::vector<std::string>{"in-house", "ode"}));  // in the order of the rows
}

TEST_F(ServerTest, GivesOutThePageWithItsRules) {
  const auto page = client().Get("/");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->status, 200);
  EXPECT_EQ(page->get_header_value("Content-Type"), "text/html; charset=utf-8");
  EXPECT_EQ(page->get_header_value("X-Content-Type-Options"), "nosniff");
  const std::string policy = page->get_header_value("Content-Security-Policy");
  for (const char* rule :
       {"default-src 'none'", "script-src 'sha256-", "frame-ancestors 'none'", "connect-src 'self'"})
    EXPECT_NE(policy.find(rule), std::string::npos) << policy;
  EXPECT_NE(page->body.find("data-page=\"view\""), std::string::npos);
  EXPECT_EQ(server_->address(), server_->url() + "#token=" + server_->token());
  EXPECT_EQ(server_->token().size(), 32u);
  EXPECT_NE(server_->token(), Server(*host_, nullptr, 0).token());
}

// Name, origin and token, one by one; with all of them right, and only then, it answers.
TEST_F(ServerTest, RejectsOtherHosts) {
  const std::string right = "127.0.0.1:" + std::to_string(server_->port());
  const std::string by_name = "localhost:" + std::to_string(server_->port()), token = server_->token();
  std::string wrong = token;
  wrong.back() = wrong.back() == '0' ? '1' : '0';
  const struct {
    const char* what;
    Headers headers;
    int status;
  } rows[] = {
      {"all right", {{"Host", right}, {"X-Cylon-Token", token}}, 200},
      {"by name", {{"Host", by_name}, {"X-Cylon-Token", token}}, 200},
      {"own origin", {{"Host", right}, {"Origin", "http://" + right}, {"X-Cylon-Token", token}}, 200},
      {"no token", {{"Host", right}}, 403},
      {"a token that is nearly right", {{"Host", right}, {"X-Cylon-Token", wrong}}, 403},
      {"a part of the token", {{"Host", right}, {"X-Cylon-Token", token.substr(0, 31)}}, 403},
      {"a name of somebody's", {{"Host", "evil.example:" + right.substr(10)}, {"X-Cylon-Token", token}}, 403},
      {"a name without a port", {{"Host", "127.0.0.1"}, {"X-Cylon-Token", token}}, 403},
      {"another origin", {{"Host", right}, {"Origin", "http://evil.example"}, {"X-Cylon-Token", token}}, 403},
      {"another port", {{"Host", right}, {"Origin", "http://127.0.0.1:1"}, {"X-Cylon-Token", token}}, 403},
      {"a file", {{"Host", right}, {"Origin", "null"}, {"X-Cylon-Token", token}}, 403},
      {"by name from by number",
       {{"Host", right}, {"Origin", "http://" + by_name}, {"X-Cylon-Token", token}},
       403},
  };
  for (const auto& row : rows) {
    const auto session = client().Get("/api/session", row.headers);
    ASSERT_TRUE(session) << row.what;
    EXPECT_EQ(session->status, row.status) << row.what;
    EXPECT_EQ(session->body.find("Test") != std::string::npos, row.status == 200) << row.what;
    EXPECT_EQ(command(R"({"do": "play"})", row.headers), row.status) << row.what;
  }
  EXPECT_EQ(client().Get("/", Headers{{"Host", "evil.example"}})->status, 403);
  Headers many = this->token();
  for (int i = 0; i < 200; ++i) many.emplace("X-" + std::to_string(i), "x");
  EXPECT_EQ(client().Get("/api/session", many)->status, 431);
}

TEST_F(ServerTest, UnknownPathsGive404) {
  for (const char* path : {"/favicon.ico", "/api", "/api/", "/api/nothing", "/../../../../etc/passwd",
                           "/%2e%2e/%2e%2e/etc/passwd", "/harness", "//"}) {
    const auto answer = client().Get(path, token());
    ASSERT_TRUE(answer) << path;
    EXPECT_EQ(answer->status, 404) << path;
    EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff") << path;
  }
  EXPECT_EQ(client().Post("/", token(), "x", "text/plain")->status, 404);
  EXPECT_EQ(client().Get("/api/command", token())->status, 404);
}

TEST_F(ServerTest, ExecutesOrRejectsCommandsWithReason) {
  EXPECT_EQ(command(R"({"do": "pause"})", token()), 200);
  const auto refused =
      client().Post("/api/command", token(), R"({"do": "speed", "value": -3})", "application/json");
  EXPECT_EQ(refused->status, 400);
  EXPECT_NE(json::parse(refused->body)["error"].get<std::string>().find("value: -3"), std::string::npos);
  EXPECT_EQ(command(std::string("\0\xff\xfe{", 4), token()), 400);
  EXPECT_EQ(command("", token()), 400);
  EXPECT_EQ(command(std::string(std::size_t{100} << 10, ' '), token()), 413);
  EXPECT_EQ(command(std::string(std::size_t{40'000}, '['), token()), 400);  // deep, and no more than that
  const auto session = client().Get("/api/session", token());
  EXPECT_EQ(json::parse(session->body)["playing"], false);
}

TEST_F(ServerTest, AcceptsAtMostFourStreams) {
  auto one = client(), two = client();
  int states[2] = {};
  std::thread second(
      [&] { states[1] = read_stream(two, token(), [](int n, const json&) { return n == 10; }); });
  bool told = false;
  states[0] = read_stream(one, token(), [&](int n, const json& header) {
    told = told || header["type"] == "session";
    return n == 10;
  });
  second.join();
  EXPECT_TRUE(told);
  EXPECT_EQ(states[0], 10);
  EXPECT_EQ(states[1], 10);

  std::vector<std::thread> readers;
  std::atomic<int> open = 0;
  std::atomic<bool> enough = false;
  const auto read = [&](int n, const json&) {
    if (n == 1) ++open;
    return enough.load();
  };
  for (int i = 0; i < 4; ++i)
    readers.emplace_back([&] {
      // The two before are gone when the server next writes to them; until then there may be no room.
      auto reader = client();
      while (read_stream(reader, token(), read) == 0) std::this_thread::yield();
    });
  while (open < 4) std::this_thread::yield();
  EXPECT_EQ(client().Get("/api/stream", token())->status, 503);
  enough = true;
  for (std::thread& reader : readers) reader.join();
}

// Somebody who opens a stream and reads nothing: time goes on for the others.
TEST_F(ServerTest, SlowReaderDoesNotBlockOthers) {
  const int slow = ::socket(AF_INET, SOCK_STREAM, 0);
  const int little = 4096;
  ::setsockopt(slow, SOL_SOCKET, SO_RCVBUF, &little, sizeof little);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(server_->port()));
  ::inet_pton(AF_INET, "127.0.0.1", &address.sin_addr);
  ASSERT_EQ(::connect(slow, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  const std::string request =
      "GET /api/stream HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(server_->port()) +
      "\r\nX-Cylon-Token: " + server_->token() + "\r\n\r\n";
  ASSERT_EQ(::send(slow, request.data(), request.size(), 0), static_cast<ssize_t>(request.size()));
  const std::uint64_t before = host_->states();
  auto reader = client();
  EXPECT_EQ(read_stream(reader, token(), [](int n, const json&) { return n == 20; }), 20);
  EXPECT_GE(host_->states(), before + 15);
  EXPECT_EQ(command(R"({"do": "pause"})", token()), 200);
  ::close(slow);
}

// Not even the machine's own other addresses.
TEST_F(ServerTest, ListensOnLoopbackOnly) {
  ifaddrs* all = nullptr;
  ASSERT_EQ(::getifaddrs(&all), 0);
  std::vector<std::string> others = {"127.0.0.2"};
  for (const ifaddrs* i = all; i; i = i->ifa_next) {
    if (!i->ifa_addr || i->ifa_addr->sa_family != AF_INET) continue;
    char text[INET_ADDRSTRLEN];
    ::inet_ntop(AF_INET, &reinterpret_cast<const sockaddr_in*>(i->ifa_addr)->sin_addr, text, sizeof text);
    if (std::string(text) != "127.0.0.1") others.emplace_back(text);
  }
  ::freeifaddrs(all);
  for (const std::string& other : others) {
    httplib::Client stranger(other, server_->port());
    stranger.set_connection_timeout(1);
    EXPECT_FALSE(stranger.Get("/")) << other;
  }
  EXPECT_TRUE(client().Get("/"));
}

TEST_F(ServerTest, PortInUseIsAnError) {
  EXPECT_THROW(Server(*host_, nullptr, server_->port()), core::InputError);
}

TEST_F(ServerTest, StoresPngFramesOnly) {
  const std::string png = std::string("\x89PNG\r\n\x1a\n", 8) + std::string(100'000, 'x');
  const auto frame = [&](const std::string& query, const std::string& body) {
    return client().Post("/api/frame" + query, token(), body, "image/png")->status;
  };
  EXPECT_EQ(frame("?n=1", png), 200);
  EXPECT_EQ(frame("?n=17", png), 200);
  for (const char* query : {"", "?n=", "?n=-1", "?n=1000000", "?n=../x", "?n=1e3"})
    EXPECT_EQ(frame(query, png), 400) << query;
  EXPECT_EQ(frame("?n=2", "GIF89a"), 400);
  EXPECT_EQ(frames_->count(), 2);
  std::ifstream file(folder_ / "frame-000017.png", std::ios::binary);
  std::stringstream kept;
  kept << file.rdbuf();
  EXPECT_EQ(kept.str(), png);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "frame-000002.png"));
}

// The names are known beforehand: a link that lies there is replaced, and what it leads to stays as it is.
TEST_F(ServerTest, FramesFollowNoLinks) {
  const std::string png("\x89PNG\r\n\x1a\n", 8);
  std::ofstream(folder_ / "other") << "mine";
  std::filesystem::create_symlink("other", folder_ / "frame-000003.png");
  EXPECT_EQ(client().Post("/api/frame?n=3", token(), png, "image/png")->status, 200);
  EXPECT_TRUE(
      std::filesystem::is_regular_file(std::filesystem::symlink_status(folder_ / "frame-000003.png")));
  std::stringstream kept;
  kept << std::ifstream(folder_ / "other").rdbuf();
  EXPECT_EQ(kept.str(), "mine");
  // Where it cannot take the place, no draft stays.
  std::filesystem::create_directory(folder_ / "frame-000004.png");
  EXPECT_EQ(client().Post("/api/frame?n=4", token(), png, "image/png")->status, 400);
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    EXPECT_NE(entry.path().extension(), ".partial") << entry.path();
}

}  // namespace
}  // namespace cylon::view
