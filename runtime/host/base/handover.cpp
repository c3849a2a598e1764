#include <unistd.h>

#include <cstdlib>
#include <runtime/host/base/handover.hpp>

namespace eagerx::host {

std::string problem_of_graph(std::string_view graph) {
  const char* const set = std::getenv(kExpectedGraph);
  const std::string expected = set == nullptr ? "" : set;
  unsetenv(kExpectedGraph);
  if (expected.empty() || expected == graph) return {};
  return "this was built from another graph: its hash is " + std::string(graph) + ", not " +
         expected;
}

void release_output_locks() {
  const char* at = std::getenv(kOutputLocks);
  while (at != nullptr && *at != '\0') {
    char* end = nullptr;
    const long descriptor = std::strtol(at, &end, 10);
    if (end != at && descriptor > STDERR_FILENO) close(static_cast<int>(descriptor));
    at = end != at && *end == ',' ? end + 1 : nullptr;
  }
  unsetenv(kOutputLocks);
}

}  // namespace eagerx::host
