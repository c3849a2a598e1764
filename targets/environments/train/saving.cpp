#include "targets/environments/train/saving.hpp"

#include <utility>

namespace eagerx::train {

Saving::Saving(std::string path, double every_s, std::function<std::string()> bytes)
    : path_(std::move(path)), every_s_(every_s), bytes_(std::move(bytes)) {}

std::optional<Problem> Saving::save() {
  std::optional<Problem> problem;
  if (!is_wanted()) return problem;
  try {
    write_file(path_, bytes_());
  } catch (const Problem& what) {
    problem = what;
  }
  is_saved_ = !problem;
  tried_ = Clock::now();
  return problem;
}

std::optional<Problem> Saving::save_if_due(bool must) {
  const std::chrono::duration<double> since = Clock::now() - tried_;
  if (!must && since.count() < every_s_) return std::nullopt;
  const bool was_saved = is_saved_;
  std::optional<Problem> problem = save();
  return was_saved ? problem : std::nullopt;
}

}  // namespace eagerx::train
