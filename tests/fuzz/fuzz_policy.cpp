// libFuzzer: any bytes are a policy or exactly one diagnostic.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "generator/policy/formats.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  eagerx::gen::Diagnostics diagnostics;
  const auto network = eagerx::gen::read_policy_bytes(bytes, "fuzz", {}, diagnostics);
  if (diagnostics.all().size() != (network ? 0U : 1U)) std::abort();
  return 0;
}
