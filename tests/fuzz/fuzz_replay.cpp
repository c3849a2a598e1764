// Any bytes as the table of a run that SAC learns from: no crash, and either whole transitions with
// finite numbers or a reason.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/sac/log.hpp"

namespace {

using namespace eagerx::train;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

void require(bool holds) {
  if (!holds) std::abort();
}

void read(const std::string& text) {
  Description description;
  description.observations = {
      {.name = "angle", .dtype = "float32", .size = 2, .low = {}, .high = {}},
      {.name = "speed", .dtype = "float32", .low = {}, .high = {}}};
  description.actions = {{.name = "voltage", .dtype = "float32", .low = {-2}, .high = {2}}};
  sac::Memory memory(3, 1, 16);
  Sums observations(3), returns(1), rewards(2);
  sac::Log log;
  try {
    log = sac::read_log(text, "fuzz", description, 0.99F, memory, observations, returns, rewards);
  } catch (const Problem&) {
  }
  require(memory.is_whole() && memory.added >= log.transitions);
  for (const float x : memory.rows) require(std::isfinite(x));
  for (std::size_t i = 0; i < memory.size(); ++i) require(std::fabs(*memory.at(i).action) <= 1.0F);
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read(text);
  read(
      "episode,step,angle[0],angle[1],speed,voltage,task.reward,task.terminated,task.truncated\n"
      "0,0,1,0,1,,,,\n" +
      text);
  return 0;
}
