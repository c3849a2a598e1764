// Any bytes as a csv file: no crash, rows of one length, and cells that are where they say.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "generator/frontend/read/text.hpp"
#include "generator/frontend/tables/csv.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace {

using eagerx::gen::CsvCell;
using eagerx::gen::CsvRow;

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  eagerx::gen::SourceMap sources;
  eagerx::gen::Diagnostics diagnostics;
  const auto file = sources.add("fuzz.csv", eagerx::gen::normalize_text(std::string(
                                                reinterpret_cast<const char*>(data), size)));
  if (!eagerx::gen::check_text(sources.text(file), file, diagnostics)) return 0;
  const auto table = eagerx::gen::read_csv(file, sources, diagnostics);
  require(table.has_value() != diagnostics.has_errors());
  render_text(diagnostics, sources, true);
  if (!table) return 0;
  const std::size_t width = table->rows.front().size();
  require(table->header.empty() || table->header.size() == width);
  for (const CsvRow& row : table->rows) {
    require(row.size() == width);
    for (const CsvCell& cell : row) {
      const auto line = sources.line(cell.span.file, cell.span.line);
      const std::size_t length = eagerx::gen::count_code_points(line);
      require(cell.span.column >= 1 && cell.span.column + cell.span.length <= length + 2);
    }
  }
  return 0;
}
