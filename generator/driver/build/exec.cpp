#include "generator/driver/build/exec.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "generator/support/command_line/command_line.hpp"
#include "generator/support/command_line/output.hpp"

namespace eagerx::gen {

int exec(const std::string& program, const std::vector<std::string>& arguments) {
  std::error_code ignored;
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
  const int refused = errno;
  // The system says "Permission denied" for all of these.
  if (refused == EACCES && std::filesystem::exists(path, ignored))
    complain("error: cannot start `{}`: {}\nhelp: {}\n", path,
             std::filesystem::is_directory(path, ignored) ? "it is a folder" : "it may not be run",
             "name the program that was built, such as generated/NAME/build/NAME");
  else
    complain("error: cannot start `{}`: {}\n", path, std::strerror(refused));
  return kInputOutput;
}

}  // namespace eagerx::gen
