#include "generator/urdf/mjcf_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "generator/frontend/read/text.hpp"

namespace eagerx::urdf {
namespace {

constexpr std::size_t kMaxIncludeBytes = 4'000'000;
constexpr std::size_t kMaxFiles = 100;
constexpr std::size_t kMaxDepth = 20;  // of files in files
constexpr std::size_t kMaxElements = 20'000;
constexpr std::size_t kMaxClasses = 100;  // in each other

/// Attributes that defaults for one kind of actuator give to all kinds.
constexpr std::string_view kOfAllActuators[] = {
    "ctrllimited", "forcelimited", "ctrlrange", "forcerange", "gear", "joint", "group"};

bool is_element(pugi::xml_node node) {
  return node.type() == pugi::node_element;
}

/// The element and all inside, however deep.
std::size_t elements_in(pugi::xml_node root) {
  std::size_t count = 0;
  for (pugi::xml_node at = root; at;) {
    if (is_element(at)) ++count;
    if (at.first_child()) {
      at = at.first_child();
      continue;
    }
    while (at && at != root && !at.next_sibling()) at = at.parent();
    at = at == root ? pugi::xml_node() : at.next_sibling();
  }
  return count;
}

std::string_view name_in_defaults(pugi::xml_node element) {
  const std::string_view tag = element.name();
  return tag == "fixed" || tag == "spatial" ? "tendon" : tag;
}

}  // namespace

Document::Document(const std::string& path, Xml& xml, pugi::xml_node root, gen::SourceMap& sources,
                   gen::Diagnostics& diagnostics)
    : folder_(std::filesystem::path(path).parent_path().string()),
      main_(xml),
      root_(root),
      sources_(sources),
      diagnostics_(diagnostics),
      elements_(elements_in(root)) {
  classes_.push_back({.name = "main"});
}

Xml& Document::xml(pugi::xml_node element) const {
  for (const auto& file : files_) {
    if (file->document == element.root()) return *file->xml;
  }
  return main_;
}

std::vector<pugi::xml_node> Document::children(pugi::xml_node element) {
  std::vector<pugi::xml_node> result;
  if (depth_ >= kMaxDepth) return result;
  for (const pugi::xml_node child : element.children()) {
    if (!is_element(child)) continue;
    if (std::string_view(child.name()) != "include") {
      result.push_back(child);
      continue;
    }
    ++depth_;
    const std::vector<pugi::xml_node> more = children(included(child));
    --depth_;
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

std::vector<pugi::xml_node> Document::section(const std::string& name) {
  std::vector<pugi::xml_node> result;
  for (const pugi::xml_node part : sections()) {
    if (part.name() != name) continue;
    const std::vector<pugi::xml_node> more = children(part);
    result.insert(result.end(), more.begin(), more.end());
  }
  return result;
}

pugi::xml_node Document::included(pugi::xml_node include) {
  const auto [at, is_new] = included_.try_emplace(include);
  if (!is_new) return at->second;
  Xml& in = xml(include);
  in.check(include, {.attributes = {"file", "prefix"}});
  const std::string name = in.text(include, "file");
  if (name.empty()) return {};
  if (files_.size() >= kMaxFiles || depth_ + 1 >= kMaxDepth) {
    in.error("E0854", in.span(include), "files include each other without end");
    return {};
  }
  const pugi::xml_node loaded = load(include, name);
  included_[include] = loaded;
  return loaded;
}

pugi::xml_node Document::load(pugi::xml_node include, const std::string& name) {
  const std::string path = (std::filesystem::path(folder_) / name).string();
  gen::LoadedFile read = gen::load_file(path, kMaxIncludeBytes);
  const gen::Span place = xml(include).span(include, "file");
  if (read.status != gen::LoadedFile::Status::loaded) {
    const bool large = read.status == gen::LoadedFile::Status::too_large;
    diagnostics_.io_error("E0101", place,
                          fmt::format("cannot read `{}`: {}", path,
                                      large ? "it is too large" : std::string(read.reason)));
    return {};
  }
  const gen::FileId id = sources_.add(path, gen::normalize_text(std::move(read.bytes)));
  if (!gen::check_text(sources_.text(id), id, diagnostics_)) return {};
  files_.push_back(std::make_unique<File>());
  File& file = *files_.back();
  file.xml.emplace(id, sources_.text(id), diagnostics_);
  const pugi::xml_node root = file.xml->parse(file.document, {"mujoco", "mujocoinclude"});
  elements_ += elements_in(root);
  return refuse_if_large(place) ? pugi::xml_node() : root;
}

bool Document::refuse_if_large(gen::Span place) {
  if (elements_ <= kMaxElements) return false;
  diagnostics_.error("E0851", place,
                     fmt::format("a description has at most {} elements", kMaxElements));
  return true;
}

void Document::read_defaults() {
  for (const pugi::xml_node part : sections()) {
    if (std::string_view(part.name()) == "default") add_class(part, nullptr, 0);
  }
}

void Document::add_class(pugi::xml_node element, const DefaultClass* parent, std::size_t depth) {
  if (depth > kMaxClasses) {
    xml(element).error("E0851", xml(element).span(element),
                       fmt::format("there are more than {} `default` in each other", kMaxClasses));
    return;
  }
  const std::string name = element.attribute("class").value();
  DefaultClass* here = nullptr;
  if (parent == nullptr) {
    here = &classes_.front();
    if (!name.empty()) here->name = name;
  } else {
    if (name.empty()) {
      xml(element).error("E0852", xml(element).span(element), "`default` has no attribute `class`");
      return;
    }
    const auto known = std::ranges::find(classes_, name, &DefaultClass::name);
    here = known != classes_.end() ? &*known : &classes_.emplace_back(DefaultClass{name, parent});
  }
  here->elements.push_back(element);
  for (const pugi::xml_node child : children(element)) {
    if (std::string_view(child.name()) == "default") {
      add_class(child, here, depth + 1);
    } else {
      check(child);
    }
  }
}

const DefaultClass* Document::find_class(pugi::xml_node element, const char* attribute) {
  const std::string name = element.attribute(attribute).value();
  const auto known = std::ranges::find(classes_, name, &DefaultClass::name);
  if (known != classes_.end()) return &*known;
  std::vector<std::string> names;
  for (const DefaultClass& one : classes_) names.push_back(one.name);
  xml(element)
      .error("E0854", xml(element).span(element, attribute),
             fmt::format("there is no class `{}` in `default`", name))
      .help = gen::did_you_mean(name, names);
  return main_class();
}

void Document::check(pugi::xml_node element) {
  if (checked_.insert(element).second) check_known(xml(element), element);
}

void Document::report_left_out() {
  for (const auto& file : files_) main_.report_with(*file->xml);
  main_.report_left_out();
}

Element::Element(Document& document, pugi::xml_node own, const DefaultClass* around)
    : document_(document), own_(own) {
  document.check(own);
  const std::string_view tag = name_in_defaults(own);
  const bool acts = is_actuator(tag);
  const DefaultClass* from = own.attribute("class") ? document.find_class(own, "class") : around;
  for (; from != nullptr; from = from->parent) {
    for (std::size_t i = from->elements.size(); i-- > 0;) {
      for (const pugi::xml_node one : document.children(from->elements[i])) {
        if (tag == one.name() || (acts && is_actuator(one.name()))) defaults_.push_back(one);
      }
    }
  }
}

pugi::xml_node Element::at(const char* attribute) const {
  if (own_.attribute(attribute)) return own_;
  const bool of_all = std::ranges::find(kOfAllActuators, attribute) != std::end(kOfAllActuators);
  for (const pugi::xml_node one : defaults_) {
    if (one.attribute(attribute) && (of_all || one.name() == name_in_defaults(own_))) return one;
  }
  return own_;
}

gen::Span Element::span(const char* attribute) const {
  const pugi::xml_node where = at(attribute);
  return document_.xml(where).span(where, attribute);
}

double Element::number(const char* attribute, double fallback) const {
  const auto list = numbers(attribute, 1);
  return list.empty() ? fallback : list[0];
}

double Element::not_negative(const char* attribute, double fallback) const {
  const double value = number(attribute, fallback);
  if (value < 0.0)
    error("E0853", span(attribute), fmt::format("`{}` cannot be negative", attribute));
  return value;
}

Vector3 Element::vector(const char* attribute, const Vector3& fallback) const {
  const pugi::xml_node where = at(attribute);
  return document_.xml(where).vector(where, attribute, fallback);
}

Vector3 Element::direction(const char* attribute, const Vector3& fallback) const {
  const pugi::xml_node where = at(attribute);
  if (!where.attribute(attribute)) return fallback;
  return document_.xml(where).direction(where, attribute);
}

std::vector<double> Element::numbers(const char* attribute, std::size_t most) const {
  const pugi::xml_node where = at(attribute);
  return document_.xml(where).numbers(where, attribute, most);
}

std::optional<bool> Element::flag(const char* attribute) const {
  const std::string word = text(attribute);
  if (word.empty() || word == "auto") return std::nullopt;
  if (word != "true" && word != "false")
    error("E0853", span(attribute),
          fmt::format("`{}` has to be `true`, `false` or `auto`, not `{}`", attribute, word));
  return word == "true";
}

}  // namespace eagerx::urdf
