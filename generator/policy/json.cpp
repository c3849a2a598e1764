#include "generator/policy/json.hpp"

#include <charconv>
#include <set>

namespace eagerx::gen {
namespace {

/// Python writes NaN, Infinity and -Infinity, which JSON does not have.
std::string without_python(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\' && i + 1 < text.size()) {
      result += c;
      result += text[++i];
      continue;
    }
    if (c == '"') quoted = !quoted;
    bool replaced = false;
    for (const std::string_view word : {"NaN", "-Infinity", "Infinity"}) {
      if (quoted || replaced || text.substr(i, word.size()) != word) continue;
      result += "null";
      i += word.size() - 1;
      replaced = true;
    }
    if (!replaced) result += c;
  }
  return result;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> values;
  std::size_t at = 0;
  constexpr std::string_view kBetween = "[]() ,\n\t";
  while ((at = text.find_first_not_of(kBetween, at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kBetween, at), text.size());
    double value = 0.0;
    const auto result = std::from_chars(text.data() + at, text.data() + end, value);
    if (result.ec != std::errc{}) return std::nullopt;
    // NumPy writes "2." for 2.0, of which from_chars takes all.
    if (result.ptr != text.data() + end) return std::nullopt;
    values.push_back(value);
    at = end;
  }
  return values;
}

}  // namespace

std::optional<nlohmann::json> parse_json(std::string_view text) {
  std::vector<std::set<std::string>> keys;
  bool twice = false;
  const auto watch = [&](int, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    if (event == nlohmann::json::parse_event_t::object_start) keys.emplace_back();
    if (event == nlohmann::json::parse_event_t::object_end && !keys.empty()) keys.pop_back();
    if (event == nlohmann::json::parse_event_t::key && !keys.empty()) {
      twice = twice || !keys.back().insert(parsed.get<std::string>()).second;
    }
    return true;
  };
  nlohmann::json value = nlohmann::json::parse(without_python(text), watch, false);
  if (value.is_discarded() || twice) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> numbers_of(const nlohmann::json& value) {
  if (value.is_number()) return std::vector<double>{value.get<double>()};
  if (value.is_string()) return numbers_in(value.get_ref<const std::string&>());
  if (!value.is_array()) return std::nullopt;
  std::vector<double> values;
  for (const nlohmann::json& item : value) {
    if (!item.is_number()) return std::nullopt;
    values.push_back(item.get<double>());
  }
  return values;
}

const nlohmann::json* member(const nlohmann::json& value, const char* key) {
  if (!value.is_object()) return nullptr;
  const auto found = value.find(key);
  return found == value.end() ? nullptr : &*found;
}

std::string text_of(const nlohmann::json* value) {
  return value != nullptr && value->is_string() ? value->get<std::string>() : std::string();
}

}  // namespace eagerx::gen
