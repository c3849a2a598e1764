#include "generator/formats/tensors/json.hpp"

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

/// Stops at keys that are there twice, at too many values, and at too deep ones.
class Guard {
 public:
  using json = nlohmann::json;
  bool null() { return count(); }
  bool boolean(bool /*value*/) { return count(); }
  bool number_integer(json::number_integer_t /*value*/) { return count(); }
  bool number_unsigned(json::number_unsigned_t /*value*/) { return count(); }
  bool number_float(json::number_float_t /*value*/, const json::string_t& /*text*/) {
    return count();
  }
  bool string(json::string_t& /*value*/) { return count(); }
  bool binary(json::binary_t& /*value*/) { return false; }
  bool start_object(std::size_t /*size*/) {
    keys_.emplace_back();
    return count() && keys_.size() <= kDeepest;
  }
  bool key(json::string_t& name) { return keys_.back().insert(std::move(name)).second; }
  bool end_object() {
    keys_.pop_back();
    return true;
  }
  bool start_array(std::size_t size) { return start_object(size); }
  bool end_array() { return end_object(); }
  static bool parse_error(std::size_t /*place*/, const std::string& /*token*/,
                          const json::exception& /*error*/) {
    return false;
  }

 private:
  static constexpr std::size_t kMostValues = 1'000'000;
  static constexpr std::size_t kDeepest = 64;
  bool count() { return ++values_ <= kMostValues; }

  std::size_t values_ = 0;
  std::vector<std::set<std::string>> keys_;  // of the objects (and arrays) that are open
};

}  // namespace

std::optional<nlohmann::json> parse_json(std::string_view text) {
  const std::string plain = without_python(text);
  // First without making anything: two bytes of text become a value of sixteen.
  Guard guard;
  if (!nlohmann::json::sax_parse(plain, &guard)) return std::nullopt;
  nlohmann::json value = nlohmann::json::parse(plain, nullptr, false);
  if (value.is_discarded()) return std::nullopt;
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
