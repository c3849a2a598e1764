// Any bytes as a pickle, as statistics and as golden rows: no crash, no endless work, and either a
// value or exactly one reason.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "generator/policy/formats/actor/actor.hpp"
#include "generator/policy/formats/statistics.hpp"
#include "generator/policy/formats/tensors/pickle.hpp"
#include "generator/policy/network/problem.hpp"

namespace {

using namespace eagerx::gen;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

void require(bool holds) {
  if (!holds) std::abort();
}

void read(std::string_view bytes, PickleNames names) {
  PolicyProblem problem;
  const auto pickle = read_pickle(bytes, names, problem);
  require(pickle.has_value() == problem.code.empty());
  if (!pickle) return;
  for (const PickleValue& value : pickle->values) {
    (void)pickle->find(value, "mean");
    (void)pickle->number(&value);
    (void)pickle->integers(&value);
    if (const auto array = pickle->array(&value)) (void)values_of(*array);
  }
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read(bytes, PickleNames::tensors);
  read(bytes, PickleNames::statistics);
  PolicyProblem problem;
  require(read_statistics(bytes, problem).has_value() == problem.code.empty());
  problem = {};
  require(facts_of_sb3(bytes, problem).has_value() == problem.code.empty());
  return 0;
}
