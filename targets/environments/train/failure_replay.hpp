// Episodes that begin with the initial states of a campaign's failed runs.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {

struct Settings;

/// The states that failed runs began with.
class FailureReplay {
 public:
  /// `text`: the table of `eagerx-gen campaign --csv`; `name`: of the file. Throws Problem if it is
  /// none, of a graph with other states, or has no run that failed.
  FailureReplay(std::string_view text, const std::string& name, const Description& description);

  std::size_t size() const { return width_ == 0 ? 0 : states_.size() / width_; }
  std::size_t width() const { return width_; }
  /// Numbers of the states, [width]. NaN: it is not set.
  const float* at(std::size_t i) const { return &states_[i * width_]; }

 private:
  std::size_t width_;
  std::vector<float> states_;  // [size][width]
};

/// The environments of a batch that begin all of their episodes at the initial states of failures:
/// a state that the graph does not sample would keep its value in the next episode.
class ReplayedEnvironments {
 public:
  /// Numbers first … first + count - 1 of a training; `settings` say how many of them.
  ReplayedEnvironments(const Settings& settings, const Library& library, std::uint32_t first,
                       std::uint32_t count);

  /// All begin the first episode of `seed`, also those that are not hard.
  void reset(Environments& environments, std::uint64_t seed, float* observation);
  /// An episode has begun in `environment` (0 … count - 1): set() is due.
  void note(std::size_t environment);
  /// Where the next episodes of those that were noted begin.
  void set(Environments& environments);

 private:
  std::shared_ptr<const FailureReplay> starts_;  // nullptr: none
  decltype(&eagerx_set_states) set_states_ = nullptr;
  std::uint32_t first_;
  std::uint64_t seed_ = 0;
  std::vector<std::uint8_t> is_hard_, is_noted_;  // [count]
  std::vector<std::uint32_t> episode_;            // [count] since reset()
  std::vector<float> states_;                     // [count][width]
  bool any_ = false;                              // is noted
};

}  // namespace eagerx::train
