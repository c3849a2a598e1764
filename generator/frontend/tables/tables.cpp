#include "generator/frontend/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "generator/frontend/read/scalar.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/frontend/tables/csv.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/missing_file.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

// They become initialisers of one array in the generated code, which compilers take seconds for.
constexpr std::size_t kMostNumbers = 65'536;
constexpr std::size_t kMostBytes = 16U << 20U;

FormatPtr table_format() {
  return format::record("a table", {{"csv", format::text("a file"), true, "the file"},
                                    {"column", format::text("the name of a column"), false,
                                     "a column, by its name or its number from 1 on"}});
}

/// f(setting) for each parameter that the graph gives an entity.
template <class F>
void for_each_setting(GraphSpec& spec, F&& f) {
  const auto config = [&](std::vector<Setting>& settings) {
    for (Setting& setting : settings) f(setting);
  };
  const auto processor = [&](std::optional<ProcessorSpec>& item) {
    if (!item) return;
    for (ProcessorSpec& each : item->before) config(each.config);
    config(item->config);
  };
  const auto components = [&](std::vector<ComponentSpec>& items) {
    for (ComponentSpec& item : items) processor(item.settings.processor);
  };
  const auto entity = [&](EntitySpec& item) {
    config(item.config);
    for (StateSpec& state : item.states) processor(state.processor);
    for (Selection* selection : {&item.sensors, &item.actuators, &item.inputs, &item.outputs})
      if (*selection) components(**selection);
  };
  entity(spec.engine);
  for (EntitySpec& item : spec.objects) entity(item);
  for (EntitySpec& item : spec.nodes) entity(item);
  components(spec.actions);
  components(spec.observations);
  for (ConnectionSpec& item : spec.connections) processor(item.settings.processor);
}

class TableReader {
 public:
  TableReader(fs::path folder, SourceMap& sources, Diagnostics& diagnostics)
      : folder_(std::move(folder)), sources_(sources), diagnostics_(diagnostics) {}

  /// Also within the value, where an entity of its own is a parameter.
  void expand(YamlValue& yaml) {
    if (yaml.find("csv") != nullptr) {
      if (check(yaml, *table_format(), diagnostics_)) replace(yaml);
      return;
    }
    for (YamlValue& item : yaml.items) expand(item);
    for (YamlValue::Entry& entry : yaml.entries) expand(entry.value);
  }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> result;
    for (const auto& [path, table] : tables_) result.push_back(path);
    return result;
  }

 private:
  void replace(YamlValue& yaml) {
    const YamlValue& file = *yaml.find("csv");
    const std::string path = (folder_ / file.text).string();
    const auto [found, added] = tables_.try_emplace(path);
    if (added) found->second = load(path, file);
    if (!found->second) return;
    const CsvTable& table = *found->second;
    const YamlValue* column = yaml.find("column");
    std::optional<std::size_t> wanted;
    if (column != nullptr && !(wanted = find_column(table, *column))) return;
    const std::size_t width = table.rows.front().size();
    const std::size_t count = table.rows.size() * (wanted ? 1 : width);
    if (count > kMostNumbers) {
      diagnostics_.error("E0345", file.span,
                         fmt::format("`{}` has {} numbers for this parameter, more than {}",
                                     file.text, count, kMostNumbers));
      return;
    }
    std::vector<YamlValue> numbers;
    numbers.reserve(count);
    for (const CsvRow& row : table.rows) {
      for (std::size_t i = wanted.value_or(0); i < (wanted ? *wanted + 1 : width); ++i)
        numbers.push_back(made_scalar(row[i].text, row[i].span));
    }
    if (are_numbers(numbers)) yaml = made_list(std::move(numbers), yaml.span);
  }

  std::optional<CsvTable> load(const std::string& path, const YamlValue& mention) {
    LoadedFile file = load_file(path, kMostBytes);
    if (file.status == LoadedFile::Status::unreadable) {
      diagnostics_
          .io_error("E0345", mention.span,
                    fmt::format("cannot read `{}`: {}", mention.text, file.reason))
          .help = help_for_missing(path, mention.text);
      return std::nullopt;
    }
    if (file.status == LoadedFile::Status::too_large) {
      diagnostics_.error("E0345", mention.span,
                         fmt::format("`{}` is larger than {} bytes", mention.text, kMostBytes));
      return std::nullopt;
    }
    const FileId id = sources_.add(path, normalize_text(std::move(file.bytes)));
    if (!check_text(sources_.text(id), id, diagnostics_)) return std::nullopt;
    return read_csv(id, sources_, diagnostics_);
  }

  std::optional<std::size_t> find_column(const CsvTable& table, const YamlValue& column) {
    const auto has_name = [&](const CsvCell& cell) { return cell.text == column.text; };
    const auto named = ranges::find_if(table.header, has_name);
    if (named != table.header.end()) {
      const auto again = std::find_if(named + 1, table.header.end(), has_name);
      if (again == table.header.end())
        return static_cast<std::size_t>(named - table.header.begin());
      auto& problem = diagnostics_.error("E0347", column.span,
                                         fmt::format("two columns are called `{}`", column.text));
      problem.notes.push_back({"the first", named->span, ""});
      problem.notes.push_back({"the second", again->span, ""});
      problem.help = "write the number of the column, counted from 1";
      return std::nullopt;
    }
    const std::size_t width = table.rows.front().size();
    const auto number = parse_int(column.text);
    if (number && *number >= 1 && static_cast<std::uint64_t>(*number) <= width)
      return static_cast<std::size_t>(*number - 1);
    report_no_column(table, column, width);
    return std::nullopt;
  }

  void report_no_column(const CsvTable& table, const YamlValue& column, std::size_t width) {
    auto& problem = diagnostics_.error(
        "E0347", column.span,
        fmt::format("`{}` has no column `{}`",
                    fs::path(sources_.name(table.file)).filename().string(), column.text));
    std::vector<std::string> names;
    for (const CsvCell& cell : table.header) names.push_back(cell.text);
    constexpr std::size_t kMostListed = 12;
    const std::string near = nearest(column.text, names);
    if (!near.empty()) {
      problem.help = meaning(near);
    } else if (names.empty()) {
      problem.help = fmt::format("it has no names; write a number from 1 to {}", width);
    } else if (names.size() <= kMostListed) {
      problem.help = fmt::format("its columns are `{}`", join(names, "`, `"));
    } else {
      problem.help = fmt::format("the first line has the names of its {} columns", names.size());
    }
  }

  bool are_numbers(const std::vector<YamlValue>& numbers) {
    std::size_t problems = 0;
    for (const YamlValue& number : numbers) {
      if (is_decimal_text(number.text) && parse_number(number.text)) continue;
      diagnostics_.error("E0346", number.span,
                         number.text.empty()
                             ? std::string("the cell is empty")
                             : fmt::format("`{}` is not a number", shortened(number.text)));
      if (++problems == kMostCsvProblems) break;
    }
    return problems == 0;
  }

  fs::path folder_;
  SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::optional<CsvTable>> tables_;  // by path; nullopt: reported
};

}  // namespace

std::vector<std::string> read_tables(GraphSpec& spec, SourceMap& sources,
                                     Diagnostics& diagnostics) {
  TableReader reader(fs::path(spec.path).parent_path(), sources, diagnostics);
  for_each_setting(spec, [&](Setting& setting) { reader.expand(setting.value); });
  return reader.files();
}

}  // namespace eagerx::gen
