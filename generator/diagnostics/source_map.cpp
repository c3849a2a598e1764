#include <algorithm>
#include <utility>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {
namespace {

std::size_t index_of(FileId file) {
  return static_cast<std::size_t>(file);
}

const std::string kNothing;

}  // namespace

FileId SourceMap::add(std::string name, std::string text) {
  std::vector<std::size_t> line_starts = {0};
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    line_starts.push_back(at + 1);
  }
  files_.push_back({std::move(name), std::move(text), std::move(line_starts)});
  return static_cast<FileId>(files_.size() - 1);
}

const std::string& SourceMap::name(FileId file) const {
  return index_of(file) < files_.size() ? files_[index_of(file)].name : kNothing;
}

const std::string& SourceMap::text(FileId file) const {
  return index_of(file) < files_.size() ? files_[index_of(file)].text : kNothing;
}

std::string_view SourceMap::line(FileId file, std::uint32_t line) const {
  if (index_of(file) >= files_.size()) return {};
  const File& source = files_[index_of(file)];
  if (line == 0 || line > source.line_starts.size()) return {};
  const std::size_t begin = source.line_starts[line - 1];
  const std::size_t end = std::min(source.text.find('\n', begin), source.text.size());
  std::string_view result = std::string_view(source.text).substr(begin, end - begin);
  if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
  return result;
}

}  // namespace eagerx::gen
