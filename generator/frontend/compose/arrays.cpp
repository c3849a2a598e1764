#include "generator/frontend/compose/arrays.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/number.hpp"
#include "generator/support/diagnostics/join.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kCount = "count";
constexpr const char* kEach = "each";

const Format& count_format() {
  static const FormatPtr kFormat = format::integer("a number of elements", 1, kLongestArray);
  return *kFormat;
}

/// Replaces every `{each: […]}` by the value of this element; false after a problem.
bool choose_each(YamlValue& yaml, std::size_t index, std::int64_t count, Diagnostics& diagnostics) {
  const YamlValue* each = yaml.is_map() && yaml.entries.size() == 1 ? yaml.find(kEach) : nullptr;
  if (each != nullptr) {
    if (!each->is_sequence() || each->items.size() != static_cast<std::size_t>(count)) {
      diagnostics
          .error("E0391", each->span,
                 each->is_sequence()
                     ? counted(each->items.size(), "value") + " for " +
                           counted(static_cast<std::uint64_t>(count), "element")
                     : fmt::format("`each` needs a list, found {}", describe(*each)))
          .help = "`each` has one value for each element, in their order";
      return false;
    }
    YamlValue chosen = each->items[index];
    yaml = std::move(chosen);
    return true;
  }
  bool good = true;
  for (auto& item : yaml.items) good = choose_each(item, index, count, diagnostics) && good;
  for (auto& entry : yaml.entries)
    good = choose_each(entry.value, index, count, diagnostics) && good;
  return good;
}

}  // namespace

std::optional<std::int64_t> count_of(const YamlValue& entity, const References& references,
                                     Diagnostics& diagnostics) {
  const YamlValue* written = entity.find(kCount);
  if (written == nullptr) return std::nullopt;
  const YamlValue count = substitute(*written, references, diagnostics);
  if (is_unresolved(count) || !check(count, count_format(), diagnostics)) return 0;
  return whole_of(count).value_or(0);
}

YamlValue element_of(YamlValue entity, std::int64_t index, std::int64_t count,
                     References references, Diagnostics& diagnostics) {
  std::erase_if(entity.entries, [](const auto& entry) { return entry.key == kCount; });
  // Overrides once, for the first element: the others have the same list.
  Diagnostics unheard;
  choose_each(entity, static_cast<std::size_t>(index), count, index == 0 ? diagnostics : unheard);
  references[{"index"}] = made_number(index, entity.span);
  return substitute(std::move(entity), references, index == 0 ? diagnostics : unheard);
}

std::string element_name(const std::string& array, std::int64_t index) {
  return fmt::format("{}[{}]", array, index);
}

}  // namespace eagerx::gen
