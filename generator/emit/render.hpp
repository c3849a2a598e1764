// Mustache, with its silent failures made loud.
#pragma once

#include <kainjow/mustache.hpp>
#include <optional>
#include <string>

#include "generator/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

using View = kainjow::mustache::data;
inline View object() {
  return View(View::type::object);
}
inline View list() {
  return View(View::type::list);
}

/// For a section that is left out where there is no text.
inline View text_or_false(const std::string& text) {
  return text.empty() ? View(false) : View(text);
}

/// A section whose lines are indented by two more columns.
View indented();

/// Renders the template file; `{{>NAME}}` includes NAME.mustache beside it. A template that cannot
/// be read, does not parse, or names a key that the view does not have is an error (E0501) instead
/// of an empty place in the output.
std::optional<std::string> render_file(const std::string& path, const View& view,
                                       Diagnostics& diagnostics);

}  // namespace eagerx::gen
