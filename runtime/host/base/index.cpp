// Functions that eagerx/index.hpp calls.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <runtime/host/base/interrupt.hpp>
#include <string>

namespace {

/// The line without spaces before it, which names the port; empty where the source is not here.
std::string text_of_line(const std::string& file, std::uint_least32_t line) {
  std::ifstream source(file);
  std::string text;
  for (std::uint_least32_t i = 0; i < line; ++i)
    if (!std::getline(source, text)) return {};
  text.erase(0, text.find_first_not_of(" \t"));
  return text;
}

}  // namespace

extern "C" [[noreturn]] void eagerx_index_is_outside(const char* file, std::uint_least32_t line,
                                                     const char* function, const char* of,
                                                     std::size_t index, std::size_t size) {
  const std::string place = std::filesystem::path(file).lexically_normal().string();
  std::fprintf(stderr, "%s:%lu: error: index %zu of a %s with %zu %s\n", place.c_str(),
               static_cast<unsigned long>(line), index, of, size,
               size == 1 ? "element" : "elements");
  if (const std::string text = text_of_line(file, line); !text.empty())
    std::fprintf(stderr, "  %s\n", text.c_str());
  std::fprintf(stderr, "  in %s\n", function);
  eagerx::host::make_safe_now();
  std::abort();
}
