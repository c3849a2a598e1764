#include "generator/cli/become.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "generator/command_line/command_line.hpp"
#include "generator/command_line/output.hpp"

namespace eagerx::gen {

int become(const std::string& program, const std::vector<std::string>& arguments) {
  const std::string path = program.find('/') == std::string::npos ? "./" + program : program;
  std::vector<char*> words;
  words.reserve(arguments.size() + 2);
  // execvp does not change them, but says so only since it is too late to say it.
  const auto add = [&](const std::string& word) {
    words.push_back(
        const_cast<char*>(word.c_str()));  // NOLINT(cppcoreguidelines-pro-type-const-cast)
  };
  add(path);
  for (const auto& argument : arguments) add(argument);
  words.push_back(nullptr);
  execvp(words[0], words.data());
  complain("error: cannot start `{}`: {}\n", path, std::strerror(errno));
  return kInputOutput;
}

}  // namespace eagerx::gen
