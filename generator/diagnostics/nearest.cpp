#include <runtime/host/base/nearest.hpp>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  return host::nearest_name(word, candidates);
}

}  // namespace eagerx::gen
