// The transitions that SAC learns from.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace eagerx::train::sac {

/// One step of one environment, without normalization, because the statistics may still change.
struct Transition {
  const float* observation;  // [width]
  const float* next;         // [width], of the same episode also where it ended
  const float* action;       // [numbers] in -1…1
  float reward;
  float continues;  // 0 behind a terminated episode, 1 else: a time limit does not end the task
};

/// The last transitions, at most `capacity`; the next one replaces the oldest.
class Memory {
 public:
  Memory(std::size_t width, std::size_t numbers, std::size_t capacity)
      : width_(width), numbers_(numbers), capacity_(capacity) {}

  std::size_t size() const { return rows.size() / row(); }
  /// Floats of a transition.
  std::size_t row() const { return 2 * width_ + numbers_ + 2; }

  void add(const Transition& one) {
    const std::size_t place = added % capacity_ * row();
    if (place == rows.size()) rows.resize(place + row());
    float* to = &rows[place];
    to = std::copy_n(one.observation, width_, to);
    to = std::copy_n(one.next, width_, to);
    to = std::copy_n(one.action, numbers_, to);
    *to++ = one.reward;
    *to = one.continues;
    ++added;
  }

  /// The one at `place`, 0 to size() - 1.
  Transition at(std::size_t place) const {
    const float* row_of_it = &rows[place * row()];
    const float* action = row_of_it + 2 * width_;
    return {row_of_it, row_of_it + width_, action, action[numbers_], action[numbers_ + 1]};
  }
  /// The one before the last `back` ones that were added; back < size().
  Transition last(std::size_t back) const {
    return at(static_cast<std::size_t>((added - 1 - back) % capacity_));
  }

  /// Whether rows and count are consistent, which external data may violate.
  bool is_whole() const { return rows.size() == std::min<std::uint64_t>(added, capacity_) * row(); }

  std::vector<float> rows;  // [size][row]
  std::uint64_t added = 0;

 private:
  std::size_t width_, numbers_, capacity_;
};

}  // namespace eagerx::train::sac
