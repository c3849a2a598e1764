// The version of the runtime. Generated code checks it, so that old output never meets a new
// runtime silently. It is that of eagerx-gen and of the package, too: CMakeLists.txt reads it here.
#pragma once

namespace eagerx {

inline constexpr int kVersionMajor = 1;
inline constexpr int kVersionMinor = 0;
inline constexpr int kVersionPatch = 0;

}  // namespace eagerx
