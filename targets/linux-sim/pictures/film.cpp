#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <runtime/host/base/claim.hpp>
#include <targets/linux-sim/pictures/film.hpp>
#include <vector>

namespace eagerx::linux_sim {
namespace {

constexpr int kNoProgram = 127;

std::vector<std::string> command(const std::string& path, int width, int height,
                                 const std::string& rate) {
  std::vector<std::string> words = {
      "ffmpeg",     "-nostdin", "-hide_banner",
      "-loglevel",  "error",    "-y",
      "-f",         "rawvideo", "-pix_fmt",
      "rgb24",      "-s",       std::to_string(width) + "x" + std::to_string(height),
      "-framerate", rate,       "-i",
      "pipe:0"};
  if (path.ends_with(".mp4") || path.ends_with(".mkv") || path.ends_with(".mov")) {
    for (const char* word :
         {"-c:v", "libx264", "-preset", "veryfast", "-crf", "18", "-pix_fmt", "yuv420p"})
      words.emplace_back(word);
  }
  words.push_back("file:" + path);  // never an address
  return words;
}

/// In the new process, where nothing may allocate.
[[noreturn]] void exec_ffmpeg(int input, char* const* arguments) {
  setpgid(0, 0);  // Ctrl-C ends our run, and we the film
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGXFSZ, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(input, STDIN_FILENO);
  execvp(arguments[0], arguments);
  _exit(kNoProgram);
}

}  // namespace

Film::~Film() {
  give_up();
}

/// Whether there is a file to write to is said by us, and in words.
std::string Film::open_draft() {
  // ffmpeg knows the kind of a film from its ending.
  int error = host::claim_output(path_);
  if (error == 0)
    error = draft_.emplace(path_).make(std::filesystem::path(path_).extension().string());
  if (error == 0) held_ = ::open(draft_->name().c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK);
  if (error == 0 && held_ < 0) error = errno;
  return error == 0 ? std::string()
                    : "error: cannot write `" + path_ + "`: " + host::problem_of_writing(error);
}

std::string Film::open(const std::string& path, int width, int height, const std::string& rate) {
  if (width % 2 != 0 || height % 2 != 0)
    return "error: films have even widths and heights, not " + std::to_string(width) + "x" +
           std::to_string(height) + "\nhelp: give another `--size`";
  path_ = path;
  if (std::string problem = open_draft(); !problem.empty()) return problem;
  std::vector<std::string> words = command(draft_->name(), width, height, rate);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0)
    return "error: cannot start ffmpeg: " + std::string(std::strerror(errno));
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  child_ = fork();
  if (child_ == 0) exec_ffmpeg(ends[0], arguments.data());
  close(ends[0]);
  pipe_ = ends[1];
  if (child_ < 0) {
    give_up();
    return "error: cannot start ffmpeg: " + std::string(std::strerror(errno));
  }
  return {};
}

bool Film::write(const std::uint8_t* pixels, std::size_t bytes) {
  while (bytes > 0 && !broken_) {
    const ssize_t written = ::write(pipe_, pixels, bytes);
    if (written > 0) {
      pixels += written;
      bytes -= static_cast<std::size_t>(written);
    } else if (errno != EINTR) {
      broken_ = true;
    }
  }
  return !broken_;
}

std::string Film::finish() {
  if (child_ < 0) return {};
  close(pipe_);
  pipe_ = -1;
  int status = 0;
  while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
  }
  child_ = -1;
  std::string problem;
  if (WIFEXITED(status) && WEXITSTATUS(status) == kNoProgram) {
    problem = "error: films need the program ffmpeg\nhelp: apt install ffmpeg";
  } else if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || broken_) {
    problem = "error: cannot write `" + path_ + "`: ffmpeg has failed";
  } else if (const int error = draft_->put()) {
    problem = "error: cannot write `" + path_ + "`: " + host::problem_of_writing(error);
  }
  let_go();
  return problem;
}

void Film::give_up() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  if (child_ > 0) {
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }
  child_ = -1;
  let_go();
}

void Film::let_go() {
  if (held_ >= 0) close(held_);
  held_ = -1;
  draft_.reset();
}

}  // namespace eagerx::linux_sim
