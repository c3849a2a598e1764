// Quotes foreign text for a language: one function for each language, and no other way.
#pragma once

#include <string>
#include <string_view>

namespace eagerx::gen {

/// A string literal of C++ with its quotes; any bytes.
std::string cpp_string(std::string_view text);
/// The text between the quotes.
std::string in_cpp_string(std::string_view text);

/// Text for a comment of any language, on one line: it neither ends nor begins a comment, does not
/// continue the line, and displays as written. Other characters are escaped as `\x0a` or `\u202e`.
std::string in_comment(std::string_view text);

/// A YAML scalar as written, so that `1e-3` stays a number; quoted if it could be anything but a
/// scalar.
std::string yaml_scalar(std::string_view text);
/// A text: a word without quotes where every reader of YAML takes it for a text.
std::string yaml_text(std::string_view text);
/// A text, always in quotes. Bytes that are no UTF-8 become U+FFFD: YAML cannot write them.
std::string yaml_string(std::string_view text);
/// The text between the double quotes of a string of JSON or YAML.
std::string in_json_string(std::string_view text);

/// One argument of a command of CMake; any bytes.
std::string cmake_argument(std::string_view text);
/// The text between the quotes of one.
std::string in_cmake_string(std::string_view text);

/// Text of XML and HTML, also between the quotes of an attribute; hidden characters, here and in
/// the languages of pictures, are written as in comments.
std::string xml_text(std::string_view text);

/// A string of Graphviz with its quotes.
std::string dot_string(std::string_view text);
/// A part of the label of one of its records: braces, bars, angles and blanks mean themselves.
std::string dot_record_text(std::string_view text);
/// A part of a quoted label of Mermaid.
std::string mermaid_text(std::string_view text);

/// One word of a POSIX shell; any bytes but 0.
std::string shell_word(std::string_view text);
/// The text between double quotes.
std::string in_shell_string(std::string_view text);

/// A path in a rule of make and ninja (the format of compilers' `-MD`).
std::string make_path(std::string_view path);
/// Whether make_path() can write it: make has no way to write a line break.
bool is_make_path(std::string_view path);

/// Letters, digits and `_.+-/`, not empty: one word in every language above.
bool is_plain_word(std::string_view text);
/// The same without `/`, and neither `.` nor `..`: the name of a file or folder.
bool is_plain_file_name(std::string_view text);
/// Such names, joined by `/`.
bool is_plain_path(std::string_view text);

}  // namespace eagerx::gen
