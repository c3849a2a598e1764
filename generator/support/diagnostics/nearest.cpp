#include <runtime/host/base/nearest.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  return host::nearest_name(word, candidates);
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates,
                         std::string otherwise) {
  std::string near = host::did_you_mean(word, candidates);
  return near.empty() ? std::move(otherwise) : near;
}

std::string did_you_mean_or(std::string_view word, const std::vector<std::string>& candidates,
                            const std::string& otherwise) {
  const std::string near = host::did_you_mean(word, candidates);
  return near.empty() ? otherwise : near + " If it is another one, " + otherwise;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       const std::string& none) {
  return candidates.empty() ? none : host::suggestion(word, candidates);
}

}  // namespace eagerx::gen
