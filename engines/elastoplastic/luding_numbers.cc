#include "engines/elastoplastic/luding_numbers.h"

#include "core/error.h"
#include "engines/text_number.h"

namespace asperity {

using P = ContactParameters;

double elastoplastic_number(const InputNotes& notes, std::optional<EffectiveQuantity> P::*member) {
  const P& record = notes.record();
  if (record.*member) return (record.*member)->value;
  for (const auto& entry : quantity_entries())
    if (entry.member == member)
      throw InputError(record.file + ": 'quantities' has no '" + entry.key + "' (" + entry.meaning +
                       "); a solved case of this contact with Experiment/Type = normal that yields and is "
                       "unloaded tells it to 'asperity derive'. Without one, leave --normal-law out");
  throw InputError(record.file + ": a quantity is missing");
}

LudingNumbers luding_numbers(InputNotes& notes, const std::string (&names)[4]) {
  const P& record = notes.record();
  LudingNumbers numbers;
  numbers.k1 = elastoplastic_number(notes, &P::luding_k1);
  numbers.kp = elastoplastic_number(notes, &P::luding_kp);
  numbers.kc = value_or_zero(record.luding_kc);
  const double approach = elastoplastic_number(notes, &P::luding_delta_p);
  if (!(numbers.kp > numbers.k1) || !(numbers.k1 > 0) || !(approach > 0))
    throw InputError(record.file +
                     ": Luding's law needs luding_kp above luding_k1, and luding_k1 and luding_delta_p above "
                     "zero; derive them anew from a case that yields and is unloaded");
  numbers.phi = approach * (numbers.kp - numbers.k1) / numbers.kp / (2 * notes.effective_radius());
  notes.meaning(names[0], numbers.k1, "N/m", "k1, F = k1 delta in loading");
  notes.meaning(names[1], numbers.kp, "N/m",
                "k_p, unloading from delta_p; k2 = k1 + (k_p - k1) delta_max/delta_p "
                "below");
  notes.meaning(names[2], numbers.kc, "N/m", "k_c, F >= -k_c delta");
  notes.meaning(names[3], numbers.phi, "",
                "phi_f, delta_p = k_p/(k_p - k1) phi_f 2 R_e = " + text_number(approach) + " m");
  numbers.sliding = notes.sliding();
  notes.meaning("friction", numbers.sliding, "", "|f_l| <= mu |F|");
  numbers.lateral = notes.constant_lateral_stiffness();
  notes.cannot("approaches beyond delta_p = " + text_number(approach) + " m, load " +
               text_number(numbers.k1 * approach) +
               " N: the law is elastic with k_p there, and nothing was solved");
  if (numbers.kc == 0) notes.leaves_out_pull_off("the record has no luding_kc");
  notes.cannot("Hertz' curve: k1 is a straight line that is right on the whole up to delta_p");
  return numbers;
}

}  // namespace asperity
