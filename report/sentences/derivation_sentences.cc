#include "report/sentences/derivation_sentences.h"

#include <cmath>
#include <map>

#include "core/joined.h"
#include "core/printed.h"
#include "report/sentences/phrases.h"

namespace asperity::report {
namespace {

using About = OpenQuestion::About;
using From = Origin::From;

/// {} is the text, number or extent of the origin.
const std::map<From, const char*>& origin_templates() {
  static const std::map<From, const char*> all{
      {From::materials, "of the materials (Hertz 1882): no case has enough load steps for a fit"},
      {From::material_shear, "of the materials (Mindlin 1949, 2 - nu): no sliding case told it"},
      {From::hertz_fit, hertz_fit},
      {From::hertz_fit_with_offset, hertz_with_offset},
      {From::largest_load, "elastic stiffness at the largest load"},
      {From::yielded, "material yielded"},
      {From::thornton_ning_fit, "Thornton & Ning (1998) fitted to loading and unloading"},
      {From::luding_fit, "Luding (2008) fitted to loading and unloading"},
      {From::pull, "largest pull while unloading; the loads are those reached before, {} contacts"},
      {From::attraction, "Interface/Attraction force of the cases: it pulls until the bodies part"},
      {From::with_attraction, "over the load and an attraction of {} N, which the contact bears"},
      {From::smooth_growth, "of a smooth contact it grows as a^{}, not as a"},
      {From::lateral_stiffness, "k_l = 8 G* a fitted, a Hertz' with E* of this file"},
      {From::dissipation_per_length,
       "energy dissipated per path length by slip, yielding and bonds on the steady first pass"},
      {From::dissipation_per_angle,
       "energy dissipated per angle by slip, yielding and bonds on the steady first pass"},
      {From::steady_resistance, "steady resistance after full slip"},
      {From::odds, "ln of the odds for a over r: {}"},
      {From::other_radii, "lambda told by the particle's other radii"},
      {From::no_offset, "one load cannot tell it; zero is assumed"},
      {From::local_friction, "local friction coefficient that went in: {}"},
      {From::solver, "solved by {}, folders in derivation/cases"}};
  return all;
}

std::string origin_words(const Origin& origin) {
  if (origin.from == From::cases) return source_words(origin.numbers);
  if (origin.from == From::stiffness) return words_of(origin.source);
  std::string pattern = origin_templates().at(origin.from);
  if (pattern.find("{}") == std::string::npos) return pattern;
  return say(pattern, {std::isfinite(origin.number) ? printed("%.3g", origin.number)
                       : origin.text.empty()        ? "a version that is not said"
                                                    : origin.text});
}

/// {what}, {folders}, {entry} and {number} are those of the question.
const char* template_of(About about) {
  static const std::map<About, const char*> all{
      {About::hertz_fit,
       "E* of the contact: no case has the three load steps (four if rough) that a Hertz fit needs; the "
       "materials' own value is written. Set Experiment/Load steps to 10"},
      {About::exponent,
       "exponent of the normal law: it takes five load steps; set Experiment/Load steps to 10"},
      {About::normal_stiffness,
       "k_n: no case has a stiffness at its largest load; set Experiment/Unload = true"},
      {About::elastoplastic,
       "elasto-plastic normal law: it takes a case of experiment normal that yields in bulk, with four steps "
       "of loading and three of unloading or more; set Experiment/Unload = true, Load steps and Unload "
       "steps to 10, or a higher load"},
      {About::pull_off,
       "pull-off force: no case of experiment normal was drawn apart; set Experiment/Unload = true"},
      {About::growth, "how {what} grows with the load: solve a case at another load"},
      {About::scatter,
       "scatter of {what} between realisations: solve the same case with two or more seeds of its roughness"},
      {About::mesh_error,
       "error of the mesh in {what}: solve one case again with twice the Mesh/Interface spacing"},
      {About::experiment, "all of it: there is no case with Experiment/Type = {motion}"},
      {About::slip,
       "the resistance of cases that did not slip fully, or for fewer than three steps ({folders}): set "
       "{entry} to more"},
      {About::end_of_change,
       "where the resistance ends: it still changes, by up to {share} from the first half of the path to the "
       "second ({folders}); set {entry} to more"},
      {About::long_paths,
       "fluctuation over long paths: the shortest steady path is {tenths} contact diameters, two or more are "
       "wanted; set {entry} to more"},
      {About::offset,
       "h: one load cannot part mu f from mu h; solve a case at a tenth or ten times the load"},
      {About::test_of_law,
       "whether the law holds: it passes through two cases whatever they are, and its uncertainty takes each "
       "for good to a thousandth; solve a third load"},
      {About::length,
       "the length lambda: odds below 20 to 1; lambda = a is written, as friction over the contact demands. "
       "Loads from 0.1 to 3 mN, four or more, or other radii of the particle would tell"},
      {About::stiffness,
       "the stiffness: no case was reversed after full slip; set Experiment/Reverse = true"},
      {About::rolling_stiffness,
       "the stiffness: no case was reversed after full slip; set Experiment/Reverse = true and "
       "Experiment/Return distance to a contact radius or more"},
      {About::shear_modulus, "G*: that of the materials is written, {pressure}"}};
  return all.at(about);
}

std::string body_words(const ContactBody& body) {
  return say("E {}, nu {}", {format_quantity(body.youngs_modulus, Dimension::pressure),
                             format_quantity(body.poissons_ratio, Dimension::none)});
}

std::string title_of(const Derivation& derivation) {
  const ContactParameters& p = derivation.parameters;
  return say("Derived from {} solved case{}: sphere {} ({}) on plane ({})",
             {std::to_string(derivation.cases), derivation.cases == 1 ? "" : "s",
              length_text(p.particle.radius), body_words(p.particle), body_words(p.target)});
}

/// Findings; the two laws of a choice of length come before what chooses.
std::vector<std::string> found_words(const LawFindings& findings) {
  std::vector<std::string> words;
  for (const Fact& fact : findings.found) {
    if (const auto* length = std::get_if<LengthFact>(&fact)) {
      words.push_back("lambda = r: " + law_words(length->choice.with_radius, "mu"));
      words.push_back("lambda = a: " + law_words(length->choice.with_contact, "mu"));
    }
    words.push_back(words_of(fact));
  }
  return words;
}

std::string law_title(const LawFindings& findings) {
  if (!findings.mode) return "Normal";
  std::vector<std::string> radii;
  for (const double radius : findings.radii) radii.push_back(length_text(radius));
  return findings.mode->title +
         (radii.empty() ? "" : say(", over the radii {} with one mu and h for all", {joined(radii, ", ")}));
}

}  // namespace

std::string words_of(const OpenQuestion& q) {
  std::string words = template_of(q.about);
  const auto fill = [&](const std::string& name, const std::string& text) {
    if (const auto at = words.find(name); at != std::string::npos) words.replace(at, name.size(), text);
  };
  fill("{what}", words_of(q.what));
  fill("{share}", share_text(q.number));
  fill("{tenths}", number_text({std::round(10 * q.number) / 10}));
  fill("{pressure}", quantity_text({q.number}, Dimension::pressure));
  if (q.mode) fill("{entry}", q.mode->path_entry), fill("{motion}", name_of(q.mode->motion));
  fill("{folders}", joined(q.folders, ", "));
  return words;
}

void write_words(Derivation& derivation) {
  ContactParameters& parameters = derivation.parameters;
  parameters.title = title_of(derivation);
  for (const auto& [member, origins] : derivation.origins) {
    std::vector<std::string> words;
    for (const Origin& origin : origins) words.push_back(origin_words(origin));
    (parameters.*member)->provenance = joined(words, "; ");
  }
  for (const LawFindings& findings : derivation.laws) {
    auto& law = parameters.derivation[name_of(findings.motion())];
    law["findings"] = found_words(findings);
    law["not_told"] = nlohmann::ordered_json::array();
    for (const OpenQuestion& question : findings.open) law["not_told"].push_back(words_of(question));
  }
}

std::string law_text(const LawFindings& findings) {
  std::string text = law_title(findings) + "\n";
  for (const auto& words : found_words(findings)) text += "  " + words + "\n";
  for (const auto& question : findings.open) text += "  not identifiable: " + words_of(question) + "\n";
  return text;
}

std::string derivation_text(const Derivation& derivation) {
  std::string text = title_of(derivation);
  for (const auto& [entry, value] : derivation.inputs) {
    const bool says_nothing = value == "smooth" || value == "isotropic" || value == "dugdale" ||
                              value == "inf" || value.rfind('0', 0) == 0;
    const bool is_said = entry.find("Radius") != std::string::npos ||
                         entry.find("Young") != std::string::npos ||
                         entry.find("Poisson") != std::string::npos;
    if (!is_said && (!says_nothing || entry == "Interface/Friction coefficient"))
      text += "\n  " + entry + " = " + value;
  }
  text += "\n";
  for (const auto& law : derivation.laws) text += "\n" + law_text(law);
  return text;
}

}  // namespace asperity::report
