// Any bytes as the checkpoint of a training: no crash, and either what a training can continue from
// or a reason. What was read is written and read again.
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

constexpr const char* kConditions = "graph 0, seed 1, net_arch 3, gamma 0.99";
constexpr const char* kInterface = "observations angle[2], actions voltage[1], net_arch 3";

void require(bool holds) {
  if (!holds) std::abort();
}

/// The initial model of a small training.
template <class SomeModel>
SomeModel first() {
  Description description;
  description.actions.push_back(
      {.name = "voltage", .dtype = "float32", .low = {-1.0}, .high = {1.0}});
  Settings settings;
  settings.net_arch = {3};
  settings.sac.buffer_size = 3;
  return {settings, 2, Head(description)};
}

/// The head that belongs to `values`, as only the trainer or somebody malicious writes it.
std::string with_head(std::string_view values) {
  static const std::string version = [] {
    const std::string whole = checkpoint_of(kConditions, kInterface, first<Model>(), {});
    return whole.substr(0, whole.find('\n'));
  }();
  std::uint64_t hash = 0xCBF29CE484222325U;
  for (const char c : values) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return fmt::format("{}\n{}\n{}\n{:016x}\n", version, kConditions, kInterface, hash) +
         std::string(values);
}

void look(const Model& learnt, const Progressed& progressed) {
  require(learnt.critic_parameters.size() == learnt.critic.parameters());
  const std::size_t best = progressed.best.parameters.size();
  require(best == 0 || best == learnt.actor.parameters());
}

void look(const sac::Model& learnt, const Progressed& progressed) {
  for (const sac::Critic& critic : learnt.critics)
    require(critic.target.size() == learnt.critic.parameters());
  const std::size_t best = progressed.best.parameters.size();
  require(best == 0 || best == 3 * 3 + 3 + 1);  // two inputs, three units, one mean
  require(learnt.memory.is_whole());
  for (std::size_t back = 0; back < learnt.memory.size(); ++back)
    require(learnt.memory.last(back).observation != nullptr);
}

template <class SomeModel>
void read(const std::string& bytes) {
  auto learnt = first<SomeModel>();
  Progressed progressed;
  try {
    restore(bytes, "fuzz", kConditions, learnt, progressed);
  } catch (const Problem&) {
    return;
  }
  require(learnt.actor_parameters.size() == learnt.actor.parameters());
  require(learnt.actor_adam.mean.size() == learnt.actor.parameters());
  require(progressed.recent.size() <= kRecent);
  look(learnt, progressed);
  const std::string again = checkpoint_of(kConditions, kInterface, learnt, progressed);
  auto other = first<SomeModel>();
  restore(again, "again", kConditions, other, progressed);
  require(checkpoint_of(kConditions, kInterface, other, progressed) == again);
}

template <class SomeModel>
void begin(const std::string& bytes) {
  auto learnt = first<SomeModel>();
  try {
    begin_from(bytes, "fuzz", kInterface, learnt);
  } catch (const Problem&) {
    return;
  }
  require(learnt.actor_parameters.size() == learnt.actor.parameters());
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read<Model>(bytes);
  const std::string whole = with_head(bytes);
  read<Model>(whole);
  read<sac::Model>(whole);
  begin<Model>(whole);
  begin<sac::Model>(whole);
  return 0;
}
