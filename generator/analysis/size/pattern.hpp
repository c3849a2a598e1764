// A regular expression of POSIX (extended, with \s and \S as in GNU's libc).
#pragma once

#include <regex.h>

#include <string>
#include <vector>

namespace eagerx::gen {

/// Replaces std::regex, which takes seconds to compile and stack for every character.
class Pattern {
 public:
  /// `expression` is one of ours: a mistake in it is a bug (std::logic_error).
  explicit Pattern(const char* expression);
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;
  ~Pattern() { regfree(&compiled_); }

  /// The match and its groups: [0] all of it, [1] the first group; groups without a match are
  /// empty. Nothing at all: `text` has no match.
  std::vector<std::string> groups(const std::string& text) const;

 private:
  regex_t compiled_{};
};

}  // namespace eagerx::gen
