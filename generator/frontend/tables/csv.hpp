// A csv file as cells that know their places.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// The number of problems of one file that are reported; more are of no use.
inline constexpr std::size_t kMostCsvProblems = 100;

struct CsvCell {
  std::string text;  // without quotes and blanks around it
  Span span;
};
using CsvRow = std::vector<CsvCell>;

/// `header` is the first row if it is names, with no number and no empty cell; else empty.
struct CsvTable {
  FileId file = FileId::none;
  CsvRow header;
  std::vector<CsvRow> rows;  // at least one, all as long as the first row of the file
};

/// The cells of a text, which is in `sources`: separated by commas, in quotes where a cell has a
/// comma. Empty lines and lines that begin with `#` are left out. nullopt and E0346 for rows of
/// another length than the first, and where there are no rows.
std::optional<CsvTable> read_csv(FileId file, const SourceMap& sources, Diagnostics& diagnostics);

}  // namespace eagerx::gen
