#include "generator/policy/formats/tensors/pickle.hpp"

#include <fmt/core.h>

#include <array>
#include <bit>
#include <initializer_list>
#include <map>

namespace eagerx::gen {
namespace {

using Kind = PickleValue::Kind;
using Index = std::uint32_t;

constexpr std::size_t kMaxPickleValues = 500'000;
constexpr std::size_t kMaxMemo = 500'000;

/// Runs the instructions over a stack of indices. Every instruction makes at most one value.
class Reader {
 public:
  Reader(std::string_view bytes, PickleNames known, PolicyProblem& problem)
      : bytes_(bytes), known_(known), problem_(problem) {
    pickle_.values.emplace_back();  // None
  }

  std::optional<Pickle> run() {
    while (!stopped_) {
      start_ = at_;
      std::string_view code;
      if (!take(1, code)) return std::nullopt;
      if (!step(static_cast<unsigned char>(code.front()))) return std::nullopt;
    }
    pickle_.end = at_;
    return std::move(pickle_);
  }

 private:
  Refused fail(const std::string& how) {
    return refuse(problem_, "E0623", fmt::format("has a pickle that {} (byte {})", how, start_),
                  "the file is damaged, or was not made by `save`: save it again");
  }
  bool damaged() { return fail("is damaged"); }

  bool take(std::size_t count, std::string_view& out) {
    if (bytes_.size() - at_ < count) return fail("ends early");
    out = bytes_.substr(at_, count);
    at_ += count;
    return true;
  }
  bool number(std::size_t count, std::uint64_t& out) {
    std::string_view raw;
    if (!take(count, raw)) return false;
    out = little_endian(raw, count);
    return true;
  }
  /// A count of `count` bytes, then as many bytes.
  bool counted(std::size_t count, std::string_view& out) {
    std::uint64_t size = 0;
    if (!number(count, size)) return false;
    return size > bytes_.size() ? fail("ends early") : take(static_cast<std::size_t>(size), out);
  }
  bool line(std::string_view& out) {
    const std::size_t end = bytes_.find('\n', at_);
    if (end == std::string_view::npos) return fail("ends early");
    out = bytes_.substr(at_, end - at_);
    at_ = end + 1;
    return true;
  }

  bool push(PickleValue value) {
    if (pickle_.values.size() >= kMaxPickleValues) return fail("has too many values");
    stack_.push_back(static_cast<Index>(pickle_.values.size()));
    pickle_.values.push_back(std::move(value));
    return true;
  }
  bool push_integer(std::int64_t value) { return push(with(Kind::integer, value)); }
  static PickleValue with(Kind kind, std::int64_t integer) {
    PickleValue value;
    value.kind = kind;
    value.integer = integer;
    return value;
  }
  bool push_text(Kind kind, std::string_view text) {
    PickleValue value;
    value.kind = kind;
    value.text = text;
    return push(std::move(value));
  }
  bool push_counted(Kind kind, std::size_t count) {
    std::string_view text;
    return counted(count, text) && push_text(kind, text);
  }
  PickleValue& value(Index index) { return pickle_.values[index]; }

  bool pop(Index& out) {
    if (stack_.empty() || value(stack_.back()).kind == Kind::mark) return damaged();
    out = stack_.back();
    stack_.pop_back();
    return true;
  }
  /// Everything above the last mark, and the mark.
  bool pop_to_mark(std::vector<Index>& out) {
    std::size_t at = stack_.size();
    while (at > 0 && value(stack_[at - 1]).kind != Kind::mark) --at;
    if (at == 0) return damaged();
    out.assign(stack_.begin() + static_cast<std::ptrdiff_t>(at), stack_.end());
    stack_.resize(at - 1);
    return true;
  }
  bool push_sequence(std::vector<Index> items) {
    PickleValue sequence;
    sequence.kind = Kind::sequence;
    sequence.items = std::move(items);
    return push(std::move(sequence));
  }
  bool pop_many(std::size_t count, std::vector<Index>& out) {
    out.resize(count);
    for (std::size_t i = count; i-- > 0;) {
      if (!pop(out[i])) return false;
    }
    return true;
  }
  bool tuple(std::size_t count) {
    std::vector<Index> items;
    return pop_many(count, items) && push_sequence(std::move(items));
  }
  bool list() {
    std::vector<Index> items;
    return pop_to_mark(items) && push_sequence(std::move(items));
  }
  bool append() {
    std::vector<Index> items;
    return pop_many(1, items) && extend(items, false);
  }
  bool set_item() {
    std::vector<Index> items;
    return pop_many(2, items) && extend(items, true);
  }
  bool extend_to_mark(bool pairs) {
    std::vector<Index> items;
    return pop_to_mark(items) && extend(items, pairs);
  }
  bool drop() {
    Index ignored = 0;
    return pop(ignored);
  }
  bool drop_to_mark() {
    std::vector<Index> ignored;
    return pop_to_mark(ignored);
  }
  bool skip(std::size_t count) {
    std::string_view ignored;
    return take(count, ignored);
  }
  /// Adds `items` to the container on top of the stack.
  bool extend(const std::vector<Index>& items, bool pairs) {
    if (stack_.empty()) return damaged();
    PickleValue& container = value(stack_.back());
    const bool fits = container.kind == Kind::object ||
                      container.kind == (pairs ? Kind::dictionary : Kind::sequence);
    if (!fits || (pairs && items.size() % 2 != 0)) return damaged();
    container.items.insert(container.items.end(), items.begin(), items.end());
    return true;
  }

  bool import(std::string_view module, std::string_view name) {
    std::string whole = fmt::format("{}.{}", module, name);
    if (!is_known_in_pickles(whole, known_)) {
      return refuse(problem_, "E0622",
                    fmt::format("has a pickle that imports `{}`", printable(whole)),
                    "it was not run: only tensors, arrays and plain values are read; do not "
                    "open files from strangers in Python");
    }
    pickle_.names.push_back(std::move(whole));
    return push_text(Kind::name, pickle_.names.back());
  }
  bool import_from_stack() {
    Index name = 0;
    Index module = 0;
    if (!pop(name) || !pop(module)) return false;
    if (value(name).kind != Kind::text || value(module).kind != Kind::text) return damaged();
    return import(value(module).text, value(name).text);
  }
  bool import_from_lines() {
    std::string_view module;
    std::string_view name;
    return line(module) && line(name) && import(module, name);
  }

  /// Records a call.
  bool call() {
    PickleValue object;
    object.kind = Kind::object;
    if (!pop(object.arguments) || !pop(object.function)) return false;
    if (value(object.function).kind != Kind::name)
      return fail("calls something that is not a function");
    if (value(object.function).text == "_codecs.encode") {
      if (const std::string* encoded = encoded_of(value(object.arguments))) {
        return push_text(Kind::bytes, *encoded);
      }
    }
    return push(std::move(object));
  }

  /// Protocol 2, which is torch's, has no bytes: they are a text of characters below 256, encoded
  /// with latin1. nullptr if it is none. Kept, as the same text may be there often.
  const std::string* encoded_of(const PickleValue& arguments) {
    if (arguments.kind != Kind::sequence || arguments.items.size() != 2) return nullptr;
    const Index index = arguments.items.front();
    const PickleValue& text = value(index);
    const PickleValue& codec = value(arguments.items.back());
    if (text.kind != Kind::text || codec.kind != Kind::text || codec.text != "latin1") {
      return nullptr;
    }
    if (const auto known = encoded_.find(index); known != encoded_.end()) return known->second;
    constexpr unsigned kAscii = 0x80, kTwoBytes = 0xC2, kLast = 0xC3, kBits = 0x3F;
    std::string bytes;
    for (std::size_t i = 0; i < text.text.size(); ++i) {
      const auto first = static_cast<unsigned char>(text.text[i]);
      if (first < kAscii) {
        bytes += text.text[i];
        continue;
      }
      if (first < kTwoBytes || first > kLast || i + 1 == text.text.size()) return nullptr;
      const auto second = static_cast<unsigned char>(text.text[++i]);
      bytes +=
          static_cast<char>(static_cast<unsigned char>((unsigned{first} << 6U) | (second & kBits)));
    }
    pickle_.names.push_back(std::move(bytes));
    return encoded_.emplace(index, &pickle_.names.back()).first->second;
  }
  bool build() {
    Index state = 0;
    if (!pop(state)) return false;
    if (stack_.empty() || value(stack_.back()).kind != Kind::object) return damaged();
    value(stack_.back()).state = state;
    return true;
  }
  bool persistent() {
    PickleValue reference;
    reference.kind = Kind::persistent;
    return pop(reference.function) && push(std::move(reference));
  }

  bool memoize(std::uint64_t key) {
    if (stack_.empty()) return damaged();
    if (key >= kMaxMemo) return fail("has too many values");
    if (memo_.size() <= key) memo_.resize(static_cast<std::size_t>(key) + 1, kNothing);
    memo_[static_cast<std::size_t>(key)] = stack_.back();
    if (key + 1 > next_memo_) next_memo_ = key + 1;
    return true;
  }
  bool recall(std::size_t count) {
    std::uint64_t key = 0;
    if (!number(count, key)) return false;
    if (key >= memo_.size() || memo_[static_cast<std::size_t>(key)] == kNothing) return damaged();
    stack_.push_back(memo_[static_cast<std::size_t>(key)]);
    return stack_.size() <= kMaxPickleValues || fail("has too many values");
  }
  bool store(std::size_t count) {
    std::uint64_t key = 0;
    return number(count, key) && memoize(key);
  }

  bool push_real() {
    std::string_view raw;
    if (!take(sizeof(double), raw)) return false;
    std::uint64_t bits = 0;
    for (const char c : raw) bits = bits << 8U | static_cast<unsigned char>(c);
    PickleValue real;
    real.kind = Kind::real;
    real.real = std::bit_cast<double>(bits);
    return push(std::move(real));
  }
  /// Integers of any length; those of more than eight bytes are seeds, which are not needed.
  bool push_long(std::size_t count) {
    std::string_view raw;
    if (!counted(count, raw)) return false;
    constexpr std::size_t kMost = sizeof(std::int64_t);
    if (raw.size() > kMost) return push(PickleValue{});
    std::uint64_t bits = !raw.empty() && (raw.back() & 0x80) != 0 ? ~std::uint64_t{0} : 0;
    for (std::size_t i = raw.size(); i-- > 0;) {
      bits = bits << 8U | static_cast<unsigned char>(raw[i]);
    }
    return push_integer(static_cast<std::int64_t>(bits));
  }
  bool push_int(std::size_t count) {
    std::uint64_t bits = 0;
    if (!number(count, bits)) return false;
    const bool wide = count == 4;
    return push_integer(wide ? static_cast<std::int32_t>(static_cast<std::uint32_t>(bits))
                             : static_cast<std::int64_t>(bits));
  }
  bool push_empty(Kind kind) { return push(with(kind, 0)); }

  bool stop() {
    stopped_ = true;
    return pop(pickle_.root);
  }

  using Instruction = bool (*)(Reader&);
  static std::array<Instruction, 256> instructions();
  bool step(unsigned char code) {
    static const auto kInstructions = instructions();
    if (const Instruction known = kInstructions.at(code)) return known(*this);
    return fail(fmt::format("has instruction 0x{:02x}, which data does not need", code));
  }

  static constexpr Index kNothing = 0xffffffff;
  std::string_view bytes_;
  PickleNames known_;
  PolicyProblem& problem_;
  std::size_t at_ = 0, start_ = 0;
  bool stopped_ = false;
  Pickle pickle_;
  std::vector<Index> stack_;
  std::vector<Index> memo_;
  std::map<Index, const std::string*> encoded_;  // of texts
  std::uint64_t next_memo_ = 0;
};

/// nullptr: what data does not need.
std::array<Reader::Instruction, 256> Reader::instructions() {
  std::array<Instruction, 256> all{};
  const auto on = [&](std::initializer_list<unsigned char> codes, Instruction what) {
    for (const unsigned char code : codes) all.at(code) = what;
  };
  on({0x80}, [](Reader& r) { return r.skip(1); });  // PROTO
  on({0x95}, [](Reader& r) { return r.skip(8); });  // FRAME
  on({'.'}, [](Reader& r) { return r.stop(); });
  on({'('}, [](Reader& r) { return r.push_empty(Kind::mark); });
  on({'N'}, [](Reader& r) { return r.push(PickleValue{}); });
  on({0x88}, [](Reader& r) { return r.push(with(Kind::boolean, 1)); });
  on({0x89}, [](Reader& r) { return r.push(with(Kind::boolean, 0)); });
  on({'J'}, [](Reader& r) { return r.push_int(4); });
  on({'K'}, [](Reader& r) { return r.push_int(1); });
  on({'M'}, [](Reader& r) { return r.push_int(2); });
  on({0x8a}, [](Reader& r) { return r.push_long(1); });
  on({0x8b}, [](Reader& r) { return r.push_long(4); });
  on({'G'}, [](Reader& r) { return r.push_real(); });
  on({'X', 'T'}, [](Reader& r) { return r.push_counted(Kind::text, 4); });
  on({0x8c, 'U'}, [](Reader& r) { return r.push_counted(Kind::text, 1); });
  on({0x8d}, [](Reader& r) { return r.push_counted(Kind::text, 8); });
  on({'C'}, [](Reader& r) { return r.push_counted(Kind::bytes, 1); });
  on({'B'}, [](Reader& r) { return r.push_counted(Kind::bytes, 4); });
  on({0x8e, 0x96}, [](Reader& r) { return r.push_counted(Kind::bytes, 8); });
  on({')', ']', 0x8f}, [](Reader& r) { return r.push_empty(Kind::sequence); });
  on({'}'}, [](Reader& r) { return r.push_empty(Kind::dictionary); });
  on({0x85}, [](Reader& r) { return r.tuple(1); });
  on({0x86}, [](Reader& r) { return r.tuple(2); });
  on({0x87}, [](Reader& r) { return r.tuple(3); });
  on({'t', 0x91, 'l'}, [](Reader& r) { return r.list(); });            // TUPLE, FROZENSET, LIST
  on({'a'}, [](Reader& r) { return r.append(); });                     // APPEND
  on({'e', 0x90}, [](Reader& r) { return r.extend_to_mark(false); });  // APPENDS, ADDITEMS
  on({'s'}, [](Reader& r) { return r.set_item(); });                   // SETITEM
  on({'u'}, [](Reader& r) { return r.extend_to_mark(true); });         // SETITEMS
  on({'0'}, [](Reader& r) { return r.drop(); });                       // POP
  on({'1'}, [](Reader& r) { return r.drop_to_mark(); });               // POP_MARK
  on({'h'}, [](Reader& r) { return r.recall(1); });
  on({'j'}, [](Reader& r) { return r.recall(4); });
  on({'q'}, [](Reader& r) { return r.store(1); });
  on({'r'}, [](Reader& r) { return r.store(4); });
  on({0x94}, [](Reader& r) { return r.memoize(r.next_memo_); });
  on({'c'}, [](Reader& r) { return r.import_from_lines(); });
  on({0x93}, [](Reader& r) { return r.import_from_stack(); });
  on({'R', 0x81}, [](Reader& r) { return r.call(); });
  on({0x92}, [](Reader& r) {
    return r.drop() && r.call();
  });  // NEWOBJ_EX: its keyword arguments are not looked at
  on({'b'}, [](Reader& r) { return r.build(); });
  on({'Q'}, [](Reader& r) { return r.persistent(); });
  return all;
}

}  // namespace

std::optional<Pickle> read_pickle(std::string_view bytes, PickleNames known,
                                  PolicyProblem& problem) {
  return Reader(bytes, known, problem).run();
}

}  // namespace eagerx::gen
