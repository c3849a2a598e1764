// Any bytes as the checkpoint of a training: no crash, and either what a training can go on from or
// a reason. What was read is written and read again.
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "targets/environments/train/checkpoint.hpp"
#include "targets/environments/train/client.hpp"

namespace {

using namespace eagerx::train;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

constexpr const char* kConditions = "graph 0, seed 1, layers 3, discount 0.99";
constexpr const char* kInterface = "observations angle[2], actions voltage[1], layers 3";

void require(bool holds) {
  if (!holds) std::abort();
}

Model model() {
  Description description;
  description.actions.push_back(
      {.name = "voltage", .dtype = "float32", .low = {-1.0}, .high = {1.0}});
  Settings settings;
  settings.layers = {3};
  return {settings, 2, Head(description)};
}

/// The head that belongs to `values`, as only the trainer or somebody malicious writes it.
std::string with_head(std::string_view values) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : values) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return fmt::format("eagerx-train checkpoint 3\n{}\n{}\n{:016x}\n", kConditions, kInterface,
                     hash) +
         std::string(values);
}

bool read(const std::string& bytes) {
  Model learnt = model();
  Progressed progressed;
  try {
    restore(bytes, "fuzz", kConditions, learnt, progressed);
  } catch (const Problem&) {
    return false;
  }
  require(learnt.actor_parameters.size() == learnt.actor.parameters());
  require(learnt.actor_adam.mean.size() == learnt.actor.parameters());
  require(progressed.recent.size() <= kRecent);
  const std::size_t best = progressed.best.parameters.size();
  require(best == 0 || best == learnt.actor.parameters());
  const std::string again = checkpoint_of(kConditions, kInterface, learnt, progressed);
  Model other = model();
  restore(again, "again", kConditions, other, progressed);
  require(checkpoint_of(kConditions, kInterface, other, progressed) == again);
  return true;
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  const std::string whole = with_head(bytes);
  read(whole);
  Model learnt = model();
  try {
    begin_from(whole, "fuzz", kInterface, learnt);
  } catch (const Problem&) {
    return 0;
  }
  require(learnt.critic_parameters.size() == learnt.critic.parameters());
  return 0;
}
