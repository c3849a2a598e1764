// Builds the tree from yaml-cpp's events, and checks everything that yaml-cpp accepts.
#pragma once

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/mark.h>

#include <cstddef>
#include <string>
#include <unordered_map>
#include <vector>

#include "generator/frontend/read/locator.hpp"
#include "generator/frontend/read/tree.hpp"
#include "generator/support/diagnostics/diagnostics.hpp"

namespace eagerx::gen {

/// Thrown through yaml-cpp after an error that makes going on pointless; caught where the parser is
/// called. yaml-cpp has no other way of being stopped.
struct StopReading {};

/// A collection that is being read.
struct OpenCollection {
  Span span;
  bool flow = false;  // [] or {}
  bool map = false;
};

class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(const Locator& locator, Tags tags, const ReadLimits& limits,
              Diagnostics& diagnostics);

  void OnDocumentStart(const YAML::Mark& mark) override;
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override;
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override;
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override;
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override;
  void OnMapEnd() override { close(); }
  void OnAnchor(const YAML::Mark& mark, const std::string& name) override;

  /// The document; null when there was none.
  YamlValue take_root() { return std::move(root_); }
  /// The innermost collection not closed yet, for messages about syntax; nullptr at the top.
  [[nodiscard]] const OpenCollection* innermost() const;
  [[nodiscard]] const std::vector<std::string>& anchor_names() const { return anchor_names_; }

 private:
  /// A finished value, and the cost of a copy.
  struct Built {
    YamlValue yaml;
    std::size_t values = 1;
    std::size_t bytes = 0;   // of texts, tags and keys
    std::size_t height = 0;  // levels of collections
  };

  /// A collection under construction.
  struct Frame {
    Built built;
    OpenCollection open;
    YAML::anchor_t anchor = 0;
    bool has_key = false;     // maps: what comes next belongs to it
    bool key_usable = false;  // else the value is read and dropped
    std::string key;
    Span key_span;
    std::unordered_map<std::string, Span> seen;  // keys so far
  };

  [[nodiscard]] bool key_expected() const;
  void open(YamlKind kind, const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
            YAML::EmitterStyle::value style);
  void close();
  /// Puts a finished value where it belongs: root, item, key or value.
  void attach(Built built, YAML::anchor_t anchor);
  /// In yaml-cpp, an unclosed quoted text continues to the end of the file.
  void check_closed(std::size_t begin);
  void report_bad_key(const YamlValue& key);
  void take_key(Frame& map, const YamlValue& key);
  void take_value(Frame& map, Built built);
  [[nodiscard]] Span implicit_null_span(std::size_t offset) const;
  /// The tag of a value in full; reports it where tags are refused.
  std::string checked_tag(const Properties& properties, const std::string& tag);
  void charge(std::size_t values, std::size_t bytes, const Span& span);
  void check_depth(std::size_t depth, const Span& span);
  Diagnostic& report(const char* code, const Span& span, std::string message);

  const Locator& locator_;
  Tags tags_;
  ReadLimits limits_;
  Diagnostics& diagnostics_;
  std::size_t first_error_;
  YamlValue root_;
  std::vector<Frame> frames_;
  std::unordered_map<YAML::anchor_t, Built> anchors_;  // finished ones
  std::vector<std::string> anchor_names_;
  std::size_t documents_ = 0;
  std::size_t values_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace eagerx::gen
