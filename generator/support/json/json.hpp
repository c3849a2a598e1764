// Reads and writes JSON as a type of this project. Only json.cpp includes nlohmann's headers, which
// take longer to compile than most stages.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace eagerx::gen {

struct JsonMember;

struct Json {
  using List = std::vector<Json>;
  using Object = std::vector<JsonMember>;  // in the order of the file, or as added
  /// std::monostate is null. Whole numbers that do not fit into 64 bits are doubles.
  std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Object> value;

  // Defined where JsonMember is known: libstdc++'s vectors need it to be destroyed.
  Json();
  // NOLINTBEGIN(google-explicit-constructor): numbers, texts and lists are JSON as they stand
  Json(std::nullptr_t /*null*/);
  Json(bool truth);
  template <std::integral Whole>
  requires(!std::same_as<Whole, bool>) Json(Whole whole);
  Json(double number);
  Json(const char* text);
  Json(std::string text);
  Json(List items);
  Json(Object members);
  Json(std::initializer_list<JsonMember> members);
  Json(const std::vector<std::string>& texts);
  // NOLINTEND(google-explicit-constructor)

  static Json object();
  static Json list();

  template <class Kind>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<Kind>(value);
  }
  /// The contents if they have that type, or nullptr.
  template <class Kind>
  [[nodiscard]] const Kind* as() const {
    return std::get_if<Kind>(&value);
  }

  /// The member of an object, added if it is not there. Null becomes an object.
  Json& operator[](std::string_view name);
  /// Adds to a list. Null becomes a list.
  void push_back(Json item);
};

struct JsonMember {
  std::string name;
  Json value;
};

template <std::integral Whole>
requires(!std::same_as<Whole, bool>) Json::Json(Whole whole)
    : value(static_cast<std::int64_t>(whole)) {}

/// The value in `text`, or nothing. Python's NaN and Infinity are null; a key twice is an error,
/// and so are more than a million values or more than 64 in one another.
std::optional<Json> parse_json(std::string_view text);

/// The text of `json`, indented by two; invalid UTF-8, possible in file names, becomes U+FFFD.
std::string dump_json(const Json& json);

/// The member `key` of an object, or nullptr; also of nullptr.
const Json* member(const Json* value, std::string_view key);

/// The text of a string, "" of anything else.
std::string text_of(const Json* value);
/// The number, whole or not.
std::optional<double> number_of(const Json* value);
std::optional<bool> truth_of(const Json* value);

/// The whole numbers of a list, or nothing.
std::optional<std::vector<std::int64_t>> integers_of(const Json* value);

}  // namespace eagerx::gen
