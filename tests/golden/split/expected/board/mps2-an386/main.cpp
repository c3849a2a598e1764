// The part of graph `multi_rate` that runs on mps2-an386; what it does is in
// targets/common/bare-metal/partner.hpp.
#include <targets/common/bare-metal/partner.hpp>

#include "multi_rate/graph.hpp"

int main() {
  return eagerx::board::serve<graphs::multi_rate::Graph>();
}
