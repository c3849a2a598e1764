#include "generator/graph/resolve/unresolved_graph.hpp"

#include <utility>

#include "generator/support/diagnostics/search.hpp"

namespace eagerx::gen {

UnresolvedInput* UnresolvedNode::input(std::string_view name) {
  return const_cast<UnresolvedInput*>(std::as_const(*this).input(name));
}

const UnresolvedInput* UnresolvedNode::input(std::string_view name) const {
  const auto found = ranges::find_if(
      inputs, [&](const UnresolvedInput& i) { return i.name == name && !i.feedthrough; });
  return found == inputs.end() ? nullptr : &*found;
}

UnresolvedOutput* UnresolvedNode::output(std::string_view name) {
  return find_named(outputs, name);
}

void UnresolvedGraph::add_object(UnresolvedObject object) {
  object_of_name.try_emplace(object.name, objects.size());
  objects.push_back(std::move(object));
}

const UnresolvedObject* UnresolvedGraph::find_object(std::string_view name) const {
  const auto found = object_of_name.find(name);
  return found == object_of_name.end() ? nullptr : &objects[found->second];
}

bool UnresolvedGraph::is_doubtful(const UnresolvedNode& node) const {
  return erroneous.contains(node.node.object ? objects[*node.node.object].name : node.node.name);
}

}  // namespace eagerx::gen
