// The template, its content policy, and the data in it.
#include <fmt/format.h>

#include <filesystem>

#include "generator/tools/page/modules.hpp"
#include "generator/tools/page/page.hpp"

namespace eagerx::gen {
namespace {

void replace(std::string& text, std::string_view what, std::string_view with) {
  const std::size_t at = text.find(what);
  if (at != std::string::npos) text.replace(at, what.size(), with);
}

/// The modules that a page begins with. Those that only some pages have put their views into the
/// table of views.mjs, so main.mjs comes last.
std::vector<std::string> entries_of(const PageContents& contents) {
  std::vector<std::string> entries;
  if (contents.module) entries.emplace_back("simulation_view.mjs");
  if (contents.is_live) entries.emplace_back("stream_view.mjs");
  if (contents.training) entries.emplace_back("training_view.mjs");
  if (contents.loops) entries.emplace_back("loop_view.mjs");
  entries.emplace_back("main.mjs");
  return entries;
}

/// The text between the first `<name>` and its end.
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
                    : fmt::format("`{}` is not a module of WebAssembly", path))
      .help = "remove its folder and build it again";
  return std::nullopt;
}

std::optional<std::string> page_text(const std::string& folder, const PageContents& contents,
                                     Diagnostics& diagnostics) {
  const PageForm form{entries_of(contents), contents.module.has_value(), contents.is_live};
  return page_of(folder, form, page_json(contents), diagnostics);
}

std::optional<std::string> page_of(const std::string& folder, const PageForm& form,
                                   const Json& data, Diagnostics& diagnostics) {
  const std::filesystem::path here = folder;
  auto text = read_part(here / "page.html", diagnostics);
  const auto style = text ? read_part(here / "page.css", diagnostics) : std::nullopt;
  const auto script = style ? joined_modules(here, form.entries, diagnostics) : std::nullopt;
  if (!script) return std::nullopt;
  replace(*text, "@style@", *style);
  replace(*text, "@script@", *script);
  // Compiling a module counts as evaluating text; nothing else is allowed with it.
  replace(*text, "@wasm@", form.runs_module ? " 'wasm-unsafe-eval'" : "");
  replace(*text, "@connect@", form.connects ? "; connect-src 'self'" : "");
  const std::string style_hash = sha256_base64(element(*text, "style"));
  const std::string script_hash = sha256_base64(element(*text, "script"));
  replace(*text, "@style-hash@", style_hash);
  replace(*text, "@script-hash@", script_hash);
  replace(*text, "@data@", for_markup(dump_json(data)));
  return text;
}

}  // namespace eagerx::gen
