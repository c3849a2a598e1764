// The comparison of bounds with executed instructions can fail: an analysis with a mistake is below
// what a machine executes. Programs of branches, loops and calls are made at random, so that each
// has inputs for its longest path; a machine of a few lines executes them with all inputs.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "generator/analysis/bound/path.hpp"
#include "tests/unit/size/tools.hpp"

namespace eagerx::gen::bound {
namespace {

constexpr Address kCallee = 0x1000;
constexpr unsigned kInputs = 4;  // r0 to r3, each 0 or 1: each decides one branch

/// Lines of a disassembly, with branches to labels that come later.
class Assembly {
 public:
  explicit Assembly(Address at) : at_(at) {}

  std::size_t label() {
    labels_.push_back(0);
    return labels_.size() - 1;
  }
  void place(std::size_t label) { labels_[label] = at_; }
  void line(const std::string& text, unsigned bytes = 2) {
    lines_.push_back({at_, text, {}});
    at_ += bytes;
  }
  void branch(const char* name, std::size_t to) {
    lines_.push_back({at_, name, to});
    at_ += 2;
  }
  [[nodiscard]] std::string text() const {
    std::string all;
    for (const Line& line : lines_)
      all += fmt::format("{:4x}:\t{}{}\n", line.at, line.text,
                         line.to ? fmt::format("\t{:x} <x>", labels_[*line.to]) : "");
    return all;
  }

 private:
  struct Line {
    Address at;
    std::string text;
    std::optional<std::size_t> to;
  };
  Address at_;
  std::vector<Line> lines_;
  std::vector<Address> labels_;
};

class Maker {
 public:
  explicit Maker(unsigned seed) : random_(seed) {}

  /// A function `f` that calls `g`.
  std::string make() {
    Assembly f(0), g(kCallee);
    f.line("push\t{r4, lr}");
    block(f, 0, true);
    block(f, 0, true);
    f.line("bl\t1000 <g>", 4);
    f.line("pop\t{r4, pc}");
    block(g, kDepthOfCallee, false);
    loop(g, kDepthOfCallee, false);
    loop(g, kDepthOfCallee, false);
    g.line("bx\tlr");
    return "00000000 <f>:\n" + f.text() + "\n00001000 <g>:\n" + g.text();
  }

 private:
  static constexpr unsigned kDepthOfCallee = 3;  // it counts in r7, and f in r4 to r6

  unsigned below(unsigned end) { return static_cast<unsigned>(random_() % end); }

  void block(Assembly& to, unsigned depth, bool calls) {
    for (unsigned i = 0; i <= below(3); ++i) to.line("nop");
    if (inputs_ < kInputs) choice(to, depth);
    if (depth < kDepthOfCallee) loop(to, depth, calls);
  }

  /// Both sides differ in length, so that the longest path is only one. Neither calls: what is
  /// known of the input there would make it another callee.
  void choice(Assembly& to, unsigned depth) {
    const auto other = to.label(), end = to.label();
    to.line(fmt::format("cmp\tr{}, #0", inputs_++));
    to.branch("beq.n", other);
    if (depth < 2) loop(to, depth + 1, false);
    to.line("nop");
    to.branch("b.n", end);
    to.place(other);
    for (unsigned i = below(2) * 40; i > 0; --i) to.line("nop");
    to.place(end);
    to.line("nop");
  }

  void loop(Assembly& to, unsigned depth, bool calls) {
    const auto begin = to.label();
    to.line(fmt::format("movs\tr{}, #{}", 4 + depth, 2 + below(5)));
    to.place(begin);
    to.line("nop");
    if (depth < 2 && below(2) == 0) loop(to, depth + 1, calls);
    if (calls && below(3) == 0) to.line("bl\t1000 <g>", 4);
    to.line(fmt::format("subs\tr{}, #1", 4 + depth));
    to.branch("bne.n", begin);
  }

  std::mt19937 random_;
  unsigned inputs_ = 0;
};

using Step = std::pair<Address, Address>;

/// Instructions that one run executes.
struct Executed {
  std::uint64_t instructions = 0;
  std::set<Step> steps;  // from an instruction to the next one
};

/// Executes what Maker makes.
Executed execute(const Image& image, unsigned inputs) {
  std::array<std::int64_t, 16> r{};
  for (unsigned i = 0; i < kInputs; ++i) r[i] = inputs >> i & 1U;
  std::vector<Address> returns;
  bool zero = false;
  Executed run;
  const auto reg = [&](const Instruction& i) -> std::int64_t& {
    return r.at(std::stoul(i.operands[0].substr(1)));
  };
  const auto number = [](const Instruction& i) { return std::stol(i.operands[1].substr(1)); };
  constexpr std::uint64_t kMost = 1'000'000;
  for (const Instruction* i = image.instruction(0); i != nullptr && run.instructions < kMost;) {
    ++run.instructions;
    Address next = i->next;
    if (i->name == "movs") reg(*i) = number(*i);
    if (i->name == "subs") zero = (reg(*i) -= number(*i)) == 0;
    if (i->name == "cmp") zero = reg(*i) == number(*i);
    const bool holds = !i->is_conditional() || (i->condition == Condition::eq) == zero;
    if (i->name == "b" && holds) next = i->target;
    if (i->name == "bl") {
      returns.push_back(i->next);
      next = i->target;
    }
    const bool is_return = i->turn == Turn::back;
    if (is_return && returns.empty()) return run;
    if (is_return) {
      next = returns.back();
      returns.pop_back();
    }
    run.steps.insert({i->at, next});
    i = image.instruction(next);
  }
  return run;
}

/// A function and its callees, which can be changed.
class Copies {
 public:
  explicit Copies(const Analysed& function) { first_ = copy(function); }

  Analysed& first() { return *first_; }
  std::vector<Analysed*> all() {
    std::vector<Analysed*> result;
    for (auto& [original, one] : copies_) result.push_back(&one);
    return result;
  }
  std::uint64_t bound() {
    LongestPath path(Weight::all());
    return path.of(*first_);
  }

 private:
  Analysed* copy(const Analysed& function) {
    const auto [found, is_new] = copies_.emplace(&function, function);
    if (is_new) {
      for (auto& [at, callee] : found->second.calls) callee = copy(*callee);
    }
    return &found->second;
  }
  std::map<const Analysed*, Analysed> copies_;
  Analysed* first_ = nullptr;
};

bool is_executed(const Analysed& function, std::pair<BlockIndex, BlockIndex> edge,
                 const Executed& run) {
  const auto& blocks = function.flow->blocks;
  return run.steps.contains(
      {blocks[edge.first].code.back()->at, blocks[edge.second].code.front()->at});
}

/// Mutants of one program: how many there are, and how many the comparison finds.
struct Found {
  unsigned mutants = 0, found = 0;

  void add(std::uint64_t bound, const Executed& run) {
    ++mutants;
    found += run.instructions > bound ? 1 : 0;
  }
};

Found mutate(const Analysed& function, const Executed& run) {
  Found result;
  result.add(Copies(function).bound() - 1, run);
  const std::size_t functions = Copies(function).all().size();
  for (std::size_t f = 0; f < functions; ++f) {
    const Analysed whole = *Copies(function).all()[f];
    for (const auto& edge : whole.possible) {
      if (!is_executed(whole, edge, run)) continue;
      Copies mutant(function);
      mutant.all()[f]->possible.erase(edge);
      result.add(mutant.bound(), run);
    }
    for (LoopIndex loop = 0; loop < whole.most_turns.size(); ++loop) {
      if (!whole.most_turns[loop] || *whole.most_turns[loop] < 2) continue;
      const BlockIndex header = whole.flow->loops[loop].header;
      if (!is_executed(whole, {whole.flow->loops[loop].latches.front(), header}, run)) continue;
      Copies straight(function);
      straight.all()[f]->most_turns[loop] = 1;
      result.add(straight.bound(), run);
      Copies shorter(function);
      --*shorter.all()[f]->most_turns[loop];
      result.add(shorter.bound(), run);
    }
  }
  return result;
}

/// The run that executes most.
Executed longest_run(const Image& image) {
  Executed most;
  for (unsigned inputs = 0; inputs < 1U << kInputs; ++inputs) {
    Executed run = execute(image, inputs);
    if (run.instructions > most.instructions) most = std::move(run);
  }
  return most;
}

TEST(Mutants, OfTheAnalysisAreBelowWhatIsExecuted) {
  constexpr unsigned kPrograms = 12;
  constexpr unsigned kLeastMutants = 200;
  Found all;
  for (unsigned seed = 1; seed <= kPrograms; ++seed) {
    const std::string program = Maker(seed).make();
    Tools tools;
    std::string elf = Tools::elf(Tools::kArm);
    elf.resize(64, '\0');
    tools.file("image.elf", elf);
    tools.says("objdump", program);
    tools.says("nm", "00000001 T f\n00001001 T g\n");
    const auto image = Image::read(tools.image(), "arm-none-eabi-");
    ASSERT_TRUE(image) << program;
    Analysis analysis(*image);
    const Executed run = longest_run(*image);
    EXPECT_EQ(Copies(analysis.of(0)).bound(), run.instructions) << program;
    const Found found = mutate(analysis.of(0), run);
    EXPECT_EQ(found.found, found.mutants) << program;
    all.mutants += found.mutants;
  }
  RecordProperty("mutants", static_cast<int>(all.mutants));
  EXPECT_GE(all.mutants, kLeastMutants);
}

}  // namespace
}  // namespace eagerx::gen::bound
