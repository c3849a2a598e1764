// The template, its content policy, and the data in it.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "generator/page/page.hpp"

namespace eagerx::gen {
namespace {

std::optional<std::string> read_part(const std::filesystem::path& path, Diagnostics& diagnostics) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file && !file.bad()) return text;
  diagnostics.io_error("E0301", {},
                       fmt::format("cannot read `{}`: {}", path.string(), std::strerror(errno)));
  return std::nullopt;
}

void replace(std::string& text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
}

/// `@include NAME@` becomes the file NAME of the folder.
std::optional<std::string> with_included(std::string text, const std::string& folder,
                                         Diagnostics& diagnostics) {
  constexpr std::string_view kBegin = "@include ";
  for (std::size_t at = text.find(kBegin); at != std::string::npos; at = text.find(kBegin, at)) {
    const std::size_t name = at + kBegin.size(), end = text.find('@', name);
    const auto part =
        read_part(std::filesystem::path(folder) / text.substr(name, end - name), diagnostics);
    if (!part) return std::nullopt;
    text.replace(at, end + 1 - at, *part);
    at += part->size();
  }
  return text;
}

/// Scripts that only pages with a simulation have.
constexpr std::string_view kSimulation =
    "@include ../../targets/wasm/simulation.js@\n"
    "@include live_controls.js@\n"
    "@include live.js@\n";
/// Those of pages that are told what a run sends.
constexpr std::string_view kStream =
    "@include stream.js@\n"
    "@include stream_shown.js@\n"
    "@include stream_view.js@\n";
/// Plots that run, of both.
constexpr std::string_view kPlots = "@include live_plots.js@\n";

/// What is between the first `<name>` and its end.
std::string_view element(std::string_view text, std::string_view name) {
  const std::string begin = fmt::format("<{}>", name), end = fmt::format("</{}>", name);
  const std::size_t at = text.find(begin) + begin.size();
  return text.substr(at, text.find(end, at) - at);
}

/// On one line, and without a character that could begin markup: within strings `<` is \u003c, and
/// elsewhere JSON has none.
std::string for_markup(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (std::size_t at = 0; at < json.size(); ++at) {
    const char c = json[at];
    if (c == '\n') {  // between values: in strings it is written as \n
      while (at + 1 < json.size() && json[at + 1] == ' ') ++at;
    } else if (c == '<' || c == '>' || c == '&') {
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::optional<std::string> load_module(const std::string& path, Diagnostics& diagnostics) {
  constexpr std::string_view kMagic("\0asm\1\0\0\0", 8);
  constexpr std::uintmax_t kMostBytes = 64'000'000;
  std::error_code error;
  const std::uintmax_t bytes = std::filesystem::file_size(path, error);
  if (!error && bytes <= kMostBytes) {
    auto module = read_part(path, diagnostics);
    if (!module || module->starts_with(kMagic)) return module;
  }
  diagnostics
      .io_error("E0301", {},
                error ? fmt::format("cannot read `{}`: {}", path, error.message())
                : bytes > kMostBytes
                    ? fmt::format("`{}` is too large for a page: {} MB", path, bytes / 1'000'000)
                    : fmt::format("`{}` is no module of WebAssembly", path))
      .help = "remove the folder that it lies in, and build it again";
  return std::nullopt;
}

std::optional<std::string> page_text(const std::string& folder, const PageContents& contents,
                                     Diagnostics& diagnostics) {
  auto text = read_part(std::filesystem::path(folder) / "report.html", diagnostics);
  if (text) {
    const bool simulates = contents.module.has_value();
    replace(*text, "@plots@", simulates || contents.is_live ? kPlots : "");
    replace(*text, "@simulation@", simulates ? kSimulation : "");
    replace(*text, "@stream@", contents.is_live ? kStream : "");
    // Compiling a module counts as evaluating text; nothing else is allowed with it.
    replace(*text, "@wasm@", simulates ? " 'wasm-unsafe-eval'" : "");
    replace(*text, "@connect@", contents.is_live ? "; connect-src 'self'" : "");
  }
  if (text) text = with_included(std::move(*text), folder, diagnostics);
  if (!text) return std::nullopt;
  const std::string style = sha256_base64(element(*text, "style"));
  const std::string script = sha256_base64(element(*text, "script"));
  replace(*text, "@style-hash@", style);
  replace(*text, "@script-hash@", script);
  replace(*text, "@data@", for_markup(dump_json(page_json(contents))));
  return text;
}

}  // namespace eagerx::gen
