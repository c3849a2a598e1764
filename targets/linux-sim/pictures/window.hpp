// A window, through SDL 2 if it is installed: the program looks for it at run time.
#pragma once

#include <cstdint>
#include <string>

namespace eagerx::linux_sim {

struct SdlFunctions;

/// The input at a window.
struct Wishes {
  bool ends = false;    // closes it, or presses Escape or Q
  bool pauses = false;  // Space
  bool steps = false;   // the right arrow or N: one picture further
  int speeds = 0;       // up or down: times twice as fast
};

class Window {
 public:
  Window() = default;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  /// Empty, or the problem.
  std::string open(const std::string& title, int width, int height);
  void show(const std::uint8_t* pixels);
  /// The input since the last call; waits for at most `wait_ms`.
  Wishes wishes(int wait_ms);

 private:
  void draw();
  void* library_ = nullptr;
  const SdlFunctions* sdl_ = nullptr;
  void *window_ = nullptr, *renderer_ = nullptr, *texture_ = nullptr;
  int width_ = 0;
};

}  // namespace eagerx::linux_sim
