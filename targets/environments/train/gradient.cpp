#include "targets/environments/train/gradient.hpp"

#include <algorithm>

namespace eagerx::train {

void Gradient::clear() {
  for (std::vector<float>* values : vectors()) std::fill(values->begin(), values->end(), 0.0F);
  divergence = count = 0.0;
}

void Gradient::add(Gradient& more) {
  const auto theirs = more.vectors();
  for (std::size_t k = 0; k < theirs.size(); ++k) {
    std::vector<float>& sum = *vectors()[k];
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*theirs[k])[i];
  }
  divergence += more.divergence;
  count += more.count;
}

}  // namespace eagerx::train
