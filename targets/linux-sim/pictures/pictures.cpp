#include <algorithm>
#include <array>
#include <eagerx/picture.hpp>
#include <eagerx/scene.hpp>
#include <filesystem>
#include <memory>
#include <runtime/host/base/claim.hpp>
#include <runtime/host/base/files.hpp>
#include <runtime/host/base/interrupt.hpp>
#include <runtime/host/base/supervisor.hpp>
#include <targets/common/image_message.hpp>
#include <targets/common/last_shown.hpp>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/pictures/film.hpp>
#include <targets/linux-sim/pictures/pictures.hpp>
#include <targets/linux-sim/pictures/png.hpp>
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
  picture::Painter<kWidest, 384, target::kMostShapes> painter{};
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

bool is_film(const std::string& path) {
  constexpr std::array kEndings = {".mp4", ".mkv", ".mov", ".webm", ".gif", ".avi"};
  return std::any_of(kEndings.begin(), kEndings.end(),
                     [&](const char* ending) { return path.ends_with(ending); });
}

class PicturesOfRun final : public Pictures {
 public:
  std::string open(const Rendering& wanted, const std::string& title,
                   const std::string& rate) override;
  bool has_window() const override;
  std::int64_t take_paused_ns() override;
  const std::uint8_t* kept(bool paints) override;
  std::string close() override;

  void show_scene(const float* scene, std::size_t rows) override;
  void show_image(const std::uint8_t* image, int width, int height, int channels) override;

 private:
  std::string open_files(const std::string& path);
  void write_png(const std::string& path);
  void hand_on();
  void look_at_window();

  bool paused_ = false;
  std::int64_t paused_ns_ = 0;
  std::unique_ptr<Studio> studio_;
};

std::string PicturesOfRun::open(const Rendering& wanted, const std::string& title,
                                const std::string& rate) {
  if (wanted.to.empty()) return {};
  studio_ = std::make_unique<Studio>();
  studio_->width = wanted.width;
  studio_->height = wanted.height;
  studio_->pixels.resize(static_cast<std::size_t>(wanted.width) *
                         static_cast<std::size_t>(wanted.height) * 3);
  std::string problem;
  if (wanted.to == "window") {
    studio_->to_window = true;
    problem = studio_->window.open(title, wanted.width, wanted.height);
  } else if (is_film(wanted.to)) {
    studio_->to_film = true;
    problem = studio_->film.open(wanted.to, wanted.width, wanted.height, rate);
  } else if (wanted.to.ends_with(".png")) {
    problem = open_files(wanted.to);
  } else if (wanted.to == "asked") {
    studio_->is_asked = true;
    studio_->scene.reserve(kMostKept);
    std::ranges::fill(studio_->pixels, kWhite);
  } else if (wanted.to != "hash") {
    problem = "error: `" + wanted.to +
              "` is not a value of `--render`\nhelp: it is `window`, a film "
              "such as `film.mp4`, pictures such as `frames/%04d.png`, `hash`, or `asked`";
  }
  is_on_ = problem.empty();
  return problem;
}

void PicturesOfRun::write_png(const std::string& path) {
  const std::string png = png_of(studio_->pixels.data(), studio_->width, studio_->height);
  const int error = host::write_whole(path, png, host::Durability::cached);
  if (error != 0)
    studio_->problem = "error: cannot write `" + path + "`: " + host::problem_of_writing(error);
}

std::string PicturesOfRun::open_files(const std::string& path) {
  if (!read_names(path, studio_->names))
    return "error: `" + path +
           "` is not a name of pictures\nhelp: write one `%d` or such as `%04d` "
           "where their numbers are to stand";
  studio_->to_files = true;
  const auto folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) return "error: cannot make `" + folder.string() + "`: " + error.message();
  const int refused = host::claim_output(path);  // for all that have these names
  return refused == 0 ? std::string()
                      : "error: cannot write `" + path + "`: " + host::problem_of_writing(refused);
}

bool PicturesOfRun::has_window() const {
  return studio_ && studio_->to_window;
}

void PicturesOfRun::hand_on() {
  const std::vector<std::uint8_t>& pixels = studio_->pixels;
  for (std::size_t i = 0; i < pixels.size(); i += 8) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < 8 && i + k < pixels.size(); ++k)
      word |= std::uint64_t{pixels[i + k]} << (8 * k);
    const std::uint64_t h = (hash_ ^ word) * 0x9e3779b97f4a7c15U;
    hash_ = h ^ h >> 32U;
  }
  if (!studio_->problem.empty()) return;
  if (studio_->to_files && studio_->names.numbered) write_png(studio_->names.of(count_));
  if (studio_->to_film && !studio_->film.write(pixels.data(), pixels.size())) ends_run_ = true;
  ++count_;
  if (!studio_->problem.empty()) ends_run_ = true;
  if (studio_->to_window) look_at_window();
}

void PicturesOfRun::look_at_window() {
  constexpr int kWaitMs = 20;
  constexpr int kFastest = 6;
  studio_->window.show(studio_->pixels.data());
  const std::int64_t begin_ns = now_ns();
  bool waited = false;
  for (;;) {
    host::send_heartbeat();
    const Wishes wishes = studio_->window.wishes(paused_ ? kWaitMs : 0);
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
  if (!studio_ || !studio_->is_asked) return nullptr;
  if (paints && studio_->scene_rows > 0)
    studio_->painter.paint(studio_->scene.data(), studio_->scene_rows,
                           {studio_->pixels.data(), studio_->width, studio_->height, 3});
  return studio_->pixels.data();
}

std::string PicturesOfRun::close() {
  if (!studio_) return {};
  if (studio_->to_files && !studio_->names.numbered && count_ > 0 && studio_->problem.empty())
    write_png(studio_->names.of(0));
  std::string problem = studio_->problem;
  if (studio_->to_film) {
    const std::string film = studio_->film.finish();
    if (problem.empty()) problem = film;
  }
  studio_.reset();
  is_on_ = false;
  return problem;
}

void PicturesOfRun::show_scene(const float* scene, std::size_t rows) {
  if (studio_->is_asked) {
    studio_->scene.assign(scene, scene + rows * kSceneColumns);
    studio_->scene_rows = rows;
    return;
  }
  studio_->painter.paint(scene, rows, {studio_->pixels.data(), studio_->width, studio_->height, 3});
  hand_on();
}

void PicturesOfRun::show_image(const std::uint8_t* image, int width, int height, int channels) {
  target::scale_image(image, width, height, channels,
                      {studio_->pixels.data(), studio_->width, studio_->height, 3});
  if (!studio_->is_asked) hand_on();
}

}  // namespace

std::unique_ptr<Pictures> make_pictures() {
  return std::make_unique<PicturesOfRun>();
}

}  // namespace eagerx::linux_sim
