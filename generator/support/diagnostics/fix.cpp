#include "generator/support/diagnostics/fix.hpp"

#include <fmt/format.h>

#include <runtime/host/base/nearest.hpp>
#include <utility>

namespace eagerx::gen {
namespace {

using EditKind = FixEdit::Kind;

Fix guess(std::string title, FixEdit edit) {
  return {std::move(title), {std::move(edit)}, false};
}

}  // namespace

Fix change_to(const std::string& word) {
  return {fmt::format("Change to `{}`", word), {{EditKind::replace, word}}, true};
}

Fix change_word_to(const std::string& word, const Span& place) {
  Fix fix = change_to(word);
  fix.edits.front().span = place;
  return fix;
}

Fix change_number_to(const std::string& number) {
  return guess(fmt::format("Change to `{}`", number), {EditKind::number, number});
}

Fix change_list_to(const std::string& value) {
  return {fmt::format("Change to `{}`", value), {{EditKind::value, value}}, true};
}

Fix set_in_graph(const std::string& name, const std::string& text) {
  return guess(fmt::format("Set `{}: {}` of the graph", name, text),
               {EditKind::top_value, text, name});
}

Fix leave_out(std::string title) {
  return {std::move(title), {{EditKind::remove}}, true};
}

Fix add_key(const std::string& name) {
  return guess(fmt::format("Add `{}:`", name), {EditKind::missing, "", name});
}

Fix add_to_connection(const std::string& key, const std::string& value) {
  return guess(fmt::format("Put `{}` on the connection", value),
               {EditKind::connection, value, key});
}

Fix add_parameter(const std::string& name) {
  return guess(fmt::format("Add the parameter `{}`", name), {EditKind::parameter, "", name});
}

Fix add_to_list(const std::string& port, const std::string& list, const std::string& owner) {
  return guess(fmt::format("Add `{}` to `{}:` of `{}`", port, list, owner),
               {EditKind::port, port, list, owner});
}

Fix skip_at(const Span& place, const std::string& from, const std::string& to) {
  return guess(fmt::format("Skip `{}` → `{}` (line {})", from, to, place.line),
               {EditKind::connection, "true", "skip", "", place});
}

Fix allow_here(const std::string& code) {
  return guess(fmt::format("Allow {} in this graph", code), {EditKind::top_item, code, "allow"});
}

Help meaning(const std::string& word) {
  return {fmt::format("did you mean `{}`?", word), change_to(word)};
}

Help write_instead(const std::string& word, std::string_view why) {
  return {fmt::format("write `{}`{}", word, why), change_to(word)};
}

Help missing_connection(const std::string& connection) {
  return {
      fmt::format("add a connection `{}`", connection),
      guess(fmt::format("Add `{}`", connection), {EditKind::top_item, connection, "connections"})};
}

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  return host::nearest_name(word, candidates);
}

Help did_you_mean(std::string_view word, const std::vector<std::string>& candidates,
                  Help otherwise) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? std::move(otherwise) : meaning(near);
}

Help did_you_mean_or(std::string_view word, const std::vector<std::string>& candidates,
                     const Help& otherwise) {
  const std::string near = nearest(word, candidates);
  if (near.empty()) return otherwise;
  Help help = meaning(near);
  help += " If it is another one, " + otherwise.text;
  return help;
}

Help suggestion(std::string_view word, const std::vector<std::string>& candidates,
                const Help& none) {
  if (candidates.empty()) return none;
  const std::string near = nearest(word, candidates);
  return near.empty() ? Help(host::suggestion(word, candidates)) : meaning(near);
}

}  // namespace eagerx::gen
