#include "targets/environments/ranks/ranks.hpp"

namespace eagerx::environments {

std::unique_ptr<Ranks> make_ranks(int& /*argc*/, char**& /*argv*/) {
  return std::make_unique<Alone>();
}

}  // namespace eagerx::environments
