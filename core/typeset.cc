#include "core/typeset.h"

#include <cctype>
#include <map>
#include <set>
#include <vector>

namespace asperity {
namespace {

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// Letters that TeX has a name for, and functions; empty: prose or a letter.
std::string command_of(const std::string& word) {
  static const std::set<std::string> same{"alpha", "beta",  "gamma", "delta",  "theta", "lambda", "mu",
                                          "nu",    "rho",   "tau",   "sigma",  "phi",   "chi",    "pi",
                                          "xi",    "kappa", "omega", "ln",     "exp",   "min",    "max",
                                          "cos",   "sin",   "tan",   "arctan", "sinh"};
  static const std::map<std::string, std::string> others{{"eps", "\\varepsilon"},
                                                         {"eps0", "\\varepsilon_{0}"},
                                                         {"int", "\\int"},
                                                         {"asinh", "\\operatorname{arsinh}"},
                                                         {"frac", "\\operatorname{frac}"},
                                                         {"log10", "\\log_{10}"}};
  if (same.count(word)) return "\\" + word;
  const auto other = others.find(word);
  return other == others.end() ? "" : other->second;
}

class Typesetter {
 public:
  explicit Typesetter(const std::string& text) : text_(text) {}

  std::string tex() {
    while (at_ < text_.size()) step();
    return out_;
  }

 private:
  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  char next() const { return at_ + 1 < text_.size() ? text_[at_ + 1] : '\0'; }

  void step() {
    const char c = now();
    if (is_letter(c)) return word();
    if (c == '^') return exponent();
    if (c == ' ') return space();
    ++at_;
    if (const std::string two{c, now()}; two == "<=" || two == ">=" || two == "<<" || two == "<-") {
      ++at_;
      out_ += two == "<=" ? "\\le" : two == ">=" ? "\\ge" : two == "<<" ? "\\ll" : "\\leftarrow";
      if (is_letter(now())) out_ += ' ';
      return;
    }
    if (c == '|') return void(out_ += is_letter(now()) ? "\\vert " : "\\vert{}");
    if (c == '(' || c == '[') ++depth_;
    if (c == ')' || c == ']') --depth_;
    if (c == ';' || c == ',')
      return void(out_ += std::string(1, c) + (now() == ' ' && depth_ == 0 ? "\\quad" : ""));
    if (c == '%' || c == '&' || c == '#' || c == '$' || c == '_') out_ += '\\';
    out_ += c;
  }

  /// Between what is multiplied a thin one.
  void space() {
    ++at_;
    const auto is_operand = [](char c) {
      return is_letter(c) || is_digit(c) || c == ')' || c == ']' || c == '*' || c == '(' || c == '[';
    };
    const char before = at_ >= 2 ? text_[at_ - 2] : '\0';
    if (!is_operand(before) || !is_operand(now())) return void(out_ += ' ');
    out_ += is_prose_ || prose_is_next() ? "\\ " : "\\, ";
  }

  bool prose_is_next() const {
    std::size_t end = at_;
    while (end < text_.size() && is_letter(text_[end])) ++end;
    const std::string next = text_.substr(at_, end - at_);
    return next.size() > 1 && command_of(next).empty() && next[0] != 'd';
  }

  void exponent() {
    ++at_;
    is_prose_ = false;
    out_ += "^{" + exponent_text() + "}";
  }

  /// In brackets, which it does without, or a number or letters.
  std::string exponent_text() {
    std::string inner;
    if (now() == '(') {
      int depth = 0;
      do {
        if (now() == '(') ++depth;
        if (now() == ')') --depth;
        inner += now();
        ++at_;
      } while (depth > 0 && at_ < text_.size());
      inner = inner.substr(1, inner.size() - 2);
    } else {
      while (is_letter(now()) || is_digit(now()) || now() == '.' || (inner.empty() && now() == '-'))
        inner += now(), ++at_;
    }
    return Typesetter(inner).tex();
  }

  std::string read_word() {
    std::string word;
    while (is_letter(now()) || is_digit(now())) word += now(), ++at_;
    return word;
  }

  void word() {
    std::string word = read_word();
    if (now() == '_' && word.size() > 1 && command_of(word).empty()) {  // an identifier
      while (now() == '_') ++at_, word += "\\_" + read_word();
      out_ += "\\text{" + word + "}";
      is_prose_ = true;
      return;
    }
    out_ += symbol_of(word);
    if (now() == '_') subscript();
    if (now() == '*') {
      ++at_;
      // TeX takes one exponent.
      if (now() == '^')
        ++at_, out_ += "^{*" + exponent_text() + "}";
      else
        out_ += "^{*}";
    }
  }

  /// A letter, a letter with digits as its index, a name, or prose.
  std::string symbol_of(const std::string& word) {
    is_prose_ = false;
    if (const std::string command = command_of(word); !command.empty())
      return command + (is_letter(now()) || now() == ' ' ? " " : "");
    std::size_t letters = word.size();
    while (letters > 0 && is_digit(word[letters - 1])) --letters;
    std::string name = word.substr(0, letters);
    const std::string index = word.substr(letters);
    if (!index.empty()) return symbol_of(name) + "_{" + index + "}";
    if (name == "d" && now() == ' ' && is_letter(next()) &&
        is_letter(at_ + 2 < text_.size() ? text_[at_ + 2] : '\0'))
      return ++at_, "\\mathrm{d}";
    if (name.size() == 1) return name;
    if (name[0] == 'd' && (name.size() == 2 || !command_of(name.substr(1)).empty()))
      return "\\mathrm{d}" + symbol_of(name.substr(1));
    is_prose_ = true;
    return prose_from(name);
  }

  /// With the words of prose that follow.
  std::string prose_from(std::string text) {
    for (;;) {
      std::size_t end = at_ + 1;
      if (now() == '\'') {  // "Masing's", "Maugis'"
        while (end < text_.size() && is_letter(text_[end])) ++end;
        text += text_.substr(at_, end - at_);
        at_ = end;
        continue;
      }
      if (now() != ' ' && now() != '-') break;
      while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
      const std::string next = text_.substr(at_ + 1, end - at_ - 1);
      const bool is_word = next.size() > 1 && is_letter(next[0]) && command_of(next).empty() &&
                           !(next.size() == 2 && (next[0] == 'd' || is_digit(next[1]))) &&
                           !(end < text_.size() && text_[end] == '_');
      if (!is_word) break;
      text += now() + next;
      at_ = end;
    }
    return "\\text{" + text + "}";
  }

  void subscript() {
    ++at_;
    std::string index = read_word();
    const bool is_prose = index.size() > 1 && is_letter(index[0]) && command_of(index).empty();
    out_ += "_{" + (is_prose ? "\\text{" + index + "}" : Typesetter(index).tex()) + "}";
  }

  const std::string text_;
  std::size_t at_ = 0;
  std::string out_;
  int depth_ = 0;          ///< of brackets
  bool is_prose_ = false;  ///< what was written last
};

/// Parts between commas and semicolons that no brackets hold, put together into lines of at most so many
/// characters where they can be.
std::vector<std::string> in_lines(const std::string& equation, std::size_t longest) {
  std::vector<std::string> lines{""};
  std::string part;
  int depth = 0;
  const auto add = [&] {
    if (!lines.back().empty() && lines.back().size() + part.size() > longest) lines.emplace_back();
    if (lines.back().empty()) part.erase(0, part.find_first_not_of(' '));
    lines.back() += part;
    part.clear();
  };
  for (const char c : equation) {
    part += c;
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    if (depth == 0 && (c == ',' || c == ';')) add();
  }
  add();
  return lines;
}

}  // namespace

std::string typeset(const std::string& equation) { return Typesetter(equation).tex(); }

std::string displayed(const std::string& equation, Equations how) {
  if (how == Equations::plain) return "    " + equation;
  constexpr std::size_t longest = 70;  // of a page's width, in plain characters
  const std::vector<std::string> lines = in_lines(equation, longest);
  if (lines.size() == 1) return "$$ " + typeset(equation) + " $$";
  std::string rows;
  for (const std::string& line : lines) rows += (rows.empty() ? "" : " \\\\\n") + typeset(line);
  return "$$\n\\begin{gathered}\n" + rows + "\n\\end{gathered}\n$$";
}

}  // namespace asperity
