#include "generator/tools/serve/edit_request.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "generator/frontend/outline/fixes.hpp"
#include "generator/tools/serve/graph_file.hpp"
#include "generator/tools/serve/state_json.hpp"
#include "generator/tools/serve/status.hpp"

namespace eagerx::gen::serve {
namespace {

constexpr std::size_t kMostEdits = 1000;

class OneEdit {
 public:
  OneEdit(std::string_view text, const Json& edit, const std::vector<Diagnostic>& problems,
          bool is_first)
      : text_(text), edit_(edit), problems_(problems), is_first_(is_first) {}

  /// Nothing: `problem` says what is wrong with the request.
  std::optional<Change> change(std::string& problem) {
    const Change change = of_kind(text_of(member(&edit_, "kind")));
    problem = problem_;
    return problem.empty() ? std::optional(change) : std::nullopt;
  }

 private:
  Change of_kind(const std::string& kind) {
    if (kind == "add") return add();
    if (kind == "set") {
      const OutlinePath path = this->path();
      const std::string value = text("value");
      return ask([&] { return set_value(text_, path, value); });
    }
    if (kind == "remove") {
      const OutlinePath path = this->path();
      return ask([&] { return remove_entry(text_, path); });
    }
    if (kind == "connect") {
      const std::string from = text("from"), to = text("to");
      const auto keys = this->keys("keys");
      return ask([&] { return connect_ports(text_, from, to, keys); });
    }
    if (kind == "rename") {
      const OutlinePath path = this->path();
      const std::string name = text("name");
      return ask([&] { return rename_entry(text_, path, name); });
    }
    if (kind == "fix") return fix();
    if (kind == "text") {
      const std::string whole = text("text");
      if (whole.size() > GraphFile::kMostBytes) problem_ = "the text is too large";
      return ask([&] { return Change{difference("Write in the file", text_, whole)}; });
    }
    problem_ = fmt::format("there is no kind of edit `{}`", kind);
    return {};
  }

  template <class Make>
  Change ask(const Make& make) {
    return problem_.empty() ? make() : Change{};
  }

  Change add() {
    NewEntry entry{text("section"), text("name"), optional_text("type"), keys("keys"),
                   keys("parameters")};
    return ask([&] { return add_entry(text_, entry); });
  }

  Change fix() {
    const Json* const number = member(&edit_, "problem");
    const auto* const index = number != nullptr ? number->as<std::int64_t>() : nullptr;
    if (index == nullptr)
      problem_ = "`problem` is not a whole number";
    else if (!is_first_)
      problem_ = "a `fix` is the first edit of a request";
    if (!problem_.empty()) return {};
    const bool is_there = *index >= 0 && static_cast<std::size_t>(*index) < problems_.size();
    auto edit =
        is_there ? fix_of(problems_[static_cast<std::size_t>(*index)], text_) : std::nullopt;
    if (!edit) return {std::nullopt, "the help of this problem is not a change of the text", ""};
    return {std::move(edit)};
  }

  std::string text(const char* key) {
    const Json* const value = member(&edit_, key);
    if (value == nullptr || !value->is<std::string>()) {
      if (problem_.empty()) problem_ = fmt::format("`{}` is not text", key);
      return {};
    }
    return text_of(value);
  }
  std::string optional_text(const char* key) {
    return member(&edit_, key) == nullptr ? std::string() : text(key);
  }
  OutlinePath path() {
    auto path = path_of(member(&edit_, "path"));
    if (!path && problem_.empty()) problem_ = "`path` is not a list of keys and numbers";
    return path.value_or(OutlinePath{});
  }
  std::vector<KeyValue> keys(const char* key) {
    const Json* const object = member(&edit_, key);
    if (object == nullptr) return {};
    const auto* const members = object->as<Json::Object>();
    if (members == nullptr) {
      if (problem_.empty()) problem_ = fmt::format("`{}` is not an object", key);
      return {};
    }
    std::vector<KeyValue> values;
    for (const JsonMember& each : *members) {
      if (!each.value.is<std::string>() && problem_.empty())
        problem_ = fmt::format("`{}` in `{}` is not text", each.name, key);
      values.push_back({each.name, text_of(&each.value)});
    }
    return values;
  }

  std::string_view text_;
  const Json& edit_;
  const std::vector<Diagnostic>& problems_;
  bool is_first_;
  std::string problem_;
};

}  // namespace

Edited edited(std::string_view text, const Json* edits, const std::vector<Diagnostic>& problems) {
  const auto* const list = edits != nullptr ? edits->as<Json::List>() : nullptr;
  Edited result{.text = std::string(text)};
  const auto fail = [&](int status, std::string problem, std::string help = {}) {
    result.status = status;
    result.problem = std::move(problem);
    result.help = std::move(help);
    result.text = text;
    return result;
  };
  if (list == nullptr || list->empty() || list->size() > kMostEdits)
    return fail(kBadRequest, fmt::format("`edits` is not a list of 1 to {} edits", kMostEdits));
  std::string reason;
  for (result.index = 0; result.index < list->size(); ++result.index) {
    std::string problem;
    auto change =
        OneEdit(result.text, (*list)[result.index], problems, result.index == 0).change(problem);
    if (!change) return fail(kBadRequest, problem);
    if (!change->edit) return fail(kImpossible, change->problem, change->help);
    if (reason.empty()) reason = change->edit->reason;
    result.text = applied(result.text, std::move(change->edit->splices));
  }
  if (list->size() > 1) reason += fmt::format(" and {} more", list->size() - 1);
  if (result.text.size() > GraphFile::kMostBytes)
    return fail(kImpossible, "the file would be too large");
  result.edit = difference(std::move(reason), text, result.text);
  return result;
}

}  // namespace eagerx::gen::serve
