#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <exception>
#include <sstream>
#include <string_view>
#include <utility>

#include "generator/frontend/read/locator.hpp"
#include "generator/frontend/read/memory.hpp"
#include "generator/frontend/read/text.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/frontend/read/tree_builder.hpp"
#include "generator/frontend/read/wide_space.hpp"
#include "generator/frontend/read/yaml_error.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/missing_file.hpp"

namespace eagerx::gen {
namespace {

void report_too_large(FileId file, std::size_t max_bytes, Diagnostics& diagnostics) {
  diagnostics.error("E0102", {file, 0, 0, 0},
                    fmt::format("the file is larger than {} bytes", max_bytes));
}

void report_too_deep(const Span& span, std::size_t max_depth, Diagnostics& diagnostics) {
  diagnostics.error("E0110", span, fmt::format("nested deeper than {} levels", max_depth));
}

/// yaml-cpp keeps all tokens of a bracket in memory until it closes, before it tells of the first.
/// So what is hopeless is refused beforehand, by counting; quoted brackets hardly reach such
/// numbers.
bool check_brackets(const Locator& locator, const ReadLimits& limits, Diagnostics& diagnostics) {
  constexpr std::size_t kMaxOpen = 10'000;
  std::size_t open = 0;
  std::size_t values = 0;
  std::size_t too_deep = 0;  // where the limit of the depth was passed
  const std::string_view text = locator.text();
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool opens = c == '[' || c == '{';
    if (opens && ++open == limits.max_depth + 1) too_deep = at;
    if ((c == ']' || c == '}') && open > 0) --open;
    if (opens || c == ',') ++values;
    if (open > kMaxOpen) {
      report_too_deep(locator.span({too_deep, too_deep + 1}), limits.max_depth, diagnostics);
      return false;
    }
    if (values > limits.max_values) {
      diagnostics.error("E0110", locator.span({at, at + 1}),
                        fmt::format("the file has more than {} values", limits.max_values));
      return false;
    }
  }
  return true;
}

/// yaml-cpp 0.7 loses its way at `- !!binary |`, which PyYAML writes for numpy's values. Without
/// the bar, the same lines are a plain text, and everything keeps its place.
std::string without_bars(std::string_view text) {
  std::string result(text);
  constexpr std::string_view kBinary = "!!binary |\n";
  for (std::size_t at = result.find(kBinary); at != std::string::npos;
       at = result.find(kBinary, at + kBinary.size()))
    result[at + kBinary.size() - 2] = ' ';
  return result;
}

/// Runs yaml-cpp: the only place where it can throw.
void parse(const Locator& locator, TreeBuilder& builder, Tags tags, Diagnostics& diagnostics) {
  std::istringstream stream{tags == Tags::accept ? without_bars(locator.text())
                                                 : std::string(locator.text())};
  try {
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(builder)) parser.HandleNextDocument(builder);
  } catch (const StopReading&) {
    // The builder has said why.
  } catch (const YAML::DeepRecursion& error) {
    // Its mark is where the scanner was, far ahead.
    const OpenCollection* open = builder.innermost();
    report_too_deep(open != nullptr ? open->span : locator.whole(),
                    static_cast<std::size_t>(error.depth() - 1), diagnostics);
  } catch (const YAML::Exception& error) {
    const std::size_t offset =
        error.mark.pos < 0 ? std::string_view::npos : static_cast<std::size_t>(error.mark.pos);
    report_yaml_error(error.msg, offset, locator, builder, diagnostics);
  } catch (const std::exception& error) {
    diagnostics.error("E0105", locator.whole(), fmt::format("not YAML: {}", error.what()));
  }
}

YamlValue read_whole(FileId file, std::string_view text, Diagnostics& diagnostics, Tags tags,
                     const ReadLimits& limits) {
  const std::size_t errors_before = diagnostics.error_count();
  const Locator locator(file, text);
  if (!check_brackets(locator, limits, diagnostics)) return {};
  if (tags == Tags::refuse && !check_wide_spaces(locator, diagnostics)) return {};
  TreeBuilder builder(locator, tags, limits, diagnostics);
  parse(locator, builder, tags, diagnostics);
  if (diagnostics.error_count() > errors_before) return {};
  YamlValue root = builder.take_root();
  if (root.is_null()) {
    diagnostics.error("E0106", {file, 0, 0, 0}, "the file is empty").help =
        "comments alone do not count";
  }
  return root;
}

YamlValue read_text(FileId file, std::string_view text, Diagnostics& diagnostics, Tags tags,
                    const ReadLimits& limits) {
  ReadMemory* const memory = tags == Tags::refuse ? ReadMemory::current() : nullptr;
  if (memory != nullptr) {
    const auto parse = [&](std::string_view part, const ReadLimits& of_part) {
      Diagnostics found;
      YamlValue root = read_whole(file, part, found, tags, of_part);
      return found.all().empty() ? std::optional(std::move(root)) : std::nullopt;
    };
    if (auto root = memory->read(file, text, limits, parse)) return std::move(*root);
  }
  return read_whole(file, text, diagnostics, tags, limits);
}

}  // namespace

const YamlValue* YamlValue::find(std::string_view key) const {
  const auto entry = ranges::find(entries, key, &Entry::key);
  return entry == entries.end() ? nullptr : &entry->value;
}

YamlValue made_scalar(std::string text, Span span) {
  YamlValue yaml;
  yaml.kind = YamlKind::scalar;
  yaml.text = std::move(text);
  yaml.span = span;
  return yaml;
}

YamlValue made_list(std::vector<YamlValue> items, Span span) {
  YamlValue yaml;
  yaml.kind = YamlKind::sequence;
  yaml.items = std::move(items);
  yaml.span = span;
  return yaml;
}

std::optional<FileId> load_yaml_file(const std::string& path, SourceMap& sources,
                                     Diagnostics& diagnostics, const ReadLimits& limits,
                                     Span mention, const std::string& written) {
  LoadedFile file = load_file(path, limits.max_bytes);
  switch (file.status) {
    case LoadedFile::Status::loaded:
      return sources.add(path, normalize_text(std::move(file.bytes)));
    case LoadedFile::Status::too_large:
      report_too_large(sources.add(path, {}), limits.max_bytes, diagnostics);
      return std::nullopt;
    case LoadedFile::Status::unreadable:
      if (mention.file == FileId::none) mention = {sources.add(path, {}), 0, 0, 0};
      diagnostics.io_error("E0101", mention, fmt::format("cannot read `{}`: {}", path, file.reason))
          .help = help_for_missing(path, written.empty() ? path : written);
      return std::nullopt;
  }
  return std::nullopt;
}

YamlValue read_loaded_yaml(FileId file, const SourceMap& sources, Diagnostics& diagnostics,
                           Tags tags, const ReadLimits& limits) {
  if (!check_text(sources.text(file), file, diagnostics)) return {};
  return read_text(file, sources.text(file), diagnostics, tags, limits);
}

YamlValue read_yaml_text(const std::string& name, std::string text, SourceMap& sources,
                         Diagnostics& diagnostics, Tags tags, const ReadLimits& limits) {
  if (text.size() > limits.max_bytes) {
    report_too_large(sources.add(name, {}), limits.max_bytes, diagnostics);
    return {};
  }
  const FileId file = sources.add(name, normalize_text(std::move(text)));
  return read_loaded_yaml(file, sources, diagnostics, tags, limits);
}

YamlValue read_yaml_file(const std::string& path, SourceMap& sources, Diagnostics& diagnostics,
                         Tags tags, const ReadLimits& limits) {
  const auto file = load_yaml_file(path, sources, diagnostics, limits);
  return file ? read_loaded_yaml(*file, sources, diagnostics, tags, limits) : YamlValue();
}

}  // namespace eagerx::gen
