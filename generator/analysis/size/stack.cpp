// The stack bound: frames from the compiler (-fcallgraph-info=su), for libraries from their
// instructions; calls from the linked image.
#include "generator/analysis/size/stack.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "generator/analysis/size/function_name.hpp"
#include "generator/analysis/size/pattern.hpp"
#include "generator/analysis/size/tools.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

struct StackOf {
  std::uint64_t frame = 0, begin = 0;
  std::map<std::string, std::uint64_t> calls;  // from which address, the first if there are more
  bool through_pointer = false;
};
using StackOfEach = std::map<std::string, StackOf>;

/// 0 for what does not fit.
std::uint64_t number(const std::string& digits) {
  constexpr std::uint64_t kMost = 1U << 30U;
  const std::uint64_t value = std::strtoull(digits.c_str(), nullptr, 10);
  return value <= kMost ? value : 0;
}

/// Bytes a list of registers such as `r4, r5, lr` or `s16-s19` takes.
std::uint64_t bytes_of_registers(const std::string& list, bool vector) {
  static const Pattern kItem("^[^a-z]*([a-z]+)([0-9]*)(-[a-z]([0-9]+))?");
  std::uint64_t count = 0;
  std::string rest = list;
  for (auto item = kItem.groups(rest); !item.empty(); item = kItem.groups(rest)) {
    const std::uint64_t width = vector && item[1] == "d" ? 8 : 4;
    const std::uint64_t first = number(item[2]);
    const std::uint64_t last = item[3].empty() ? first : number(item[4]);
    count += width * (last >= first ? last - first + 1 : 1);
    rest.erase(0, item[0].size());
  }
  return count;
}

/// Bytes that an instruction takes from the stack. Adding up all of a function's is a bound for it.
std::uint64_t stack_taken(const std::string& text) {
  static const Pattern kPush(R"(^(v?)(push|stmdb\.?w?\s+sp!,|stmfd\s+sp!,)\S*\s*\{(.*)\})");
  static const Pattern kSub(R"(^subw?\S*\s+sp,.*#([0-9]+))");
  static const Pattern kStore(R"(^(str|strd)\S*\s.*\[sp, #-([0-9]+)\]!)");
  static const Pattern kRiscv(R"(^(c\.)?addi?(16sp)?\s+sp,sp,-([0-9]+))");
  if (const auto push = kPush.groups(text); !push.empty())
    return bytes_of_registers(push[3], !push[1].empty());
  if (const auto sub = kSub.groups(text); !sub.empty()) return number(sub[1]);
  if (const auto store = kStore.groups(text); !store.empty()) return number(store[2]);
  if (const auto add = kRiscv.groups(text); !add.empty()) return number(add[3]);
  return 0;
}

/// Reads a disassembly line by line into functions, calls and frames.
class Disassembly {
 public:
  void line(const std::string& text) {
    static const Pattern kHead("^([0-9a-f]+) <(.+)>:$");
    static const Pattern kInstruction(R"(^\s*([0-9a-f]+):\s+(.*)$)");
    if (const auto head = kHead.groups(text); !head.empty()) {
      if (head[2].starts_with(".L")) return;
      name_ = head[2];
      current_ = &functions_[name_];
      current_->begin = address(head[1]);
    } else if (const auto found = kInstruction.groups(text);
               current_ != nullptr && !found.empty()) {
      instruction(found[2], address(found[1]));
    }
  }

  StackOfEach take() { return std::move(functions_); }

 private:
  static std::uint64_t address(const std::string& digits) {
    constexpr int kHexadecimal = 16;
    return std::strtoull(digits.c_str(), nullptr, kHexadecimal);
  }

  void instruction(const std::string& text, std::uint64_t at) {
    static const Pattern kCall(R"(^(bl?|b\.w|b\.n|j|jal|call|tail)\S*\s.*<([^+>]+)>)");
    static const Pattern kPointer(R"(^(blx\s+r|jalr|c\.jalr|bx\s+r))");
    current_->frame += stack_taken(text);
    if (const auto call = kCall.groups(text); !call.empty()) {
      if (call[2] != name_ || text.starts_with("bl")) current_->calls.emplace(call[2], at);
    } else if (!kPointer.groups(text).empty()) {
      current_->through_pointer = true;
    }
  }

  StackOfEach functions_;
  StackOf* current_ = nullptr;
  std::string name_;
};

StackOfEach read_disassembly(const std::string& prefix, const std::string& image) {
  Disassembly disassembly;
  for_each_line({prefix + "objdump", "-d", "--no-show-raw-insn", image},
                [&](std::string_view line) {
                  if (line.size() <= kMaxLine) disassembly.line(std::string(line));
                });
  return disassembly.take();
}

/// The compiler's own figures, which know variable frames and where they overlap.
void read_frames(const std::string& build, StackOfEach& functions) {
  static const Pattern kNode(
      R"re(^node: \{ title: "([^"]+)" label: ".*\\n([0-9]+) bytes \([a-zA-Z0-9_]+\S*\))re");
  std::map<std::string, std::uint64_t> frames;
  std::error_code error;
  for (fs::recursive_directory_iterator walk(build, error), last; !error && walk != last;
       walk.increment(error)) {
    if (walk->path().extension() != ".ci") continue;
    std::ifstream file(walk->path());
    for (std::string line; std::getline(file, line);) {
      if (line.size() > kMaxLine) continue;
      const auto node = kNode.groups(line);
      if (node.empty()) continue;
      std::string title = node[1];
      title.erase(0, title.rfind(':') + 1);  // local functions: file:name
      std::uint64_t& frame = frames[title];
      frame = std::max<std::uint64_t>(frame, number(node[2]));
    }
  }
  for (auto& [name, function] : functions) {
    if (const auto found = frames.find(name); found != frames.end()) function.frame = found->second;
  }
}

class DeepestPath {
 public:
  explicit DeepestPath(const StackOfEach& functions) : functions_(functions) {}

  StackBound from(const std::string& start) {
    StackBound bound;
    bound.bytes = depth(start);
    std::uint64_t called_from = 0;
    for (std::string name = start; !name.empty(); name = next_[name]) {
      bound.path.push_back(name);
      const auto found = functions_.find(name);
      if (found == functions_.end()) continue;
      const StackOf& function = found->second;
      bound.calls.push_back({function_name(name), "", false, function.frame, function.begin,
                             bound.calls.empty() ? function.begin : called_from});
      if (const auto call = function.calls.find(next_[name]); call != function.calls.end())
        called_from = call->second;
    }
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
    for (const auto& [callee, at] : found->second.calls) {
      const std::uint64_t below = depth(callee);
      if (below <= deepest) continue;
      deepest = below;
      next_[name] = callee;
    }
    active_.erase(name);
    return depth_[name] = deepest + found->second.frame;
  }

  const StackOfEach& functions_;
  std::map<std::string, std::uint64_t> depth_;
  std::map<std::string, std::string> next_;
  std::set<std::string> active_, unbounded_;
};

}  // namespace

StackBound stack_bound(const std::string& prefix, const std::string& image,
                       const std::string& build) {
  StackOfEach functions = read_disassembly(prefix, image);
  read_frames(build, functions);
  return DeepestPath(functions).from(functions.contains("eagerx_start") ? "eagerx_start" : "main");
}

}  // namespace eagerx::gen
