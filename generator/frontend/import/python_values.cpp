// Values that PyYAML writes and YAML does not have: tuples, and the scalars and arrays of
// numpy.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "generator/frontend/import/saved.hpp"
#include "generator/frontend/read/scalar.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/json/base64.hpp"

namespace eagerx::gen {
namespace {

constexpr std::string_view kYaml = "tag:yaml.org,2002:";

bool is_plain(std::string_view tag) {
  static constexpr std::array<std::string_view, 20> kPlain = {
      "str",         "int",          "float",       "bool",           "null",
      "seq",         "map",          "set",         "omap",           "python/tuple",
      "python/list", "python/dict",  "python/str",  "python/unicode", "python/int",
      "python/long", "python/float", "python/bool", "python/none",    "timestamp"};
  if (tag.empty() || tag == "!" || tag == "?") return true;
  if (!tag.starts_with(kYaml)) return false;
  return ranges::find(kPlain, tag.substr(kYaml.size())) != kPlain.end();
}

bool has_python_tag(const YamlValue& yaml, std::string_view ending) {
  return yaml.tag.starts_with(kYaml) && yaml.tag.ends_with(ending);
}

/// "f8", "i4", "b1", … of a numpy.dtype; empty if it is none that is written in digits. Big-endian
/// ones say so in their state.
std::string dtype_of(const YamlValue& yaml) {
  if (!has_python_tag(yaml, "apply:numpy.dtype")) return {};
  const YamlValue* arguments = yaml.find("args");
  const YamlValue* state = yaml.find("state");
  if (arguments == nullptr || arguments->items.empty() || state == nullptr ||
      state->items.size() < 2 || state->items[1].text == ">")
    return {};
  return arguments->items[0].text;
}

template <class T>
std::string as_text(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  if constexpr (std::is_floating_point_v<T>) {
    std::string text = fmt::format("{}", value);
    if (text == "inf" || text == "-inf") return text.front() == '-' ? "-.inf" : ".inf";
    return text.find("nan") != std::string::npos ? ".nan" : text;
  } else {
    return fmt::format("{}", +value);
  }
}

using Decode = std::string (*)(const char*);

/// How one element is read, and how long it is.
std::pair<Decode, std::size_t> decoder(std::string_view dtype) {
  if (std::endian::native != std::endian::little) return {nullptr, 0};
  if (dtype == "f8") return {as_text<double>, 8};
  if (dtype == "f4") return {as_text<float>, 4};
  if (dtype == "i8") return {as_text<std::int64_t>, 8};
  if (dtype == "i4") return {as_text<std::int32_t>, 4};
  if (dtype == "i2") return {as_text<std::int16_t>, 2};
  if (dtype == "i1") return {as_text<std::int8_t>, 1};
  if (dtype == "u8") return {as_text<std::uint64_t>, 8};
  if (dtype == "u4") return {as_text<std::uint32_t>, 4};
  if (dtype == "u2") return {as_text<std::uint16_t>, 2};
  if (dtype == "u1") return {as_text<std::uint8_t>, 1};
  if (dtype == "b1")
    return {[](const char* byte) { return std::string(*byte != 0 ? "true" : "false"); }, 1};
  return {nullptr, 0};
}

/// numpy.float64(0.5): the dtype and the bytes.
std::optional<YamlValue> numpy_scalar(const YamlValue& yaml) {
  if (!has_python_tag(yaml, "multiarray.scalar") || yaml.items.size() != 2) return std::nullopt;
  const auto [decode, size] = decoder(dtype_of(yaml.items[0]));
  const auto bytes = from_base64(yaml.items[1].text);
  if (decode == nullptr || !bytes || bytes->size() != size) return std::nullopt;
  return made_scalar(decode(bytes->data()), yaml.span);
}

/// numpy.array([1.0, 2.0]), one axis only: state (version, shape, dtype, order, bytes).
std::optional<YamlValue> numpy_array(const YamlValue& yaml) {
  if (!has_python_tag(yaml, "multiarray._reconstruct")) return std::nullopt;
  const YamlValue* state = yaml.find("state");
  if (state == nullptr || state->items.size() != 5 || state->items[1].items.size() != 1)
    return std::nullopt;
  const auto [decode, size] = decoder(dtype_of(state->items[2]));
  const auto bytes = from_base64(state->items[4].text);
  const auto length = parse_int(state->items[1].items[0].text);
  if (decode == nullptr || !bytes || !length || *length < 0 ||
      bytes->size() / size != static_cast<std::size_t>(*length) || bytes->size() % size != 0)
    return std::nullopt;
  std::vector<YamlValue> items;
  for (std::size_t i = 0; i < bytes->size(); i += size)
    items.push_back(made_scalar(decode(bytes->data() + i), yaml.span));
  return made_list(std::move(items), yaml.span);
}

/// "!!python/name:package.function"
std::string shown_tag(std::string_view tag) {
  return tag.starts_with(kYaml) ? fmt::format("!!{}", tag.substr(kYaml.size())) : std::string(tag);
}

}  // namespace

bool is_python_object(const YamlValue& yaml) {
  return yaml.origin == Origin::python;
}

YamlValue plain_values(const YamlValue& yaml) {
  if (!is_plain(yaml.tag)) {
    if (auto number = numpy_scalar(yaml)) return std::move(*number);
    if (auto list = numpy_array(yaml)) return std::move(*list);
    YamlValue opaque = made_scalar(shown_tag(yaml.tag), yaml.span);
    opaque.origin = Origin::python;
    opaque.quoted = true;
    return opaque;
  }
  YamlValue result;
  result.kind = yaml.kind;
  result.span = yaml.span;
  result.text = yaml.text;
  result.quoted = yaml.quoted || has_python_tag(yaml, ":str") || has_python_tag(yaml, "/str");
  if (has_python_tag(yaml, "python/none")) result.kind = YamlKind::null;
  for (const auto& item : yaml.items) result.items.push_back(plain_values(item));
  for (const auto& entry : yaml.entries)
    result.entries.push_back({entry.key, entry.key_span, plain_values(entry.value)});
  return result;
}

}  // namespace eagerx::gen
