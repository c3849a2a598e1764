// Compares the telemetry of a board with the trace of the same run:
//   telemetry_check telemetry.json CAPTURE TRACE [lossy | damage COUNT SEED]
// Every value that the decoder shows must be that of the trace, and there must be all of them;
// `lossy`: some may be missing; `damage`: this number of frames is damaged first, and exactly these
// must be missing. Prints what was counted.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <random>
#include <runtime/host/telemetry/decoder.hpp>
#include <runtime/host/trace/log_file.hpp>
#include <string>
#include <tuple>

#include "generator/tools/monitor/telemetry_layout.hpp"

namespace {

using namespace eagerx;

std::string read(const char* path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Compares every message with the trace.
class Comparing : public telemetry::Listener {
 public:
  Comparing(const telemetry::Layout& layout, const trace_log::Log& log)
      : layout_(layout), log_(log) {
    for (const auto& row : log.rows)
      values_.insert({{log.channels[row.channel].name, row.episode, row.seq}, log.values_of(row)});
  }

  void message(const telemetry::Message& message) override {
    const telemetry::Group& group = layout_.groups[message.group];
    const telemetry::Channel& channel = group.channels[message.channel];
    ++seen_[channel.name];
    const auto [begin, end] = values_.equal_range({channel.name, message.episode, message.seq});
    const auto found = std::find_if(begin, end, [&](const auto& one) {
      return std::equal(message.values, message.values + channel.size, one.second);
    });
    if (message.seq % group.every != 0 || begin == end) {
      fail(channel, message, "is not in the trace");
    } else if (found == end) {
      fail(channel, message, "has other values than in the trace");
    } else {
      values_.erase(found);  // each is there once
    }
  }

  /// How many messages there should have been and were not.
  std::uint64_t missing() const {
    std::map<std::string, std::uint64_t> expected;
    for (const auto& row : log_.rows) {
      const std::string& name = log_.channels[row.channel].name;
      for (const auto& group : layout_.groups) {
        if (std::ranges::find(group.channels, name, &telemetry::Channel::name) !=
            group.channels.end())
          expected[name] += row.seq % group.every == 0 ? 1 : 0;
      }
    }
    std::uint64_t sum = 0;
    for (const auto& [name, count] : expected) {
      const auto seen = seen_.find(name);
      sum += count - (seen == seen_.end() ? 0 : seen->second);
    }
    return sum;
  }
  std::uint64_t wrong() const { return wrong_; }
  std::uint64_t shown() const {
    std::uint64_t sum = 0;
    for (const auto& [name, count] : seen_) sum += count;
    return sum;
  }

 private:
  void fail(const telemetry::Channel& channel, const telemetry::Message& message,
            const char* what) {
    if (++wrong_ > 5) return;
    fmt::print("FAIL: message {} of `{}` in episode {} {}\n", message.seq, channel.name,
               message.episode, what);
  }

  const telemetry::Layout& layout_;
  const trace_log::Log& log_;
  // After a reset routine numbers begin anew, so there may be two of a kind.
  std::multimap<std::tuple<std::string, std::uint32_t, std::uint64_t>, const std::uint64_t*>
      values_;
  std::map<std::string, std::uint64_t> seen_;
  std::uint64_t wrong_ = 0;
};

/// One bit, a byte less or a byte more, in `count` frames chosen at random, but for the first.
std::string damaged(const std::string& line, std::uint64_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::string> pieces;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find('\0', at), line.size());
    if (end > at) pieces.push_back(line.substr(at, end - at));
    at = end + 1;
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 1; i < pieces.size(); ++i) order.push_back(i);
  std::ranges::shuffle(order, random);
  order.resize(std::min<std::size_t>(order.size(), count));
  for (const std::size_t i : order) {
    std::string& piece = pieces[i];
    const std::size_t place = random() % piece.size();
    const auto bit = static_cast<char>(1U << random() % 7);
    if (random() % 3 == 0)
      piece.erase(place, 1);
    else if (random() % 2 == 0)
      piece.insert(place, 1, 'U');
    else
      piece[place] = static_cast<char>(piece[place] == bit ? bit + 1 : piece[place] ^ bit);
  }
  std::string result;
  for (const auto& piece : pieces) (result += '\0').append(piece) += '\0';
  return result;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) return 2;
  std::string problem;
  const auto layout = gen::read_telemetry_layout(read(arguments[1]), problem);
  if (!layout) return fmt::print("FAIL: {}: {}\n", arguments[1], problem), 1;
  const auto log = trace_log::read_log_file(arguments[3], problem);
  if (!log) return fmt::print("FAIL: {}\n", problem), 1;
  const bool damages = count > 6 && std::strcmp(arguments[4], "damage") == 0;
  const std::uint64_t frames = damages ? std::strtoull(arguments[5], nullptr, 10) : 0;
  const bool lossy = count > 4;
  std::string line = read(arguments[2]);
  if (damages) line = damaged(line, frames, std::strtoull(arguments[6], nullptr, 10));
  Comparing comparing(*layout, *log);
  const auto decoder = std::make_unique<telemetry::Decoder>(*layout);
  decoder->take(reinterpret_cast<const std::uint8_t*>(line.data()), line.size(), comparing);
  const telemetry::Counts& counts = decoder->counts();
  fmt::print(
      "messages {} missing {} records {} greetings {} damaged {} lost {} dropped {} late {} text "
      "{}\n",
      comparing.shown(), comparing.missing(), counts.records, counts.greetings, counts.damaged,
      counts.lost, counts.dropped, counts.late, counts.text);
  if (!decoder->refusal().empty()) return fmt::print("FAIL: {}\n", decoder->refusal()), 1;
  if (comparing.wrong() > 0)
    return fmt::print("FAIL: {} messages are wrong\n", comparing.wrong()), 1;
  if (counts.damaged != frames)
    return fmt::print("FAIL: {} damaged frames, and {} were damaged\n", counts.damaged, frames), 1;
  if (!lossy && comparing.missing() > 0) return fmt::print("FAIL: messages are missing\n"), 1;
  if (comparing.shown() == 0) return fmt::print("FAIL: there are no messages\n"), 1;
  return 0;
}
