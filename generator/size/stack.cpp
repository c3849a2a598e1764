// The stack bound: frames from the compiler (-fcallgraph-info=su), for libraries from their
// instructions; calls from the linked image.
#include "generator/size/stack.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "generator/size/tools.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct Function {
  std::uint64_t frame = 0;
  std::set<std::string> calls;
  bool through_pointer = false;
};
using Functions = std::map<std::string, Function>;

/// Lines are read with std::regex, which takes stack for every character.

/// 0 for what does not fit.
std::uint64_t number(const std::string& digits) {
  constexpr std::uint64_t kMost = 1U << 30U;
  const std::uint64_t value = std::strtoull(digits.c_str(), nullptr, 10);
  return value <= kMost ? value : 0;
}

/// Bytes a list of registers such as `{r4, r5, lr}` or `{s16-s19}` takes.
std::uint64_t bytes_of_registers(const std::string& list, bool vector) {
  std::uint64_t count = 0;
  static const std::regex kItem(R"(([a-z]+)(\d*)(-[a-z](\d+))?)");
  for (std::sregex_iterator item(list.begin(), list.end(), kItem), last; item != last; ++item) {
    const bool range = (*item)[4].matched;
    const std::uint64_t width = vector && (*item)[1] == "d" ? 8 : 4;
    const std::uint64_t first = number((*item)[2]);
    const std::uint64_t last_one = range ? number((*item)[4]) : first;
    count += width * (last_one >= first ? last_one - first + 1 : 1);
  }
  return count;
}

/// What an instruction takes from the stack. Adding up all of a function's is a bound for it.
std::uint64_t stack_taken(const std::string& text) {
  static const std::regex kPush(R"(^(v?)(push|stmdb\.?w?\s+sp!,|stmfd\s+sp!,)\S*\s*\{(.*)\})");
  static const std::regex kSub(R"(^subw?\S*\s+sp,.*#(\d+))");
  static const std::regex kStore(R"(^(str|strd)\S*\s.*\[sp, #-(\d+)\]!)");
  static const std::regex kRiscv(R"(^(c\.)?addi?(16sp)?\s+sp,sp,-(\d+))");
  std::smatch match;
  if (std::regex_search(text, match, kPush))
    return bytes_of_registers(match[3], match[1].length() > 0);
  if (std::regex_search(text, match, kSub)) return number(match[1]);
  if (std::regex_search(text, match, kStore)) return number(match[2]);
  if (std::regex_search(text, match, kRiscv)) return number(match[3]);
  return 0;
}

/// Functions, calls and frames as the disassembly shows them.
Functions read_disassembly(const std::string& prefix, const std::string& image) {
  static const std::regex kHead(R"(^[0-9a-f]+ <(.+)>:$)");
  static const std::regex kLine(R"(^\s*[0-9a-f]+:\s+(.*)$)");
  static const std::regex kCall(R"(^(bl?|b\.w|b\.n|j|jal|call|tail)\S*\s.*<([^+>]+)>)");
  static const std::regex kPointer(R"(^(blx\s+r|jalr|c\.jalr|bx\s+r))");
  Functions functions;
  Function* current = nullptr;
  std::string name;
  std::smatch match;
  for_each_line({prefix + "objdump", "-d", "--no-show-raw-insn", image},
                [&](std::string_view view) {
                  if (view.size() > kMaxLine) return;
                  std::string line(view);
                  if (std::regex_match(line, match, kHead) && match[1].str().starts_with(".L"))
                    return;
                  if (std::regex_match(line, match, kHead)) {
                    name = match[1];
                    current = &functions[name];
                    return;
                  }
                  if (current == nullptr || !std::regex_match(line, match, kLine)) return;
                  const std::string text = match[1];
                  current->frame += stack_taken(text);
                  if (std::regex_search(text, match, kCall)) {
                    if (match[2] != name) current->calls.insert(match[2]);
                    if (match[2] == name && text.rfind("bl", 0) == 0) current->calls.insert(name);
                  } else if (std::regex_search(text, match, kPointer)) {
                    current->through_pointer = true;
                  }
                });
  return functions;
}

/// The compiler's own figures, which know variable frames and where they overlap.
void read_frames(const std::string& build, Functions& functions) {
  static const std::regex kNode(
      R"re(^node: \{ title: "([^"]+)" label: ".*\\n(\d+) bytes \((\w+)\S*\))re");
  std::map<std::string, std::uint64_t> frames;
  std::error_code error;
  for (fs::recursive_directory_iterator walk(build, error), last; !error && walk != last;
       walk.increment(error)) {
    if (walk->path().extension() != ".ci") continue;
    std::ifstream file(walk->path());
    std::smatch match;
    for (std::string line; std::getline(file, line);) {
      if (line.size() > kMaxLine || !std::regex_search(line, match, kNode)) continue;
      std::string title = match[1];
      title.erase(0, title.rfind(':') + 1);  // local functions: file:name
      std::uint64_t& frame = frames[title];
      frame = std::max<std::uint64_t>(frame, number(match[2]));
    }
  }
  for (auto& [name, function] : functions) {
    if (const auto found = frames.find(name); found != frames.end()) function.frame = found->second;
  }
}

class DeepestPath {
 public:
  explicit DeepestPath(const Functions& functions) : functions_(functions) {}

  StackBound from(const std::string& start) {
    StackBound bound;
    bound.bytes = depth(start);
    for (std::string name = start; !name.empty(); name = next_[name]) bound.path.push_back(name);
    bound.unbounded.assign(unbounded_.begin(), unbounded_.end());
    return bound;
  }

 private:
  std::uint64_t depth(const std::string& name) {
    const auto found = functions_.find(name);
    if (found == functions_.end()) return 0;
    if (const auto known = depth_.find(name); known != depth_.end()) return known->second;
    if (!active_.insert(name).second) {
      unbounded_.insert(name);
      return 0;
    }
    if (found->second.through_pointer) unbounded_.insert(name);
    std::uint64_t deepest = 0;
    for (const auto& callee : found->second.calls) {
      const std::uint64_t below = depth(callee);
      if (below <= deepest) continue;
      deepest = below;
      next_[name] = callee;
    }
    active_.erase(name);
    return depth_[name] = deepest + found->second.frame;
  }

  const Functions& functions_;
  std::map<std::string, std::uint64_t> depth_;
  std::map<std::string, std::string> next_;
  std::set<std::string> active_, unbounded_;
};

}  // namespace

StackBound stack_bound(const std::string& prefix, const std::string& image,
                       const std::string& build) {
  Functions functions = read_disassembly(prefix, image);
  read_frames(build, functions);
  return DeepestPath(functions).from(functions.contains("eagerx_start") ? "eagerx_start" : "main");
}

}  // namespace eagerx::gen
