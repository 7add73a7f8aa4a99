// The viewer's host: time passes in one thread, commands come from several, readers wait in others, and all end.
#include "harness/view/host.h"
#include "tests/harness/view/fixture.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace cylon::view {
namespace {

TEST(HostThreads, CommandsReadersAndTheEnd) {
  Host host(std::make_unique<Session>(scenario(ball_on_floor(0.5, {0.1, 0, 0}, 0.8)), options("in-house")),
            "", [](const std::string&) {});
  std::atomic<int> read = 0, refused = 0;
  std::vector<std::thread> readers, speakers;
  for (int i = 0; i < 3; ++i)
    readers.emplace_back([&] {
      Seen seen;
      while (!host.newer(seen).empty()) ++read;
    });
  for (int i = 0; i < 3; ++i)
    speakers.emplace_back([&, i] {
      for (int n = 0; n < 20; ++n)
        for (
            const std::string& line :
            {std::string(R"({"do": "kick", "body": 0, "impulse": [0.1, 0.2, -0.1]})"),
             R"({"do": "speed", "value": )" + std::to_string(1 + i) + "}",
             std::string(R"({"do": "set", "key": "gravity", "value": [0, -1.6, 0]})"),
             std::string(n % 5 ? R"({"do": "play"})" : R"({"do": "reset"})"),
             std::string(
                 n == 10
                     ? R"({"do": "lanes", "lanes": [{"engine": "in-house", "integrator": "rk4", "dt_text": "0.001"}]})"
                     : R"({"do": "kick", "body": 7, "impulse": [0, 0, 0]})")})
          try {
            host.command(line);
            host.session_json();
            host.failures();
          } catch (const BadCommand&) {
            ++refused;
          }
    });
  for (std::thread& speaker : speakers) speaker.join();
  const std::uint64_t before = host.states();
  while (host.states() < before + 5) std::this_thread::yield();
  host.stop();
  for (std::thread& reader : readers) reader.join();
  EXPECT_GT(read, 5);
  EXPECT_GE(refused, 3 * 19);
}

}  // namespace
}  // namespace cylon::view
