// Adds the gradients of all parts in the order of the parts, with any number of ranks.
#pragma once

#include <span>
#include <vector>

#include "targets/environments/ranks/ranks.hpp"
#include "targets/environments/train/gradient.hpp"

namespace eagerx::train {

using environments::Ranks;

/// Each rank adds one slice of the numbers over all parts, and sends the sums to the others, so it
/// sends and receives two gradients for any number of ranks. Slices do not change bits, because
/// numbers do not mix.
class GradientSum {
 public:
  GradientSum(Ranks& ranks, const Model& model);

  /// Called by all ranks, with the gradients of their shares of the parts: the sum of all. One rank
  /// adds to its first.
  const Gradient& of(std::span<Gradient* const> own);

 private:
  /// The numbers of each of `own`, one slice after the other: to_[slice][own][numbers].
  void cut(std::span<Gradient* const> own);
  void add_slices();
  void put_together(std::span<Gradient* const> own);
  std::size_t slice(std::uint32_t rank) const;

  Ranks& ranks_;
  Gradient total_;
  std::size_t numbers_ = 0;
  std::vector<float> flat_;             // [numbers] of one gradient
  std::vector<float> to_, from_;        // pieces for and of other ranks
  std::vector<std::size_t> out_, in_;   // [ranks] bytes of these pieces
  std::vector<char> mine_, all_;        // a slice of the sum with the doubles of own parts
  std::vector<std::size_t> all_sizes_;  // [ranks]
};

}  // namespace eagerx::train
