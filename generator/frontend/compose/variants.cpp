#include "generator/frontend/compose/variants.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "generator/frontend/compose/inner_files.hpp"
#include "generator/frontend/compose/overlay.hpp"
#include "generator/frontend/compose/port_bindings.hpp"
#include "generator/frontend/spec/format.hpp"
#include "generator/support/diagnostics/join.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExtends = "extends";
constexpr const char* kVariants = "variants";
constexpr std::size_t kMostFiles = 16;

const Format& extends_format() {
  static const FormatPtr kFormat = format::one_of(
      "a graph file, or a mapping with its `file` and `variant`",
      {format::record("what is extended",
                      {{"file", format::text("a graph file"), true, "a graph file, from this one"},
                       {"variant", format::name("a variant"), false, "a variant in that file"}}),
       format::text("a graph file")});
  return *kFormat;
}

void erase(YamlValue& map, std::string_view key) {
  std::erase_if(map.entries, [&](const auto& entry) { return entry.key == key; });
}

std::optional<YamlValue> taken(YamlValue& map, std::string_view key) {
  const auto found = ranges::find(map.entries, key, &YamlValue::Entry::key);
  if (found == map.entries.end()) return std::nullopt;
  YamlValue value = std::move(found->value);
  map.entries.erase(found);
  return value;
}

class Chooser {
 public:
  Chooser(SourceMap& sources, Diagnostics& diagnostics)
      : sources_(sources), diagnostics_(diagnostics) {}

  /// The file with what it extends; its variants are still separate.
  YamlValue with_base(YamlValue root, const std::string& path) {
    const auto extends = root.is_map() ? taken(root, kExtends) : std::nullopt;
    if (!extends) return root;
    if (!check(*extends, extends_format(), diagnostics_)) return root;
    const YamlValue& file = extends->is_scalar() ? *extends : *extends->find("file");
    const YamlValue* variant = extends->find("variant");
    const std::string base_path = (fs::path(path).parent_path() / file.text).string();
    if (!enters(path, base_path, file.span)) return root;
    const auto loaded = load_yaml_file(base_path, sources_, diagnostics_, {}, file.span, file.text);
    YamlValue base = loaded ? read_loaded_yaml(*loaded, sources_, diagnostics_) : YamlValue();
    if (base.is_null()) {
      failed_ = true;
      return root;
    }
    move_file(base, sources_.add_use(base.span.file,
                                     {file.span, fmt::format("`{}` extends it, here",
                                                             fs::path(path).filename().string())}));
    base = with_base(std::move(base), base_path);
    if (variant != nullptr) base = chosen(std::move(base), variant->text, variant->span);
    name_files_of_graph(base, fs::path(base_path).parent_path(), fs::path(path).parent_path());
    files_.pop_back();
    const Span span = root.span;
    base = laid_over(std::move(base), std::move(root), diagnostics_);
    base.span = span;
    return base;
  }

  /// The graph with the variant over it. `variant` empty: as it is.
  YamlValue chosen(YamlValue root, const std::string& variant, Span span) {
    const YamlValue* all = root.find(kVariants);
    if (variant.empty()) return root;
    const YamlValue variants = all != nullptr ? *all : YamlValue{};
    std::vector<YamlValue> layers;  // the last one first
    std::vector<std::string> names;
    for (std::string name = variant; !name.empty();) {
      const YamlValue* found = variants.find(name);
      if (found == nullptr) {
        report_unknown(name, variants, span);
        return root;
      }
      if (ranges::contains(names, name)) {
        diagnostics_.error("E0394", found->span, fmt::format("variant `{}` extends itself", name));
        return root;
      }
      names.push_back(name);
      YamlValue layer = *found;
      name.clear();
      if (const auto extends = taken(layer, kExtends)) {
        name = extends->text;
        span = extends->span;
      }
      layers.push_back(std::move(layer));
    }
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer) {
      if (layer->is_null()) continue;  // a name for the graph as it is
      if (!layer->is_map()) {
        diagnostics_.error(
            "E0203", layer->span,
            fmt::format("expected a mapping for a variant, found {}", describe(*layer)));
        return root;
      }
      const Span place = root.span;
      root = laid_over(std::move(root), std::move(*layer), diagnostics_);
      root.span = place;
    }
    return root;
  }

  [[nodiscard]] bool failed() const { return failed_; }

 private:
  bool enters(const std::string& path, const std::string& base, Span span) {
    std::error_code error;
    if (files_.empty()) files_.push_back(fs::weakly_canonical(path, error));
    const fs::path next = fs::weakly_canonical(base, error);
    const bool circle = ranges::contains(files_, next);
    if (!circle && files_.size() < kMostFiles) {
      files_.push_back(next);
      return true;
    }
    diagnostics_.error(
        "E0394", span,
        circle ? fmt::format("`{}` extends itself", next.filename().string())
               : fmt::format("graphs that extend graphs, more than {} deep", kMostFiles));
    failed_ = true;
    return false;
  }

  void report_unknown(const std::string& name, const YamlValue& variants, Span span) {
    std::vector<std::string> known;
    for (const auto& entry : variants.entries) known.push_back(entry.key);
    auto& problem =
        diagnostics_.error("E0394", span, fmt::format("the graph has no variant `{}`", name));
    problem.help = did_you_mean(
        name, known,
        known.empty() ? "it has no `variants:`" : fmt::format("it has {}", join(known, ", ")));
    failed_ = true;
  }

  SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::vector<fs::path> files_;  // that extend each other
  bool failed_ = false;
};

/// A graph that stands on no other one has nothing to remove.
void refuse_idle_remove(const YamlValue& root, Diagnostics& diagnostics) {
  const YamlValue* remove = root.find("remove");
  if (remove == nullptr || root.find(kExtends) != nullptr) return;
  diagnostics.error("E0208", remove->span, "`remove` does nothing without `extends:`").help =
      "leave out what it names, or write it in one of the `variants:`";
}

}  // namespace

YamlValue choose_variant(YamlValue root, const std::string& path, const std::string& variant,
                         SourceMap& sources, Diagnostics& diagnostics) {
  Chooser chooser(sources, diagnostics);
  const bool plain = root.find(kExtends) == nullptr && root.find(kVariants) == nullptr;
  if (!root.is_map()) return root;
  refuse_idle_remove(root, diagnostics);
  if (plain && variant.empty()) return root;
  root = chooser.with_base(std::move(root), path);
  if (!chooser.failed()) root = chooser.chosen(std::move(root), variant, {});
  if (!diagnostics.has_errors()) check_removed(root, diagnostics);
  for (const char* key : {kExtends, kVariants, kRemovedEntities}) erase(root, key);
  return root;
}

std::vector<std::string> variants_of(const YamlValue& root, const std::string& path,
                                     SourceMap& sources, Diagnostics& diagnostics) {
  const YamlValue whole = Chooser(sources, diagnostics).with_base(root, path);
  std::vector<std::string> names;
  const YamlValue* variants = whole.find(kVariants);
  if (variants != nullptr)
    for (const auto& entry : variants->entries) names.push_back(entry.key);
  return names;
}

}  // namespace eagerx::gen
