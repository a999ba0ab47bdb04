// Every entry of a case file, declared once: its place in CaseInput, default, admissible values and manual
// text. Reading, checking, the template and the reference manual all work from this list.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/typeset.h"

namespace asperity {

/// One entry.
struct CaseEntry {
  std::string section, name;
  std::string default_text;   ///< empty: required
  std::string example;        ///< a sensible value, shown in the template where there is no default
  std::string admissible;     ///< "a length above 0", in words
  std::string documentation;  ///< one or two sentences
  /// Stores the text's value; throws InputError with the reason alone (the reader adds file and line).
  std::function<void(CaseInput&, const std::string&)> store;
  /// One text for all spellings of a value: a quantity in SI, with 14 digits. Expects a value that `store`
  /// accepts.
  std::function<std::string(const std::string&)> canonical = [](const std::string& text) { return text; };
  /// Decides the answer, so that cases which differ in it are of different contacts or experiments. A new
  /// entry does unless it says otherwise (mesh, solver, steps, output, title).
  bool is_physical = true;
  /// Left at its default it says nothing, so that results of before there was the entry are still of the same
  /// contact.
  bool counts_if_given = false;

  bool required() const { return default_text.empty(); }
};

/// One subsection, for the manual.
struct CaseSection {
  std::string name, documentation;
};

/// Sections in the order of the manual; the first has no name (entries outside of subsections).
const std::vector<CaseSection>& case_sections();

/// Entries in the order of the manual.
const std::vector<CaseEntry>& case_entries();

/// A case file with every entry, its documentation and its default (`asperity case-template`).
std::string case_template();

/// The reference manual in Markdown (`asperity case-reference`, docs/case_reference.md).
std::string case_reference(Equations equations = Equations::plain);

}  // namespace asperity
