#include <fmt/format.h>

#include <runtime/host/base/nearest.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  return host::nearest_name(word, candidates);
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates,
                         std::string otherwise) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? std::move(otherwise) : fmt::format("did you mean `{}`?", near);
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& none) {
  return did_you_mean(
      word, candidates,
      candidates.empty() ? none : fmt::format("there is {}", fmt::join(candidates, ", ")));
}

}  // namespace eagerx::gen
