// libFuzzer: any bytes as the code of a TorchScript archive are a policy or exactly one diagnostic.
// The rest of the archive comes from a file that torch wrote.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "generator/policy/formats/read.hpp"
#include "generator/policy/formats/tensors/archive.hpp"
#include "generator/policy/network/cost.hpp"
#include "generator/policy/network/evaluate.hpp"
#include "tests/unit/formats/table_builder.hpp"

namespace {

using eagerx::gen::test::ZipEntry;

/// The entries of the archive, the code of its module first.
std::vector<ZipEntry> entries_of_archive() {
  std::ifstream file(EAGERX_SOURCE_DIR "/tests/data/policy/torchscript/small_scripted.pt",
                     std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  eagerx::gen::PolicyProblem problem;
  const auto archive = eagerx::gen::Archive::open(bytes, problem);
  if (!archive) std::abort();
  std::vector<ZipEntry> entries(1);
  for (const std::string& name : archive->names()) {
    std::string buffer;
    const auto content = archive->read(name, buffer, problem);
    if (!content) std::abort();
    ZipEntry entry{name, std::string(*content)};
    const bool is_module = entry.content.starts_with("class Small(");
    if (is_module) entries.front() = std::move(entry);
    if (!is_module) entries.push_back(std::move(entry));
  }
  if (entries.front().name.empty()) std::abort();
  return entries;
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static std::vector<ZipEntry> entries = entries_of_archive();
  entries.front().content.assign(reinterpret_cast<const char*>(data), size);
  const std::string bytes = eagerx::gen::test::zip(entries);
  eagerx::gen::Diagnostics diagnostics;
  const auto network = eagerx::gen::read_policy_bytes(bytes, "fuzz", {}, diagnostics);
  if (diagnostics.all().size() != (network ? 0U : 1U)) std::abort();
  if (!network) return 0;
  constexpr std::size_t kMostWork = 300'000;
  std::size_t work = network->inputs();
  for (const auto& layer : network->layers) {
    work += eagerx::gen::cost_of(layer).multiply_adds + layer.outputs + layer.inputs;
  }
  if (work > kMostWork) return 0;
  const std::vector<float> observation(network->inputs(), 0.5F);
  if (eagerx::gen::evaluate(*network, observation).size() != network->outputs()) std::abort();
  return 0;
}
