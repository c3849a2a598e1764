// The record of a training for `eagerx-gen report --training`: a file with one JSON object per
// line, complete at any time.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/curve.hpp"
#include "targets/environments/train/curve_file.hpp"
#include "targets/environments/train/evaluation.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/summary.hpp"

namespace eagerx::train {

/// First a line that describes the training. Then, for each training, a line for each iteration,
/// with the names of the columns of curve_csv(), and `terms` of an evaluation; at the end a line
/// with `ended`. A training without that line is running, or was killed. Any thread may write.
class Record {
 public:
  /// The record of one training, or of all `options.seeds`. Writes nothing without
  /// `options.record`.
  Record(const Options& options, const Description& description);

  /// After an iteration, the last point of `curve`; `seen`: the last evaluation of this run.
  /// Returns the result of CurveFile::grow().
  std::string grow(std::uint64_t seed, double now_s, const std::vector<CurvePoint>& curve,
                   const Evaluation& seen);
  /// At the end of a training whose policy is written. Throws Problem.
  void end(const Ended& ended, const Evaluation& evaluation);
  /// It has ended by a problem. A later write error is not reported: the problem is.
  void fail(std::uint64_t seed, const std::vector<CurvePoint>& curve, const Problem& problem);

 private:
  struct Training {
    std::string rows, end;
    std::size_t count = 0;  // of the points that are in `rows`
  };

  void append(Training& training, std::uint64_t seed, const std::vector<CurvePoint>& curve,
              const std::vector<double>& terms) const;
  std::string text() const;

  bool is_wanted_;
  CurveFile file_;
  std::string head_;
  std::mutex mutex_;                             // of
  std::map<std::uint64_t, Training> trainings_;  // by seed
};

}  // namespace eagerx::train
