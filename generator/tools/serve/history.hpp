// Changes that can be undone, byte for byte.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "generator/tools/edit/edit.hpp"

namespace eagerx::gen::serve {

class History {
 public:
  static constexpr std::size_t kMostSteps = 1000, kMostBytes = 64U << 20U;

  /// The text was changed by `edit`, which has one splice.
  void add(std::string_view before, const Edit& edit);
  /// The effect of undo and redo; "": none.
  [[nodiscard]] std::string undo_reason() const;
  [[nodiscard]] std::string redo_reason() const;
  /// The text one step earlier or later; the same if there is none.
  [[nodiscard]] std::string undone(std::string_view text) const;
  [[nodiscard]] std::string redone(std::string_view text) const;
  void step_back() { --done_; }
  void step_forward() { ++done_; }
  void clear();

 private:
  struct Step {
    std::string reason;
    std::size_t begin;
    std::string before, after;
    [[nodiscard]] std::size_t bytes() const { return before.size() + after.size(); }
  };
  void forget_oldest();

  std::deque<Step> steps_;
  std::size_t done_ = 0;  // the number of them in the text
  std::size_t bytes_ = 0;
};

}  // namespace eagerx::gen::serve
