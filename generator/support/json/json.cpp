#include "generator/support/json/json.hpp"

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

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

/// Builds the value while it is read, so that nothing is made of what is too much. Stops at keys
/// that are there twice, at too many values, and at too deep ones.
class JsonBuilder {
 public:
  using json = nlohmann::json;
  bool null() { return add(Json{}); }
  bool boolean(bool value) { return add(Json(value)); }
  bool number_integer(json::number_integer_t value) { return add(Json(value)); }
  bool number_unsigned(json::number_unsigned_t value) {
    if (value > std::uint64_t{INT64_MAX}) return add(Json(static_cast<double>(value)));
    return add(Json(static_cast<std::int64_t>(value)));
  }
  bool number_float(json::number_float_t value, const json::string_t& /*text*/) {
    return add(Json(value));
  }
  bool string(json::string_t& value) { return add(Json(std::move(value))); }
  bool binary(json::binary_t& /*value*/) { return false; }
  bool start_object(std::size_t /*size*/) { return open(Json::object()); }
  bool key(json::string_t& name) {
    open_.back().key = std::move(name);
    return true;
  }
  bool end_object() {
    std::vector<std::string_view> names;
    for (const JsonMember& member : std::get<Json::Object>(open_.back().value.value))
      names.push_back(member.name);
    std::ranges::sort(names);
    return std::ranges::adjacent_find(names) == names.end() && close();
  }
  bool start_array(std::size_t /*size*/) { return open(Json::list()); }
  bool end_array() { return close(); }
  static bool parse_error(std::size_t /*place*/, const std::string& /*token*/,
                          const json::exception& /*error*/) {
    return false;
  }

  Json take() { return std::move(root_); }

 private:
  static constexpr std::size_t kMostValues = 1'000'000;
  static constexpr std::size_t kDeepest = 64;

  struct Open {
    Json value;       // a list or an object
    std::string key;  // of the member that comes next
  };

  bool count() { return ++values_ <= kMostValues; }
  bool open(Json value) {
    open_.push_back({std::move(value), {}});
    return count() && open_.size() <= kDeepest;
  }
  bool close() {
    Json value = std::move(open_.back().value);
    open_.pop_back();
    put(std::move(value));
    return true;
  }
  bool add(Json value) {
    if (!count()) return false;
    put(std::move(value));
    return true;
  }
  void put(Json value) {
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (auto* list = std::get_if<Json::List>(&open_.back().value.value)) {
      list->push_back(std::move(value));
    } else {
      std::get<Json::Object>(open_.back().value.value)
          .push_back({std::move(open_.back().key), std::move(value)});
    }
  }

  std::size_t values_ = 0;
  Json root_;
  std::vector<Open> open_;  // from the outermost
};

nlohmann::ordered_json to_write(const Json& json) {
  const auto write = [](const auto& value) -> nlohmann::ordered_json {
    using Kind = std::decay_t<decltype(value)>;
    if constexpr (std::is_same_v<Kind, std::monostate>) {
      return nullptr;
    } else if constexpr (std::is_same_v<Kind, Json::List>) {
      auto list = nlohmann::ordered_json::array();
      for (const Json& item : value) list.push_back(to_write(item));
      return list;
    } else if constexpr (std::is_same_v<Kind, Json::Object>) {
      auto object = nlohmann::ordered_json::object();
      for (const JsonMember& member : value) object[member.name] = to_write(member.value);
      return object;
    } else {
      return value;
    }
  };
  return std::visit(write, json.value);
}

}  // namespace

Json::Json() = default;
Json::Json(std::nullptr_t /*null*/) {}
Json::Json(bool truth) : value(truth) {}
Json::Json(double number) : value(number) {}
Json::Json(const char* text) : value(std::string(text)) {}
Json::Json(std::string text) : value(std::move(text)) {}
Json::Json(List items) : value(std::move(items)) {}
Json::Json(Object members) : value(std::move(members)) {}
Json::Json(std::initializer_list<JsonMember> members) : value(Object(members)) {}
Json::Json(const std::vector<std::string>& texts) : value(List(texts.begin(), texts.end())) {}

Json Json::object() {
  return Object{};
}

Json Json::list() {
  return List{};
}

Json& Json::operator[](std::string_view name) {
  if (is<std::monostate>()) value = Object{};
  auto& members = std::get<Object>(value);
  const auto found = std::ranges::find(members, name, &JsonMember::name);
  if (found != members.end()) return found->value;
  return members.emplace_back(JsonMember{std::string(name), {}}).value;
}

void Json::push_back(Json item) {
  if (is<std::monostate>()) value = List{};
  std::get<List>(value).push_back(std::move(item));
}

namespace {

/// JSON allows DEL, U+0080 to U+009F and the marks that turn the direction of writing; a terminal
/// that shows it should not get them.
std::string without_controls(std::string text) {
  std::string result;
  const auto byte = [&](std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
  };
  constexpr const char* kDigits = "0123456789abcdef";
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned code = 0;  // below U+10000, of up to three bytes
    std::size_t size = 1;
    if (byte(at) == 0x7fU) {
      code = 0x7fU;
    } else if (byte(at) == 0xc2U && byte(at + 1) < 0xa0U) {
      code = byte(at + 1);
      size = 2;
    } else if (byte(at) == 0xe2U && (byte(at + 1) == 0x80U || byte(at + 1) == 0x81U)) {
      const unsigned third = 0x2000U + ((byte(at + 1) & 1U) << 6U) + (byte(at + 2) & 0x3fU);
      const bool turns = third == 0x200eU || third == 0x200fU ||
                         (third >= 0x2028U && third <= 0x202eU) ||
                         (third >= 0x2066U && third <= 0x2069U);
      code = turns ? third : 0U;
      size = 3;
    }
    if (code == 0) {
      result += text[at];
      continue;
    }
    result += "\\u";
    for (const unsigned shift : {12U, 8U, 4U, 0U}) result += kDigits[(code >> shift) & 0xfU];
    at += size - 1;
  }
  return result;
}

}  // namespace

std::string dump_json(const Json& json) {
  constexpr int kIndent = 2;
  return without_controls(
      to_write(json).dump(kIndent, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

std::optional<Json> parse_json(std::string_view text) {
  JsonBuilder builder;
  if (!nlohmann::json::sax_parse(without_python(text), &builder)) return std::nullopt;
  return builder.take();
}

const Json* member(const Json* value, std::string_view key) {
  const auto* object = value != nullptr ? value->as<Json::Object>() : nullptr;
  if (object == nullptr) return nullptr;
  const auto found = std::ranges::find(*object, key, &JsonMember::name);
  return found == object->end() ? nullptr : &found->value;
}

std::string text_of(const Json* value) {
  const auto* text = value != nullptr ? value->as<std::string>() : nullptr;
  return text != nullptr ? *text : std::string();
}

std::optional<double> number_of(const Json* value) {
  if (value == nullptr) return std::nullopt;
  if (const auto* whole = value->as<std::int64_t>()) return static_cast<double>(*whole);
  if (const auto* real = value->as<double>()) return *real;
  return std::nullopt;
}

std::optional<bool> truth_of(const Json* value) {
  const auto* truth = value != nullptr ? value->as<bool>() : nullptr;
  return truth != nullptr ? std::optional(*truth) : std::nullopt;
}

std::optional<std::vector<std::int64_t>> integers_of(const Json* value) {
  const auto* list = value != nullptr ? value->as<Json::List>() : nullptr;
  if (list == nullptr) return std::nullopt;
  std::vector<std::int64_t> result;
  for (const Json& item : *list) {
    const auto* whole = item.as<std::int64_t>();
    if (whole == nullptr) return std::nullopt;
    result.push_back(*whole);
  }
  return result;
}

}  // namespace eagerx::gen
