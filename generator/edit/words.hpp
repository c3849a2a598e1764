// What names are made of.
#pragma once

#include <cctype>

namespace eagerx::gen {

inline bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

}  // namespace eagerx::gen
