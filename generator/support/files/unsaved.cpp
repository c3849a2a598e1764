#include "generator/support/files/unsaved.hpp"

#include <filesystem>
#include <map>
#include <utility>

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string>& texts() {
  static std::map<std::string, std::string> all;
  return all;
}

std::string whole(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return (error ? fs::path(path) : absolute).lexically_normal().string();
}

}  // namespace

void set_unsaved(const std::string& path, std::optional<std::string> text) {
  if (text) {
    texts()[whole(path)] = std::move(*text);
  } else {
    texts().erase(whole(path));
  }
}

std::optional<std::string> unsaved_text(const std::string& path) {
  if (texts().empty()) return std::nullopt;
  const auto found = texts().find(whole(path));
  return found != texts().end() ? std::optional(found->second) : std::nullopt;
}

}  // namespace eagerx::gen
