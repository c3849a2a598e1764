#include "generator/tools/lsp/fold.hpp"

#include <algorithm>

namespace eagerx::gen::lsp {
namespace {

class Folder {
 public:
  explicit Folder(std::string_view text) : text_(text) {
    for (std::size_t at = 0; at < text.size(); ++at) {
      if (text[at] == '\n') line_starts_.push_back(at + 1);
    }
  }

  std::vector<Fold> all() {
    below(outline_of(text_));
    comments();
    std::ranges::sort(folds_, std::less{}, &Fold::first);
    return std::move(folds_);
  }

 private:
  [[nodiscard]] std::uint32_t line_of(std::size_t byte) const {
    return static_cast<std::uint32_t>(std::ranges::upper_bound(line_starts_, byte) -
                                      line_starts_.begin() - 1);
  }
  void add(std::uint32_t first, std::uint32_t last, bool is_comment) {
    if (last > first) folds_.push_back({first, last, is_comment});
  }
  void below(const OutlineNode& node) {
    for (const OutlineEntry& entry : node.entries) {
      std::size_t end = std::min(entry.whole.end, text_.size());
      while (end > entry.whole.begin &&
             std::string_view(" \t\r\n").find(text_[end - 1]) != std::string_view::npos)
        --end;
      if (end > entry.whole.begin) add(line_of(entry.whole.begin), line_of(end - 1), false);
      below(entry.value);
    }
  }
  [[nodiscard]] bool is_comment(std::uint32_t line) const {
    const std::size_t begin = text_.find_first_not_of(" \t", line_starts_[line]);
    return begin != std::string_view::npos && text_[begin] == '#';
  }
  void comments() {
    const auto count = static_cast<std::uint32_t>(line_starts_.size());
    for (std::uint32_t first = 0; first < count; ++first) {
      std::uint32_t last = first;
      while (last < count && is_comment(last)) ++last;
      if (last == first) continue;
      add(first, last - 1, true);
      first = last - 1;
    }
  }

  std::string_view text_;
  std::vector<std::size_t> line_starts_ = {0};
  std::vector<Fold> folds_;
};

}  // namespace

std::vector<Fold> folds_of(std::string_view text) {
  return Folder(text).all();
}

}  // namespace eagerx::gen::lsp
