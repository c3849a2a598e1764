// XML with places, and strict about what is written.
#pragma once

#include <initializer_list>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>

#include "generator/frontend/read/locator.hpp"
#include "models/engines/open_dynamics_engine/rotation.hpp"

namespace eagerx::urdf {

using Names = std::initializer_list<std::string_view>;

/// What an element may contain.
struct Contents {
  Names attributes = {};
  Names once = {};    // elements
  Names many = {};    // elements that may be there several times
  Names unseen = {};  // elements that do not change the motion
  Names warned = {};  // elements that are left out with a warning
};

/// Reads one file. Everything that is wrong becomes a diagnostic with its place.
class Xml {
 public:
  Xml(gen::FileId file, std::string_view text, gen::Diagnostics& diagnostics)
      : locator_(file, text), diagnostics_(diagnostics) {}

  /// The only element at the top. Without a parent if there is no such thing (E0850).
  pugi::xml_node parse(pugi::xml_document& document);

  [[nodiscard]] gen::Span span(pugi::xml_node element) const;
  [[nodiscard]] gen::Span span(pugi::xml_node element, const char* attribute) const;

  /// Everything in the element is one of `contents`, and not too often.
  void check(pugi::xml_node element, const Contents& contents);

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
  /// A number that has to be positive (E0853), or at least not negative.
  double positive(pugi::xml_node element, const char* attribute);
  double not_negative(pugi::xml_node element, const char* attribute, double fallback);

  gen::Diagnostic& error(const char* code, gen::Span span, std::string message) {
    return diagnostics_.error(code, span, std::move(message));
  }

 private:
  void check_attributes(pugi::xml_node element, const Contents& contents);
  void check_child(pugi::xml_node element, pugi::xml_node child, const Contents& contents);
  bool is_missing(pugi::xml_node element, const char* attribute, bool optional);
  [[nodiscard]] std::size_t offset_of(pugi::xml_node element) const;

  gen::Locator locator_;
  gen::Diagnostics& diagnostics_;
};

}  // namespace eagerx::urdf
