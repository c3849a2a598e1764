#include <algorithm>
#include <bit>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/publish/remote.hpp>

namespace eagerx::linux_sim {
namespace {

std::size_t elements_of(const std::vector<Field>& fields) {
  std::size_t sum = 0;
  for (const Field& field : fields) sum += field.type.size;
  return sum;
}

std::size_t longest_of(const Fields& fields) {
  std::size_t longest = 1;
  for (const auto* list : {&fields.states, &fields.actions})
    for (const Field& field : *list) longest = std::max(longest, field.type.size);
  return longest;
}

}  // namespace

Remote::Remote(const Fields& fields)
    : fields_(fields),
      ring_(4096, kHeadWords + longest_of(fields)),
      elements_(elements_of(fields.states)),
      states_(std::make_unique<std::atomic<std::uint64_t>[]>(elements_ + 1)),
      has_value_(std::make_unique<std::atomic<bool>[]>(fields.states.size() + 1)) {}

bool Remote::put(Wish wish, std::uint32_t index, const std::vector<double>& numbers) {
  std::uint64_t* const at = ring_.begin(kHeadWords + numbers.size());
  if (at == nullptr) return false;
  at[0] = static_cast<std::uint64_t>(wish) | std::uint64_t{index} << kIndexShift;
  at[1] = numbers.size();
  for (std::size_t i = 0; i < numbers.size(); ++i)
    at[kHeadWords + i] = std::bit_cast<std::uint64_t>(numbers[i]);
  ring_.commit(kHeadWords + numbers.size());
  return true;
}

std::uint64_t Remote::ask(Wish wish, std::uint32_t steps) {
  return put(wish, steps, {}) ? ++asked_ : 0;
}

bool Remote::set(Wish wish, std::uint32_t index, const std::vector<double>& numbers) {
  return put(wish, index, numbers);
}

bool Remote::next(Request& request) {
  constexpr std::uint64_t kWish = 0xff;
  const std::uint64_t* const at = ring_.front();
  if (at == nullptr) return false;
  request = {static_cast<Wish>(at[0] & kWish), static_cast<std::uint32_t>(at[0] >> kIndexShift),
             at[1], at + kHeadWords};
  return true;
}

void Remote::tell_states(StateRow states) {
  version_.fetch_add(1, std::memory_order_relaxed);
  // Before any of the numbers: acq_rel would keep them behind the load of an addition, not behind
  // its store, which are two on Arm (H.-J. Boehm, Can seqlocks get along with programming language
  // memory models?, MSPC 2012).
  std::atomic_thread_fence(std::memory_order_release);
  std::size_t at = 0;
  for (std::size_t s = 0; s < fields_.states.size(); ++s) {
    const MessageType& type = fields_.states[s].type;
    has_value_[s].store(states.has_value[s], std::memory_order_relaxed);
    for (std::size_t i = 0; i < type.size; ++i, ++at) {
      if (!states.has_value[s]) continue;
      const double value = number_of(type.scalar, states.messages[s], i);
      states_[at].store(std::bit_cast<std::uint64_t>(value), std::memory_order_relaxed);
    }
  }
  version_.fetch_add(1, std::memory_order_release);
}

bool Remote::read_states(std::vector<double>& numbers, std::vector<bool>& has_value) const {
  const std::uint64_t before = version();
  if (before == 0 || before % 2 != 0) return false;
  numbers.resize(elements_);
  has_value.resize(fields_.states.size());
  for (std::size_t i = 0; i < elements_; ++i)
    numbers[i] = std::bit_cast<double>(states_[i].load(std::memory_order_relaxed));
  for (std::size_t s = 0; s < has_value.size(); ++s)
    has_value[s] = has_value_[s].load(std::memory_order_relaxed);
  std::atomic_thread_fence(std::memory_order_acquire);
  return version_.load(std::memory_order_relaxed) == before;
}

}  // namespace eagerx::linux_sim
