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

bool Line::names_state_of_node(const char* field) const {
  const char* object = std::strchr(text(), '/');
  const char* state = std::strrchr(text(), '/');
  if (object == state) return false;
  const std::size_t object_size = static_cast<std::size_t>(object - text());
  const std::size_t state_size = std::strlen(state);
  const std::size_t size = std::strlen(field);
  if (size <= object_size + state_size) return false;
  const char* ending = field + size - state_size;
  return std::strncmp(field, text(), object_size) == 0 && field[object_size] == '_' &&
         *ending == '_' && std::strcmp(ending + 1, state + 1) == 0;
}

void refuse(const char* what, const char* name) {
  std::fprintf(stderr, "the program has no %s `%s`\n", what, name);
  std::exit(2);
}

}  // namespace eagerx::conformance
