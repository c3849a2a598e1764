#include "targets/environments/train/curve_file.hpp"

#include <runtime/host/base/files.hpp>
#include <utility>

#include "targets/environments/train/client.hpp"

namespace eagerx::train {

std::string CurveFile::grow(double now_s, const std::function<std::string()>& text) {
  constexpr double kEvery_s = 1.0;  // the whole file each time, so that no reader sees half a row
  const std::lock_guard lock(mutex_);
  if (path_.empty() || now_s < next_s_ || !host::is_replaced_by_output(path_)) return {};
  next_s_ = now_s + kEvery_s;
  try {
    write_file(path_, text());
    is_reported_ = false;
  } catch (const Problem& problem) {
    if (!std::exchange(is_reported_, true)) return problem.what();
  }
  return {};
}

void CurveFile::write(const std::function<std::string()>& text) {
  const std::lock_guard lock(mutex_);
  if (!path_.empty()) write_file(path_, text());
}

}  // namespace eagerx::train
