// Where models, targets and templates are: beside an installed eagerx-gen, or in the source tree it
// was built from.
#pragma once

#include <string>

namespace eagerx::gen {

/// The folder that holds models/, targets/, templates/, toolchains/; EAGERX_HOME in the environment
/// wins. Empty if there is none.
std::string data_root();

}  // namespace eagerx::gen
