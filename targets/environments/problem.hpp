// What is wrong with a call, on its way to eagerx_error().
#pragma once

#include <stdexcept>

namespace eagerx::environments {

/// Nothing else is thrown here on purpose; none of it leaves the library.
class Problem : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace eagerx::environments
