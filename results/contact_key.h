// What makes "the same contact": the one definition that derive, compare and resistance go by. All physical
// entries of a case are in it; result.json lists them (`inputs`, `entries`), so that an entry which a later
// version adds is in it too.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "results/solved_case.h"

namespace asperity {

/// "Section/Entry" and text; quantities in one way of writing (700 pm, not 0.7 nm), surfaces without their
/// seeds, which make realisations of the same surface.
using ContactInputs = std::map<std::string, std::string>;

/// Physical entries but those of the experiment: the same for all motions, loads, meshes and realisations of
/// a contact. A result that does not list them (solved by an earlier version) gives those of its case.prm and
/// its own numbers; what these do not say has the default of that version. Throws InputError naming folder
/// and entry.
ContactInputs contact_inputs(const SolvedCase& solved);

/// With all entries of the experiment, its steps too: the same for all meshes and realisations of a case.
ContactInputs case_inputs(const SolvedCase& solved);

/// True if a body ("Particle", "Substrate") has a finite yield stress.
bool yields(const ContactInputs& inputs, const std::string& body);
/// True if the shear modulus of a body ("Particle", "Substrate") relaxes with time.
bool relaxes(const ContactInputs& inputs, const std::string& body);
/// True if the surfaces attract: work of adhesion, liquid bridges, patch potentials, or a force.
bool adheres(const ContactInputs& inputs);

/// Names of the entries in which both differ.
std::vector<std::string> differing_entries(const ContactInputs& one, const ContactInputs& other);

/// Both surfaces, seeds included: the same for the same realisation.
std::string realisation_of(const SolvedCase& solved);

}  // namespace asperity
