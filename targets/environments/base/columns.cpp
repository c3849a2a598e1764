#include <algorithm>
#include <cstddef>
#include <numeric>
#include <string>
#include <targets/environments/base/columns.hpp>

namespace eagerx::environments {

void Columns::add(const char* name, std::size_t numbers) {
  names_.emplace_back(name);
  sizes_.push_back(numbers);
}

void Columns::arrange() {
  order_.resize(names_.size());
  std::iota(order_.begin(), order_.end(), std::size_t{0});
  std::ranges::sort(order_, {}, [&](std::size_t i) -> const std::string& { return names_[i]; });
  first_.resize(names_.size());
  for (const std::size_t field : order_) {
    first_[field] = numbers_;
    numbers_ += sizes_[field];
  }
}

}  // namespace eagerx::environments
