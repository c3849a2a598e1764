// eagerx-gen started for the page: one program at a time, its output, the curve of a training.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "generator/support/json/json.hpp"
#include "generator/tools/serve/session.hpp"

namespace eagerx::gen::serve {

class Programs {
 public:
  static constexpr std::size_t kMostLines = 10'000, kLongestLine = 2000;

  /// `self`: the command line that starts eagerx-gen. `graph`: a path.
  Programs(std::vector<std::string> self, std::string graph);
  /// Ends what runs.
  ~Programs();
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;

  Reply start(const Json& request);
  /// Lines from number `after` on, rows of the curve from `row` on; waits at most `seconds` for
  /// something new.
  Reply output(std::uint64_t after, std::uint64_t row, double seconds);
  Reply stop();
  /// `{kind, id}`, or null.
  Json running();
  /// The page that the last `report` or `simulate` wrote.
  std::optional<std::string> result();
  /// JSON of the loop that the last `linearize` opened.
  std::optional<std::string> loop();
  /// Requests stop waiting, and running programs are ended.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  struct Line {
    std::string text;
    bool is_error;
  };

  void run(const std::vector<std::string>& command);
  void add(std::string_view line, bool is_error);
  void signal(int number);
  std::optional<std::string> written(const char* name);
  [[nodiscard]] Json curve(std::uint64_t row) const;
  [[nodiscard]] std::string place_of(const char* name) const;

  const std::vector<std::string> self_;
  const std::string graph_;
  std::string folder_;  // for what programs write for the page; empty: there is none yet
  int lock_ = -1;       // of it, while this server lives
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
  pid_t group_ = 0;
  std::int64_t id_ = 0;
  std::string kind_, curve_file_;
  std::optional<std::filesystem::file_time_type>
      old_curve_;  // of another training, until it is written anew
  bool running_ = false, ended_ = false;
  std::optional<int> exit_code_;
  std::optional<Clock::time_point> interrupted_;
  std::deque<Line> lines_;
  std::uint64_t first_line_ = 0;  // the number of the first one that is kept
};

}  // namespace eagerx::gen::serve
