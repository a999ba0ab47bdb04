// Kinds of entries of a case file: a quantity, a whole number, one of several words. Each knows how its text
// is read and checked, and says what is admissible.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/case_declaration.h"
#include "core/error.h"
#include "core/law_declaration.h"
#include "core/nearest_name.h"
#include "core/quantity.h"

namespace asperity {

/// Where in the input a value is kept.
template <class T>
using Member = std::function<T&(CaseInput&)>;

/// A number with a unit of `dimension`, kept in SI. Reading it throws InputError outside of `range`.
CaseEntry quantity(std::string section, std::string name, const Member<double>& member, Dimension dimension,
                   Range range, std::string default_text, std::string example, std::string documentation);

/// A whole number of at least `low`. Reading another throws InputError.
CaseEntry whole_number(std::string section, std::string name, const Member<int>& member, int low,
                       std::string default_text, std::string documentation);

/// One of several words, each with the value it stands for. Reading another throws InputError.
template <class T>
CaseEntry choice(std::string section, std::string name, const Member<T>& member,
                 std::vector<std::pair<std::string, T>> values, std::string default_text,
                 std::string documentation) {
  std::vector<std::string> words;
  std::string admissible;
  for (const auto& [word, value] : values) {
    words.push_back(word);
    admissible += (admissible.empty() ? "" : " | ") + word;
  }
  return {std::move(section),
          std::move(name),
          std::move(default_text),
          "",
          admissible,
          std::move(documentation),
          [=](CaseInput& input, const std::string& text) {
            for (const auto& [word, value] : values)
              if (word == text) {
                member(input) = value;
                return;
              }
            const std::string meant = nearest_name(text, words);
            throw InputError("'" + text + "' is not one of " + admissible +
                             (meant.empty() ? "" : "; did you mean '" + meant + "'?"));
          }};
}

/// What a law takes, of a number or of words; one that earlier versions did not have counts only if given.
CaseEntry law_entry(const std::string& section, const ParameterEntry& parameter,
                    const Member<LawValues>& values);

/// true or false.
CaseEntry flag(std::string section, std::string name, const Member<bool>& member, std::string default_text,
               std::string documentation);

/// The entry with the mark: how finely something is solved, how or where it is written, not what is solved.
CaseEntry not_physical(CaseEntry entry);

}  // namespace asperity
