#include "generator/tools/monitor/watching.hpp"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <runtime/host/base/interrupt.hpp>

namespace eagerx::gen {

void end_at_signals() {
  host::watch_interrupts({SIGINT, SIGTERM, SIGHUP}, host::Second::does_nothing);
}

bool is_interrupted() {
  return host::interrupted();
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
