#include <algorithm>
#include <array>
#include <eagerx/picture.hpp>
#include <eagerx/scene.hpp>
#include <filesystem>
#include <memory>
#include <runtime/host/base/claim.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/keeper.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/pictures/film.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/pictures/png.hpp>
#include <targets/linux-sim/pictures/show.hpp>
#include <targets/linux-sim/pictures/window.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

constexpr int kWidest = 4096;
constexpr std::uint8_t kWhite = 255;
constexpr std::size_t kMostKept = std::size_t{1}
                                  << 16U;  // numbers of a scene without an allocation

/// `frames/%04d.png` with the number of the picture in it; without a `%` one file for the last.
struct FileNames {
  std::string before, after;
  int digits = 0;
  bool numbered = false;

  std::string of(std::uint64_t number) const {
    if (!numbered) return before;
    std::string text = std::to_string(number);
    if (static_cast<int>(text.size()) < digits)
      text.insert(0, static_cast<std::size_t>(digits) - text.size(), '0');
    return before + text + after;
  }
};

/// False if there is something else than one %d, or one such as %04d.
bool read_names(const std::string& path, FileNames& names) {
  const std::size_t percent = path.find('%');
  names.before = path.substr(0, percent);
  if (percent == std::string::npos) return true;
  const std::size_t end = path.find_first_not_of("0123456789", percent + 1);
  if (end == std::string::npos || path[end] != 'd' || end - percent > 3) return false;
  const std::string digits = path.substr(percent + 1, end - percent - 1);
  names.digits = digits.empty() ? 0 : std::stoi(digits);
  names.numbered = true;
  names.after = path.substr(end + 1);
  return names.after.find('%') == std::string::npos;
}

/// All that needs memory; made when there is something to show.
struct Studio {
  picture::Painter<kWidest> painter{};
  std::vector<std::uint8_t> pixels;
  int width = 0, height = 0;
  bool to_files = false, to_film = false, to_window = false;
  bool is_asked = false;     // whether somebody asks for pictures
  std::vector<float> scene;  // the last one, if so
  std::size_t scene_rows = 0;
  FileNames names;
  Film film;
  Window window;
  std::string problem;  // the first
};
std::unique_ptr<Studio> studio;

bool is_film(const std::string& path) {
  constexpr std::array kEndings = {".mp4", ".mkv", ".mov", ".webm", ".gif", ".avi"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return path.ends_with(ending); });
}

void write_png(const std::string& path) {
  const std::string png = png_of(studio->pixels.data(), studio->width, studio->height);
  const int error = host::write_whole(path, png, host::Durability::cached);
  if (error != 0)
    studio->problem = "error: cannot write `" + path + "`: " + host::problem_of_writing(error);
}

std::string open_files(const std::string& path) {
  if (!read_names(path, studio->names))
    return "error: `" + path +
           "` is no name of pictures\nhelp: write one `%d` or such as `%04d` "
           "where their numbers are to stand";
  studio->to_files = true;
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) return "error: cannot make `" + folder.string() + "`: " + error.message();
  const int refused = host::claim_output(path);  // for all that have these names
  return refused == 0 ? std::string()
                      : "error: cannot write `" + path + "`: " + host::problem_of_writing(refused);
}

class PicturesOfRun final : public Pictures {
 public:
  std::string open(const Rendering& wanted, const std::string& title,
                   const std::string& rate) override;
  bool has_window() const override;
  std::int64_t take_paused_ns() override;
  const std::uint8_t* kept(bool paints) override;
  std::string close() override;

  void hand_on();

 private:
  void look_at_window();

  bool paused_ = false;
  std::int64_t paused_ns_ = 0;
};
PicturesOfRun pictures;

std::string PicturesOfRun::open(const Rendering& wanted, const std::string& title,
                                const std::string& rate) {
  if (wanted.to.empty()) return {};
  studio = std::make_unique<Studio>();
  studio->width = wanted.width;
  studio->height = wanted.height;
  studio->pixels.resize(static_cast<std::size_t>(wanted.width) *
                        static_cast<std::size_t>(wanted.height) * 3);
  std::string problem;
  if (wanted.to == "window") {
    studio->to_window = true;
    problem = studio->window.open(title, wanted.width, wanted.height);
  } else if (is_film(wanted.to)) {
    studio->to_film = true;
    problem = studio->film.open(wanted.to, wanted.width, wanted.height, rate);
  } else if (wanted.to.ends_with(".png")) {
    problem = open_files(wanted.to);
  } else if (wanted.to == "asked") {
    studio->is_asked = true;
    studio->scene.reserve(kMostKept);
    std::ranges::fill(studio->pixels, kWhite);
  } else if (wanted.to != "hash") {
    problem = "error: `" + wanted.to +
              "` is not a value of `--render`\nhelp: it is `window`, a film "
              "such as `film.mp4`, pictures such as `frames/%04d.png`, `hash`, or `asked`";
  }
  is_on_ = problem.empty();
  return problem;
}

bool PicturesOfRun::has_window() const {
  return studio && studio->to_window;
}

void PicturesOfRun::hand_on() {
  const std::vector<std::uint8_t>& pixels = studio->pixels;
  for (std::size_t i = 0; i < pixels.size(); i += 8) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 8 && i + k < pixels.size(); ++k)
      word |= std::uint64_t{pixels[i + k]} << (8 * k);
    const std::uint64_t h = (hash_ ^ word) * 0x9e3779b97f4a7c15U;
    hash_ = h ^ h >> 32U;
  }
  if (!studio->problem.empty()) return;
  if (studio->to_files && studio->names.numbered) write_png(studio->names.of(count_));
  if (studio->to_film && !studio->film.write(pixels.data(), pixels.size())) ends_run_ = true;
  ++count_;
  if (!studio->problem.empty()) ends_run_ = true;
  if (studio->to_window) look_at_window();
}

void PicturesOfRun::look_at_window() {
  constexpr int kWaitMs = 20;
  constexpr int kFastest = 6;
  studio->window.show(studio->pixels.data());
  const std::int64_t begin_ns = now_ns();
  bool waited = false;
  for (;;) {
    host::say_alive();
    const Wishes wishes = studio->window.wishes(paused_ ? kWaitMs : 0);
    ends_run_ = ends_run_ || wishes.ends;
    if (wishes.pauses) paused_ = !paused_;
    speed_ = std::clamp(speed_ + wishes.speeds, -kFastest, kFastest);
    if (!paused_ || ends_run_ || host::interrupted()) break;
    waited = true;
    if (wishes.steps) break;
  }
  if (waited) paused_ns_ += now_ns() - begin_ns;
}

std::int64_t PicturesOfRun::take_paused_ns() {
  const std::int64_t paused_ns = paused_ns_;
  paused_ns_ = 0;
  return paused_ns;
}

const std::uint8_t* PicturesOfRun::kept(bool paints) {
  if (!studio || !studio->is_asked) return nullptr;
  if (paints && studio->scene_rows > 0)
    studio->painter.paint(studio->scene.data(), studio->scene_rows,
                          {studio->pixels.data(), studio->width, studio->height, 3});
  return studio->pixels.data();
}

std::string PicturesOfRun::close() {
  if (!studio) return {};
  if (studio->to_files && !studio->names.numbered && count_ > 0 && studio->problem.empty())
    write_png(studio->names.of(0));
  std::string problem = studio->problem;
  if (studio->to_film) {
    const std::string film = studio->film.finish();
    if (problem.empty()) problem = film;
  }
  studio.reset();
  is_on_ = false;
  return problem;
}

}  // namespace

Pictures* pictures_of_run() {
  return &pictures;
}
bool pictures_are_on() {
  return pictures.is_on();
}

void show_scene(const float* scene, std::size_t rows) {
  if (studio->is_asked) {
    studio->scene.assign(scene, scene + rows * kSceneColumns);
    studio->scene_rows = rows;
    return;
  }
  studio->painter.paint(scene, rows, {studio->pixels.data(), studio->width, studio->height, 3});
  pictures.hand_on();
}

void show_image(const std::uint8_t* image, int width, int height, int channels) {
  target::scale_image(image, width, height, channels,
                      {studio->pixels.data(), studio->width, studio->height, 3});
  if (!studio->is_asked) pictures.hand_on();
}

}  // namespace eagerx::linux_sim
