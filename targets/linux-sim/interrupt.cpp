#include <csignal>
#include <targets/linux-sim/interrupt.hpp>

namespace eagerx::linux_sim {
namespace {

volatile std::sig_atomic_t caught = 0;

void on_signal(int /*signal*/) {
  caught = 1;
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;  // without SA_RESTART: a sleep ends early
  sigaction(SIGTERM, &action, nullptr);
  // A terminal that is closed, or a connection that is lost, must not leave a motor running;
  // `nohup` has the signal ignored. It comes twice: from the shell, and when the shell has ended.
  struct sigaction before {};
  if (sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
    sigaction(SIGHUP, &action, nullptr);
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // a second Ctrl-C is the usual one
  sigaction(SIGINT, &action, nullptr);
  std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() {
  return caught != 0;
}

}  // namespace eagerx::linux_sim
