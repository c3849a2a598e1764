#include "generator/size/program_map.hpp"

#include <fstream>
#include <regex>

namespace eagerx::gen {

namespace {}  // namespace

std::string ProgramMap::owner_of_member(const std::string& member) const {
  if (const auto node = node_of_member.find(member); node != node_of_member.end())
    return node->second;
  if (member.ends_with("_simulator_")) return "simulators";
  return is_ring.contains(member) ? "rings" : "schedule";
}

ProgramMap read_program_map(const std::string& path) {
  static const std::regex kHead(R"(^( *)// ([^ :]+): (\w+), [^ ]+:\d+:\d+$)");
  static const std::regex kCall(R"((\w+)\.callback\()");
  static const std::regex kMember(R"(^  [^/].* (\w+_)(\[\w+\])?\{?.*;.*$)");
  ProgramMap map;
  std::ifstream file(path);
  std::string node, end;
  bool messages = false;
  std::smatch match;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (line.size() > kMaxLine) continue;
    if (std::regex_match(line, match, kHead)) {
      node = match[2];
      end = match[1].str() + "}";
      map.type_of_node[node] = match[3];
    }
    if (!node.empty()) {
      map.node_of_line[number] = node;
      if (std::regex_search(line, match, kCall)) map.node_of_member[match[1]] = node;
      if (line == end) node.clear();
      continue;
    }
    if (line.find("// Messages:") != std::string::npos) messages = true;
    if (line.empty()) messages = false;
    if (messages && std::regex_match(line, match, kMember)) map.is_ring[match[1]] = true;
  }
  return map;
}

}  // namespace eagerx::gen
