#include "targets/environments/client/interrupt.hpp"

#include <csignal>

namespace eagerx::client {
namespace {

volatile int interrupted = 0;

extern "C" void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

const volatile int& watch_interrupts() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return interrupted;
}

}  // namespace eagerx::client
