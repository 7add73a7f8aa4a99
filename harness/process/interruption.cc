#include "harness/process/interruption.h"

#include <signal.h>

namespace cylon::process {
namespace {

void interrupt(int) { interrupted() = true; }

void on_signals(void (*handler)(int), int flags) {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM}) {
    struct sigaction present = {};
    // Who started us with a signal ignored (nohup, a shell's background) wants it ignored.
    if (::sigaction(number, nullptr, &present) == 0 && present.sa_handler == SIG_IGN) continue;
    ::sigaction(number, &action, nullptr);
  }
}

}  // namespace

std::atomic<bool>& interrupted() {
  static std::atomic<bool> flag{false};
  return flag;
}

Interruptible::Interruptible() { on_signals(interrupt, static_cast<int>(SA_RESETHAND)); }
Interruptible::~Interruptible() { on_signals(SIG_DFL, 0); }

}  // namespace cylon::process
