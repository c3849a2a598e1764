#include <algorithm>
#include <utility>

#include "generator/support/diagnostics/diagnostics.hpp"

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
  files_.push_back({std::move(name), std::move(text), std::move(line_starts), FileId::none, {}});
  return static_cast<FileId>(files_.size() - 1);
}

FileId SourceMap::add_use(FileId file, Use use) {
  const FileId same = index_of(file) < files_.size() ? files_[index_of(file)].same : FileId::none;
  files_.push_back({{}, {}, {}, same == FileId::none ? file : same, std::move(use)});
  return static_cast<FileId>(files_.size() - 1);
}

const SourceMap::Use* SourceMap::use(FileId file) const {
  const bool used = index_of(file) < files_.size() && files_[index_of(file)].same != FileId::none;
  return used ? &files_[index_of(file)].use : nullptr;
}

Span SourceMap::place_in(FileId file, Span span) const {
  for (const Use* by = use(span.file); by != nullptr && span.file != file; by = use(span.file))
    span = by->place;
  return span.file == file ? span : Span{};
}

const SourceMap::File* SourceMap::file(FileId id) const {
  if (index_of(id) >= files_.size()) return nullptr;
  const File& file = files_[index_of(id)];
  return file.same == FileId::none ? &file : &files_[index_of(file.same)];
}

const std::string& SourceMap::name(FileId file) const {
  const File* found = this->file(file);
  return found != nullptr ? found->name : kNothing;
}

const std::string& SourceMap::text(FileId file) const {
  const File* found = this->file(file);
  return found != nullptr ? found->text : kNothing;
}

std::string_view SourceMap::line(FileId file, std::uint32_t line) const {
  const File* source = this->file(file);
  if (source == nullptr || line == 0 || line > source->line_starts.size()) return {};
  const std::size_t begin = source->line_starts[line - 1];
  const std::size_t end = std::min(source->text.find('\n', begin), source->text.size());
  std::string_view result = std::string_view(source->text).substr(begin, end - begin);
  if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
  return result;
}

std::vector<Diagnostic::Note> notes_with_uses(const Diagnostic& diagnostic,
                                              const SourceMap& sources) {
  std::vector<Diagnostic::Note> notes = diagnostic.notes;
  for (const auto* use = sources.use(diagnostic.span.file); use != nullptr;
       use = sources.use(use->place.file))
    notes.push_back({use->what, use->place, ""});
  return notes;
}

}  // namespace eagerx::gen
