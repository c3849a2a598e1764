// Any bytes as the tables that a trainer continues from, the results of a sweep and the runs of a
// campaign: no crash, and either rows of finite numbers or a reason. Results are written again as
// they were.
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/failure_replay.hpp"
#include "targets/environments/train/sweep_results.hpp"

namespace {

using namespace eagerx::train;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

void require(bool holds) {
  if (!holds) std::abort();
}

void read_results(const std::string& text) {
  // In memory: files are synchronised with the disk.
  static const std::string path = "/dev/shm/fuzz_tables." + std::to_string(getpid());
  write_file(path, text);
  try {
    const SweepResults results(path);
    results.write();
    const std::string once = read_file(path);
    const SweepResults again(path);
    again.write();
    require(again.size() == results.size() && once == read_file(path));
  } catch (const Problem&) {
  }
}

void read_starts(const std::string& text) {
  Description description;
  description.states = {{.name = "pendulum.model_state", .dtype = "float32", .size = 2}};
  try {
    const FailureReplay starts(text, "fuzz", description);
    require(starts.size() > 0 && starts.width() == 2);
    for (std::size_t i = 0; i < starts.size() * starts.width(); ++i)
      require(!std::isinf(starts.at(0)[i]));
  } catch (const Problem&) {
  }
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read_results(text);
  read_results(
      "training,settings,seed,succeeds,steps,successes,episodes,return,processor_s,problem\n" +
      text);
  read_starts(text);
  read_starts(
      "run,return,steps,success,terminated,truncated,state:pendulum.model_state[0],"
      "state:pendulum.model_state[1]\n" +
      text);
  return 0;
}
