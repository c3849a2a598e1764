#include "generator/frontend/tables/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

/// The text of a cell in quotes, in which "" is a quote.
std::string without_quotes(std::string_view text) {
  std::string result;
  for (std::size_t at = 1; at < text.size() && !(text[at] == '"' && text.substr(at) == "\"");
       ++at) {
    result += text[at];
    if (text[at] == '"') ++at;
  }
  return result;
}

/// Where the cell that begins at `begin` ends: at a comma that is not in quotes, or at the end.
std::size_t end_of_cell(std::string_view line, std::size_t begin) {
  bool quoted = false;
  std::size_t at = begin;
  while (at < line.size() && (quoted || line[at] != ',')) {
    if (line[at] == '"') quoted = !quoted;
    ++at;
  }
  return at;
}

CsvRow read_row(std::string_view line, FileId file, std::uint32_t number) {
  CsvRow row;
  std::uint32_t column = 1;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = end_of_cell(line, begin);
    const std::string_view whole = line.substr(begin, end - begin);
    const std::string_view text = trimmed(whole, " \t");
    const std::size_t blanks =
        text.empty() ? 0 : static_cast<std::size_t>(text.data() - whole.data());
    const auto length = static_cast<std::uint32_t>(count_code_points(text));
    row.push_back({text.starts_with('"') ? without_quotes(text) : std::string(text),
                   {file, number, column + static_cast<std::uint32_t>(blanks),
                    std::max<std::uint32_t>(length, 1)}});
    column += static_cast<std::uint32_t>(count_code_points(whole)) + 1;
    begin = end + 1;
  }
  return row;
}

/// A row with a number is none: what else is in it is a mistake.
bool is_header(const CsvRow& row) {
  return ranges::none_of(row, [](const CsvCell& cell) {
    return cell.text.empty() || (parse_number(cell.text).has_value() && cell.text != "pi");
  });
}

}  // namespace

std::optional<CsvTable> read_csv(FileId file, const SourceMap& sources, Diagnostics& diagnostics) {
  const std::size_t errors_before = diagnostics.error_count();
  CsvTable table;
  table.file = file;
  const std::string_view text = sources.text(file);
  std::optional<CsvRow> first;
  std::uint32_t number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    ++number;
    const std::string_view content = trimmed(line, " \t");
    if (content.empty() || content.starts_with('#')) continue;
    CsvRow row = read_row(line, file, number);
    if (!first) {
      first = row;
      if (is_header(row)) {
        table.header = std::move(row);
        continue;
      }
    }
    if (row.size() != first->size()) {
      auto& problem = diagnostics.error("E0346", row.back().span,
                                        fmt::format("the row has {}, the first row has {}",
                                                    counted(row.size(), "cell"), first->size()));
      problem.notes.push_back({"the first row", first->front().span, ""});
      if (diagnostics.error_count() - errors_before >= kMostCsvProblems) break;
    }
    table.rows.push_back(std::move(row));
  }
  if (diagnostics.error_count() != errors_before) return std::nullopt;
  if (table.rows.empty()) {
    diagnostics.error("E0346", {file, 0, 0, 0}, "the file has no row of numbers");
    return std::nullopt;
  }
  return table;
}

}  // namespace eagerx::gen
