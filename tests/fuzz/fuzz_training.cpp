// Any bytes as what a training has left, for `report --training`: no crash, no endless work, and
// either a view of it whose numbers are ones of JSON, or one problem with its line.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "generator/support/json/json.hpp"
#include "generator/tools/training/tables.hpp"
#include "generator/tools/training/training.hpp"

namespace {

using namespace eagerx::gen;  // NOLINT(google-build-using-namespace): a fuzzer, not a library

void require(bool holds) {
  if (!holds) std::abort();
}

void check(const TrainingRecord& record) {
  require(parse_json(dump_json(record.page)).has_value());
  if (record.episodes.empty()) return;
  const auto [best, worst] = best_and_worst(record.episodes);
  require(best.success >= worst.success);
  for (const TrainingEpisode& one : record.episodes) {
    require(std::isfinite(one.sum) && one.steps > 0);
    require(one.success != best.success || one.sum <= best.sum);
  }
}

void read(const std::string& text) {
  SourceMap sources;
  Diagnostics diagnostics;
  const auto record = read_training_text("fuzz", text, sources, diagnostics);
  require(record.has_value() == !diagnostics.has_errors() && diagnostics.error_count() <= 1);
  render_text(diagnostics, sources, true);
  if (record) check(*record);
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read(text);
  read(
      R"({"eagerx_training":1,"graph":"g","algorithm":"ppo","settings":"clip 0.1","rate":30,"seed":1,)"
      R"("seeds":2,"steps":9,"terms":["a"]})"
      "\n" +
      text);
  read(std::string(kSweepHeader) + "\n" + text);
  read("seed,steps,return,success_rate,eval_return\n" + text);
  return 0;
}
