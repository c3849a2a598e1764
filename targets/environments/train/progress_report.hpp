// Reports of a training on the terminal: its line, its table, its events.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "targets/environments/train/client.hpp"
#include "targets/environments/train/curve_file.hpp"
#include "targets/environments/train/evaluation.hpp"
#include "targets/environments/train/options.hpp"
#include "targets/environments/train/progress.hpp"
#include "targets/environments/train/record.hpp"
#include "targets/environments/train/tensorboard.hpp"

namespace eagerx::train {

class ProgressReport {
 public:
  /// The file and current text of a table that several trainings write, with the curve of this one;
  /// and their record.
  struct SharedTable {
    CurveFile* file = nullptr;  // nullptr: the training has one of its own
    std::function<std::string(const std::vector<CurvePoint>&)> text = curve_csv;
    Record* record = nullptr;  // nullptr: as `file`
  };

  /// `first_step`: that the training begins with.
  ProgressReport(const Options& options, const Description& description, std::uint64_t first_step,
                 SharedTable table);

  /// A file of events has the points that a resumed training begins with, too.
  void open_events(const std::vector<CurvePoint>& curve);
  /// After an iteration, the last point of `curve`; `seen`: the last evaluation of this run.
  void show(const std::vector<CurvePoint>& curve, const Evaluation& seen);
  /// Removes the line of a terminal.
  void finish() { progress_.finish(); }
  /// The last point of `curve` has passed its stage.
  void tell_stage(const std::vector<CurvePoint>& curve);
  /// The phase after learning, which may take long.
  void tell_last_evaluation(std::size_t episodes);
  /// "warning: …; the training continues …"
  void warn(const std::string& problem, const char* continues);
  /// The table at the end. Throws Problem.
  void write_table(const std::vector<CurvePoint>& curve);
  /// The record of a completed training.
  Record& record() { return record_; }
  double seconds() const { return progress_.seconds(); }

 private:
  void show_events(const CurvePoint& point, const Evaluation& seen);

  std::string stage_of(const std::vector<CurvePoint>& curve) const;

  const Description& description_;
  const std::uint64_t seed_;
  const std::string folder_;  // of events; empty: none
  Progress progress_;
  CurveFile own_table_;
  CurveFile& table_;
  const std::function<std::string(const std::vector<CurvePoint>&)> table_text_;
  Record own_record_;
  Record& record_;
  std::optional<EventFile> events_;
};

}  // namespace eagerx::train
