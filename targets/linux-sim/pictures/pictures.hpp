// Output of `--render` of a program: a window, a film, or pictures in files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <targets/linux-sim/options.hpp>

namespace eagerx::linux_sim {

/// The pictures of a run. A program that shows nothing has none, and is not linked with them: so
/// the library calls them by this interface.
class Pictures {
 public:
  virtual ~Pictures() = default;
  /// Call it before the run. `rate`: pictures per second, "30/1". Empty, or the problem.
  virtual std::string open(const Rendering& wanted, const std::string& title,
                           const std::string& rate) = 0;
  bool is_on() const { return is_on_; }
  virtual bool has_window() const = 0;
  /// Whether the user has closed the window, or a picture could not be written.
  bool ends_run() const { return ends_run_; }
  /// Nanoseconds of pauses in the window since the last call.
  virtual std::int64_t take_paused_ns() = 0;
  /// How much faster than requested the run should be, as a power of two.
  int speed() const { return speed_; }

  /// With `asked`: the last picture, [height][width][3], white before the first one; null if none
  /// is kept. `paints`: paints the last scene, otherwise returns the last painted picture.
  virtual const std::uint8_t* kept(bool paints) = 0;

  /// Shows a scene of [rows][kSceneColumns], if the pictures are on.
  virtual void show_scene(const float* scene, std::size_t rows) = 0;
  /// The same of an image of [height][width][channels].
  virtual void show_image(const std::uint8_t* image, int width, int height, int channels) = 0;

  /// Call it after the run. Empty, or the problem: there is then no film or picture.
  virtual std::string close() = 0;
  std::uint64_t count() const { return count_; }
  /// Of all pixels so far: equal on every machine.
  std::uint64_t hash() const { return hash_; }

 protected:
  bool is_on_ = false, ends_run_ = false;
  int speed_ = 0;
  std::uint64_t count_ = 0;
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// They are off until they are opened.
std::unique_ptr<Pictures> make_pictures();

}  // namespace eagerx::linux_sim
