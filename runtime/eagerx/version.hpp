// The version of the runtime. Generated code checks it, so that old output never meets a new
// runtime silently.
#pragma once

namespace eagerx {

inline constexpr int kVersionMajor = 0;
inline constexpr int kVersionMinor = 1;

}  // namespace eagerx
