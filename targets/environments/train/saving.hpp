// The checkpoint of a training, rewritten regularly.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {

class Saving {
 public:
  /// `path` empty: nothing is written. `bytes` makes the checkpoint as of now.
  Saving(std::string path, double every_s, std::function<std::string()> bytes);

  bool is_wanted() const { return !path_.empty(); }
  /// Returns why it could not be written, if so.
  std::optional<Problem> save();
  /// If it `must`, or it was long ago. Returns what is to be said: why it could not be written, the
  /// first time. A disk that is full now may have room in a minute.
  std::optional<Problem> save_if_due(bool must);

 private:
  using Clock = std::chrono::steady_clock;

  const std::string path_;
  const double every_s_;
  const std::function<std::string()> bytes_;
  bool is_saved_ = true;  // as far as it was tried
  Clock::time_point tried_ = Clock::now();
};

}  // namespace eagerx::train
