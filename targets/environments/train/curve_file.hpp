// The table of a training that grows: whole at any time.
#pragma once

#include <functional>
#include <string>
#include <utility>

namespace eagerx::train {

class CurveFile {
 public:
  /// `path`: empty: there is none.
  explicit CurveFile(std::string path) : path_(std::move(path)) {}

  /// After an iteration, `now_s` after the start: writes what `text` makes, if that was a second
  /// ago or never done. Returns why not, the first time that it fails; the next second it is tried
  /// again.
  std::string grow(double now_s, const std::function<std::string()>& text);

 private:
  std::string path_;
  double next_s_ = 0.0;
  bool is_told_ = false;
};

}  // namespace eagerx::train
