#include "engines/escaped_text.h"

#include "core/printable.h"

namespace asperity {
namespace {

/// `text` with each of `characters` (visible ASCII) as \x26.
std::string without(const std::string& text, const std::string& characters) {
  std::string kept;
  for (const char c : text)
    kept += characters.find(c) == std::string::npos ? std::string(1, c)
                                                    : escape_sequence({static_cast<unsigned char>(c), true});
  return kept;
}

std::string in_lammps(const std::string& text) { return without(printable(text), "&\"$"); }

/// PEP 263 asks for "coding", then ':' or '='.
std::string in_python(const std::string& text) {
  const std::string line = printable(text), word = "coding";
  std::string kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool follows = i >= word.size() && line.compare(i - word.size(), word.size(), word) == 0;
    kept += follows ? without(line.substr(i, 1), ":=") : line.substr(i, 1);
  }
  return kept;
}

std::string in_cplusplus(const std::string& text) {
  std::string line = printable(text);
  line.erase(line.find_last_not_of(' ') + 1);  // compilers look for the backslash before trailing blanks, too
  const auto ends_with = [&](const std::string& end) {
    return line.size() >= end.size() && line.compare(line.size() - end.size(), end.size(), end) == 0;
  };
  if (ends_with("\\") || ends_with("?\?/"))
    line = line.substr(0, line.size() - 1) + without(line.substr(line.size() - 1), "\\/");
  return line;
}

}  // namespace

const CommentStyle lammps_comment{"#", in_lammps};
const CommentStyle python_comment{"#", in_python};
const CommentStyle cplusplus_comment{"//", in_cplusplus};
const CommentStyle plain_comment{"#", printable};

std::string CommentStyle::line(const std::string& text) const {
  return text.empty() ? sign : sign + (" " + escaped(text));
}

std::string python_literal(const std::string& text) {
  std::string literal = "'";
  for_each_code_point(text, [&](const CodePoint& character) {
    const bool is_plain = character.is_visible_ascii() && character.value != '\'' && character.value != '\\';
    literal += is_plain ? std::string(1, static_cast<char>(character.value)) : escape_sequence(character);
  });
  return literal + "'";
}

}  // namespace asperity
