// The results of a sweep's trainings in a file, so that none is repeated.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace eagerx::train {

/// The result of one training. Numbers are of its best policy, in episodes that took no part in the
/// choice.
struct SweepRow {
  std::string training;  // hash of all that it depends on: 16 hexadecimal digits
  std::string settings;  // "learning_rate=0.001 layers=64,64", for people
  std::uint64_t seed = 0;
  bool succeeds = false;
  std::uint64_t steps = 0;
  std::uint64_t successes = 0, episodes = 0;
  double mean_return = 0.0;
  double processor_s = 0.0;
  std::string problem;  // why it broke; then there are no numbers
};

/// Several sweeps may write into one file at the same time: each adds its rows to those that are
/// there.
class SweepResults {
 public:
  /// Reads the existing file. Throws Problem if it is not a file of results.
  explicit SweepResults(std::string path);

  /// Of a training, or nullptr.
  const SweepRow* find(std::string_view training) const;
  std::size_t size() const { return rows_.size(); }
  /// Adds a row and writes the file. Returns the reason if it cannot be written: the row is kept,
  /// and a later add() or write() writes it.
  std::string add(SweepRow row);
  /// Takes the rows that others have written, too. Throws Problem.
  void write();

 private:
  std::vector<SweepRow> read() const;
  void add_from_file();

  std::string path_;
  std::vector<SweepRow> rows_;
};

}  // namespace eagerx::train
