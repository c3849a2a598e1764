// The growing table of one or more trainings in parallel, complete at any time.
#pragma once

#include <functional>
#include <mutex>
#include <string>
#include <utility>

namespace eagerx::train {

class CurveFile {
 public:
  /// `path`: empty for no file.
  explicit CurveFile(std::string path) : path_(std::move(path)) {}

  /// After an iteration, `now_s` after the start: writes the result of `text`, at most once a
  /// second. Returns the reason the first time that it fails, and tries again after a second. Any
  /// thread may call it; `text` is called by one thread at a time.
  std::string grow(double now_s, const std::function<std::string()>& text);
  /// The same at the end. Throws Problem.
  void write(const std::function<std::string()>& text);

 private:
  std::string path_;
  std::mutex mutex_;
  double next_s_ = 0.0;
  bool is_reported_ = false;
};

}  // namespace eagerx::train
