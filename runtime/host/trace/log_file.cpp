#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <eagerx/trace_text.hpp>
#include <fstream>
#include <iterator>
#include <map>
#include <runtime/host/base/counted.hpp>
#include <runtime/host/base/number.hpp>
#include <runtime/host/trace/channel_name.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <runtime/host/trace/scene_line.hpp>

namespace eagerx::trace_log {
namespace {

template <class T>
bool parse_as(std::string_view text, std::uint64_t& bits) {
  T value{};
  if (!host::read_number(text, value)) return false;
  bits = canonical_bits(value);
  return true;
}

bool parse_value(Dtype dtype, std::string_view text, std::uint64_t& bits) {
  switch (dtype) {
    case Dtype::float32:
      return parse_as<float>(text, bits);
    case Dtype::float64:
      return parse_as<double>(text, bits);
    case Dtype::int8:
      return parse_as<std::int8_t>(text, bits);
    case Dtype::int16:
      return parse_as<std::int16_t>(text, bits);
    case Dtype::int32:
      return parse_as<std::int32_t>(text, bits);
    case Dtype::int64:
      return parse_as<std::int64_t>(text, bits);
    case Dtype::uint8:
      return parse_as<std::uint8_t>(text, bits);
    case Dtype::uint16:
      return parse_as<std::uint16_t>(text, bits);
    case Dtype::uint32:
      return parse_as<std::uint32_t>(text, bits);
    case Dtype::uint64:
      return parse_as<std::uint64_t>(text, bits);
    case Dtype::boolean:
      break;
  }
  bits = text == "1" ? 1 : 0;
  return text == "0" || text == "1";
}

/// The excerpt of the file in an error: at most 40 characters, none that a terminal would obey.
std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string result = "`";
  for (const char c : text.substr(0, kMost)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > kMost ? "…`" : "`");
}

}  // namespace

/// One line at a time.
class LogReader::Lines {
 public:
  explicit Lines(std::string path) { log_.path = std::move(path); }

  bool read(std::string_view& text) {
    while (problem_.empty() && phase_ != Phase::behind && next(text)) {
      if (!read_line()) return false;
    }
    log_.lines = line_;
    return problem_.empty();
  }

  /// There is nothing behind `rest`, which is the beginning of a line.
  bool finish(std::string_view rest) {
    if (!problem_.empty()) return false;
    if (phase_ == Phase::before) {
      problem_ = log_.path + ": error: no line `" + std::string(kTraceFirstLine) +
                 "`; a log is what a program writes with `--trace FILE`";
    } else if (phase_ == Phase::head) {
      problem_ = log_.path + ": error: the log ends before its first message, in line " +
                 std::to_string(line_ + 1);
    } else if (phase_ == Phase::rows && !rest.empty()) {
      log_.lines = line_ + 1;  // ended early
    }
    return problem_.empty();
  }

  bool has_head() const { return phase_ == Phase::rows || phase_ == Phase::behind; }
  const std::string& problem() const { return problem_; }
  Log& log() { return log_; }

 private:
  enum class Phase : std::uint8_t { before, head, rows, behind };

  /// The next line without its end. False behind the last one; an unfinished one is none.
  bool next(std::string_view& rest) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos) return false;
    text_ = rest.substr(0, end);
    rest.remove_prefix(end + 1);
    if (!text_.empty() && text_.back() == '\r') text_.remove_suffix(1);  // serial lines
    ++line_;
    return true;
  }

  bool fail(std::string_view place, const std::string& what) {
    const std::size_t before = place.data() == nullptr
                                   ? text_.size()
                                   : static_cast<std::size_t>(place.data() - text_.data());
    const std::size_t column = before + 1;
    problem_ =
        log_.path + ":" + std::to_string(line_) + ":" + std::to_string(column) + ": error: " + what;
    return false;
  }

  bool read_line() {
    switch (phase_) {
      case Phase::before:
        return read_before();
      case Phase::head:
        return read_head();
      case Phase::rows:
        return read_body();
      case Phase::behind:
        break;
    }
    return true;
  }

  /// A board may have said something before.
  bool read_before() {
    if (text_ == kTraceFirstLine) {
      phase_ = Phase::head;
    } else if (text_.starts_with("# eagerx trace ")) {
      return fail(text_, shown(text_) + " is not a version that can be read; this is version 1");
    }
    return true;
  }

  /// Lines `# name value` up to the names of the columns.
  bool read_head() {
    if (text_ == "episode,channel,seq,values") return check_head();
    if (text_ == "episode,channel,seq,time_ns,values") {
      log_.timed = true;
      return check_head();
    }
    if (!text_.starts_with("# "))
      return fail(text_,
                  "expected `# name value` or `episode,channel,seq,values`, found " + shown(text_));
    const std::string_view fact = text_.substr(2);
    const std::size_t space = std::min(fact.find(' '), fact.size());
    const std::string_view name = fact.substr(0, space);
    const std::string_view value = fact.substr(std::min(space + 1, fact.size()));
    return read_fact(name, value);
  }

  bool read_fact(std::string_view name, std::string_view value) {
    if (name == "graph") return log_.graph = value, true;
    if (name == "engine") return log_.engine = value, true;
    if (name == "agent") return log_.agent = value, true;
    if (name == "seed") {
      has_seed_ = true;
      return host::read_number(value, log_.seed) || fail(value, shown(value) + " is not a seed");
    }
    if (name == "environment")
      return host::read_number(value, log_.environment) ||
             fail(value, shown(value) + " is not the number of an environment");
    if (name == "channel") return read_channel(value);
    return true;  // what a later version may add
  }

  bool read_channel(std::string_view value) {
    std::array<std::string_view, 4> words;
    std::string_view rest = value;
    for (auto& word : words) {
      const std::size_t space = std::min(rest.find(' '), rest.size());
      word = rest.substr(0, space);
      rest.remove_prefix(std::min(space + 1, rest.size()));
      if (word.empty())
        return fail(value, "a channel is `name dtype size rate`, not " + shown(value));
    }
    if (!rest.empty()) return fail(rest, shown(rest) + " behind the rate of a channel");
    if (const std::string why = problem_with_channel_name(words[0]); !why.empty())
      return fail(words[0], shown(words[0]) + " is not the name of a channel: " + why);
    RecordedChannel channel;
    channel.name = words[0];
    const std::optional<Dtype> dtype = dtype_of(words[1]);
    if (!dtype) return fail(words[1], shown(words[1]) + " is not a type");
    channel.dtype = *dtype;
    if (!host::read_number(words[2], channel.size) || channel.size == 0)
      return fail(words[2], shown(words[2]) + " is not a number of elements");
    const std::size_t slash = words[3].find('/');
    if (slash == std::string_view::npos ||
        !host::read_number(words[3].substr(0, slash), channel.rate_num) ||
        !host::read_number(words[3].substr(slash + 1), channel.rate_den) || channel.rate_num == 0 ||
        channel.rate_den == 0)
      return fail(words[3], shown(words[3]) + " is not a rate");
    const auto number = static_cast<std::uint32_t>(log_.channels.size());
    if (!channels_.emplace(channel.name, number).second)
      return fail(words[0], shown(words[0]) + " is there twice");
    log_.channels.push_back(std::move(channel));
    return true;
  }

  bool check_head() {
    if (!has_seed_) return fail(text_, "the log does not say its `# seed`");
    if (log_.channels.empty())
      return fail(text_, "the log has no lines `# channel name dtype size rate`");
    phase_ = Phase::rows;
    return true;
  }

  bool read_body() {
    if (text_.starts_with("# end ")) return read_end(text_.substr(6));
    if (text_.starts_with("# state ")) return read_state(text_.substr(8));
    if (text_.starts_with("# set ")) return read_setting(text_.substr(6));
    if (text_.starts_with("# scene")) {
      std::string what;
      std::string_view place = text_;
      return read_scene_line(text_, log_, place, what) || fail(place, what);
    }
    return text_.starts_with("# ") || read_row();  // a later version may add something
  }

  /// EPISODE NAME VALUE,…
  bool read_state(std::string_view fact) {
    RecordedState state;
    const std::size_t first = fact.find(' ');
    const std::size_t last = fact.rfind(' ');
    if (first == last || !host::read_number(fact.substr(0, first), state.episode))
      return fail(fact, "a state is `episode name values`, not " + shown(fact));
    state.name = fact.substr(first + 1, last - first - 1);
    if (!read_numbers(fact.substr(last + 1), state.values)) return false;
    log_.states.push_back(std::move(state));
    return true;
  }

  /// EPISODE STEP NAME VALUE,…
  bool read_setting(std::string_view fact) {
    RecordedSetting setting;
    const std::size_t first = fact.find(' ');
    const std::size_t second = fact.find(' ', std::min(first, fact.size() - 1) + 1);
    const std::size_t last = fact.rfind(' ');
    if (second == std::string_view::npos || second == last ||
        !host::read_number(fact.substr(0, first), setting.episode) ||
        !host::read_number(fact.substr(first + 1, second - first - 1), setting.step))
      return fail(fact, "what is set is `episode step name values`, not " + shown(fact));
    setting.name = fact.substr(second + 1, last - second - 1);
    if (!read_numbers(fact.substr(last + 1), setting.values)) return false;
    log_.settings.push_back(std::move(setting));
    return true;
  }

  bool read_numbers(std::string_view rest, std::vector<std::string>& values) {
    std::string_view cell;
    while (take(rest, cell)) {
      double value = 0.0;
      if (!host::read_number(cell, value)) return fail(cell, shown(cell) + " is not a number");
      values.emplace_back(cell);
    }
    return true;
  }

  bool read_row() {
    Row row;
    row.line = line_;
    row.first = log_.values.size();
    std::string_view rest = text_;
    std::string_view cell;
    if (!take(rest, cell) || !host::read_number(cell, row.episode))
      return fail(cell, shown(cell) + " is not the number of an episode");
    const bool follows = row.episode == episode_ || (row.episode == episode_ + 1 && messages_ > 0);
    if (!follows)
      return fail(cell, "expected episode " + std::to_string(episode_) + " or the next");
    if (!take(rest, cell)) return fail(rest, "the line ends before its channel");
    const auto channel = channels_.find(cell);
    if (channel == channels_.end())
      return fail(cell, "no line `# channel` says what " + shown(cell) + " is");
    row.channel = channel->second;
    if (!take(rest, cell) || !host::read_number(cell, row.seq))
      return fail(cell, shown(cell) + " is not the number of a message");
    if (log_.timed && (!take(rest, cell) || !host::read_number(cell, row.time_ns)))
      return fail(cell, shown(cell) + " is not a time in nanoseconds");
    return read_values(rest, row);
  }

  bool read_values(std::string_view rest, const Row& row) {
    const RecordedChannel& channel = log_.channels[row.channel];
    std::string_view cell;
    std::uint64_t size = 0;
    while (take(rest, cell)) {
      if (size == channel.size)
        return fail(cell, "a message of " + shown(channel.name) + " has " +
                              host::counted(channel.size, "value") + ", this one more");
      std::uint64_t bits = 0;
      if (!parse_value(channel.dtype, cell, bits))
        return fail(cell, shown(cell) + " is not a " + std::string(name_of(channel.dtype)));
      log_.values.push_back(bits);
      ++size;
    }
    if (size < channel.size)
      return fail(rest, "a message of " + shown(channel.name) + " has " +
                            host::counted(channel.size, "value") + ", this one " +
                            std::to_string(size));
    log_.rows.push_back(row);
    episode_ = row.episode;
    ++messages_;
    return true;
  }

  /// Cuts the next cell off; false if there is none.
  static bool take(std::string_view& rest, std::string_view& cell) {
    cell = rest;
    if (rest.data() == nullptr) return false;
    const std::size_t comma = rest.find(',');
    cell = rest.substr(0, comma);
    if (comma == std::string_view::npos) {
      rest = {};
    } else {
      rest.remove_prefix(comma + 1);
    }
    return true;
  }

  bool read_end(std::string_view fact) {
    const std::size_t space = std::min(fact.find(' '), fact.size());
    const std::string_view hash = fact.substr(std::min(space + 1, fact.size()));
    std::uint64_t messages = 0;
    if (!host::read_number(fact.substr(0, space), messages) || !hash.starts_with("0x") ||
        hash.size() != 18 || !parse_hex(hash.substr(2), log_.hash))
      return fail(fact, "the last line is `# end messages hash`, not " + shown(text_));
    if (messages != messages_)
      return fail(fact, "the log has " + host::counted(messages_, "message") +
                            ", its last line says " + std::to_string(messages));
    log_.complete = true;
    phase_ = Phase::behind;
    return true;
  }

  static bool parse_hex(std::string_view text, std::uint64_t& value) {
    constexpr int kHexadecimal = 16;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, kHexadecimal);
    return error == std::errc() && end == text.data() + text.size();
  }

  Log log_;
  std::map<std::string, std::uint32_t, std::less<>> channels_;
  std::string_view text_;
  std::size_t line_ = 0;
  std::uint64_t messages_ = 0;  // so far; rows may be taken away
  std::uint32_t episode_ = 0;   // of the last one
  Phase phase_ = Phase::before;
  bool has_seed_ = false;
  std::string problem_;
};

std::optional<std::uint32_t> Log::channel(std::string_view name) const {
  for (std::uint32_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == name) return i;
  }
  return std::nullopt;
}

std::optional<Log> read_log(const std::string& path, std::string_view text, std::string& problem) {
  LogReader reader(path);
  if (!reader.read(text) || !reader.finish(text)) {
    problem = reader.problem();
    return std::nullopt;
  }
  return std::move(reader.log());
}

LogReader::LogReader(std::string path) : lines_(std::make_unique<Lines>(std::move(path))) {}
LogReader::~LogReader() = default;
bool LogReader::read(std::string_view& text) {
  return lines_->read(text);
}
bool LogReader::finish(std::string_view rest) {
  return lines_->finish(rest);
}
bool LogReader::has_head() const {
  return lines_->has_head();
}
const std::string& LogReader::problem() const {
  return lines_->problem();
}
Log& LogReader::log() {
  return lines_->log();
}

std::optional<Log> read_log_file(const std::string& path, std::string& problem) {
  const auto fail = [&](const char* why) {
    problem = "error: cannot read `" + path + "`: " + why;
    return std::nullopt;
  };
  // A pipe without a writer, or a device, would be read for ever.
  struct stat status {};
  if (stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode))
    return fail(S_ISDIR(status.st_mode) ? std::strerror(EISDIR) : "it is not a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (!file || errno != 0) return fail(std::strerror(errno));
  return read_log(path, text, problem);
}

}  // namespace eagerx::trace_log
