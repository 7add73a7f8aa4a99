// A worker: the one engine build that is linked here, behind the protocol.
//   cylon-worker-ENGINE [--plugin NAME FILE]…
#include "cylon/worker.h"

#include <cstdio>
#include <exception>
#include <span>
#include <string_view>

namespace {

std::span<char*> words;

std::unique_ptr<cylon::core::Simulator> make() {
  auto simulator = cylon::core::make_simulator();
  for (std::size_t i = 0; i + 2 < words.size(); i += 3) simulator->admit(words[i + 1], words[i + 2]);
  return simulator;
}

bool usable() {
  if (words.size() % 3 != 0) return false;
  for (std::size_t i = 0; i < words.size(); i += 3)
    if (words[i] != std::string_view("--plugin")) return false;
  return true;
}

}  // namespace

int main(int argc, char** argv) try {
  words = std::span(argv, static_cast<std::size_t>(argc)).subspan(1);
  if (usable()) return cylon::worker::run(make);
  std::fputs("a worker of Cylon takes no words but --plugin NAME FILE\n", stderr);
  return 2;
} catch (const std::invalid_argument& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
