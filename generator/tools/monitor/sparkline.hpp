// A plot of one line.
#pragma once

#include <cstddef>
#include <deque>
#include <string>

namespace eagerx::gen {

/// The last `columns` values between the least and the greatest of these, as blocks of Unicode or
/// in ASCII. A value that is not finite is `?`. Columns without a value are blank, on the left.
std::string sparkline(const std::deque<float>& values, std::size_t columns, bool unicode);

}  // namespace eagerx::gen
