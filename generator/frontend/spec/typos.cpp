#include "generator/frontend/spec/typos.hpp"

#include <fmt/format.h>

#include "generator/frontend/read/typos.hpp"
#include "generator/frontend/spec/named.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

bool is_map_of_records(const Format& format) {
  return format.kind == Format::Kind::map && format.item &&
         format.item->kind == Format::Kind::record;
}

}  // namespace

bool report_decimal_comma(const std::vector<YamlValue::Entry>& entries, std::size_t i,
                          Diagnostics& diagnostics) {
  if (i == 0 || !entries[i].value.is_null()) return false;
  const YamlValue::Entry& before = entries[i - 1];
  const Span& first = before.value.span;
  const Span& second = entries[i].key_span;
  if (!before.value.is_scalar() || before.value.quoted || first.line != second.line) return false;
  const std::string text = before.value.text + "," + entries[i].key;
  const auto meant = with_decimal_point(text);
  if (!meant || second.column <= first.column) return false;
  Span span = first;
  span.length = second.column + second.length - first.column;
  diagnostics.error("E0203", span, fmt::format("expected a number, found `{}`", text)).help = {
      fmt::format("write `{}: {}`: a number has a decimal point, and a comma ends it", before.key,
                  *meant),
      change_to(*meant)};
  return true;
}

std::string outdented_from(const YamlValue& record, std::size_t i, const Format& format) {
  const YamlValue& value = record.entries[i].value;
  if (!value.is_map() || value.entries.empty()) return {};
  for (std::size_t before = i; before-- > 0;) {
    const YamlValue::Entry& entry = record.entries[before];
    const Field* field = find_named(format.fields, entry.key);
    if (field == nullptr || !is_map_of_records(*field->format)) continue;
    if (!entry.value.is_null() && !entry.value.is_map()) continue;
    const bool fits = ranges::all_of(value.entries, [&](const YamlValue::Entry& inner) {
      return find_named(field->format->item->fields, inner.key) != nullptr;
    });
    if (fits) return entry.key;
  }
  return {};
}

std::size_t report_not_indented(const YamlValue& map, std::size_t i, const Format& format,
                                Diagnostics& diagnostics) {
  if (!is_map_of_records(format) || i == 0 || !map.entries[i - 1].value.is_null()) return 0;
  const auto& fields = format.item->fields;
  // A record without required keys may be empty, and a key of it may be a name.
  if (ranges::none_of(fields, &Field::required)) return 0;
  std::size_t count = 0;
  while (i + count < map.entries.size() &&
         find_named(fields, map.entries[i + count].key) != nullptr &&
         (count > 0 || !map.entries[i + count].value.is_map()))
    ++count;
  if (count == 0) return 0;
  const YamlValue::Entry& first = map.entries[i];
  const std::string& owner = map.entries[i - 1].key;
  auto& problem = diagnostics.error(
      "E0203", first.key_span, fmt::format("`{}` is not indented below `{}`", first.key, owner));
  problem.notes.push_back({"which has nothing else", map.entries[i - 1].key_span, ""});
  problem.help =
      fmt::format("begin the lines that belong to `{}` with more spaces than its own", owner);
  return count;
}

}  // namespace eagerx::gen
