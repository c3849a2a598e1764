// Arguments of common kinds.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

constexpr const char* kExperimental = " (experimental)";

}  // namespace

std::vector<std::string> comma_separated(std::string_view text) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = std::min(text.find(','), text.size());
    parts.emplace_back(text.substr(0, end));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

Argument flag(std::string names, bool& value, std::string about) {
  return {std::move(names), std::move(about), "", [&value](const auto&) { value = true; }};
}

Argument text(std::string names, std::string& value, std::string about, std::string type) {
  return {std::move(names), std::move(about), std::move(type),
          [&value](const auto& values) { value = values.front(); }};
}

Argument texts(std::string names, std::vector<std::string>& values, std::string about,
               std::string type) {
  Argument argument{std::move(names), std::move(about), std::move(type),
                    [&values](const auto& all) {
                      values.clear();
                      for (const std::string& each : all) {
                        if (!ranges::contains(values, each)) values.push_back(each);
                      }
                    }};
  argument.repeated = true;
  return argument;
}

Argument choice(std::string names, std::vector<std::string> choices, std::string about,
                std::function<void(const std::string&)> take) {
  std::string type;
  for (const std::string& each : choices) type += (type.empty() ? "" : "|") + each;
  Argument argument{std::move(names), std::move(about), std::move(type),
                    [take = std::move(take)](const auto& values) { take(values.front()); }};
  argument.choices = std::move(choices);
  return argument;
}

Argument required(Argument argument) {
  argument.required = true;
  return argument;
}

Argument experimental(Argument argument) {
  argument.about += kExperimental;
  return argument;
}

Command experimental(Command command) {
  command.about += kExperimental;
  return command;
}

Argument checked(Argument argument, std::function<bool(const std::string&)> good,
                 std::string problem) {
  argument.check = [good = std::move(good), problem = std::move(problem)](const std::string& word) {
    return good(word) ? std::string() : word + " " + problem;
  };
  return argument;
}

Argument whole(std::string names, std::optional<std::uint64_t>& value, std::string about,
               std::uint64_t low, std::uint64_t high) {
  const auto parsed = [low, high](const std::string& word) -> std::optional<std::uint64_t> {
    std::uint64_t number = 0;
    const char* end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, number);
    const bool good = error == std::errc() && at == end && number >= low && number <= high;
    return good ? std::optional(number) : std::nullopt;
  };
  return checked(
      {std::move(names), std::move(about), "N",
       [&value, parsed](const auto& values) { value = parsed(values.front()); }},
      [parsed](const std::string& word) { return parsed(word).has_value(); },
      fmt::format("is not a whole number from {} to {}", low, high));
}

Argument reads(Argument argument, std::string continues) {
  argument.use = FileUse::reads;
  argument.continues = std::move(continues);
  return argument;
}

Argument writes(Argument argument, std::string otherwise) {
  argument.use = FileUse::writes;
  argument.otherwise = std::move(otherwise);
  return argument;
}

Argument folder(Argument argument) {
  argument.use = FileUse::folder;
  return argument;
}

}  // namespace eagerx::gen
