// Changes of a text that fix a problem, created where the problem is found. frontend/outline lays
// them out, because it has the text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "generator/support/diagnostics/span.hpp"

namespace eagerx::gen {

/// One place that changes. Additions have the style of the lines around them.
struct FixEdit {
  enum class Kind : std::uint8_t {
    replace,     // what stands at `span` becomes `text`
    number,      // the same, where it is a number
    value,       // the list that begins at `span` becomes `text`
    remove,      // what stands at `span` goes, with the blanks behind it
    top_value,   // the value of the graph's key `name` becomes `text`
    missing,     // `name: text` is added to the map that begins at `span`
    connection,  // `name: text` is added to the connection around `span`
    parameter,   // `name:` is added to `config:` of the entity around `span`
    top_item,    // `text` is added to the graph's list `name`
    port,        // `text` is added to `name:` of the object or node `owner`
  };
  Kind kind = Kind::replace;
  std::string text = {};
  std::string name = {};
  std::string owner = {};
  Span span = {};  // without a file: where the problem is
};

struct Fix {
  std::string title;  // as a button would say it: "Change to `theta`"
  std::vector<FixEdit> edits;
  bool certain = false;  // else one of several, or with a place where something is to be written
};

/// The help: in words, and as changes of the text, the likeliest first.
struct Help {
  Help() = default;
  // NOLINTBEGIN(google-explicit-constructor): most helps are words only
  Help(std::string words) : text(std::move(words)) {}
  Help(const char* words) : text(words) {}
  // NOLINTEND(google-explicit-constructor)
  Help(std::string words, Fix fix) : text(std::move(words)) { fixes.push_back(std::move(fix)); }

  [[nodiscard]] bool empty() const { return text.empty(); }
  Help& operator+=(std::string_view words) {
    text += words;
    return *this;
  }

  std::string text;
  std::vector<Fix> fixes;
};

/// Replaces the wrong word.
Fix change_to(const std::string& word);
/// The word at `place`.
Fix change_word_to(const std::string& word, const Span& place);
/// Replaces a number with a guess at the intended one, if the text is a number.
Fix change_number_to(const std::string& number);
/// Replaces a list with one value.
Fix change_list_to(const std::string& value);
/// The graph's key `name` gets the value `text`.
Fix set_in_graph(const std::string& name, const std::string& text);
/// Removes the wrong text.
Fix leave_out(std::string title);
/// Adds `name: value` to the map that begins where the problem is; a rate is the graph's.
Fix add_key(const std::string& name);
/// Adds `key: value` to the connection where the problem is.
Fix add_to_connection(const std::string& key, const std::string& value);
/// Adds a parameter, whose value is left open, to the entity where the problem is.
Fix add_parameter(const std::string& name);
/// Adds a port (or a state) to `list:` of an object or a node.
Fix add_to_list(const std::string& port, const std::string& list, const std::string& owner);
/// Lets the connection at `place` take the message of the tick before.
Fix skip_at(const Span& place, const std::string& from, const std::string& to);
/// Takes a warning back, in this graph.
Fix allow_here(const std::string& code);

/// "did you mean `word`?"
Help meaning(const std::string& word);
/// "write `word`", followed by `why`.
Help write_instead(const std::string& word, std::string_view why = {});
/// "add a connection `connection`"; "…" is left for the user.
Help missing_connection(const std::string& connection);
/// The candidate nearest to `word` (Damerau-Levenshtein, at most a third of the letters wrong, case
/// ignored at no cost), or empty.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);
/// "did you mean `…`?" with the nearest one, or `otherwise`.
Help did_you_mean(std::string_view word, const std::vector<std::string>& candidates,
                  Help otherwise = {});
/// The nearest one, if it is meant, and `otherwise` if it is not: "did you mean `…`? If it is
/// another one, …".
Help did_you_mean_or(std::string_view word, const std::vector<std::string>& candidates,
                     const Help& otherwise);
/// did_you_mean(), or "available: A, B, C", or `none` if there are no candidates.
Help suggestion(std::string_view word, const std::vector<std::string>& candidates,
                const Help& none = {});

}  // namespace eagerx::gen
