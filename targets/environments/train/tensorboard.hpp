// The learning curve as event files that TensorBoard reads, while it grows.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "targets/environments/train/curve.hpp"

namespace eagerx::train {

/// A record of a TFRecord file: length, masked CRC-32C of it, `bytes`, masked CRC-32C of them
/// (tensorflow/core/lib/io/record_writer.h).
std::string tfrecord(std::string_view bytes);

/// The first record of a file: `brain.Event:2`. `wall_time_s` since 1970.
std::string first_event(double wall_time_s);

/// A record with values at `step`, by their tags (message Event of tensorflow's event.proto).
using Scalars = std::vector<std::pair<std::string, double>>;
std::string scalar_event(double wall_time_s, std::int64_t step, const Scalars& scalars);

/// The values of a point of the curve, without missing ones.
Scalars scalars_of(const CurvePoint& point);

/// Throws Problem if such a folder cannot be made. Changes nothing.
void check_folder(const std::string& folder);

/// A file in a folder. A resumed training rewrites its own file, with its points. Next to the curve
/// of another training, it uses a separate folder, `run2`: TensorBoard takes all files in a folder
/// for one curve.
class EventFile {
 public:
  /// Makes the folder and the file. Throws Problem if that is not possible.
  EventFile(const std::string& folder, const std::string& graph,
            const std::vector<CurvePoint>& curve = {});

  /// The folder of the file.
  const std::string& folder() const { return folder_; }
  void append(const CurvePoint& point, const Scalars& more = {});
  /// Why something could not be written; empty: all was.
  const std::string& problem() const { return problem_; }

 private:
  void write(const std::string& record);

  std::string folder_, path_, problem_;
};

}  // namespace eagerx::train
