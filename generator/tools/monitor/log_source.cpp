#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <eagerx/scene.hpp>
#include <memory>
#include <optional>
#include <runtime/host/trace/log_clock.hpp>
#include <utility>

#include "generator/tools/monitor/source.hpp"
#include "generator/tools/monitor/written_number.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kAtOnce = 1 << 18;       // bytes
constexpr std::size_t kLongestLine = 1 << 24;  // bytes

/// A file that grows, or a pipe or device that gives the same text.
class LogSource final : public Source {
 public:
  LogSource(std::string path, int file, bool is_regular)
      : path_(std::move(path)),
        file_(file),
        is_regular_(is_regular),
        reader_(std::make_unique<trace_log::LogReader>(path_)) {}
  ~LogSource() override { ::close(file_); }
  LogSource(const LogSource&) = delete;
  LogSource& operator=(const LogSource&) = delete;

  [[nodiscard]] int descriptor() const override { return is_regular_ ? -1 : file_; }
  [[nodiscard]] std::string problem() const override { return problem_; }

  State read(std::int64_t now_ns, StreamListener& listener) override {
    if (is_regular_ && was_cut()) begin_anew();
    const std::size_t before = text_.size();
    text_.resize(before + kAtOnce);
    const ssize_t size = ::read(file_, text_.data() + before, kAtOnce);
    text_.resize(before + static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    if (size < 0 && errno != EAGAIN && errno != EINTR) return fail(std::strerror(errno));
    if (size <= 0) {
      live_ = true;  // all that was there before has been read
      return size == 0 && !is_regular_ ? State::ended : State::open;
    }
    offset_ += size;
    return take(now_ns, listener);
  }

 private:
  State take(std::int64_t now_ns, StreamListener& listener) {
    std::string_view rest = text_;
    const bool is_right = reader_->read(rest);
    text_.erase(0, text_.size() - rest.size());
    const trace_log::Log& log = reader_->log();
    if (log.channels.size() > kMostStreamChannels)
      return fail(fmt::format("it has more than {} channels", kMostStreamChannels));
    if (is_right && reader_->has_head() && !clock_ && !begin(listener)) return State::failed;
    tell_rows(now_ns, listener);
    if (!is_right) {
      problem_ = reader_->problem();
      return State::failed;
    }
    if (log.complete) return State::ended;
    if (text_.size() > kLongestLine)
      return fail(fmt::format("a line has more than {} MB", kLongestLine >> 20));
    return State::more;
  }

  bool begin(StreamListener& listener) {
    const trace_log::Log& log = reader_->log();
    clock_.emplace(log.channels);
    StreamFacts facts;
    facts.graph = log.graph;
    facts.engine = log.engine;
    facts.agent = log.agent;
    facts.seed = log.seed;
    facts.environment = log.environment;
    facts.channels = log.channels;
    facts.timed_by_sender = log.timed;
    facts.has_scenes = log.scenes_num > 0;
    return listener.begin(facts);
  }

  void tell_rows(std::int64_t now_ns, StreamListener& listener) {
    trace_log::Log& log = reader_->log();
    if (!clock_) return;
    for (const trace_log::Row& row : log.rows) tell(log, row, now_ns, listener);
    for (const trace_log::RecordedScene& scene : log.scenes) tell(log, scene, listener);
    log.rows.clear();
    log.values.clear();
    log.states.clear();
    log.scenes.clear();
    log.scene_changes.clear();
  }

  void tell(const trace_log::Log& log, const trace_log::Row& row, std::int64_t now_ns,
            StreamListener& listener) {
    const trace_log::RecordedChannel& channel = log.channels[row.channel];
    const std::uint64_t* const bits = log.values_of(row);
    values_.clear();
    for (std::size_t i = 0; i < std::min<std::uint64_t>(channel.size, kMostStreamElements); ++i)
      values_.push_back(written_number(channel.dtype, bits[i]));
    const std::int64_t time_ns = clock_->in_log_ns(
        row.episode, trace_log::time_of_tick(row.seq, channel.rate_num, channel.rate_den));
    // Without time stamps only what comes now has a time.
    std::optional<std::int64_t> real_ns;
    if (log.timed) {
      real_ns = row.time_ns;
    } else if (live_) {
      real_ns = now_ns;
    }
    listener.message(
        {channel.name, values_, bits, channel.size, row.episode, row.seq, time_ns, real_ns});
    // Every step has one action.
    if (!steps_ && channel.name.starts_with("environment/")) steps_ = row.channel;
    if (steps_ == row.channel) listener.step({row.episode, row.seq + 1, time_ns, real_ns});
  }

  /// The file has what differs from the scene before.
  void tell(const trace_log::Log& log, const trace_log::RecordedScene& scene,
            StreamListener& listener) {
    const std::size_t size = std::size_t{scene.rows} * kSceneColumns;
    scene_.resize(std::max(scene_.size(), size));
    for (std::size_t i = scene.first; i < scene.first + scene.changes; ++i)
      scene_[log.scene_changes[i].index] = log.scene_changes[i].value;
    if (!listener.wants_scenes()) return;
    const std::int64_t time_ns = clock_->in_log_of_other_ns(
        scene.episode, trace_log::time_of_tick(scene.tick, log.scenes_num, log.scenes_den));
    listener.scene({scene.episode, time_ns, std::span(scene_).first(size)});
  }

  /// Another run writes into the same file.
  void begin_anew() {
    static_cast<void>(lseek(file_, 0, SEEK_SET));
    reader_ = std::make_unique<trace_log::LogReader>(path_);
    clock_.reset();
    steps_.reset();
    text_.clear();
    scene_.clear();
    offset_ = 0;
    live_ = false;
  }
  [[nodiscard]] bool was_cut() const {
    struct stat status {};
    return fstat(file_, &status) == 0 && status.st_size < offset_;
  }
  State fail(const std::string& why) {
    problem_ = fmt::format("error: cannot read `{}`: {}", path_, why);
    return State::failed;
  }

  const std::string path_;
  const int file_;
  const bool is_regular_;
  std::unique_ptr<trace_log::LogReader> reader_;
  std::optional<trace_log::LogClock> clock_;
  std::optional<std::uint32_t> steps_;  // the channel that counts them
  std::string text_;                    // the beginning of a line
  std::vector<double> values_;
  std::vector<float> scene_;  // numbers of the latest one
  off_t offset_ = 0;
  bool live_ = false;
  std::string problem_;
};

}  // namespace

std::unique_ptr<Source> open_log_source(const std::string& path, std::string& problem) {
  // Opening a pipe without a writer must not block.
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0 || S_ISDIR(status.st_mode)) {
    const int why = file < 0 ? errno : EISDIR;
    if (file >= 0) ::close(file);
    problem = fmt::format("error: cannot read `{}`: {}", path, std::strerror(why));
    if (why == ENOENT)
      problem +=
          "\nhelp: a source is `udp:PORT`, `foxglove:PORT`, `serial:DEVICE`, or the file of a "
          "trace";
    return nullptr;
  }
  return std::make_unique<LogSource>(path, file, S_ISREG(status.st_mode));
}

}  // namespace eagerx::gen
