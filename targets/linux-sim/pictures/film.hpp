// Films: Debian's program ffmpeg makes them of raw pictures.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <string>

namespace eagerx::linux_sim {

/// A film under another name until it is finished, so that there is no broken one under its own.
class Film {
 public:
  Film() = default;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;
  ~Film();

  /// Starts ffmpeg for pictures of red, green, blue at `rate` a second ("30/1"). Empty, or what is
  /// wrong.
  std::string open(const std::string& path, int width, int height, const std::string& rate);
  /// False when ffmpeg takes no more: finish() says why.
  bool write(const std::uint8_t* pixels, std::size_t bytes);
  /// Waits for ffmpeg. Empty, or what is wrong; then there is no file.
  std::string finish();

 private:
  void give_up();
  std::string path_, part_;
  int pipe_ = -1;
  pid_t child_ = -1;
  bool broken_ = false;
};

}  // namespace eagerx::linux_sim
