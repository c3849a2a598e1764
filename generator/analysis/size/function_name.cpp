#include "generator/analysis/size/function_name.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

namespace eagerx::gen {
namespace {

/// Without what stands in <…> and {…}, and without "(anonymous namespace)", whose parenthesis would
/// be taken for that of the arguments: "a::(anonymous namespace)::f<int>(int)" → "a::::f(int)".
std::string without_templates(std::string_view text) {
  std::string result;
  int depth = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    constexpr std::string_view kAnonymous = "(anonymous namespace)";
    const char c = text[at];
    if (text.substr(at).starts_with(kAnonymous)) {
      at += kAnonymous.size() - 1;
    } else if (c == '<' || c == '{') {
      ++depth;
    } else if (c == '>' || c == '}') {
      depth = std::max(depth - 1, 0);
    } else if (depth == 0) {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string function_name(const std::string& mangled) {
  const std::string plain = mangled.substr(0, mangled.find('.', 1));
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> text(
      abi::__cxa_demangle(plain.c_str(), nullptr, nullptr, &status), std::free);
  if (!mangled.starts_with("_Z") || status != 0 || text == nullptr) return mangled;
  std::string_view whole = text.get();
  if (whole.find("operator") != std::string_view::npos) return std::string(whole);
  std::string name = without_templates(whole);
  name.resize(std::min(name.find('('), name.size()));
  name.erase(0, name.find_last_of(" *&") + 1);  // what it returns
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find("::", begin), name.size());
    if (end > begin) parts.push_back(name.substr(begin, end - begin));
    begin = end + 2;
  }
  if (parts.empty()) return mangled;
  const bool of_class =
      parts.size() > 1 && parts[parts.size() - 2][0] >= 'A' && parts[parts.size() - 2][0] <= 'Z';
  return of_class ? parts[parts.size() - 2] + "::" + parts.back() : parts.back();
}

}  // namespace eagerx::gen
