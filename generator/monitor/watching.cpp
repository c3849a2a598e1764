#include "generator/monitor/watching.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>

namespace eagerx::gen {
namespace {

volatile std::sig_atomic_t interrupts = 0;

}  // namespace

void end_at_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupts = 1; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool is_interrupted() {
  return interrupts != 0;
}

std::int64_t steady_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

std::string refusal_text(const Model& model) {
  return fmt::format(
      "error: {}\nhelp: build the program of this graph again, or name the graph that it was "
      "built of, with the options that it was built with",
      model.refusal());
}

}  // namespace eagerx::gen
