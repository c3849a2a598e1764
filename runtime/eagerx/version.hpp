// The version of the runtime. Generated code checks it, so that old output never compiles with a
// new runtime. eagerx-gen and the package have the same version: CMakeLists.txt reads it here.
#pragma once

namespace eagerx {

inline constexpr int kVersionMajor = 1;
inline constexpr int kVersionMinor = 0;
inline constexpr int kVersionPatch = 0;

}  // namespace eagerx
