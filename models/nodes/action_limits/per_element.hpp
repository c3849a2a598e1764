// Parameters with one value for all elements of a message, or one for each.
#pragma once

#include <cstddef>

namespace eagerx::models {

/// Value `i` of a list that has one value for all, or one for each.
template <class Real, class List>
constexpr Real value_for(const List& list, std::size_t i) {
  return static_cast<Real>(list[list.size() == 1 ? 0 : i]);
}

template <class List>
constexpr bool is_one_or_each(const List& list, std::size_t elements) {
  return list.size() == 1 || list.size() == elements;
}

}  // namespace eagerx::models
