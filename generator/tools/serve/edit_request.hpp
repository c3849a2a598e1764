// The edits that a page asks for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/support/diagnostics/diagnostics.hpp"
#include "generator/support/json/json.hpp"
#include "generator/tools/edit/structure.hpp"

namespace eagerx::gen::serve {

/// The changes of a request, one after the other, as one; or why there is none.
struct Edited {
  Edit edit = {};         // of the whole, with one splice
  std::string text = {};  // what it makes
  int status = 200;       // of HTTP: 400 it is no edit, 422 it is impossible
  std::size_t index = 0;  // of the edit that is not possible
  std::string problem = {}, help = {};
};

/// `problems`: those of `text`, for edits that apply their help; `own`: the graph's file in them.
Edited edited(std::string_view text, const Json* edits, const std::vector<Diagnostic>& problems);

}  // namespace eagerx::gen::serve
