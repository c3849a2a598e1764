// Errors in a command line. Inside command_line/ only.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "generator/support/command_line/command_line.hpp"

namespace eagerx::gen {

/// An `error:` line and, where there is one, a `help:` line.
std::string usage_message(const CLI::App& app, const CLI::Error& problem);

/// The message for a value that is not among the choices; its second line lists the choices.
std::string not_a_choice(const std::string& word, const std::vector<std::string>& choices);

/// Of a word that is neither a command of `app` nor a file: the same. Empty if it may be a file.
std::string not_a_command(const CLI::App& app, const std::string& word);

/// Of a word after `help` that is neither a command of `app` nor a topic: the same.
std::string no_help(const CLI::App& app, const std::vector<Topic>& topics, const std::string& word);

}  // namespace eagerx::gen
