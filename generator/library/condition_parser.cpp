// Conditions from their text: recursive descent, with types checked on the way.
#include <fmt/format.h>

#include <algorithm>

#include "generator/library/condition_text.hpp"
#include "generator/library/library.hpp"
#include "generator/read/scalar.hpp"
#include "generator/spec/dtype.hpp"
#include "generator/spec/named.hpp"

namespace eagerx::gen {
namespace {

using Op = ConditionStep::Op;

/// What an operand is.
struct Type {
  enum class Kind : std::uint8_t { number, boolean, list, text, word };
  Kind kind = Kind::number;
  const std::vector<std::string>* choices = nullptr;  // text: what it can be; nullptr: anything
  std::string word;                                   // a choice, still without its parameter
  std::size_t begin = 0;                              // where in the text
};

std::string_view to_string(Type::Kind kind) {
  switch (kind) {
    case Type::Kind::number:
      return "a number";
    case Type::Kind::boolean:
      return "true or false";
    case Type::Kind::list:
      return "a list";
    case Type::Kind::text:
    case Type::Kind::word:
      return "a text";
  }
  return "";
}

class Parser : protected ConditionText {
 public:
  Parser(const YamlValue& yaml, const char* code, Diagnostics& diagnostics)
      : ConditionText(yaml, code, diagnostics) {}
  virtual ~Parser() = default;
  Parser(const Parser&) = delete;
  Parser& operator=(const Parser&) = delete;

  std::optional<Condition> read(Type::Kind kind) {
    const Type type = disjunction();
    if (!at_end()) fail(place(), fmt::format("expected the end, found {}", next()));
    expect(type, kind);
    return good() ? std::optional<Condition>(std::move(steps_)) : std::nullopt;
  }

 protected:
  // What the two kinds of texts have names for.

  /// What begins with the name `word`, which is taken already.
  virtual Type name(const std::string& word, std::size_t begin) = 0;
  /// A function of a port: size, window, dtype.
  virtual Type port_fact(const std::string& function, std::size_t begin) = 0;
  /// A name that means nothing.
  virtual void unknown(const Type& word) = 0;
  /// What else an operand can be; nullopt if this is none.
  virtual std::optional<Type> more_operands() { return std::nullopt; }

  // Grammar, loosest first.

  Type disjunction() {
    const Nested nested(*this);
    Type left = conjunction();
    while (take_word("or")) left = logical(Op::logical_or, left, conjunction());
    return left;
  }

  Type conjunction() {
    Type left = negation();
    while (take_word("and")) left = logical(Op::logical_and, left, negation());
    return left;
  }

  Type negation() {
    const Nested nested(*this);
    if (!take_word("not")) return comparison();
    const Type operand = negation();
    expect(operand, Type::Kind::boolean);
    return result({Op::logical_not, {}, {}, {}, 1}, Type::Kind::boolean, operand.begin);
  }

  Type comparison() {
    Type left = sum();
    if (take_word("in")) return membership(left);
    const auto op = take_comparison();
    if (!op) return left;
    const Type right = sum();
    check_comparable(*op, left, right);
    Type type = result({*op, {}, {}, {}, 2}, Type::Kind::boolean, left.begin);
    const std::size_t after = place();
    if (take_comparison()) fail(after, "comparisons cannot be chained: join them with `and`");
    return type;
  }

  Type membership(const Type& left) {
    require('(');
    std::size_t count = 0;
    do {
      check_comparable(Op::equal, left, sum());
      ++count;
    } while (take(','));
    require(')');
    return result({Op::one_of, {}, {}, {}, count}, Type::Kind::boolean, left.begin);
  }

  Type sum() {
    Type left = product();
    while (good()) {
      if (take('+')) {
        left = arithmetic(Op::add, left, product());
      } else if (take('-')) {
        left = arithmetic(Op::subtract, left, product());
      } else {
        break;
      }
    }
    return left;
  }

  Type product() {
    Type left = sign();
    while (good()) {
      if (take('*')) {
        left = arithmetic(Op::multiply, left, sign());
      } else if (take('/')) {
        left = arithmetic(Op::divide, left, sign());
      } else {
        break;
      }
    }
    return left;
  }

  Type sign() {
    const Nested nested(*this);
    if (!take('-')) return operand();
    const Type negated = sign();
    expect(negated, Type::Kind::number);
    return result({Op::negate, {}, {}, {}, 1}, Type::Kind::number, negated.begin);
  }

  Type operand() {
    const std::size_t begin = place();
    if (take('(')) {
      Type inside = disjunction();
      require(')');
      return inside;
    }
    if (auto more = more_operands()) return *more;
    if (const std::string digits = take_number(); !digits.empty()) return number(digits, begin);
    const std::string word = take_name();
    if (word.empty()) {
      fail(begin, fmt::format("expected a value, found {}", next()));
      return {};
    }
    if (peek('(')) return call(word, begin);
    if (word == "true" || word == "false")
      return result({Op::constant, word == "true", {}, {}, 0}, Type::Kind::boolean, begin);
    return name(word, begin);
  }

  Type number(const std::string& text, std::size_t begin) {
    if (const auto whole = parse_int(text))
      return result({Op::constant, *whole, {}, {}, 0}, Type::Kind::number, begin);
    if (const auto exact = is_decimal_text(text) ? Rational::parse(text) : std::nullopt)
      return result({Op::constant, *exact, {}, {}, 0}, Type::Kind::number, begin);
    const auto real = is_decimal_text(text) ? parse_number(text) : std::nullopt;
    if (!real) fail(begin, fmt::format("`{}` is no number", text));
    return result({Op::constant, real.value_or(0.0), {}, {}, 0}, Type::Kind::number, begin);
  }

  Type call(const std::string& function, std::size_t begin) {
    require('(');
    Type type;
    if (function == "min" || function == "max") {
      type = extreme(function == "min" ? Op::least : Op::most, begin);
    } else if (function == "len") {
      expect(sum(), Type::Kind::list);
      type = result({Op::length, {}, {}, {}, 1}, Type::Kind::number, begin);
    } else if (function == "increasing") {
      expect(sum(), Type::Kind::list);
      type = result({Op::increasing, {}, {}, {}, 1}, Type::Kind::boolean, begin);
    } else if (function == "size" || function == "window" || function == "dtype") {
      type = port_fact(function, begin);
    } else {
      fail(begin, fmt::format("unknown function `{}`", function),
           suggest(function, {"min", "max", "len", "increasing", "size", "window", "dtype"}));
    }
    require(')');
    return type;
  }

  Type extreme(Op op, std::size_t begin) {
    std::size_t count = 0;
    do {
      const Type argument = sum();
      if (argument.kind != Type::Kind::list) expect(argument, Type::Kind::number);
      ++count;
    } while (take(','));
    return result({op, {}, {}, {}, count}, Type::Kind::number, begin);
  }

  // Types.

  void expect(const Type& type, Type::Kind kind) {
    if (type.kind == kind || !good()) return;
    if (type.kind == Type::Kind::word) return unknown(type);
    fail(type.begin, fmt::format("expected {}, found {}", to_string(kind), to_string(type.kind)));
  }

  void check_comparable(Op op, const Type& left, const Type& right) {
    if (!good()) return;
    const bool equality = op == Op::equal || op == Op::not_equal;
    const bool wrong =
        left.kind == Type::Kind::list ||
        (left.kind != Type::Kind::number && left.kind != Type::Kind::word && !equality);
    if (wrong)
      fail(left.begin, fmt::format("{} cannot be compared like this", to_string(left.kind)));
    if (left.kind == Type::Kind::word)
      return right.kind == Type::Kind::text && equality ? check_choice(left, right) : unknown(left);
    if (right.kind == Type::Kind::word && left.kind == Type::Kind::text)
      return check_choice(right, left);
    expect(right, left.kind);
  }

  void check_choice(const Type& word, const Type& text) {
    if (text.choices == nullptr || contains(*text.choices, word.word)) return;
    fail(word.begin, fmt::format("`{}` is not one of its choices", word.word),
         suggest(word.word, *text.choices));
  }

  Type logical(Op op, const Type& left, const Type& right) {
    expect(left, Type::Kind::boolean);
    expect(right, Type::Kind::boolean);
    return result({op, {}, {}, {}, 2}, Type::Kind::boolean, left.begin);
  }

  Type arithmetic(Op op, const Type& left, const Type& right) {
    expect(left, Type::Kind::number);
    expect(right, Type::Kind::number);
    return result({op, {}, {}, {}, 2}, Type::Kind::number, left.begin);
  }

  Type result(ConditionStep step, Type::Kind kind, std::size_t begin) {
    if (good()) steps_.push_back(std::move(step));
    return {kind, nullptr, {}, begin};
  }

  Condition steps_;
};

/// Of an entity: its parameters, ports and rate.
class ConditionParser : public Parser {
 public:
  ConditionParser(const YamlValue& yaml, const Entity& entity, Diagnostics& diagnostics)
      : Parser(yaml, "E0207", diagnostics), entity_(entity) {}

 private:
  /// A parameter, the node's rate, or a choice.
  Type name(const std::string& word, std::size_t begin) override {
    if (const Parameter* found = find_named(entity_.config, word)) {
      Type type = result({Op::fact, {}, word, word, 0}, kind_of(*found), begin);
      if (found->type == Parameter::Type::keyword) type.choices = &found->options;
      return type;
    }
    if (word == "rate" && has_rate())
      return result({Op::fact, {}, word, word, 0}, Type::Kind::number, begin);
    Type type = result({Op::constant, word, {}, {}, 0}, Type::Kind::word, begin);
    type.word = word;
    return type;
  }

  Type port_fact(const std::string& function, std::size_t begin) override {
    const std::size_t port_begin = place();
    const std::string written = take_port();
    const std::string port = find_port(written, port_begin);
    if (function == "window" && !port.starts_with("inputs."))
      fail(port_begin, fmt::format("`{}` is no input", written));
    Type type = result({Op::fact,
                        {},
                        fmt::format("{}({})", function, port),
                        fmt::format("{}({})", function, written),
                        0},
                       function == "dtype" ? Type::Kind::text : Type::Kind::number, begin);
    if (function == "dtype") type.choices = &dtype_names();
    return type;
  }

  /// The port with its group: "inputs.signal".
  std::string find_port(const std::string& written, std::size_t begin) {
    std::vector<std::string> known, found;
    const auto collect = [&](const char* group, const std::vector<PortManifest>& ports) {
      for (const auto& port : ports) {
        const std::string full = fmt::format("{}.{}", group, port.name.value);
        known.push_back(port.name.value);
        if (written == port.name.value || written == full) found.push_back(full);
      }
    };
    collect("inputs", entity_.inputs);
    collect("outputs", entity_.outputs);
    collect("states", entity_.states);
    if (found.empty()) {
      fail(begin, fmt::format("there is no input, output or state `{}`", written),
           suggest(written, known));
    } else if (found.size() > 1) {
      fail(begin, fmt::format("`{}` could be two ports", written),
           fmt::format("write {}", fmt::join(found, " or ")));
    }
    return found.empty() ? "" : found.front();
  }

  static Type::Kind kind_of(const Parameter& parameter) {
    switch (parameter.type) {
      case Parameter::Type::boolean:
        return Type::Kind::boolean;
      case Parameter::Type::text:
      case Parameter::Type::keyword:
        return Type::Kind::text;
      case Parameter::Type::integers:
      case Parameter::Type::numbers:
        return Type::Kind::list;
      default:
        return Type::Kind::number;
    }
  }

  [[nodiscard]] bool has_rate() const {
    return entity_.kind == EntityKind::node || entity_.kind == EntityKind::engine ||
           entity_.kind == EntityKind::engine_node;
  }

  void unknown(const Type& word) override {
    std::vector<std::string> known;
    for (const auto& parameter : entity_.config) known.push_back(parameter.name.value);
    if (has_rate()) known.emplace_back("rate");
    fail(word.begin, fmt::format("unknown name `{}`", word.word), suggest(word.word, known));
  }

  const Entity& entity_;
};

/// Of an object or engine node: what its manifest refers to with `$(…)`.
class ExpressionParser : public Parser {
 public:
  ExpressionParser(const YamlValue& yaml, const KnownReferences& references,
                   Diagnostics& diagnostics)
      : Parser(yaml, "E0324", diagnostics), references_(references) {}

 private:
  /// `$(…)` anywhere in the text, and what is in it.
  std::optional<Type> more_operands() override {
    if (!take('$')) return std::nullopt;
    require('(');
    ++depth_;
    Type inside = sum();
    --depth_;
    require(')');
    return inside;
  }

  /// `config limit`, `sensors theta rate`, `config list 0`: names with blanks between them.
  Type name(const std::string& word, std::size_t begin) override {
    std::string reference = word;
    for (std::string more = take_name(); !more.empty(); more = take_name()) reference += " " + more;
    if (const std::string index = take_number(); !index.empty()) reference += " " + index;
    const auto found = references_.find(reference);
    if (found == references_.end() || depth_ == 0) {
      report(reference, begin);
      return {};
    }
    return result({Op::fact, {}, reference, reference, 0}, kind_of(found->second), begin);
  }

  void report(const std::string& reference, std::size_t begin) {
    if (depth_ == 0)
      return fail(begin, fmt::format("`{}` is no number", reference),
                  "references stand inside of `$(…)`");
    std::vector<std::string> known;
    for (const auto& [name, value] : references_) known.push_back(name);
    const std::string near = nearest(reference, known);
    fail(begin, fmt::format("`{}` refers to nothing", reference),
         near.empty() ? "" : fmt::format("did you mean `{}`?", near));
  }

  Type port_fact(const std::string& function, std::size_t begin) override {
    fail(begin, fmt::format("unknown function `{}`", function),
         suggest(function, {"min", "max", "len"}));
    return {};
  }

  void unknown(const Type& word) override { report(word.word, word.begin); }

  static Type::Kind kind_of(const std::optional<ConditionValue>& value) {
    if (!value) return Type::Kind::number;  // said elsewhere why it is not known
    if (std::holds_alternative<bool>(*value)) return Type::Kind::boolean;
    if (std::holds_alternative<std::string>(*value)) return Type::Kind::text;
    return std::holds_alternative<std::vector<ConditionNumber>>(*value) ? Type::Kind::list
                                                                        : Type::Kind::number;
  }

  const KnownReferences& references_;
  int depth_ = 0;  // of `$(`
};

}  // namespace

std::optional<Condition> read_condition(const YamlValue& text, const Entity& entity,
                                        Diagnostics& diagnostics) {
  return ConditionParser(text, entity, diagnostics).read(Type::Kind::boolean);
}

bool is_expression(const YamlValue& yaml) {
  const std::size_t reference = yaml.text.find("$(");
  return yaml.is_scalar() && !yaml.quoted && reference != std::string::npos &&
         yaml.text.ends_with(')') && yaml.text.find_first_not_of("0123456789.+-*/( ") >= reference;
}

std::optional<Condition> read_expression(const YamlValue& text, const KnownReferences& references,
                                         Diagnostics& diagnostics) {
  return ExpressionParser(text, references, diagnostics).read(Type::Kind::number);
}

}  // namespace eagerx::gen
