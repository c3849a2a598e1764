// Mustache whose silent failures are errors.
#pragma once

#include <algorithm>
#include <kainjow/mustache.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// kainjow's data, whose members and elements are moved instead of copied: copies of copies are a
/// third of the work for a large graph.
class View : public kainjow::mustache::data {
  using Data = kainjow::mustache::data;
  using Elements = kainjow::mustache::list;

 public:
  using Data::Data;
  View() = default;
  View(const Data& data) : Data(data) {}
  View(Data&& data) : Data(std::move(data)) {}

  void set(const std::string& name, View value) { (*this)[name] = std::move(value); }
  void push_back(View value) {
    // Data gives no other access, and its move may throw, so that vector would copy what it has.
    auto& elements = const_cast<Elements&>(list_value());
    if (elements.size() == elements.capacity()) grow(elements);
    elements.push_back(std::move(value));
  }

 private:
  static void grow(Elements& elements) {
    Elements larger;
    larger.reserve(std::max<std::size_t>(4, 2 * elements.size()));
    for (Data& element : elements) larger.push_back(std::move(element));
    elements.swap(larger);
  }
};

inline View object() {
  return View(View::type::object);
}
inline View list() {
  return View(View::type::list);
}

/// A list of items `line`.
inline View lines_view(const std::vector<std::string>& lines) {
  View view = list();
  for (const std::string& line : lines) {
    View item = object();
    item.set("line", line);
    view.push_back(std::move(item));
  }
  return view;
}

/// For a section that is left out where there is no text.
inline View text_or_false(const std::string& text) {
  return text.empty() ? View(false) : View(text);
}

/// A section whose lines are indented by two more columns.
View indented();

/// Renders the template file for the file `output`; `{{>NAME}}` includes NAME.mustache next to it.
/// `{{NAME}}` is escaped for its place in the language of `output` (quote/language.hpp);
/// `{{{NAME}}}` is not escaped, for lines and tables that the generator itself made. A template
/// that cannot be read, does not parse, names a key that the view lacks, or has a value in an
/// invalid place is an error (E0501).
std::optional<std::string> render_file(const std::string& path, const std::string& output,
                                       const View& view, Diagnostics& diagnostics);

}  // namespace eagerx::gen
