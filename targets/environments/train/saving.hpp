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
  /// `path` empty: writes nothing. `bytes` makes the current checkpoint.
  Saving(std::string path, double every_s, std::function<std::string()> bytes);

  bool is_wanted() const { return !path_.empty(); }
  /// Returns why it could not be written, if so.
  std::optional<Problem> save();
  /// Writes if it `must`, or if the last checkpoint is old enough. Returns a problem the first time
  /// that it cannot be written: a full disk may have room again a minute later.
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
