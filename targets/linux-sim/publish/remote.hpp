// Requests of clients to a run: passed from the publishing thread to the stepping thread, which
// handles them between two steps.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <targets/linux-sim/fields.hpp>
#include <targets/linux-sim/publish/ring.hpp>
#include <vector>

namespace eagerx::linux_sim {

/// Neither side waits for the other, or allocates memory for it.
class Remote {
 public:
  enum class Wish : std::uint8_t { reset, pause, resume, step, state, action };
  struct Request {
    Wish wish;
    std::uint32_t index;          // of the state or the action; of step: how many
    std::size_t count;            // of numbers; 0: it is no longer set
    const std::uint64_t* values;  // their bits
  };

  explicit Remote(const Fields& fields);

  // Of the thread that publishes.

  /// The number of the request, which has been done when done() is not below it; 0: no room.
  std::uint64_t ask(Wish wish, std::uint32_t steps);
  /// Of a state or an action. False: no room.
  bool set(Wish wish, std::uint32_t index, const std::vector<double>& numbers);
  std::uint64_t done() const { return done_.load(std::memory_order_acquire); }
  /// Copies the initial states of the latest episode, state after state, into `numbers` and, one a
  /// state, `has_value`. False: not known yet, or it changes just now.
  bool read_states(std::vector<double>& numbers, std::vector<bool>& has_value) const;
  /// Another one each time that an episode begins.
  std::uint64_t version() const { return version_.load(std::memory_order_acquire); }

  // Of the thread that steps.

  /// The oldest request, or false.
  bool next(Request& request);
  /// … which is taken. Its values are gone then.
  void pop(const Request& request) { ring_.pop(kHeadWords + request.count); }
  void set_done(std::uint64_t number) { done_.store(number, std::memory_order_release); }
  void tell_states(StateRow states);

 private:
  static constexpr std::size_t kHeadWords = 2;
  static constexpr unsigned kIndexShift = 8;

  bool put(Wish wish, std::uint32_t index, const std::vector<double>& numbers);

  const Fields& fields_;
  PublishRing ring_;
  std::uint64_t asked_ = 0;
  std::atomic<std::uint64_t> done_ = 0;
  std::atomic<std::uint64_t> version_ = 0;  // odd: something changes
  std::size_t elements_ = 0;                // of all states
  std::unique_ptr<std::atomic<std::uint64_t>[]> states_;
  std::unique_ptr<std::atomic<bool>[]> has_value_;
};

}  // namespace eagerx::linux_sim
