// One graph while it is edited: its text, its revisions, what was changed. Its functions may be
// called from several threads.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "generator/support/json/json.hpp"
#include "generator/tools/serve/graph_file.hpp"
#include "generator/tools/serve/history.hpp"
#include "generator/tools/serve/workshop.hpp"

namespace eagerx::gen::serve {

/// The answer: a status of HTTP, and its body.
struct Reply {
  int status = 200;
  Json body = Json::object();
};

Reply failure(int status, std::string problem, std::string help = {});

class Session {
 public:
  /// `path` as the user wrote it. problem(): why it cannot be read.
  Session(Workshop& workshop, std::string path);
  [[nodiscard]] const std::string& problem() const { return problem_; }
  [[nodiscard]] const std::string& path() const { return path_; }

  /// `known_page`: the revision of the page that the asker has.
  Reply state(std::optional<std::int64_t> known_page, const Json& running);
  Reply edit(const Json& request, const Json& running);
  Reply undo(const Json& request, const Json& running);
  Reply redo(const Json& request, const Json& running);
  Reply set_layout(const Json& request);
  /// Waits for another revision than `known`, at most `seconds`, or until end().
  Reply changes(std::int64_t known, double seconds);
  /// The page itself.
  std::optional<std::string> page(std::string& problem);
  Json library();
  Json schema();

  /// Looks at the disk: frequent calls make changes() answer soon.
  void look();
  /// Requests stop waiting.
  void end();

 private:
  using Lock = std::unique_lock<std::mutex>;

  bool take_from_disk();
  void take_text(std::string text, bool exists);
  const Workshop::Checked& checked();
  Json state_json(std::optional<std::int64_t> known_page, const Json& running);
  Reply conflict(std::string problem, const Json& running);
  /// Refuses a request of another revision, or after a change on the disk.
  std::optional<Reply> refusal(const Json& request, const Json& running);
  /// Writes `text`; then `done` is done, and the answer is the new state.
  template <class Done>
  Reply write(std::string text, const Json& running, const Done& done);
  [[nodiscard]] std::string layout_path() const;
  void read_layout();

  Workshop& workshop_;
  const std::string path_;
  GraphFile file_;
  std::string problem_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::string text_;
  bool exists_ = false, ended_ = false;
  std::int64_t revision_ = 1;
  std::int64_t disk_revision_ = 1;  // the newest one that the disk had and no page made
  History history_;
  std::optional<Workshop::Checked> checked_;  // of the text, if somebody has asked
  std::optional<Json> page_;                  // of the last revision without errors
  std::int64_t page_revision_ = 0;
  Json layout_ = Json::object();
};

}  // namespace eagerx::gen::serve
