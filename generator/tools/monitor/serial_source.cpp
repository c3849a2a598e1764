#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <optional>
#include <runtime/host/telemetry/decoder.hpp>
#include <runtime/host/trace/log_clock.hpp>
#include <utility>

#include "generator/tools/monitor/source.hpp"
#include "generator/tools/monitor/telemetry_layout.hpp"
#include "generator/tools/monitor/written_number.hpp"

namespace eagerx::gen {
namespace {

/// Telemetry of a board, from its serial line: a device, a pipe, or a file of what one has given.
class SerialSource final : public Source, private telemetry::Listener {
 public:
  SerialSource(std::string path, int file, bool grows, telemetry::Layout layout)
      : path_(std::move(path)),
        file_(file),
        grows_(grows),
        layout_(std::move(layout)),
        facts_(facts_of(layout_)),
        clock_(facts_.channels),
        decoder_(layout_) {
    for (const telemetry::Group& group : layout_.groups) {
      firsts_.push_back(channels_);
      channels_ += group.channels.size();
    }
    last_ns_.resize(channels_);
  }
  ~SerialSource() override { ::close(file_); }
  SerialSource(const SerialSource&) = delete;
  SerialSource& operator=(const SerialSource&) = delete;

  [[nodiscard]] int descriptor() const override { return grows_ ? -1 : file_; }
  [[nodiscard]] std::string problem() const override { return problem_; }

  State read(std::int64_t now_ns, StreamListener& listener) override {
    std::array<std::uint8_t, kBytesAtOnce> bytes{};
    const ssize_t size = ::read(file_, bytes.data(), bytes.size());
    if (size < 0 && errno != EAGAIN && errno != EINTR) {
      problem_ = fmt::format("error: cannot read `{}`: {}", path_, std::strerror(errno));
      return State::failed;
    }
    if (size <= 0) {
      live_ = true;
      return size == 0 && !grows_ ? State::ended : State::open;
    }
    listener_ = &listener;
    now_ns_ = now_ns;
    const bool ours = decoder_.take(bytes.data(), static_cast<std::size_t>(size), *this);
    tell_counts();
    if (!ours && !begun_) {
      problem_ =
          "error: " + decoder_.refusal() +
          "\nhelp: build and flash the program of this graph, or name its own `telemetry.json` "
          "with `--layout`";
      return State::refused;
    }
    return State::more;
  }

 private:
  static constexpr std::size_t kBytesAtOnce = 4096;

  static StreamFacts facts_of(const telemetry::Layout& layout) {
    StreamFacts facts;
    facts.graph = layout.graph;
    facts.hash = layout.hash;
    for (const telemetry::Group& group : layout.groups) {
      for (const telemetry::Channel& channel : group.channels) {
        facts.channels.push_back(
            {channel.name, channel.dtype, channel.size, group.rate_num, group.rate_den});
        facts.every.push_back(group.every);
      }
    }
    return facts;
  }

  void message(const telemetry::Message& message) override {
    const std::size_t place = firsts_[message.group] + message.channel;
    const trace_log::RecordedChannel& channel = facts_.channels[place];
    const std::int64_t in_episode_ns =
        trace_log::time_of_tick(message.seq, channel.rate_num, channel.rate_den);
    if (!begun_) begun_ = accepted_ = listener_->begin(facts_);
    if (!accepted_) return;
    // Numbers begin anew with an episode, behind a reset routine, and where the board was reset.
    if (message.episode != episode_ || in_episode_ns < last_ns_[place]) {
      ++part_;
      last_ns_.assign(last_ns_.size(), 0);
    }
    episode_ = message.episode;
    last_ns_[place] = in_episode_ns;
    const std::int64_t time_ns = clock_.in_log_ns(part_, in_episode_ns);
    values_.clear();
    for (std::size_t i = 0; i < std::min<std::uint64_t>(channel.size, kMostStreamElements); ++i)
      values_.push_back(written_number(channel.dtype, message.values[i]));
    // Earlier contents of a file have no current time.
    const std::optional<std::int64_t> real_ns =
        live_ || !grows_ ? std::optional(now_ns_) : std::nullopt;
    listener_->message({channel.name, values_, message.values, channel.size, message.episode,
                        message.seq, time_ns, real_ns, part_});
    listener_->step({message.episode, {}, time_ns, real_ns});
  }

  void tell_counts() {
    const telemetry::Counts& now = decoder_.counts();
    tell(StreamFault::damaged, now.damaged, reported_.damaged);
    tell(StreamFault::lost, now.lost, reported_.lost);
    tell(StreamFault::dropped, now.dropped, reported_.dropped);
    tell(StreamFault::late_slots, now.late, reported_.late);
  }
  /// The board's counters begin at 0 when the board starts.
  template <class T>
  void tell(StreamFault fault, T count, T& reported) {
    if (count < reported) reported = 0;
    if (count > reported) listener_->fault(fault, count - reported);
    reported = count;
  }

  const std::string path_;
  const int file_;
  const bool grows_;
  const telemetry::Layout layout_;
  const StreamFacts facts_;
  trace_log::LogClock clock_;
  telemetry::Decoder decoder_;
  telemetry::Counts reported_;
  std::vector<std::size_t> firsts_;  // of groups: their first channel in facts_
  std::size_t channels_ = 0;
  std::vector<std::int64_t>
      last_ns_;  // of channels: when the last message was sent, in its episode
  std::vector<double> values_;
  StreamListener* listener_ = nullptr;  // of the call
  std::int64_t now_ns_ = 0;
  std::uint32_t episode_ = 0, part_ = 0;
  bool begun_ = false, accepted_ = false, live_ = false;
  std::string problem_;
};

/// The constant of termios.
std::optional<speed_t> speed_of(std::uint32_t baud) {
  static const std::map<std::uint32_t, speed_t> speeds = {
      {9'600, B9600},        {19'200, B19200},      {38'400, B38400},      {57'600, B57600},
      {115'200, B115200},    {230'400, B230400},    {460'800, B460800},    {500'000, B500000},
      {576'000, B576000},    {921'600, B921600},    {1'000'000, B1000000}, {1'152'000, B1152000},
      {1'500'000, B1500000}, {2'000'000, B2000000}, {2'500'000, B2500000}, {3'000'000, B3000000},
      {3'500'000, B3500000}, {4'000'000, B4000000}};
  const auto found = speeds.find(baud);
  if (found == speeds.end()) return std::nullopt;
  return found->second;
}

/// 8N1 at this speed, bytes as they come. Empty, or why not.
std::string set_line(int file, std::uint32_t baud) {
  const auto speed = speed_of(baud);
  if (!speed) return fmt::format("this machine has no serial line of {} baud", baud);
  termios line{};
  if (tcgetattr(file, &line) != 0) return std::strerror(errno);
  cfmakeraw(&line);
  line.c_cflag |= CLOCAL | CREAD;
  line.c_cc[VMIN] = 1;
  line.c_cc[VTIME] = 0;
  cfsetspeed(&line, *speed);
  return tcsetattr(file, TCSANOW, &line) == 0 ? "" : std::strerror(errno);
}

}  // namespace

std::unique_ptr<Source> open_serial_source(const std::string& path, const std::string& layout_text,
                                           std::string& problem) {
  if (layout_text.empty()) {
    problem =
        "error: the format of what the board sends is unknown\nhelp: name its graph, which has "
        "`telemetry:`, "
        "with `--graph`, or the file `telemetry.json` next to its program with `--layout`";
    return nullptr;
  }
  auto layout = read_telemetry_layout(layout_text, problem);
  if (!layout) {
    problem = "error: the layout of the telemetry: " + problem;
    return nullptr;
  }
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  struct stat status {};
  std::string why;
  if (file < 0 || fstat(file, &status) != 0) {
    why = std::strerror(errno);
  } else if (S_ISDIR(status.st_mode)) {
    why = std::strerror(EISDIR);
  } else if (isatty(file) == 1) {
    why = set_line(file, layout->baud);
  }
  if (why.empty())
    return std::make_unique<SerialSource>(path, file, S_ISREG(status.st_mode), std::move(*layout));
  if (file >= 0) ::close(file);
  problem = fmt::format("error: cannot read `{}`: {}", path, why);
  return nullptr;
}

}  // namespace eagerx::gen
