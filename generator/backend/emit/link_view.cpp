#include "generator/backend/emit/link_view.hpp"

namespace eagerx::gen {

void add_links(const ProgramNames& names, const LinkUse& use, const std::string& channel,
               View& view) {
  std::string from;
  if (use.from) {
    from = names.link_argument(*use.from);
    if (!from.empty() && !channel.empty()) from += channel + ", ";
  }
  view.set("link", from);
  View sends = list();
  for (const std::size_t part : use.to) {
    View item = object();
    item.set("link", names.link_argument(part));
    sends.push_back(std::move(item));
  }
  view["sends"] = std::move(sends);
}

}  // namespace eagerx::gen
