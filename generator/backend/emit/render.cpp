#include "generator/backend/emit/render.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "generator/frontend/spec/format.hpp"
#include "generator/support/quote/language.hpp"

namespace eagerx::gen {
namespace {

// Stands in empty lines until the text is rendered: after a tag, kainjow would take them for the
// tag's own.
constexpr char kEmptyLine = '\x01';

/// Where a tag begins that is alone on its line; npos if there is none.
std::size_t begin_of_lone_tag(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  const bool is_tag = begin != std::string::npos && line.compare(begin, 2, "{{") == 0 &&
                      line.size() > begin + 2 &&
                      std::string_view("#/^>").find(line[begin + 2]) != std::string_view::npos &&
                      line.find("}}") == line.size() - 2;
  return is_tag ? begin : std::string::npos;
}

/// A template with those that it includes, `{{>NAME}}` on a line of its own: NAME.mustache next to
/// it. (kainjow parses a partial anew wherever it is rendered: three quarters of the time for 1,000
/// nodes.) Another tag alone on its line leaves nothing behind, neither its indentation nor the end
/// of its line. (kainjow keeps the line of a section that is not rendered.)
class TemplateReader {
 public:
  explicit TemplateReader(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  /// nullopt with a problem.
  std::optional<std::string> read(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream lines;
    lines << file.rdbuf();
    constexpr std::size_t kDeepest = 8;
    if (!file || ++depth_ > kDeepest) {
      const char* what =
          file ? "the template `{}` includes itself" : "cannot read the template `{}`";
      diagnostics_.io_error("E0501", {}, fmt::format(fmt::runtime(what), path.string()));
      return std::nullopt;
    }
    std::string result;
    for (std::string line; std::getline(lines, line);) {
      const std::size_t tag = begin_of_lone_tag(line);
      if (tag == std::string::npos) {
        result += line.empty() ? std::string(1, kEmptyLine) + "\n" : line + "\n";
      } else if (line[tag + 2] != '>') {
        result += line.substr(tag);
      } else {
        const std::string name = line.substr(tag + 3, line.size() - tag - 5);
        const auto text = read(path.parent_path() / (name + ".mustache"));
        if (!text) return std::nullopt;
        result += *text;
      }
    }
    --depth_;
    return result;
  }

 private:
  Diagnostics& diagnostics_;
  std::size_t depth_ = 0;
};

// Around the number of a value, until it is known where it stands. No template has these.
constexpr char kValue = '\x04';
constexpr char kValueEnd = '\x05';

/// Values on their way through mustache, which knows no place.
class Values {
 public:
  std::string keep(const std::string& value) {
    values_.push_back(value);
    return kValue + std::to_string(values_.size() - 1) + kValueEnd;
  }

  /// The text with the values in it. `refused`: the first that cannot stand where it is.
  std::string place(std::string_view text, Language language,
                    std::optional<std::string>& refused) const {
    Quoter quoter(language);
    while (!text.empty()) {
      const std::size_t begin = std::min(text.find(kValue), text.size());
      quoter.add(text.substr(0, begin));
      text.remove_prefix(begin);
      if (text.empty()) break;
      const std::size_t end = text.find(kValueEnd);
      std::size_t number = 0;
      std::from_chars(text.data() + 1, text.data() + end, number);
      if (!quoter.add_value(values_.at(number)) && !refused) refused = values_[number];
      text.remove_prefix(end + 1);
    }
    return quoter.take();
  }

 private:
  std::vector<std::string> values_;
};

class CheckingContext : public kainjow::mustache::context<std::string> {
 public:
  explicit CheckingContext(const View* view) : context<std::string>(view) {}
  const kainjow::mustache::data* get(const std::string& name) const override {
    const auto* found = context<std::string>::get(name);
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

std::optional<std::string> render_file(const std::string& path, const std::string& output,
                                       const View& view, Diagnostics& diagnostics) {
  const auto text = TemplateReader(diagnostics).read(path);
  if (!text) return std::nullopt;
  kainjow::mustache::mustache parsed(*text);
  if (!parsed.is_valid()) {
    diagnostics.error("E0501", {},
                      fmt::format("the template `{}` is wrong: {}", path, parsed.error_message()));
    return std::nullopt;
  }
  Values values;
  parsed.set_custom_escape([&values](const std::string& value) { return values.keep(value); });
  CheckingContext context(&view);
  std::string rendered = parsed.render(context);
  std::erase(rendered, kEmptyLine);
  if (!context.missing().empty()) {
    diagnostics.error("E0501", {},
                      fmt::format("the template `{}` names `{}`, which does not exist", path,
                                  *context.missing().begin()));
    return std::nullopt;
  }
  std::optional<std::string> refused;
  std::string result = values.place(rendered, language_of(output), refused);
  if (refused) {
    diagnostics
        .error("E0501", {},
               fmt::format("the template `{}` has `{}` where only a name can stand", path,
                           shortened(*refused)))
        .help = "put quotes around the tag";
    return std::nullopt;
  }
  return result;
}

}  // namespace eagerx::gen
