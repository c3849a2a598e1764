#include "driver.hpp"

#include <cctype>
#include <cstring>

namespace eagerx::conformance {

bool Line::read() {
  if (std::fgets(text_, sizeof text_, stdin) == nullptr) return false;
  count_ = 0;
  for (char* word = std::strtok(text_, " \n"); word != nullptr; word = std::strtok(nullptr, " \n"))
    words_[count_++] = word;
  return true;
}

bool Line::begins_with(const char* word) const {
  return count_ > 0 && std::strcmp(words_[0], word) == 0;
}

bool Line::names(const char* field) const {
  const char* name = text();
  for (; *name != '\0' && *field != '\0'; ++name, ++field) {
    const bool plain = std::isalnum(static_cast<unsigned char>(*name)) != 0;
    if (*field != (plain ? *name : '_')) return false;
  }
  // A word of C++ gets a `_` behind it.
  return *name == '\0' && (*field == '\0' || std::strcmp(field, "_") == 0);
}

std::size_t Line::values() const {
  return count_ < 2 ? 0 : count_ - 2;
}
const char* Line::value(std::size_t i) const {
  return words_[i + 2];
}
const char* Line::text() const {
  return count_ > 1 ? words_[1] : "";
}

bool Line::drop_node() {
  char* first = count_ > 1 ? std::strchr(words_[1], '/') : nullptr;
  const char* second = first != nullptr ? std::strchr(first + 1, '/') : nullptr;
  if (second == nullptr) return false;
  std::memmove(first, second, std::strlen(second) + 1);
  return true;
}

void refuse(const char* what, const char* name) {
  std::fprintf(stderr, "the program has no %s `%s`\n", what, name);
  std::exit(2);
}

}  // namespace eagerx::conformance
