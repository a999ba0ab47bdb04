// The roughness of a contact as a report tells contacts apart by it.
#pragma once

#include <optional>
#include <string>

#include "core/topography_spec.h"
#include "dem_compare/cases/case_collection.h"
#include "dem_compare/numbers/statistics.h"

namespace asperity::report {

/// Of the surface that a section ("Particle", "Substrate") asks to be generated; empty for smooth ones and
/// scans.
std::optional<GeneratorParameters> generator_of(const SolvedCase& solved, const std::string& section);

/// Root mean square height of both surfaces together [m], as given; of a scan, as meshed. NaN where it is not
/// known.
double composite_rms(const SolvedCase& solved);

/// RMS height in the contact region over realisations [m], as meshed.
Scatter meshed_rms(const CaseGroup& group, const std::string& section);

/// What is the same for surfaces that differ by their RMS and seed alone; empty where nothing is generated.
std::string spectrum_shape(const SolvedCase& solved);

}  // namespace asperity::report
