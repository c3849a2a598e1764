#include "generator/emit/render.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <sstream>

namespace eagerx::gen {
namespace {

// Stands in empty lines until the text is rendered: after a tag, kainjow would take them for the
// tag's own.
constexpr char kEmptyLine = '\x01';

/// A tag alone on its line leaves nothing behind: not its indentation, not the end of its line.
/// (kainjow keeps the line of a section that is not rendered.)
std::string without_tag_lines(const std::string& text) {
  std::string result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = line.find_first_not_of(' ');
    const std::size_t end = line.find("}}");
    const bool tag = begin != std::string::npos && line.compare(begin, 2, "{{") == 0 &&
                     line.size() > begin + 2 &&
                     std::string_view("#/^>").find(line[begin + 2]) != std::string_view::npos &&
                     end == line.size() - 2;
    if (line.empty()) line = kEmptyLine;
    result += tag ? line.substr(begin) : line + "\n";
  }
  return result;
}

/// Text that is already C++ is written as it is; nothing here is HTML.
std::string as_is(const std::string& text) {
  return text;
}

class CheckingContext : public kainjow::mustache::context<std::string> {
 public:
  explicit CheckingContext(const View* view) : context<std::string>(view) {}
  const View* get(const std::string& name) const override {
    const View* found = context<std::string>::get(name);
    if (found == nullptr) missing_.insert(name);
    return found;
  }
  [[nodiscard]] const std::set<std::string>& missing() const { return missing_; }

 private:
  mutable std::set<std::string> missing_;
};

}  // namespace

View indented() {
  using kainjow::mustache::renderer;
  return View(kainjow::mustache::lambda2([](const std::string& text, const renderer& render) {
    std::string result;
    std::istringstream lines(render(text, false));
    for (std::string line; std::getline(lines, line);)
      result += (line.empty() || line.front() == kEmptyLine ? "" : "  ") + line + "\n";
    return result;
  }));
}

std::optional<std::string> read_template(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  if (!file) return std::nullopt;
  return without_tag_lines(text.str());
}

std::optional<std::string> render_file(const std::string& path, const View& view,
                                       Diagnostics& diagnostics) {
  const auto text = read_template(path);
  if (!text) {
    diagnostics.io_error("E0501", {}, fmt::format("cannot read the template `{}`", path));
    return std::nullopt;
  }
  kainjow::mustache::mustache parsed(*text);
  if (!parsed.is_valid()) {
    diagnostics.error("E0501", {},
                      fmt::format("the template `{}` is wrong: {}", path, parsed.error_message()));
    return std::nullopt;
  }
  parsed.set_custom_escape(as_is);
  CheckingContext context(&view);
  std::string result = parsed.render(context);
  std::erase(result, kEmptyLine);
  if (!context.missing().empty()) {
    diagnostics.error("E0501", {},
                      fmt::format("the template `{}` names `{}`, which there is not", path,
                                  *context.missing().begin()));
    return std::nullopt;
  }
  return result;
}

}  // namespace eagerx::gen
