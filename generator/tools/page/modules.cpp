#include "generator/tools/page/modules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <string_view>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// `./NAME` of `import {a, b} from "./NAME";` or `import "./NAME";`; empty if it is no such text.
std::string_view imported_by(std::string_view statement) {
  constexpr std::string_view kImport = "import ", kEnd = "\";", kFrom = "} from ";
  if (!statement.ends_with(kEnd) || statement.find(" as ") != std::string_view::npos) return {};
  statement.remove_suffix(kEnd.size());
  const std::size_t quote = statement.find('"');
  if (quote == std::string_view::npos) return {};
  const std::string_view before = statement.substr(kImport.size(), quote - kImport.size());
  if (!before.empty() && !(before.starts_with('{') && before.ends_with(kFrom))) return {};
  const std::string_view name = statement.substr(quote + 1);
  return name.starts_with('.') && name.find('"') == std::string_view::npos ? name
                                                                           : std::string_view();
}

class Joiner {
 public:
  explicit Joiner(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// False with a problem.
  bool add(const fs::path& path) {
    const auto [known, is_new] = is_done_.try_emplace(path, false);
    if (!is_new) return known->second || problem(path, "it imports itself in a circle");
    const auto text = read_part(path, diagnostics_);
    if (!text) return false;
    std::string own;
    if (!take_apart(path, *text, own)) return false;
    script_ += own;
    is_done_[path] = true;
    return true;
  }

  [[nodiscard]] const std::string& script() const { return script_; }

 private:
  /// Adds what it imports; `own` is what is left.
  bool take_apart(const fs::path& path, std::string_view text, std::string& own) {
    while (!text.empty()) {
      const std::size_t newline = std::min(text.find('\n'), text.size());
      std::string_view line = text.substr(0, newline);
      if (line.starts_with("import ")) {
        line = text.substr(0, std::min(text.find(';'), text.size() - 1) + 1);
        const std::string_view name = imported_by(line);
        if (name.empty())
          return problem(path, fmt::format("`{}` has another form than `import {{a}} from "
                                           "\"./b.mjs\";`",
                                           line.substr(0, newline)));
        if (!add((path.parent_path() / name).lexically_normal())) return false;
      } else if (line.starts_with("export ")) {
        const std::string_view declared = line.substr(std::string_view("export ").size());
        constexpr std::array kDeclarations = {"function ", "const ", "let ", "class ",
                                              "async function "};
        if (ranges::none_of(kDeclarations,
                            [&](const char* word) { return declared.starts_with(word); }))
          return problem(path, fmt::format("`{}` is not an `export` before a declaration", line));
        own += fmt::format("{}\n", declared);
      } else {
        own += fmt::format("{}\n", line);
      }
      text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return true;
  }

  bool problem(const fs::path& path, const std::string& what) {
    diagnostics_.io_error("E0301", {}, fmt::format("cannot read `{}`: {}", path.string(), what));
    return false;
  }

  Diagnostics& diagnostics_;
  std::map<fs::path, bool> is_done_;
  std::string script_;
};

}  // namespace

std::optional<std::string> read_part(const fs::path& path, Diagnostics& diagnostics) {
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file && !file.bad()) return text;
  diagnostics.io_error("E0301", {},
                       fmt::format("cannot read `{}`: {}", path.string(), std::strerror(errno)));
  return std::nullopt;
}

std::optional<std::string> joined_modules(const fs::path& folder,
                                          const std::vector<std::string>& entries,
                                          Diagnostics& diagnostics) {
  Joiner joiner(diagnostics);
  for (const std::string& entry : entries)
    if (!joiner.add((folder / entry).lexically_normal())) return std::nullopt;
  return joiner.script();
}

}  // namespace eagerx::gen
