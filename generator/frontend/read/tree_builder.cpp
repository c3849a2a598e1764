#include "generator/frontend/read/tree_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace eagerx::gen {
namespace {

constexpr std::size_t kMaxErrors = 100;   // of one file; past them it is stopped
constexpr std::size_t kMaxExpansion = 4;  // texts after aliases, in multiples of the size limit

std::size_t offset_of(const YAML::Mark& mark) {
  return static_cast<std::size_t>(mark.pos);
}

}  // namespace

TreeBuilder::TreeBuilder(const Locator& locator, Tags tags, const ReadLimits& limits,
                         Diagnostics& diagnostics)
    : locator_(locator),
      tags_(tags),
      limits_(limits),
      diagnostics_(diagnostics),
      first_error_(diagnostics.error_count()) {}

Diagnostic& TreeBuilder::report(const char* code, const Span& span, std::string message) {
  if (diagnostics_.error_count() - first_error_ >= kMaxErrors) throw StopReading();
  return diagnostics_.error(code, span, std::move(message));
}

const OpenCollection* TreeBuilder::innermost() const {
  return frames_.empty() ? nullptr : &frames_.back().open;
}

bool TreeBuilder::key_expected() const {
  return !frames_.empty() && frames_.back().open.map && !frames_.back().has_key;
}

void TreeBuilder::charge(std::size_t values, std::size_t bytes, const Span& span) {
  values_ += values;
  bytes_ += bytes;
  if (values_ > limits_.max_values) {
    report("E0110", span, fmt::format("the file has more than {} values", limits_.max_values))
        .help = "every use of an alias counts as a copy";
    throw StopReading();
  }
  if (bytes_ > kMaxExpansion * limits_.max_bytes) {
    report("E0110", span, "the aliases of this file expand to too much text");
    throw StopReading();
  }
}

void TreeBuilder::check_depth(std::size_t depth, const Span& span) {
  if (depth <= limits_.max_depth) return;
  report("E0110", span, fmt::format("nested deeper than {} levels", limits_.max_depth));
  throw StopReading();
}

void TreeBuilder::OnDocumentStart(const YAML::Mark& mark) {
  if (++documents_ == 1) return;
  const std::size_t offset = offset_of(mark);
  const std::string_view rest = locator_.text().substr(std::min(offset, locator_.text().size()));
  const bool marked = rest.starts_with("---");
  const Span span = locator_.span(locator_.word(offset));
  if (marked) {
    report("E0107", span, "a second document begins here").help =
        "a file can have only one document: remove `---` and the text after it, or use two files";
  } else {
    Diagnostic& error = report("E0105", span, "the document ended before this");
    error.label = "does not belong to anything";
    error.help = "check the indentation of this line and the brackets before it";
  }
  throw StopReading();
}

void TreeBuilder::OnAnchor(const YAML::Mark& /*mark*/, const std::string& name) {
  constexpr std::size_t kMaxNames = 1000;  // they are only kept for suggestions
  if (anchor_names_.size() < kMaxNames) anchor_names_.push_back(name);
}

std::string TreeBuilder::checked_tag(const Properties& properties, const std::string& tag) {
  if (properties.tag.begin == properties.tag.end) return {};
  if (tags_ == Tags::refuse) {
    const std::string_view written =
        locator_.text().substr(properties.tag.begin, properties.tag.end - properties.tag.begin);
    report("E0108", locator_.span(properties.tag),
           fmt::format("tag `{}` has no meaning here", written))
        .help = {"leave the tag out", leave_out("Leave the tag out")};
  }
  return tag;
}

/// The mark of a null that is not written out is that of the next token: point at the key or the
/// dash.
Span TreeBuilder::implicit_null_span(std::size_t offset) const {
  if (frames_.empty()) return locator_.span({offset, offset});
  const Frame& frame = frames_.back();
  if (frame.open.map && frame.has_key) return frame.key_span;
  if (!frame.open.map && !frame.open.flow) {
    const std::size_t dash = locator_.dash_before(offset);
    return dash == std::string_view::npos ? frame.open.span : locator_.span({dash, dash + 1});
  }
  return locator_.span({offset, offset + 1});
}

void TreeBuilder::OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const Extent written = locator_.null_at(locator_.properties(offset_of(mark)).content);
  // If this value is empty, the text at the mark may be the next key.
  const bool explicit_null =
      written.end > written.begin && (key_expected() || !locator_.colon_follows(written.end));
  Built built;
  if (explicit_null) {
    built.yaml.span = locator_.span(written);
    built.yaml.text = locator_.text().substr(written.begin, written.end - written.begin);
  } else {
    built.yaml.span = implicit_null_span(offset_of(mark));
  }
  charge(1, 0, built.yaml.span);
  attach(std::move(built), anchor);
}

void TreeBuilder::OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                           const std::string& value) {
  const Properties properties = locator_.properties(offset_of(mark));
  const Extent extent = locator_.scalar(properties, value);
  check_closed(extent.begin);
  constexpr std::string_view kNotPlain = "'\"|>";
  Built built;
  built.yaml.kind = YamlKind::scalar;
  built.yaml.span = locator_.span(extent);
  built.yaml.tag = checked_tag(properties, tag);
  built.yaml.text = value;
  built.yaml.quoted = extent.begin < extent.end &&
                      kNotPlain.find(locator_.text()[extent.begin]) != std::string_view::npos;
  built.bytes = value.size() + built.yaml.tag.size();
  charge(1, built.bytes, built.yaml.span);
  attach(std::move(built), anchor);
}

void TreeBuilder::check_closed(std::size_t begin) {
  const std::string_view text = locator_.text();
  const bool quoted = begin < text.size() && (text[begin] == '"' || text[begin] == '\'');
  if (!quoted || locator_.quoted_end(begin) != std::string_view::npos) return;
  report("E0105", locator_.span({begin, begin + 1}), "the quotation mark is never closed").label =
      "opened here";
  throw StopReading();
}

void TreeBuilder::OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) {
  const std::size_t offset = offset_of(mark);
  const Extent extent = locator_.word(offset);
  const Span span = locator_.span(extent);
  const std::string_view written = locator_.text().substr(offset, extent.end - offset);
  if (key_expected()) {
    report("E0111", span, fmt::format("alias `{}` cannot be a key", written)).help =
        "write the key out";
    attach(Built(), 0);
    return;
  }
  const auto found = anchors_.find(anchor);
  if (found == anchors_.end()) {
    report("E0109", span, fmt::format("`{}` refers to a value that contains it", written)).label =
        "this would never end";
    attach(Built(), 0);
    return;
  }
  check_depth(frames_.size() + found->second.height, span);
  charge(found->second.values, found->second.bytes, span);
  Built copy = found->second;
  copy.yaml.span = span;
  attach(std::move(copy), 0);
}

void TreeBuilder::OnSequenceStart(const YAML::Mark& mark, const std::string& tag,
                                  YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
  open(YamlKind::sequence, mark, tag, anchor, style);
}

void TreeBuilder::OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                             YAML::EmitterStyle::value style) {
  open(YamlKind::map, mark, tag, anchor, style);
}

void TreeBuilder::open(YamlKind kind, const YAML::Mark& mark, const std::string& tag,
                       YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
  const Properties properties = locator_.properties(offset_of(mark));
  Frame frame;
  frame.open.map = kind == YamlKind::map;
  frame.open.flow = style == YAML::EmitterStyle::Flow;
  const bool one_character = frame.open.flow || !frame.open.map;  // `[`, `{`, `-`
  const std::size_t begin = properties.content;
  frame.open.span = locator_.span(one_character ? Extent{begin, begin + 1} : locator_.word(begin));
  check_depth(frames_.size() + 1, frame.open.span);
  frame.built.yaml.kind = kind;
  frame.built.yaml.span = frame.open.span;
  frame.built.yaml.tag = checked_tag(properties, tag);
  frame.built.bytes = frame.built.yaml.tag.size();
  frame.built.height = 1;
  frame.anchor = anchor;
  charge(1, frame.built.bytes, frame.open.span);
  frames_.push_back(std::move(frame));
}

void TreeBuilder::close() {
  Frame frame = std::move(frames_.back());
  frames_.pop_back();
  attach(std::move(frame.built), frame.anchor);
}

void TreeBuilder::attach(Built built, YAML::anchor_t anchor) {
  if (anchor != 0) {
    // The copy counts: anchors inside anchors would otherwise multiply memory unseen.
    charge(built.values, built.bytes, built.yaml.span);
    anchors_[anchor] = built;
  }
  if (frames_.empty()) {
    root_ = std::move(built.yaml);
    return;
  }
  Frame& parent = frames_.back();
  parent.built.values += built.values;
  parent.built.bytes += built.bytes;
  parent.built.height = std::max(parent.built.height, built.height + 1);
  if (!parent.open.map) {
    parent.built.yaml.items.push_back(std::move(built.yaml));
  } else if (parent.has_key) {
    take_value(parent, std::move(built));
  } else {
    take_key(parent, built.yaml);
  }
}

void TreeBuilder::report_bad_key(const YamlValue& key) {
  if (!key.is_null()) {
    report("E0111", key.span, "a list or map cannot be a key").help =
        "put a text with brackets in quotes";
  } else if (key.text.empty()) {
    report("E0111", key.span, "a key is missing here").help = "write the key before `:`";
  } else {
    report("E0111", key.span,
           fmt::format("`{}` means nothing in YAML and cannot be a key", key.text))
        .help = {"put it in quotes", change_to(fmt::format("\"{}\"", key.text))};
  }
}

void TreeBuilder::take_key(Frame& map, const YamlValue& key) {
  map.has_key = true;
  map.key_usable = false;
  map.key_span = key.span;
  const bool first_of_block = map.seen.empty() && !map.open.flow && key.span.file != FileId::none;
  if (first_of_block && map.built.yaml.entries.empty()) map.built.yaml.span = key.span;
  if (key.span.file == FileId::none) return;  // an alias, reported already
  if (!key.is_scalar()) {
    report_bad_key(key);
    return;
  }
  if (key.text == "<<" && !key.quoted) {
    report("E0109", key.span, "merge keys are not supported").help =
        "copy the entries to this place";
    return;
  }
  if (key.text.find('\n') != std::string::npos) {
    report("E0111", key.span, "a text of several lines cannot be a key").help =
        "write the key on one line";
    return;
  }
  const auto [first, is_new] = map.seen.emplace(key.text, key.span);
  if (!is_new) {
    Diagnostic& error = report("E0104", key.span, fmt::format("key `{}` appears twice", key.text));
    error.notes.push_back({"the first one is here", first->second, "first"});
    // `{low: -1,5, high: 1,5}`
    const bool number =
        map.open.flow && key.text.find_first_not_of("0123456789") == std::string::npos;
    error.help = number ? "a number has a decimal point: a comma within `{…}` ends it"
                        : "remove or rename one of them";
    return;
  }
  map.key = key.text;
  map.key_usable = true;
}

void TreeBuilder::take_value(Frame& map, Built built) {
  map.has_key = false;
  if (!map.key_usable) return;
  map.built.yaml.entries.push_back({std::move(map.key), map.key_span, std::move(built.yaml)});
}

}  // namespace eagerx::gen
