#include <dlfcn.h>

#include <cstdlib>
#include <runtime/host/base/look_up.hpp>
#include <targets/linux-sim/pictures/window.hpp>

namespace eagerx::linux_sim {

// Of SDL 2's headers, whose interface does not change within version 2. The headers are not needed
// where a program is built, and the library not where it shows nothing.
struct SdlFunctions {
  int (*Init)(std::uint32_t flags);
  void (*Quit)();
  const char* (*GetError)();
  int (*SetHint)(const char* name, const char* value);
  void* (*CreateWindow)(const char* title, int x, int y, int w, int h, std::uint32_t flags);
  void (*DestroyWindow)(void* window);
  void* (*CreateRenderer)(void* window, int index, std::uint32_t flags);
  void (*DestroyRenderer)(void* renderer);
  void* (*CreateTexture)(void* renderer, std::uint32_t format, int access, int w, int h);
  int (*UpdateTexture)(void* texture, const void* rect, const void* pixels, int pitch);
  int (*RenderCopy)(void* renderer, void* texture, const void* source, const void* target);
  void (*RenderPresent)(void* renderer);
  int (*WaitEventTimeout)(void* event, int ms);
};

namespace {

constexpr std::uint32_t kVideo = 0x20;
constexpr int kCentred = 0x2FFF0000;
constexpr std::uint32_t kResizable = 0x20;
constexpr std::uint32_t kSoftware = 0x1;
constexpr std::uint32_t kRgb24 = 0x17101803;
constexpr int kStreaming = 1;
constexpr std::uint32_t kQuitEvent = 0x100, kWindowEvent = 0x200, kKeyDown = 0x300;

union Event {
  std::uint32_t type;
  struct {
    std::uint32_t type, timestamp, window;
    std::uint8_t state, repeat, padding[2];
    std::int32_t scancode, key;
  } keyboard;
  std::uint8_t room[128];
};

enum Key : std::int32_t {
  kEscape = 27,
  kSpace = ' ',
  kN = 'n',
  kQ = 'q',
  kRight = 0x4000004F,
  kDown = 0x40000051,
  kUp = 0x40000052,
};

SdlFunctions functions;  // of the one library

bool find_all(void* library) {
  SdlFunctions& f = functions;
  return look_up(library, "SDL_Init", f.Init) && look_up(library, "SDL_Quit", f.Quit) &&
         look_up(library, "SDL_GetError", f.GetError) &&
         look_up(library, "SDL_SetHint", f.SetHint) &&
         look_up(library, "SDL_CreateWindow", f.CreateWindow) &&
         look_up(library, "SDL_DestroyWindow", f.DestroyWindow) &&
         look_up(library, "SDL_CreateRenderer", f.CreateRenderer) &&
         look_up(library, "SDL_DestroyRenderer", f.DestroyRenderer) &&
         look_up(library, "SDL_CreateTexture", f.CreateTexture) &&
         look_up(library, "SDL_UpdateTexture", f.UpdateTexture) &&
         look_up(library, "SDL_RenderCopy", f.RenderCopy) &&
         look_up(library, "SDL_RenderPresent", f.RenderPresent) &&
         look_up(library, "SDL_WaitEventTimeout", f.WaitEventTimeout);
}

void note_key(std::int32_t key, Wishes& wishes) {
  switch (key) {
    case kEscape:
    case kQ:
      wishes.ends = true;
      break;
    case kSpace:
      wishes.pauses = !wishes.pauses;
      break;
    case kN:
    case kRight:
      wishes.steps = true;
      break;
    case kUp:
      ++wishes.speeds;
      break;
    case kDown:
      --wishes.speeds;
      break;
    default:
      break;
  }
}

/// Without one SDL may find a console to draw on, or draw into nothing.
bool has_display() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"}) {
    const char* const value = std::getenv(name);
    if (value != nullptr && *value != '\0') return true;
  }
  return false;
}

std::string no_display(const std::string& why) {
  return "error: there is no display" + why +
         "\nhelp: without one, `--render film.mp4` or `--render frames/%04d.png`";
}

}  // namespace

Window::~Window() {
  if (sdl_ == nullptr) return;
  if (renderer_ != nullptr) sdl_->DestroyRenderer(renderer_);  // with its texture
  if (window_ != nullptr) sdl_->DestroyWindow(window_);
  sdl_->Quit();
}

std::string Window::open(const std::string& title, int width, int height) {
  library_ = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
  if (library_ == nullptr || !find_all(library_))
    return "error: a window needs the library SDL 2\nhelp: apt install libsdl2-2.0-0";
  functions.SetHint("SDL_NO_SIGNAL_HANDLERS", "1");
  // SDL would load OpenGL's drivers to show pixels that are finished.
  functions.SetHint("SDL_FRAMEBUFFER_ACCELERATION", "0");
  if (!has_display()) return no_display("");
  if (functions.Init(kVideo) != 0) return no_display(": " + std::string(functions.GetError()));
  sdl_ = &functions;
  width_ = width;
  window_ = sdl_->CreateWindow(title.c_str(), kCentred, kCentred, width, height, kResizable);
  if (window_ != nullptr) renderer_ = sdl_->CreateRenderer(window_, -1, kSoftware);
  if (renderer_ != nullptr)
    texture_ = sdl_->CreateTexture(renderer_, kRgb24, kStreaming, width, height);
  if (texture_ == nullptr) return "error: there is no window: " + std::string(sdl_->GetError());
  return {};
}

void Window::draw() {
  sdl_->RenderCopy(renderer_, texture_, nullptr, nullptr);
  sdl_->RenderPresent(renderer_);
}

void Window::show(const std::uint8_t* pixels) {
  sdl_->UpdateTexture(texture_, nullptr, pixels, 3 * width_);
  draw();
}

Wishes Window::wishes(int wait_ms) {
  Wishes wishes;
  Event event{};
  for (int wait = wait_ms; sdl_->WaitEventTimeout(&event, wait) != 0; wait = 0) {
    if (event.type == kQuitEvent) wishes.ends = true;
    if (event.type == kWindowEvent) draw();
    if (event.type == kKeyDown && event.keyboard.repeat == 0) note_key(event.keyboard.key, wishes);
  }
  return wishes;
}

}  // namespace eagerx::linux_sim
