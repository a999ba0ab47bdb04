#include "core/law_declaration.h"

namespace asperity {
void join_parameters(const LawDeclaration& law, std::vector<ParameterEntry>& parameters) {
  for (const ParameterEntry& own : law.parameters) {
    const auto same = std::find_if(parameters.begin(), parameters.end(),
                                   [&](const auto& p) { return p.entry == own.entry; });
    if (same == parameters.end()) {
      parameters.push_back(own);
      continue;
    }
    if (same->dimension != own.dimension || same->default_text != own.default_text ||
        same->documentation != own.documentation)
      throw std::logic_error("law '" + law.name + "' declares '" + own.entry +
                             "' otherwise than another law");
    for (const auto& symbol : own.symbols)
      if (std::find(same->symbols.begin(), same->symbols.end(), symbol) == same->symbols.end())
        same->symbols.push_back(symbol);
  }
}

std::string documentation_of(const ParameterEntry& parameter) {
  const std::string mark = "{symbols}";
  std::string text = parameter.documentation;
  const auto at = text.find(mark);
  if (at != std::string::npos) text.replace(at, mark.size(), alternatives(parameter.symbols));
  return text;
}

double default_of(const ParameterEntry& parameter) {
  const auto& words = parameter.words;
  if (!words.empty())
    return static_cast<double>(std::find(words.begin(), words.end(), parameter.default_text) - words.begin());
  return parse_quantity(parameter.default_text, parameter.dimension);
}

std::vector<std::string> given_entries(const std::vector<ParameterEntry>& parameters,
                                       const LawValues& values) {
  std::vector<std::string> given;
  for (const auto& parameter : parameters)
    if (values.at(parameter.entry) != default_of(parameter)) given.push_back(parameter.entry);
  return given;
}

std::string law_in_words(const LawDeclaration& law) {
  std::vector<std::string> entries;
  for (const auto& parameter : law.parameters) entries.push_back(parameter.entry);
  return law.name + " (" + alternatives(entries, " and ") + ")";
}

LawValues with_defaults(const std::vector<ParameterEntry>& parameters, LawValues values) {
  for (const auto& parameter : parameters) values.emplace(parameter.entry, default_of(parameter));
  return values;
}

const ParameterEntry* first_missing(const LawDeclaration& law, const LawValues& values) {
  for (const auto& parameter : law.parameters) {
    const auto given = values.find(parameter.entry);
    if (!parameter.optional && (given == values.end() || given->second == default_of(parameter)))
      return &parameter;
  }
  return nullptr;
}

std::string alternatives(const std::vector<std::string>& words, const std::string& last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? last : ", ") + words[k];
  return text;
}

}  // namespace asperity
