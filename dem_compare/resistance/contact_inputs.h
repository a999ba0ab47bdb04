// What makes a contact, as the entries of its case file: the same for all its motions, loads, meshes and realisations.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "dem_compare/solved_case.h"

namespace asperity {

/// Entries of both bodies and of the interface and their texts, seeds left out, without what cannot matter: hardening
/// without yielding, the law of an adhesion that is zero.
using ContactInputs = std::map<std::string, std::string>;

ContactInputs inputs_of(const SolvedCase& solved);

/// True if a body ("Particle", "Substrate") has a finite yield stress.
bool yields(const ContactInputs& inputs, const std::string& body);

/// Names of the entries in which both differ.
std::vector<std::string> differing_entries(const ContactInputs& one, const ContactInputs& other);

}  // namespace asperity
