// Mustache whose silent failures are errors.
#pragma once

#include <kainjow/mustache.hpp>
#include <optional>
#include <string>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

using View = kainjow::mustache::data;
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
    view.push_back(item);
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
