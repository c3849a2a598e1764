// Shared parts of processors that change only the shape.
#pragma once

#include <cstddef>
#include <eagerx/message.hpp>

namespace eagerx::models {

/// A message of another shape and the same type, with the elements in the same row-major order.
template <class Out, class In>
Out same_elements(const In& in) {
  static_assert(size_of<In> == size_of<Out>);
  Out out{};
  for (std::size_t i = 0; i < size_of<In>; ++i) element(out, i) = element(in, i);
  return out;
}

}  // namespace eagerx::models
