#include "generator/backend/compile/compile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "generator/backend/compile/flags.hpp"
#include "generator/backend/compile/forbidden.hpp"
#include "generator/backend/compile/messages.hpp"
#include "generator/backend/program_map/program_map.hpp"
#include "generator/support/diagnostics/search.hpp"
#include "generator/support/files/paths.hpp"
#include "generator/support/process/process.hpp"

namespace eagerx::gen {
namespace {

namespace fs = std::filesystem;

/// As a `#line` names the place of a class in its manifest.
constexpr std::string_view kProbe = "eagerx-gen-class-";

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

class CompileCheck {
 public:
  CompileCheck(const Plan& plan, const std::vector<GeneratedFile>& files, const std::string& folder,
               const CompileOptions& options, SourceMap& sources, Diagnostics& diagnostics)
      : plan_(plan),
        files_(files),
        folder_(folder),
        options_(options),
        sources_(sources),
        diagnostics_(diagnostics),
        classes_(used_classes(plan)) {}

  void run() {
    if (!write_files() || !has_compiler() || !has_flags()) return;
    if (!compile_program()) return;
    look_for_calls();
    compile_vectorized();
    compile_derivatives();
  }

 private:
  bool write(const std::string& name, const std::string& text) {
    const fs::path path = fs::path(folder_) / name;
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    std::ofstream out(path, std::ios::binary);
    out << text;
    out.close();
    if (!out)
      diagnostics_.io_error("E0901", {},
                            fmt::format("cannot write `{}`: {}", path.string(),
                                        error ? error.message() : std::strerror(errno)));
    return static_cast<bool>(out);
  }

  bool write_files() {
    return ranges::all_of(files_,
                          [&](const GeneratedFile& file) { return write(file.path, file.text); });
  }

  bool has_compiler() {
    if (const auto said = run_process({options_.compiler, "--version"})) {
      version_ = said->output;
      return true;
    }
    diagnostics_.error("E0513", {}, fmt::format("there is no C++ compiler `{}`", options_.compiler))
        .help = "install one with `apt install g++`, or name another one in the variable CXX";
    return false;
  }

  bool has_flags() {
    const fs::path path = fs::path(options_.root) / "runtime" / "flags.txt";
    std::ifstream list(path);
    if (!list) {
      diagnostics_.io_error(
          "E0101", {}, fmt::format("cannot read `{}`: {}", path.string(), std::strerror(errno)));
      return false;
    }
    flags_ = runtime_flags(list, compiler_id(version_));
    return true;
  }

  /// The compiler's command, with the options that boards add.
  std::vector<std::string> command() const {
    // addr2line asks for lines only, also of what was inlined: more than -g1 takes longer.
    std::vector<std::string> words = {options_.compiler, "-std=c++20", "-O2", "-g1",
                                      "-ffunction-sections"};
    words.insert(words.end(), flags_.begin(), flags_.end());
    words.insert(words.end(),
                 {"-Wdouble-promotion", "-DEAGERX_CONSTANT_INDEXES", "-Wuninitialized",
                  "-I" + folder_, "-I" + options_.root + "/runtime", "-I" + options_.root});
    for (const std::string& each : options_.include_folders) words.push_back("-I" + each);
    const bool portable =
        ranges::all_of(classes_, [](const UsedClass& each) { return each.system.empty(); });
    if (portable) words.insert(words.end(), {"-fno-exceptions", "-fno-rtti"});
    if (!options_.packages.empty()) {
      std::vector<std::string> ask = {"pkg-config", "--cflags"};
      ask.insert(ask.end(), options_.packages.begin(), options_.packages.end());
      const auto said = run_process(ask);
      std::istringstream flags(said && said->exit_code == 0 ? said->output : "");
      for (std::string flag; flags >> flag;) words.push_back(flag);
    }
    return words;
  }

  /// Compiles a file of the folder; what the compiler said.
  std::string compile(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> words = command();
    words.insert(words.end(), more.begin(), more.end());
    words.push_back((fs::path(folder_) / name).string());
    const auto said = run_process(words);
    return said ? said->output : "";
  }

  /// Whether each header has the class that its manifest names. The compiler is asked for each by
  /// an alias, which it finds in a file named after the class. A program that compiles has them
  /// all, as it names them: only one that does not is worth the question.
  bool find_classes() {
    std::string text;
    std::set<std::string> headers;
    for (const UsedClass& each : classes_) {
      if (!each.header.empty() && headers.insert(each.header).second)
        text += fmt::format("#include \"{}\"\n", each.header);
    }
    for (std::size_t i = 0; i < classes_.size(); ++i)
      text += fmt::format("#line 1 \"{0}{1}\"\ntemplate <class T> using Probe{1} = {2}<T>;\n",
                          kProbe, i, classes_[i].name);
    if (!write("classes.cpp", text)) return false;
    const auto messages = messages_in(compile("classes.cpp", {"-fsyntax-only"}));
    std::set<std::size_t> missing;
    for (const CompilerMessage& message : messages) {
      if (!message.error) continue;
      if (!message.file.starts_with(kProbe)) {  // a header
        report(message);
        return false;
      }
      const std::size_t index = std::stoul(message.file.substr(kProbe.size()));
      if (missing.insert(index).second) report_missing(classes_[index], message.text);
    }
    return missing.empty();
  }

  void report_missing(const UsedClass& missing, const std::string& said) {
    auto& problem = diagnostics_.error(
        "E0510", missing.span,
        missing.header.empty()
            ? fmt::format("there is no class template `{}`", missing.name)
            : fmt::format("`{}` has no class template `{}`",
                          fs::path(missing.header).filename().string(), missing.name));
    constexpr std::string_view kMeant = "did you mean '";
    const std::size_t at = said.find(kMeant);
    if (at == std::string::npos) {
      problem.help = "write the name with its namespaces, as the header has it";
      return;
    }
    std::string meant = said.substr(at + kMeant.size());
    meant.resize(std::min(meant.find('\''), meant.size()));
    const std::size_t scope = missing.name.rfind("::");
    if (scope != std::string::npos && meant.find("::") == std::string::npos)
      meant = missing.name.substr(0, scope + 2) + meant;
    problem.help = meaning(meant);
  }

  bool compile_program() {
    const std::string name = plan_.graph->name;
    if (!write("program.cpp",
               // A template's constructors are instantiated where one is made.
               fmt::format("#include \"{0}/program.hpp\"\ntemplate class graphs::{0}::Program<>;\n"
                           "graphs::{0}::Program<> made();\n"
                           "graphs::{0}::Program<> made() {{ return graphs::{0}::Program<>(); }}\n",
                           name)))
      return false;
    const auto messages = messages_in(compile("program.cpp", {"-c", "-o", folder_ + "/program.o"}));
    const auto error = ranges::find_if(messages, &CompilerMessage::error);
    if (error != messages.end()) {
      // A missing class causes further errors; other problems count from the first error on.
      if (find_classes()) report(*error);
      return false;
    }
    std::set<std::pair<std::string, std::uint32_t>>
        reported;  // one constant makes a line of doubles
    for (const CompilerMessage& message : messages) {
      report_wrong_memory(message, reported);
      if (message.text.find("[-Wdouble-promotion]") == std::string::npos ||
          plan_.graph->double_precision || !is_of_portable_entity(message.file) ||
          !reported.insert({message.file, message.line}).second)
        continue;
      broken(span_of(message.file, message.line, message.column),
             "calculates in double, but the graph in float")
          .help = "write constants as `Real(0.5)` and use `Io::Real`";
    }
    return true;
  }

  /// A constant index beyond a message; a variable without a value.
  void report_wrong_memory(const CompilerMessage& message,
                           std::set<std::pair<std::string, std::uint32_t>>& reported) {
    const auto says = [&](std::string_view words) {
      return message.text.find(words) != std::string::npos;
    };
    const bool is_outside = says("index is outside of the message");
    if (!is_outside && !says("[-Wuninitialized]")) return;
    std::vector<CompilerMessage::Place> places = {{message.file, message.line, message.column}};
    places.insert(places.end(), message.inlined_at.begin(), message.inlined_at.end());
    const auto place =
        ranges::find_if(places, [&](const auto& each) { return is_of_entity(each.file); });
    if (place == places.end() || !reported.insert({place->file, place->line}).second) return;
    const Span span = span_of(place->file, place->line, place->column);
    const std::string text = message.text.substr(0, message.text.find(" [-W"));
    if (is_outside)
      broken(span, "index is outside of the message").help =
          "a message of shape [N] has the indexes 0 to N - 1";
    else
      broken(span, "reads what has no value: " + text).help =
          "give the variable a value where it is declared";
  }

  /// The compiler's messages for the program in this form, a folder and a namespace; nothing if the
  /// target has none.
  std::string compile_form(const std::string& form, const std::vector<std::string>& more) {
    const std::string header = fmt::format("{}/{}/program.hpp", plan_.graph->name, form);
    if (!ranges::contains(files_, header, &GeneratedFile::path)) return "";
    const std::string file = form + ".cpp";
    if (!write(file, fmt::format("#include \"{}\"\ntemplate class graphs::{}::{}::Program<>;\n",
                                 header, plan_.graph->name, form)))
      return "";
    return compile(file, more);
  }

  /// The program over SIMD vectors.
  void compile_vectorized() {
    const auto messages = messages_in(compile_form("vectorized", {"-fsyntax-only", "-Wno-psabi"}));
    const auto error = ranges::find_if(messages, &CompilerMessage::error);
    if (error == messages.end()) return;
    CompilerMessage message = *error;
    const auto says = [&](std::string_view word) {
      return message.text.find(word) != std::string::npos;
    };
    if (says("Mask<") && says("'bool'"))  // names of templates over some lines
      message.text = "a choice by a number, which differs between the lanes of a vector";
    report(message).help =
        "its manifest says `vectorized: true`: then `Io::Real` is a SIMD vector, one lane of each "
        "environment. `eagerx::select(a > b, x, y)` is for `if` and `? :`. Without "
        "`vectorized: true` environments run one by one";
  }

  /// The program over numbers with derivatives.
  void compile_derivatives() {
    const std::string said = compile_form("derivatives", {"-fsyntax-only"});
    const auto messages = messages_in(said);
    const auto error = ranges::find_if(messages, &CompilerMessage::error);
    if (error == messages.end()) return;
    CompilerMessage message = *error;
    // The compiler rejects code in the runtime, but the user can only change the code that
    // instantiates it.
    for (const CompilerMessage& asking : instantiations_in(said)) {
      if (is_of_entity(message.file) || !is_of_entity(asking.file)) continue;
      message.file = asking.file;
      message.line = asking.line;
      message.column = asking.column;
    }
    // The rest of the text is about solvers of models.
    message.text.resize(
        std::min(message.text.find(": the derivative of a model"), message.text.size()));
    report(message).help =
        "`eagerx-gen linearize` computes it over numbers with derivatives: then `Io::Real` and the "
        "elements of messages are `eagerx::Number`. In all of the class write `Real` for `float` "
        "and `double`, and `out.y[0] = value` or `element(out.y, i) = value` without a cast";
  }

  void look_for_calls() {
    std::set<std::pair<std::string, std::uint32_t>> reported;
    std::set<std::string> variables;  // each where it is used first
    for (const ForbiddenCall& call : forbidden_calls(folder_ + "/program.o")) {
      const auto place = ranges::find_if(
          call.places, [&](const auto& each) { return is_of_portable_entity(each.file); });
      if (place == call.places.end() || !reported.insert({place->file, place->line}).second)
        continue;
      const bool named = call.variable.starts_with('_');
      if (named && !variables.insert(call.variable).second) continue;
      broken(span_of(place->file, place->line, 0), call.what).help = call.fix;
    }
  }

  Diagnostic& broken(Span span, const std::string& what) {
    return diagnostics_.error("E0512", span, fmt::format("this {}", what));
  }

  /// An error in a header, or in generated code: then it is the code of a node that does not fit.
  Diagnostic& report(const CompilerMessage& message) {
    if (is_of_entity(message.file))
      return diagnostics_.error("E0511", span_of(message.file, message.line, message.column),
                                fmt::format("this does not compile: {}", message.text));
    const std::string node = node_of(message);
    const auto found = ranges::find(plan_.graph->nodes, node, &GraphNode::name);
    if (found == plan_.graph->nodes.end() || found->entity == nullptr)
      return diagnostics_.error("E0511", plan_.graph->span,
                                fmt::format("the program does not compile: {}", message.text));
    auto& problem = diagnostics_.error("E0511", found->entity->cpp.span,
                                       fmt::format("`{}` does not fit what its manifest says: {}",
                                                   found->entity->cpp.name, message.text));
    problem.notes.push_back({fmt::format("the node `{}`", node), found->span, ""});
    if (found->role == NodeRole::node && !found->is_reset_node())
      problem.help =
          "it has `void reset(const typename Io::States&)` and `void callback(const "
          "eagerx::Tick&, const typename Io::Inputs&, typename Io::Outputs&)`, a constructor "
          "without arguments, and its parameters in `Io::Config`: `eagerx-gen new node NAME` "
          "writes one";
    return problem;
  }

  /// Whose part of program.hpp it is, or whose member the line names; empty if it is in neither.
  std::string node_of(const CompilerMessage& message) {
    const std::string map_name = plan_.graph->name + "/program.map";
    const auto file = ranges::find(files_, map_name, &GeneratedFile::path);
    if (file == files_.end() || !message.file.ends_with("program.hpp")) return {};
    const auto map = parse_program_map(file->text, map_name, diagnostics_);
    if (!map) return {};
    if (const std::string* node = map->node_of_line(message.line)) return *node;
    const auto program =
        ranges::find(files_, plan_.graph->name + "/program.hpp", &GeneratedFile::path);
    return program != files_.end() ? node_of_member(*map, program->text, message.line)
                                   : std::string();
  }

  /// Of the first member of a node in a line, such as `gain_.reset({});`.
  static std::string node_of_member(const ProgramMap& map, const std::string& text,
                                    std::uint32_t line) {
    std::istringstream lines(text);
    std::string found;
    for (std::uint32_t i = 0; i < line && std::getline(lines, found); ++i) continue;
    constexpr std::string_view kLetters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";
    for (std::size_t begin = 0; begin < found.size();) {
      begin = std::min(found.find_first_of(kLetters, begin), found.size());
      const std::size_t end = std::min(found.find_first_not_of(kLetters, begin), found.size());
      const ProgramMap::Owner owner = map.owner(found.substr(begin, end - begin));
      if (owner.is_node) return owner.name;
      begin = end;
    }
    return {};
  }

  /// The class whose header lies in the same folder or above, the nearest one; nullptr if the file
  /// is no entity's.
  const UsedClass* class_of(const std::string& file) const {
    const std::string path = absolute_path(file).lexically_normal().string();
    const UsedClass* found = nullptr;
    std::size_t longest = 0;
    for (const UsedClass& each : classes_) {
      const std::string folder =
          (absolute_path(each.header).lexically_normal().parent_path() / "").string();
      if (each.header.empty() || !path.starts_with(folder) || folder.size() <= longest) continue;
      longest = folder.size();
      found = &each;
    }
    return found;
  }
  bool is_of_entity(const std::string& file) const { return class_of(file) != nullptr; }
  bool is_of_portable_entity(const std::string& file) const {
    const UsedClass* owner = class_of(file);
    return owner != nullptr && owner->system.empty();
  }

  Span span_of(const std::string& file, std::uint32_t line, std::uint32_t column) {
    const auto [place, added] = spans_.try_emplace(file);
    if (added) place->second = sources_.add(shown(file), text_of(file));
    if (column > 0) return {place->second, line, column, 1};
    const std::string_view text = sources_.line(place->second, line);
    const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
    return {place->second, line, static_cast<std::uint32_t>(begin + 1),
            static_cast<std::uint32_t>(text.size() - begin)};
  }

  /// As messages name the manifest in the same folder.
  std::string shown(const std::string& file) const {
    const UsedClass& owner = *class_of(file);
    const fs::path manifest = sources_.name(owner.span.file);
    const fs::path relative = absolute_path(file).lexically_normal().lexically_relative(
        absolute_path(manifest).lexically_normal().parent_path());
    return (manifest.parent_path() / relative).lexically_normal().string();
  }

  const Plan& plan_;
  const std::vector<GeneratedFile>& files_;
  const std::string& folder_;
  const CompileOptions& options_;
  SourceMap& sources_;
  Diagnostics& diagnostics_;
  std::vector<UsedClass> classes_;
  std::string version_;             // what the compiler says of itself
  std::vector<std::string> flags_;  // of the runtime, for it
  std::map<std::string, FileId> spans_;
};

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::error_code error;
  const fs::path parent = fs::temp_directory_path(error);
  std::string name = ((error ? fs::path("/tmp") : parent) / "eagerx-gen-XXXXXX").string();
  if (mkdtemp(name.data()) != nullptr) path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void check_entities(const Plan& plan, const std::vector<GeneratedFile>& files,
                    const TemporaryFolder& folder, const CompileOptions& options,
                    SourceMap& sources, Diagnostics& diagnostics) {
  CompileCheck(plan, files, folder.path(), options, sources, diagnostics).run();
}

}  // namespace eagerx::gen
