#include "targets/environments/client/interrupt.hpp"

#include <csignal>

namespace eagerx::client {
namespace {

Interrupt interrupted = false;

extern "C" void interrupt(int signal) {
  interrupted = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

const Interrupt& watch_interrupts() {
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  return interrupted;
}

}  // namespace eagerx::client
