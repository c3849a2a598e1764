// Films: Debian's program ffmpeg makes them of raw pictures.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <runtime/host/base/files.hpp>
#include <string>

namespace eagerx::linux_sim {

/// A film under another name until it is finished, so that its own name never has a broken one.
class Film {
 public:
  Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  ~Film();

  /// Starts ffmpeg for RGB pictures at `rate` per second ("30/1"). Empty, or the problem.
  std::string open(const std::string& path, int width, int height, const std::string& rate);
  /// False if ffmpeg accepts no more pictures: see finish().
  bool write(const std::uint8_t* pixels, std::size_t bytes);
  /// Waits for ffmpeg. Empty, or the problem; there is then no file.
  std::string finish();

 private:
  std::string open_draft();
  void let_go();
  void give_up();
  std::string path_;
  std::optional<host::AtomicFile> draft_;
  int held_ = -1;  // the file, until ffmpeg has ended: a FIFO's reader must not see its end before
  int pipe_ = -1;
  pid_t child_ = -1;
  bool broken_ = false;
};

}  // namespace eagerx::linux_sim
