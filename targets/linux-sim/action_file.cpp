#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/base/number.hpp>
#include <sstream>
#include <targets/linux-sim/action_file.hpp>
#include <targets/linux-sim/elements.hpp>
#include <targets/linux-sim/options.hpp>
#include <type_traits>

namespace eagerx::linux_sim {
namespace {

constexpr std::string_view kBlank = " \t\r";

/// `text` without blanks around it; `column` moves along.
std::string_view trimmed(std::string_view text, std::size_t& column) {
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  column += first;
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool is_header(const std::vector<Cell>& row, const std::vector<std::string>& columns) {
  return std::equal(
      row.begin(), row.end(), columns.begin(),
      [](const Cell& cell, const std::string& column) { return cell.text == column; });
}

bool are_words(const std::vector<Cell>& row) {
  return std::ranges::none_of(row, [](const Cell& cell) {
    return cell.text.find_first_of("0123456789") == 0 || cell.text.find_first_of("+-.") == 0;
  });
}

std::string names_of(const std::vector<std::string>& columns) {
  std::string names = "`";
  for (const std::string& column : columns) names += (names == "`" ? "" : ",") + column;
  return names + "`";
}

/// Reads one number exactly: no spaces inside, nothing after it, in range, finite.
template <class T>
bool parse_cell(std::string_view text, T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    if (text != "0" && text != "1") return false;
    value = text == "1";
    return true;
  } else {
    if (!host::read_number(text, value)) return false;
    if constexpr (std::is_floating_point_v<T>) return std::isfinite(value);
    return true;
  }
}

}  // namespace

bool CsvFile::read(const std::string& path, ActionProblem& problem) {
  path_ = path;
  // A pipe without a writer, or a device, would be read for ever.
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
    problem = {"error: cannot read `" + path + "`: it is not a file", kBadFile};
    return false;
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream content;
  if (stream && stream.peek() != std::ifstream::traits_type::eof()) content << stream.rdbuf();
  if (!stream.eof() && !stream) {
    problem = {"error: cannot read `" + path + "`: " + std::strerror(errno != 0 ? errno : EIO),
               kBadFile};
    return false;
  }
  text_ = content.str();
  std::string_view rest = text_;
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // of spreadsheets
  if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    add_row(rest.substr(0, end), ++lines_);
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  return true;
}

void CsvFile::add_row(std::string_view line, std::size_t number) {
  std::size_t column = 1;
  const std::string_view content = trimmed(line, column);
  if (content.empty() || content.front() == '#') return;
  std::vector<Cell>& row = rows_.emplace_back();
  std::size_t begin = 0;
  while (true) {
    const std::size_t comma = line.find(',', begin);
    const std::size_t length = comma == std::string_view::npos ? comma : comma - begin;
    column = begin + 1;
    const std::string_view text = trimmed(line.substr(begin, length), column);
    row.push_back({text, number, column});
    if (comma == std::string_view::npos) return;
    begin = comma + 1;
  }
}

ActionTable::ActionTable(const std::vector<Field>& actions, const void* zero, std::size_t bytes)
    : actions_(actions),
      zero_(static_cast<const std::byte*>(zero), static_cast<const std::byte*>(zero) + bytes),
      bytes_(bytes) {
  for (const Field& action : actions) {
    for (std::size_t i = 0; i < action.type.size; ++i) {
      columns_.emplace_back(action.name);
      if (!action.type.is_scalar()) columns_.back() += "[" + std::to_string(i) + "]";
    }
  }
}

const Cell* ActionTable::add(const std::vector<Cell>& row) {
  const Cell* cell = row.data();
  const Cell* bad = nullptr;
  rows_.insert(rows_.end(), zero_.begin(), zero_.end());
  std::byte* const action = rows_.data() + count_ * bytes_;
  for (const Field& field : actions_) {
    with_elements(field.type.scalar, static_cast<void*>(action + field.offset),
                  [&](auto* elements) {
                    for (std::size_t i = 0; i < field.type.size; ++i, ++cell) {
                      if (!parse_cell(cell->text, elements[i]) && bad == nullptr) bad = cell;
                    }
                  });
  }
  ++count_;
  return bad;
}

ActionProblem ActionTable::load(const std::string& path, std::uint64_t steps) {
  CsvFile file;
  ActionProblem problem;
  if (!file.read(path, problem)) return problem;
  rows_.clear();
  count_ = 0;
  for (const std::vector<Cell>& row : file.rows()) {
    if (row.size() != columns_.size()) {
      const Cell& place = row[std::min(columns_.size(), row.size() - 1)];
      return file.at(place.line, place.column,
                     "this row has " + host::counted(row.size(), "number") + ", an action has " +
                         std::to_string(columns_.size()));
    }
    const bool first = &row == &file.rows().front();
    if (first && is_header(row, columns_)) continue;
    if (const Cell* bad = add(row)) {
      std::string text = "`" + std::string(bad->text) + "` is not a number that `" +
                         columns_[static_cast<std::size_t>(bad - row.data())] + "` can hold";
      if (first && are_words(row)) text += "\nhelp: names of columns are " + names_of(columns_);
      return file.at(bad->line, bad->column, text);
    }
  }
  if (count_ < steps) {
    return file.at(file.lines() + 1, 1,
                   "the file ends after " + host::counted(count_, "action") +
                       ", but an episode has " + host::counted(steps, "step"));
  }
  return {};
}

ActionProblem CsvFile::at(std::size_t line, std::size_t column, const std::string& text) const {
  return {path_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": error: " + text,
          kBadActions};
}

}  // namespace eagerx::linux_sim
