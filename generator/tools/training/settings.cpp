#include "generator/tools/training/settings.hpp"

#include <algorithm>
#include <runtime/host/base/number.hpp>
#include <runtime/host/base/renamed.hpp>
#include <string>

#include "generator/support/diagnostics/search.hpp"
#include "targets/environments/options/train_settings.hpp"

namespace eagerx::gen {
namespace {

using eagerx::options::kTrainSettings;
using SettingRow = eagerx::options::Setting;

std::string_view without_blanks(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

/// 1e-05 is 0.00001.
bool are_equal(std::string_view a, std::string_view b) {
  double x = 0.0, y = 0.0;
  return a == b || (host::read_number(a, x) && host::read_number(b, y) && x == y);
}

}  // namespace

Json settings_json(std::string_view text, std::string_view algorithm) {
  Json list = Json::list();
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(';'), text.size());
    const std::string_view part = without_blanks(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t blank = std::min(part.find(' '), part.size());
    const std::string_view written = part.substr(0, blank);
    const std::string_view now = host::new_name(host::kTrainSettings, written);
    const std::string_view name = now.empty() ? written : now;
    const std::string_view value = without_blanks(part.substr(blank));
    const SettingRow* const row = ranges::find(kTrainSettings, name, &SettingRow::name);
    const bool is_known = row != std::end(kTrainSettings);
    if (name.empty() || (is_known && *row->algorithm != '\0' && row->algorithm != algorithm))
      continue;
    list.push_back(Json{{"name", std::string(name)},
                        {"value", std::string(value)},
                        {"default", is_known ? Json(row->otherwise) : Json(nullptr)},
                        {"differs", !is_known || !are_equal(value, row->otherwise)},
                        {"about", is_known ? row->about : ""}});
  }
  return list;
}

}  // namespace eagerx::gen
