#include "generator/tools/serve/history.hpp"

namespace eagerx::gen::serve {
namespace {

std::string replaced(std::string_view text, std::size_t begin, std::size_t size,
                     std::string_view with) {
  std::string result(text);
  result.replace(begin, size, with);
  return result;
}

}  // namespace

void History::add(std::string_view before, const Edit& edit) {
  while (steps_.size() > done_) {
    bytes_ -= steps_.back().bytes();
    steps_.pop_back();
  }
  const Splice& splice = edit.splices.front();
  steps_.push_back(
      {edit.reason, splice.place.begin,
       std::string(before.substr(splice.place.begin, splice.place.end - splice.place.begin)),
       splice.text});
  bytes_ += steps_.back().bytes();
  ++done_;
  while (steps_.size() > kMostSteps || (bytes_ > kMostBytes && steps_.size() > 1)) forget_oldest();
}

void History::forget_oldest() {
  bytes_ -= steps_.front().bytes();
  steps_.pop_front();
  --done_;
}

std::string History::undo_reason() const {
  return done_ > 0 ? steps_[done_ - 1].reason : "";
}
std::string History::redo_reason() const {
  return done_ < steps_.size() ? steps_[done_].reason : "";
}

std::string History::undone(std::string_view text) const {
  if (done_ == 0) return std::string(text);
  const Step& step = steps_[done_ - 1];
  return replaced(text, step.begin, step.after.size(), step.before);
}
std::string History::redone(std::string_view text) const {
  if (done_ == steps_.size()) return std::string(text);
  const Step& step = steps_[done_];
  return replaced(text, step.begin, step.before.size(), step.after);
}

void History::clear() {
  steps_.clear();
  done_ = bytes_ = 0;
}

}  // namespace eagerx::gen::serve
