// eagerx-gen key: makes keys by which two machines trust each other.
#include <fmt/format.h>

#include <cstring>
#include <runtime/host/key/key_file.hpp>

#include "generator/driver/commands/arguments.hpp"
#include "generator/driver/commands/commands.hpp"
#include "generator/driver/pipeline/pipeline.hpp"
#include "generator/support/quote/quote.hpp"

namespace eagerx::gen {
namespace {

struct KeyNewOptions : MessageOptions {
  std::string file;
};

int perform(const KeyNewOptions& options) {
  Run run;
  const std::string problem = key::new_key(options.file);
  if (!problem.empty()) {
    run.diagnostics
        .io_error("E0901", {}, fmt::format("cannot write the key `{}`: {}", options.file, problem))
        .help = "a key takes the place of no file; give a name that is free";
  } else if (!options.quiet) {
    const std::string word = shell_word(options.file);
    say("{0}: a new key, for you alone. Copy it where the part runs, such as `scp -p {0} HOST:`, "
        "and give both sides `--key FILE`\n",
        word);
  }
  return finish(run, options);
}

Command table(KeyNewOptions& options) {
  return {
      .name = "new",
      .about = "write a new key to a file that only you can read (mode 0600)",
      .examples = {{"for the link to a part on another machine", "eagerx-gen key new camera.key"}},
      .arguments = joined({{required(writes(text("file", options.file,
                                                 "file to write, which must not exist", "FILE")))},
                           diagnostics(options)}),
      .run = [&options] { return perform(options); }};
}

}  // namespace

Command key_command() {
  return {
      .name = "key",
      .about = "make a key, which lets programs on several machines form one graph over TCP",
      .examples = {{"for the link to a part on another machine", "eagerx-gen key new camera.key"}},
      .commands = {with_options<KeyNewOptions>(table)}};
}

}  // namespace eagerx::gen
