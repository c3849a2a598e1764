# Makes a C++ source of the pages of codes/, so that the program needs no file to explain a code:
#   cmake -D FOLDER=codes -D OUTPUT=codes.cpp -P embed_codes.cmake
# The texts pass through quoted arguments only: a list would lose semicolons and brackets.
file(GLOB pages ${FOLDER}/[EW]*.md)
list(SORT pages)
set(entries "")
set(count 0)
foreach(page IN LISTS pages)
  cmake_path(GET page STEM code)
  file(READ ${page} text)
  string(REPLACE "\\" "\\\\" text "${text}")
  string(REPLACE "\"" "\\\"" text "${text}")
  string(REPLACE "?" "\\?" text "${text}") # no trigraphs
  string(REPLACE "\n" "\\n\"\n     \"" text "${text}")
  string(APPEND entries "    {\"${code}\",\n     \"${text}\"},\n")
  math(EXPR count "${count} + 1")
endforeach()
file(WRITE ${OUTPUT} "// Made of the files in generator/support/diagnostics/codes by embed_codes.cmake: change those.
#include <array>

#include \"generator/support/diagnostics/pages.hpp\"

namespace eagerx::gen {
namespace {

constexpr std::array<CodePage, ${count}> kPages = {{
${entries}}};

}  // namespace

std::span<const CodePage> code_pages() {
  return kPages;
}

}  // namespace eagerx::gen
")
