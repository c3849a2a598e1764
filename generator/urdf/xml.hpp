// A strict XML reader whose elements know their places.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "generator/frontend/read/locator.hpp"
#include "models/engines/open_dynamics_engine/rotation.hpp"

namespace eagerx::urdf {

using Names = std::initializer_list<std::string_view>;

/// The allowed contents of an element.
struct Contents {
  Names attributes = {};
  Names once = {};    // elements
  Names many = {};    // elements that may be there several times
  Names unseen = {};  // elements that do not change the motion
  // Left out with a note:
  Names ignored_attributes = {};
  Names ignored = {};  // elements
};

/// Reads one file. Everything that is wrong becomes a diagnostic with its place. Elements and
/// attributes of other tools are left out; a name close to a known one is taken for a mistake.
class Xml {
 public:
  Xml(gen::FileId file, std::string_view text, gen::Diagnostics& diagnostics)
      : locator_(file, text), diagnostics_(diagnostics) {}

  /// The only element at the top, if its name is one of these; else nothing (E0850).
  pugi::xml_node parse(pugi::xml_document& document, Names names);

  [[nodiscard]] gen::Span span(pugi::xml_node element) const;
  [[nodiscard]] gen::Span span(pugi::xml_node element, const char* attribute) const;

  /// Everything in the element is one of `contents`, and not too often, or of another tool.
  void check(pugi::xml_node element, const Contents& contents);
  /// Reports the elements that check() left out: one note for those that do not change the motion,
  /// one warning (E0851) for the rest.
  void report_left_out();
  /// Of another file of the same robot.
  void report_with(const Xml& other);

  /// An element inside that has to be there (E0852).
  pugi::xml_node child(pugi::xml_node element, const char* name);
  /// An attribute that has to be there and not empty (E0852).
  std::string text(pugi::xml_node element, const char* attribute);
  /// A finite number (E0853), `fallback` if it is not there; without a fallback it has to be.
  double number(pugi::xml_node element, const char* attribute,
                std::optional<double> fallback = std::nullopt);
  /// The same of three numbers with blanks between them.
  models::Vector3 vector(pugi::xml_node element, const char* attribute,
                         std::optional<models::Vector3> fallback = std::nullopt);
  /// Three numbers as a vector of length 1 (E0853).
  models::Vector3 direction(pugi::xml_node element, const char* attribute);
  /// Three numbers, or one for all three; 1 without the attribute.
  models::Vector3 scale(pugi::xml_node element, const char* attribute);
  /// As many numbers as there are, at most `most` (E0853).
  std::vector<double> numbers(pugi::xml_node element, const char* attribute, std::size_t most);
  /// A number that has to be positive (E0853), or at least not negative.
  double positive(pugi::xml_node element, const char* attribute);
  double not_negative(pugi::xml_node element, const char* attribute, double fallback);

  gen::Diagnostic& warning(const char* code, gen::Span span, std::string message) {
    return diagnostics_.warning(code, span, std::move(message));
  }
  gen::Diagnostic& error(const char* code, gen::Span span, std::string message) {
    return diagnostics_.error(code, span, std::move(message));
  }

 private:
  void check_attributes(pugi::xml_node element, const Contents& contents);
  void check_child(pugi::xml_node element, pugi::xml_node child, const Contents& contents);
  void leave_out(std::string name, gen::Span place, bool is_harmless);
  bool is_missing(pugi::xml_node element, const char* attribute, bool optional);
  [[nodiscard]] std::size_t offset_of(pugi::xml_node element) const;

  struct LeftOut {
    std::size_t count = 0;
    gen::Span first;
  };
  using LeftOutItems = std::map<std::string, LeftOut>;
  static std::string list(const LeftOutItems& items);

  LeftOutItems harmless_, unknown_;
  gen::Locator locator_;
  gen::Diagnostics& diagnostics_;
};

}  // namespace eagerx::urdf
