// A description in MJCF with the files that it includes and its classes of defaults.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/urdf/urdf.hpp"
#include "generator/urdf/xml.hpp"

namespace eagerx::urdf {

/// Defaults of attributes; missing ones come from its parent.
struct DefaultClass {
  std::string name;
  const DefaultClass* parent = nullptr;
  std::vector<pugi::xml_node> elements = {};  // `default`
};

/// All files of a description as one tree of elements.
class Document {
 public:
  Document(const std::string& path, Xml& xml, pugi::xml_node root, gen::SourceMap& sources,
           gen::Diagnostics& diagnostics);

  /// Of the file that the element is in.
  [[nodiscard]] Xml& xml(pugi::xml_node element) const;
  /// The elements inside, with those of other files instead of `include`.
  std::vector<pugi::xml_node> children(pugi::xml_node element);
  /// The elements of all sections with this name.
  std::vector<pugi::xml_node> section(const std::string& name);
  /// All sections.
  std::vector<pugi::xml_node> sections() { return children(root_); }
  [[nodiscard]] pugi::xml_node root() const { return root_; }
  [[nodiscard]] const std::string& folder() const { return folder_; }
  /// Whether there are too many elements, of which each looks at others. Of `place`: E0851.
  bool refuse_if_large(gen::Span place);

  /// Reads all `default`.
  void read_defaults();
  /// The class with this name (E0854).
  const DefaultClass* find_class(pugi::xml_node element, const char* attribute);
  /// The class whose defaults hold where no other one is named.
  [[nodiscard]] const DefaultClass* main_class() const { return &classes_.front(); }

  /// Once for each element.
  void check(pugi::xml_node element);

  /// Elements that were left out of all files.
  void report_left_out();

 private:
  struct File {
    pugi::xml_document document;
    std::optional<Xml> xml;
  };
  pugi::xml_node included(pugi::xml_node include);
  pugi::xml_node load(pugi::xml_node include, const std::string& name);
  void add_class(pugi::xml_node element, const DefaultClass* parent, std::size_t depth);

  std::string folder_;
  Xml& main_;
  pugi::xml_node root_;
  gen::SourceMap& sources_;
  gen::Diagnostics& diagnostics_;
  std::vector<std::unique_ptr<File>> files_;
  std::map<pugi::xml_node, pugi::xml_node> included_;
  std::size_t depth_ = 0;
  std::size_t elements_ = 0;  // of all files
  std::set<pugi::xml_node> checked_;
  std::deque<DefaultClass> classes_;
};

/// An element with the defaults of its class.
class Element {
 public:
  /// An element of the class that it names, otherwise of `around`, the `childclass` of its parent.
  Element(Document& document, pugi::xml_node own, const DefaultClass* around);

  [[nodiscard]] bool has(const char* attribute) const {
    return !!at(attribute).attribute(attribute);
  }
  [[nodiscard]] std::string text(const char* attribute) const {
    return at(attribute).attribute(attribute).value();
  }
  double number(const char* attribute, double fallback) const;
  double not_negative(const char* attribute, double fallback) const;
  Vector3 vector(const char* attribute, const Vector3& fallback) const;
  Vector3 direction(const char* attribute, const Vector3& fallback) const;
  std::vector<double> numbers(const char* attribute, std::size_t most) const;
  /// `true` or `false`; nothing for `auto` and where it is not there.
  [[nodiscard]] std::optional<bool> flag(const char* attribute) const;

  [[nodiscard]] pugi::xml_node node() const { return own_; }
  [[nodiscard]] std::string tag() const { return own_.name(); }
  [[nodiscard]] gen::Span span() const { return document_.xml(own_).span(own_); }
  [[nodiscard]] gen::Span span(const char* attribute) const;
  gen::Diagnostic& error(const char* code, gen::Span place, std::string message) const {
    return document_.xml(own_).error(code, place, std::move(message));
  }
  gen::Diagnostic& warning(const char* code, gen::Span place, std::string message) const {
    return document_.xml(own_).warning(code, place, std::move(message));
  }

 private:
  /// The element or default that contains the attribute; the element if none does.
  [[nodiscard]] pugi::xml_node at(const char* attribute) const;

  Document& document_;
  pugi::xml_node own_;
  std::vector<pugi::xml_node> defaults_ = {};  // of the nearest class first
};

/// Everything in the element, of any kind but a section, is known (E0851).
void check_known(Xml& xml, pugi::xml_node element);
/// The same for the contents of `mujoco`.
void check_sections(Xml& xml, pugi::xml_node root);
bool is_actuator(std::string_view tag);

}  // namespace eagerx::urdf
