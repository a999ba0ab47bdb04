#include "results/energy_balance.h"

#include "core/error.h"
#include "core/written_apart.h"

namespace asperity {

bool is_energy_flagged(const SolvedCase& solved) { return solved.open_energy() > flagged_open_energy; }
bool is_energy_refused(const SolvedCase& solved) { return solved.open_energy() > refused_open_energy; }

std::string open_energy_words(const SolvedCase& solved) {
  if (!is_energy_flagged(solved)) return "";
  const double limit = is_energy_refused(solved) ? refused_open_energy : flagged_open_energy;
  const auto [share, allowed] = percents_apart(solved.open_energy(), limit);
  return share + " of its energy is not accounted for, more than " + allowed +
         (is_energy_refused(solved) ? ": none of its numbers can be relied on"
                                    : ": its numbers are uncertain by about as much");
}

void refuse_open_energy(const SolvedCase& solved) {
  if (is_energy_refused(solved))
    throw InputError(solved.folder.string() + ": " + open_energy_words(solved) +
                     "; solve it again in a new folder with more steps (Experiment/Load steps, Motion steps) "
                     "or a finer Mesh/Interface spacing, or leave it out");
}

}  // namespace asperity
