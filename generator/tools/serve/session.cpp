#include "generator/tools/serve/session.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <runtime/host/base/files.hpp>
#include <utility>

#include "generator/tools/serve/edit_request.hpp"
#include "generator/tools/serve/state_json.hpp"
#include "generator/tools/serve/status.hpp"

namespace eagerx::gen::serve {
namespace {

constexpr const char* kOnDisk = "the file was changed on the disk";

Json or_null(const std::string& reason) {
  return reason.empty() ? Json(nullptr) : Json(reason);
}

}  // namespace

Reply failure(int status, std::string problem, std::string help) {
  return {status, Json{{"error", std::move(problem)}, {"help", std::move(help)}}};
}

Session::Session(Workshop& workshop, std::string path)
    : workshop_(workshop), path_(std::move(path)), file_(path_) {
  FileText found = file_.read();
  problem_ = std::move(found.problem);
  text_ = std::move(found.text);
  exists_ = found.exists;
  read_layout();
}

void Session::take_text(std::string text, bool exists) {
  text_ = std::move(text);
  exists_ = exists;
  checked_.reset();
  ++revision_;
  changed_.notify_all();
}

/// True: the disk has another text, which is the newest revision now.
bool Session::take_from_disk() {
  if (!file_.may_have_changed()) return false;
  FileText found = file_.read();
  // What cannot be read now may be readable the next time; meanwhile nothing is known of it.
  if (!found.problem.empty()) return false;
  if (found.exists == exists_ && found.text == text_) return false;
  history_.clear();
  take_text(std::move(found.text), found.exists);
  disk_revision_ = revision_;
  return true;
}

const Workshop::Checked& Session::checked() {
  if (!checked_) {
    checked_ = workshop_.check(path_, text_);
    if (checked_->page) {
      page_ = std::exchange(checked_->page, std::nullopt);
      page_revision_ = revision_;
    }
  }
  return *checked_;
}

Json Session::state_json(std::optional<std::int64_t> known_page, const Json& running) {
  const Workshop::Checked& checked = this->checked();
  Json json{{"revision", revision_},
            {"file", std::filesystem::path(path_).filename().string()},
            {"exists", exists_},
            {"text", text_},
            {"good", !checked.diagnostics.has_errors()},
            {"problems", problems_json(checked, path_, text_)}};
  if (!page_)
    json["page"] = nullptr;
  else if (known_page != page_revision_)
    json["page"] = *page_;
  json["page_revision"] = page_revision_;
  json["layout"] = layout_;
  json["undo"] = or_null(history_.undo_reason());
  json["redo"] = or_null(history_.redo_reason());
  json["outline"] = outline_json(text_);
  json["tree"] = tree_json(text_);
  json["running"] = running;
  return json;
}

Reply Session::state(std::optional<std::int64_t> known_page, const Json& running) {
  const Lock lock(mutex_);
  take_from_disk();
  return {200, state_json(known_page, running)};
}

Reply Session::conflict(std::string problem, const Json& running) {
  Reply reply = failure(kConflict, std::move(problem), "look at the newest state, and try again");
  reply.body["state"] = state_json(std::nullopt, running);
  return reply;
}

std::optional<Reply> Session::refusal(const Json& request, const Json& running) {
  const Json* const asked = member(&request, "revision");
  const auto* const revision = asked != nullptr ? asked->as<std::int64_t>() : nullptr;
  if (revision == nullptr) return failure(kBadRequest, "`revision` is not a whole number");
  // A page that waits for changes may have had them taken from the disk before this edit came.
  if (take_from_disk() || *revision < disk_revision_) return conflict(kOnDisk, running);
  if (*revision != revision_)
    return conflict(fmt::format("revision {} is not the newest one, {}", *revision, revision_),
                    running);
  return std::nullopt;
}

template <class Done>
Reply Session::write(std::string text, const Json& running, const Done& done) {
  const auto expected = exists_ ? std::optional(text_) : std::nullopt;
  switch (file_.write(expected, text)) {
    case GraphFile::Written::done:
      break;
    case GraphFile::Written::changed:
      take_from_disk();
      return conflict(kOnDisk, running);
    case GraphFile::Written::failed:
      return failure(kFailed, fmt::format("cannot write `{}`: {}", path_, file_.problem()));
  }
  done();
  take_text(std::move(text), true);
  return {200, state_json(std::nullopt, running)};
}

Reply Session::edit(const Json& request, const Json& running) {
  const Lock lock(mutex_);
  if (auto refused = refusal(request, running)) return std::move(*refused);
  Edited made = edited(text_, member(&request, "edits"), checked().diagnostics.all());
  if (made.status != 200) {
    Reply reply = failure(made.status, made.problem, made.help);
    reply.body["index"] = made.index;
    return reply;
  }
  if (exists_ && made.text == text_) return {200, state_json(std::nullopt, running)};
  const std::string before = text_;
  return write(std::move(made.text), running, [&] { history_.add(before, made.edit); });
}

Reply Session::undo(const Json& request, const Json& running) {
  const Lock lock(mutex_);
  if (auto refused = refusal(request, running)) return std::move(*refused);
  if (history_.undo_reason().empty()) return failure(kImpossible, "there is nothing to undo");
  return write(history_.undone(text_), running, [&] { history_.step_back(); });
}

Reply Session::redo(const Json& request, const Json& running) {
  const Lock lock(mutex_);
  if (auto refused = refusal(request, running)) return std::move(*refused);
  if (history_.redo_reason().empty()) return failure(kImpossible, "there is nothing to do again");
  return write(history_.redone(text_), running, [&] { history_.step_forward(); });
}

Reply Session::changes(std::int64_t known, double seconds) {
  Lock lock(mutex_);
  changed_.wait_for(lock, std::chrono::duration<double>(seconds),
                    [&] { return ended_ || revision_ != known; });
  return {200, Json{{"revision", revision_}}};
}

void Session::look() {
  const Lock lock(mutex_);
  take_from_disk();
}

void Session::end() {
  const Lock lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

std::optional<std::string> Session::page(std::string& problem) {
  const Lock lock(mutex_);
  take_from_disk();
  checked();
  Json data = page_ ? *page_ : Json::object();
  data["served"] = true;
  return workshop_.page(data, problem);
}

Json Session::library() {
  const Lock lock(mutex_);
  return workshop_.library(path_, text_);
}
Json Session::schema() {
  const Lock lock(mutex_);
  return workshop_.schema(path_, text_);
}

std::string Session::layout_path() const {
  return std::filesystem::path(file_.path()).replace_extension("layout.json").string();
}

namespace {

/// `[x, y]`, both finite.
bool is_place(const Json& json) {
  const auto* const numbers = json.as<Json::List>();
  if (numbers == nullptr || numbers->size() != 2) return false;
  for (const Json& each : *numbers) {
    const auto number = number_of(&each);
    if (!number || !std::isfinite(*number)) return false;
  }
  return true;
}

/// Nothing: it is no object of places.
std::optional<Json> places_of(const Json* json) {
  constexpr std::size_t kMostPlaces = 10'000;
  const auto* const members = json != nullptr ? json->as<Json::Object>() : nullptr;
  if (members == nullptr || members->size() > kMostPlaces) return std::nullopt;
  for (const JsonMember& each : *members) {
    if (!is_place(each.value)) return std::nullopt;
  }
  return *json;
}

}  // namespace

void Session::read_layout() {
  const FileText found = GraphFile(layout_path()).read();
  const auto json = parse_json(found.text);
  if (auto places = json ? places_of(member(&*json, "places")) : std::nullopt)
    layout_ = std::move(*places);
}

Reply Session::set_layout(const Json& request) {
  const Lock lock(mutex_);
  auto places = places_of(member(&request, "places"));
  if (!places) return failure(kBadRequest, "`places` is not an object of `[x, y]`");
  const std::string text = dump_json(Json{{"places", *places}}) + "\n";
  if (const int error = host::write_whole(layout_path(), text))
    return failure(kFailed, fmt::format("cannot write `{}`: {}", layout_path(),
                                        host::problem_of_writing(error)));
  layout_ = std::move(*places);
  return {};
}

}  // namespace eagerx::gen::serve
