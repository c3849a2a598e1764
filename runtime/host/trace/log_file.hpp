// Reads files of `--trace` on Linux. The file is not trusted: every problem is reported with line
// and column.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <eagerx/trace.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace eagerx::trace_log {

/// The type of an element. A value is kept as the bits that the trace hashes, see canonical_bits().
enum class Dtype : std::uint8_t {
  float32,
  float64,
  int8,
  int16,
  int32,
  int64,
  uint8,
  uint16,
  uint32,
  uint64,
  boolean
};
std::optional<Dtype> dtype_of(std::string_view name);
std::string_view name_of(Dtype dtype);

struct RecordedChannel {
  std::string name;  // "node/output"
  Dtype dtype = Dtype::float32;
  std::uint64_t size = 0;  // elements of a message
  std::uint64_t rate_num = 0, rate_den = 1;
};

struct Row {
  std::size_t line = 0;   // in the file, from 1
  std::size_t first = 0;  // of its values in Log::values
  std::uint64_t seq = 0;
  std::int64_t time_ns = 0;  // since the log began; 0 without time stamps
  std::uint32_t channel = 0;
  std::uint32_t episode = 0;
};

/// The initial value of a state of an episode, as written: numbers in decimal.
struct RecordedState {
  std::uint32_t episode = 0;
  std::string name;  // "pendulum/mass"
  std::vector<std::string> values;
};

/// A value set while an episode ran, before step `step` (from 0), as written.
struct RecordedSetting {
  std::uint32_t episode = 0;
  std::uint64_t step = 0;
  std::string name;  // "controller/kp"
  std::vector<std::string> values;
};

/// A drawing: the numbers that differ from the previous scene in the file, for its rows.
struct RecordedScene {
  std::uint64_t tick = 0;
  std::uint32_t episode = 0;
  std::uint32_t rows = 0;              // of 16 numbers
  std::size_t first = 0, changes = 0;  // in Log::scene_changes
};
struct SceneChange {
  std::uint32_t index = 0;
  float value = 0.0F;
};

struct Log {
  std::string path, graph, engine, agent;
  std::uint64_t seed = 0;
  std::uint32_t environment = 0;
  std::vector<RecordedChannel> channels;
  std::vector<Row> rows;  // in the order of the file
  std::vector<std::uint64_t> values;
  std::vector<RecordedState> states;
  std::vector<RecordedSetting> settings;  // in the order of the file
  std::vector<RecordedScene> scenes;
  std::vector<SceneChange> scene_changes;
  std::uint64_t scenes_num = 0, scenes_den = 1;  // scenes a second; 0: there are none
  bool timed = false;
  bool complete = false;   // has its last line; otherwise it ended early
  std::uint64_t hash = 0;  // if complete
  std::size_t lines = 0;

  const std::uint64_t* values_of(const Row& row) const { return values.data() + row.first; }
  std::optional<std::uint32_t> channel(std::string_view name) const;
  std::uint32_t episodes() const { return rows.empty() ? 0 : rows.back().episode + 1; }
};

/// Reads a log piece by piece, also while it grows.
class LogReader {
 public:
  explicit LogReader(std::string path);
  LogReader(const LogReader&) = delete;
  LogReader& operator=(const LogReader&) = delete;
  ~LogReader();

  /// Removes all complete lines from `text`. The rest is an incomplete line, or text after the last
  /// line of the log. False: see problem(); nothing more is read.
  bool read(std::string_view& text);
  /// Nothing will follow `rest`, which read() left. False: that is too early.
  bool finish(std::string_view rest);

  bool has_head() const;  // then the channels are known
  const std::string& problem() const;
  /// The data read so far. Rows, values, states and scenes may be taken away.
  Log& log();

 private:
  class Lines;
  std::unique_ptr<Lines> lines_;
};

/// Reads the text of a log. nullopt: see `problem`, "path:line:column: error: …". An incomplete
/// log, even if it ends within a line, is read up to its end.
std::optional<Log> read_log(const std::string& path, std::string_view text, std::string& problem);
/// The same from the file `path`.
std::optional<Log> read_log_file(const std::string& path, std::string& problem);

/// The number in decimal: floating-point numbers with the fewest digits that give the same bits.
std::string text_of(Dtype dtype, std::uint64_t bits);
/// How many numbers of the type further on `b` is: units in the last place, whole numbers. Nothing
/// if one of them is NaN.
std::optional<std::uint64_t> distance(Dtype dtype, std::uint64_t a, std::uint64_t b);
/// "4 ulp", "3", "not a number"
std::string distance_text(Dtype dtype, std::uint64_t a, std::uint64_t b);

/// The value of type `T` with these bits.
template <class T>
T value_of(std::uint64_t bits) {
  if constexpr (std::is_same_v<T, float>) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
  } else if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<double>(bits);
  } else {
    return static_cast<T>(bits);
  }
}

/// As a number to calculate with.
double number_of(Dtype dtype, std::uint64_t bits);

}  // namespace eagerx::trace_log
