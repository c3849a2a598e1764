#include <charconv>
#include <cmath>
#include <runtime/host/base/json_reader.hpp>

namespace eagerx::host {
namespace {

bool is_decimal(char c) {
  return c >= '0' && c <= '9';
}

void append_utf8(std::string& to, std::uint32_t point) {
  const auto add = [&](std::uint32_t byte) { to += static_cast<char>(byte); };
  if (point < 0x80) return add(point);
  if (point < 0x800) {
    add(0xc0 | point >> 6);
  } else {
    if (point < 0x10000) {
      add(0xe0 | point >> 12);
    } else {
      add(0xf0 | point >> 18);
      add(0x80 | (point >> 12 & 0x3f));
    }
    add(0x80 | (point >> 6 & 0x3f));
  }
  add(0x80 | (point & 0x3f));
}

class JsonReader {
 public:
  JsonReader(std::string_view text, std::size_t most_values)
      : text_(text), most_values_(most_values) {}

  bool document(JsonValue& value) { return this->value(value, 0) && (skip_space(), text_.empty()); }

 private:
  void skip_space() {
    const std::size_t end = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(end == std::string_view::npos ? text_.size() : end);
  }
  /// Takes `word` if it is next.
  bool take(std::string_view word) {
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  bool take_after_space(char c) {
    skip_space();
    return take({&c, 1});
  }

  bool value(JsonValue& to, int depth) {
    skip_space();
    if (depth > kDeepestJson || ++values_ > most_values_ || text_.empty()) return false;
    switch (text_.front()) {
      case '{':
        return object(to, depth);
      case '[':
        return array(to, depth);
      case '"':
        to.kind = JsonValue::Kind::text;
        return string(to.text);
      case 'n':
        return take("null");
      case 't':
      case 'f':
        to.kind = JsonValue::Kind::boolean;
        to.boolean = text_.front() == 't';
        return take(to.boolean ? "true" : "false");
      default:
        return number(to);
    }
  }

  bool object(JsonValue& to, int depth) {
    to.kind = JsonValue::Kind::object;
    text_.remove_prefix(1);
    if (take_after_space('}')) return true;
    do {
      skip_space();
      if (!string(to.names.emplace_back()) || !take_after_space(':') ||
          !value(to.items.emplace_back(), depth + 1))
        return false;
    } while (take_after_space(','));
    return take("}");
  }

  bool array(JsonValue& to, int depth) {
    to.kind = JsonValue::Kind::array;
    text_.remove_prefix(1);
    if (take_after_space(']')) return true;
    do {
      if (!value(to.items.emplace_back(), depth + 1)) return false;
    } while (take_after_space(','));
    return take("]");
  }

  bool number(JsonValue& to) {
    to.kind = JsonValue::Kind::number;
    // from_chars takes `.5`, `5.`, `01`, `inf` and `nan`, too.
    std::size_t at = text_.front() == '-' ? 1 : 0;
    const auto digits = [&] {
      const std::size_t begin = at;
      while (at < text_.size() && is_decimal(text_[at])) ++at;
      return at - begin;
    };
    const bool begins_with_0 = at < text_.size() && text_[at] == '0';
    const std::size_t whole = digits();
    if (whole == 0 || (begins_with_0 && whole > 1)) return false;
    if (at < text_.size() && text_[at] == '.' && (++at, digits() == 0)) return false;
    if (at < text_.size() && (text_[at] == 'e' || text_[at] == 'E')) {
      ++at;
      if (at < text_.size() && (text_[at] == '+' || text_[at] == '-')) ++at;
      if (digits() == 0) return false;
    }
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + at, to.number);
    if (error != std::errc() || end != text_.data() + at) return false;
    text_.remove_prefix(at);
    return std::isfinite(to.number);
  }

  bool string(std::string& to) {
    if (!take("\"")) return false;
    while (!text_.empty()) {
      const char c = text_.front();
      text_.remove_prefix(1);
      if (c == '"') return true;
      if (static_cast<unsigned char>(c) < 0x20) return false;
      if (c != '\\') {
        to += c;
      } else if (!escape(to)) {
        return false;
      }
    }
    return false;
  }

  bool escape(std::string& to) {
    constexpr std::string_view kEscapes = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
    if (text_.empty()) return false;
    const char c = text_.front();
    text_.remove_prefix(1);
    if (c != 'u') {
      const std::size_t which = kEscapes.find(c);
      if (which != std::string_view::npos) to += kMeanings[which];
      return which != std::string_view::npos;
    }
    std::uint32_t point = 0;
    if (!unit(point)) return false;
    if (point >= 0xd800 && point < 0xe000) {  // the first half of one beyond 16 bits
      std::uint32_t second = 0;
      if (point >= 0xdc00 || !take("\\u") || !unit(second)) return false;
      if (second < 0xdc00 || second >= 0xe000) return false;
      point = 0x10000 + ((point - 0xd800) << 10) + (second - 0xdc00);
    }
    append_utf8(to, point);
    return true;
  }

  /// Four digits.
  bool unit(std::uint32_t& value) {
    constexpr std::size_t kDigits = 4;
    if (text_.size() < kDigits) return false;
    const char* const end = text_.data() + kDigits;
    const auto result = std::from_chars(text_.data(), end, value, 16);
    text_.remove_prefix(kDigits);
    return result.ec == std::errc() && result.ptr == end;
  }

  std::string_view text_;
  const std::size_t most_values_;
  std::size_t values_ = 0;
};

}  // namespace

const JsonValue* JsonValue::find(std::string_view name) const {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name) return &items[i];
  return nullptr;
}

std::optional<JsonValue> read_json(std::string_view text, std::size_t most_values) {
  JsonValue value;
  if (!JsonReader(text, most_values).document(value)) return std::nullopt;
  return value;
}

}  // namespace eagerx::host
