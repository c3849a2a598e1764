// libFuzzer: any bytes are a policy, whose layers fit together, or exactly one diagnostic.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"

namespace {

/// Two observations through a network that is not too large: layers read what is there.
void answer(const eagerx::gen::Network& network) {
  constexpr std::size_t kMostWork = 300'000;
  std::size_t work = 0;
  for (const auto& layer : network.layers) {
    work += eagerx::gen::cost_of(layer).multiply_adds + layer.outputs + layer.inputs;
    if (const auto* pool = std::get_if<eagerx::gen::Pooling>(&layer.form)) {
      work += std::size_t{layer.outputs} * pool->kernel.rows * pool->kernel.columns;
    }
  }
  if (work > kMostWork) return;
  eagerx::gen::Memory<float> memory;
  const std::vector<float> observation(network.inputs(), 0.5F);
  for (int i = 0; i < 2; ++i) {
    const auto action = eagerx::gen::evaluate(network, observation, &memory);
    if (action.size() != network.outputs()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  eagerx::gen::Diagnostics diagnostics;
  // A file next to it has half of the same bytes.
  eagerx::gen::ReadContext context;
  context.files = [bytes](const std::string& /*name*/, std::string& /*why*/) {
    return std::optional<std::string>(bytes.substr(bytes.size() / 2));
  };
  const auto network = eagerx::gen::read_policy_bytes(bytes, "fuzz", {}, diagnostics, context);
  if (diagnostics.all().size() != (network ? 0U : 1U)) std::abort();
  if (network) answer(*network);
  return 0;
}
