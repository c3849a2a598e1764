// Any bytes as the checkpoint of a campaign: no crash, no endless work. What is good of them is
// found, and the file that is left has nothing else in it.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "targets/environments/campaign/journal.hpp"
#include "targets/environments/campaign/record.hpp"
#include "targets/environments/client/files.hpp"
#include "targets/environments/client/problem.hpp"

namespace {

using namespace eagerx::campaign;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

constexpr const char* kTitle = "eagerx-gen campaign 1 fuzz\n";

void require(bool holds) {
  if (!holds) std::abort();
}

/// Three chunks, the last one of few runs so that a record of it is short.
Plan plan() {
  Plan plan;
  plan.runs = 2 * kChunk + 2;
  plan.columns = {"pendulum.mass"};
  return plan;
}

/// `body` with the size and the check sum that belong to it.
std::string record(std::string_view body) {
  std::uint64_t sum = 0xcbf29ce484222325U;
  for (const char c : body) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  const auto size = static_cast<std::uint32_t>(body.size());
  std::string bytes(sizeof size + sizeof sum, '\0');
  std::memcpy(bytes.data(), &size, sizeof size);
  std::memcpy(bytes.data() + sizeof size, &sum, sizeof sum);
  return bytes.append(body);
}

/// In memory: files are synchronised with the disk.
std::string path_of_run() {
  return "/dev/shm/fuzz_journal." + std::to_string(getpid());
}

/// False if it is not a journal, or of another campaign.
bool resume(std::string_view bytes) {
  static const std::string path = path_of_run();
  eagerx::client::write_file(path, bytes);
  const Plan whole = plan();
  Results first(whole.runs, whole.width()), second(whole.runs, whole.width());
  try {
    Journal::Found found, again;
    {
      Journal journal(path, "fuzz");
      found = journal.resume(whole, first);
      require(found.damaged_bytes <= bytes.size() && found.done.size() == whole.chunks());
    }
    Journal journal(path, "fuzz");
    again = journal.resume(whole, second);
    require(again.damaged_bytes == 0 && again.done == found.done && first.steps == second.steps);
  } catch (const eagerx::client::Problem&) {
    return false;
  }
  return true;
}

}  // namespace

// The names are libFuzzer's.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  std::atexit([] { unlink(path_of_run().c_str()); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Plan whole = plan();
  const std::string sealed = record(bytes);
  std::string_view left = sealed;
  if (const auto taken = take_record(left, whole)) {
    require(left.empty());
    const std::string again = record_of(taken->chunk, taken->results);
    std::string_view rest = again;
    require(take_record(rest, whole).has_value() && rest.empty());
    const std::string noise = "noise" + sealed;
    std::size_t work = noise.size();
    require(find_record(noise, 0, whole, work) == std::strlen("noise"));
  }
  resume(bytes);
  require(resume(kTitle + std::string(bytes)));
  require(resume(kTitle + sealed + std::string(bytes) + sealed));
  return 0;
}
