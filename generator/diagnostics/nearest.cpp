#include <algorithm>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "generator/diagnostics/diagnostics.hpp"
#include "generator/diagnostics/utf8.hpp"

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxLength = 128;  // longer words are not typing errors of each other

std::u32string code_points(std::string_view text) {
  std::u32string result;
  for (std::size_t at = 0; at < text.size() && result.size() <= kMaxLength;) {
    const CodePoint point = decode_utf8(text, at);
    result.push_back(point.value);
    at += point.size;
  }
  return result;
}

std::u32string lower(std::u32string text) {
  for (char32_t& c : text) {
    if (c >= U'A' && c <= U'Z') c += U'a' - U'A';
  }
  return text;
}

/// Letters left out, added, replaced, or two neighbours swapped (optimal string alignment).
std::size_t distance(const std::u32string& a, const std::u32string& b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  const std::u32string exact = code_points(word);
  const std::u32string wanted = lower(exact);
  if (exact.empty() || exact.size() > kMaxLength) return {};

  const std::string* best = nullptr;
  std::size_t best_distance = std::numeric_limits<std::size_t>::max();
  std::size_t best_exact = std::numeric_limits<std::size_t>::max();  // breaks ties, case counted
  for (const std::string& candidate : candidates) {
    const std::u32string letters = code_points(candidate);
    const std::size_t longer = std::max(letters.size(), exact.size());
    const std::size_t shorter = std::min(letters.size(), exact.size());
    if (longer > kMaxLength || longer - shorter > longer / 3) continue;
    const std::size_t wrong = distance(wanted, lower(letters));
    if (wrong > longer / 3 || wrong > best_distance) continue;
    const std::size_t wrong_exact = distance(exact, letters);
    if (wrong == best_distance && wrong_exact >= best_exact) continue;
    best = &candidate;
    best_distance = wrong;
    best_exact = wrong_exact;
  }
  return best != nullptr ? *best : std::string();
}

}  // namespace eagerx::gen
