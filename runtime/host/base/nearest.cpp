#include <algorithm>
#include <limits>
#include <runtime/host/base/nearest.hpp>
#include <runtime/host/base/utf8.hpp>

namespace eagerx::host {
namespace {

constexpr std::size_t kMaxLength = 128;  // longer words are not typing errors of each other

/// The beginning of `text` into `result`, whose memory is used again.
void decode(std::string_view text, std::u32string& result) {
  result.clear();
  for (std::size_t at = 0; at < text.size() && result.size() <= kMaxLength;) {
    const CodePoint point = decode_utf8(text, at);
    result.push_back(point.value);
    at += point.size;
  }
}

void make_lower(std::u32string& text) {
  for (char32_t& c : text) {
    if (c >= U'A' && c <= U'Z') c += U'a' - U'A';
  }
}

/// Rows of the table below, used again: a graph may have thousands of names to compare.
struct Rows {
  std::vector<std::size_t> before_last, last, row;
};

/// Letters left out, added, replaced, or two neighbours swapped (optimal string alignment). More
/// than `most` may come out as any larger number.
std::size_t distance(const std::u32string& a, const std::u32string& b, std::size_t most,
                     Rows& rows) {
  auto& [before_last, last, row] = rows;
  for (auto* each : {&before_last, &last, &row}) each->resize(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  std::size_t least_of_last = 0;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    std::size_t least = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
      least = std::min(least, row[j]);
    }
    // A row is made of the two before it.
    if (least > most && least_of_last > most) return most + 1;
    least_of_last = least;
  }
  return row[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string>& known) {
  std::u32string exact, letters, lower;
  decode(name, exact);
  std::u32string wanted = exact;
  make_lower(wanted);
  if (exact.empty() || exact.size() > kMaxLength) return {};

  Rows rows;
  const std::string* best = nullptr;
  std::size_t best_distance = kMaxLength;
  std::size_t best_exact = std::numeric_limits<std::size_t>::max();  // breaks ties, case counted
  for (const std::string& candidate : known) {
    if (candidate.size() > 4 * kMaxLength) continue;
    decode(candidate, letters);
    const std::size_t longer = std::max(letters.size(), exact.size());
    const std::size_t shorter = std::min(letters.size(), exact.size());
    if (longer > kMaxLength || longer - shorter > std::min(longer / 3, best_distance)) continue;
    const std::size_t most = std::min(longer / 3, best_distance);
    lower = letters;
    make_lower(lower);
    const std::size_t wrong = distance(wanted, lower, most, rows);
    if (wrong > most) continue;
    const std::size_t wrong_exact = distance(exact, letters, longer, rows);
    if (wrong == best_distance && wrong_exact >= best_exact) continue;
    best = &candidate;
    best_distance = wrong;
    best_exact = wrong_exact;
  }
  return best != nullptr ? *best : std::string();
}

const std::string* spelled_otherwise(std::string_view name, const std::vector<std::string>& known) {
  const auto same = [](char a, char b) {
    return a == b || ((a == '.' || a == '/') && (b == '.' || b == '/'));
  };
  const std::string* found = nullptr;
  for (const std::string& each : known) {
    if (!std::equal(each.begin(), each.end(), name.begin(), name.end(), same)) continue;
    if (found != nullptr) return nullptr;
    found = &each;
  }
  return found;
}

std::vector<const std::string*> with_parts_of(std::string_view name,
                                              const std::vector<std::string>& known) {
  const auto framed = [](std::string_view text) {
    std::string result = "/" + std::string(text) + "/";
    std::replace(result.begin(), result.end(), '.', '/');
    return result;
  };
  std::vector<const std::string*> found;
  const std::string wanted = framed(name);
  for (const std::string& each : known) {
    if (framed(each).find(wanted) != std::string::npos) found.push_back(&each);
  }
  return found;
}

const std::string* name_meant(std::string_view name, const std::vector<std::string>& known) {
  const auto exact = std::find(known.begin(), known.end(), name);
  if (exact != known.end()) return &*exact;
  if (const std::string* const spelled = spelled_otherwise(name, known)) return spelled;
  const std::vector<const std::string*> found = with_parts_of(name, known);
  return found.size() == 1 ? found.front() : nullptr;
}

const std::string* name_meant(std::string_view name, const std::vector<Named>& known) {
  if (name.empty()) return nullptr;
  std::vector<std::string> names;
  for (const Named& each : known) {
    if (each.accepted && each.name == name) return &each.of;
    names.push_back(each.accepted ? each.name : std::string());
  }
  const auto of = [&](const std::string* each) {
    return &known[static_cast<std::size_t>(each - names.data())].of;
  };
  if (const std::string* const spelled = spelled_otherwise(name, names)) return of(spelled);
  const std::string* found = nullptr;
  for (const std::string* each : with_parts_of(name, names)) {
    if (found != nullptr && *found != *of(each)) return nullptr;
    found = of(each);
  }
  return found;
}

std::string suggestion(std::string_view name, const std::vector<Named>& known) {
  std::vector<std::string> names, all;
  for (const Named& each : known) {
    names.push_back(each.name);
    if (std::find(all.begin(), all.end(), each.of) == all.end()) all.push_back(each.of);
  }
  const auto listed = [](const std::vector<std::string>& list) {
    std::string text;
    for (const std::string& each : list) text += (text.empty() ? "" : ", ") + each;
    return text;
  };
  std::vector<std::string> fitting;
  for (const std::string* each : with_parts_of(name, names)) {
    const std::string& of = known[static_cast<std::size_t>(each - names.data())].of;
    if (std::find(fitting.begin(), fitting.end(), of) == fitting.end()) fitting.push_back(of);
  }
  if (!fitting.empty()) return "it may be " + listed(fitting);
  const std::string near = nearest_name(name, names);
  for (const Named& each : known)
    if (!near.empty() && each.name == near) return "did you mean `" + each.of + "`?";
  return all.empty() ? std::string() : "available: " + listed(all);
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& known) {
  const std::string near = nearest_name(name, known);
  return near.empty() ? near : "did you mean `" + near + "`?";
}

std::string suggestion(std::string_view name, const std::vector<std::string>& known) {
  if (std::string near = did_you_mean(name, known); !near.empty()) return near;
  std::string all;
  for (const std::string& each : known) all += (all.empty() ? "available: " : ", ") + each;
  return all;
}

}  // namespace eagerx::host
