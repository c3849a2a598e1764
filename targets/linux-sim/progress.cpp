#include <unistd.h>

#include <array>
#include <charconv>
#include <cstring>
#include <string_view>
#include <targets/linux-sim/pacer.hpp>
#include <targets/linux-sim/progress.hpp>

namespace eagerx::linux_sim {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kFirstDrawing = 1000 * kMs;
constexpr std::int64_t kRedraw = 100 * kMs;
constexpr std::int64_t kLook = 20 * kMs;
constexpr std::uint64_t kBarWidth = 30;
constexpr double kSecond = 1e9;  // in ns

/// A line built on the stack.
class Line {
 public:
  void text(std::string_view text) {
    if (text.size() > bytes_.size() - used_) return;
    std::memcpy(bytes_.data() + used_, text.data(), text.size());
    used_ += text.size();
  }
  void number(std::uint64_t value) {
    const auto result = std::to_chars(bytes_.data() + used_, bytes_.data() + bytes_.size(), value);
    if (result.ec == std::errc()) used_ = static_cast<std::size_t>(result.ptr - bytes_.data());
  }
  void show() const {
    // Nothing can be done about a terminal that does not take it.
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, bytes_.data(), used_);
  }

 private:
  std::array<char, 256> bytes_{};
  std::size_t used_ = 0;
};

}  // namespace

Progress::Progress(std::uint64_t steps, bool wanted)
    : steps_(steps), enabled_(wanted && isatty(STDERR_FILENO) == 1) {}

void Progress::look(std::uint64_t done) {
  const std::int64_t now = now_ns();
  if (now - last_ns_ < kLook) {
    stride_ *= 2;
  } else if (stride_ > 1) {
    stride_ /= 2;
  }
  next_ = done + stride_;
  last_ns_ = now;
  const bool first = drawn_ns_ == 0;
  if (now - (first ? start_ns_ : drawn_ns_) < (first ? kFirstDrawing : kRedraw)) return;
  drawn_ns_ = now;
  draw(done, now);
}

void Progress::draw(std::uint64_t done, std::int64_t now) const {
  const double share = static_cast<double>(done) / static_cast<double>(steps_);
  const double seconds = static_cast<double>(now - start_ns_) / kSecond;
  constexpr double kPercent = 100.0;
  Line line;
  line.text("\r[");
  const auto filled = static_cast<std::uint64_t>(share * static_cast<double>(kBarWidth));
  for (std::uint64_t i = 0; i < kBarWidth; ++i) line.text(i < filled ? "=" : " ");
  line.text("] ");
  line.number(static_cast<std::uint64_t>(share * kPercent));
  line.text(" %  ");
  line.number(done);
  line.text(" of ");
  line.number(steps_);
  line.text(" steps, ");
  line.number(static_cast<std::uint64_t>(static_cast<double>(done) / seconds));
  line.text(" steps/s, ");
  line.number(static_cast<std::uint64_t>(seconds / share * (1.0 - share)));
  line.text(" s left\x1b[K");
  line.show();
}

void Progress::finish() {
  if (drawn_ns_ == 0) return;
  Line line;
  line.text("\r\x1b[K");
  line.show();
}

}  // namespace eagerx::linux_sim
