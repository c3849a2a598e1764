// A chunk of runs, with the graph's agent in the loop.
#pragma once

#include <string>

#include "targets/environments/campaign/plan.hpp"
#include "targets/environments/campaign/results.hpp"
#include "targets/environments/client/library.hpp"

namespace eagerx::campaign {

class Runner {
 public:
  /// Throws Problem if the library is older than campaigns.
  Runner(const client::Library& library, const Plan& plan);

  /// Run k is the first episode of environment k of the plan's seed. Several threads may call it in
  /// parallel. Throws Problem for errors of the library.
  Results run(std::uint32_t chunk) const;
  /// How those of the first chunk are stepped, in words: vectorized, or why not.
  std::string stepping() const;

 private:
  struct Functions {
    decltype(&eagerx_act) act;
    decltype(&eagerx_set_states) set_states;
    decltype(&eagerx_get_exact_states) get_states;
    decltype(&eagerx_counts) counts;
  };
  class Chunk;

  const client::Library& library_;
  const Plan& plan_;
  Functions functions_;
};

}  // namespace eagerx::campaign
