// Where a recording and its simulation part, and which physics was left out: the result
// "asperity-diagnosis/1", SI units.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace asperity {

/// What the diagnosis comes to.
enum class Verdict { no_mismatch, explained, partly_explained, ambiguous, unexplained };

/// As it stands in diagnosis.json.
std::string name_of(Verdict verdict);

/// Does an effect belong to the physics of the contact or to that of the measurement?
enum class EffectKind { contact, instrument };

/// A number with unit and 95 % interval.
struct DiagnosedParameter {
  std::string name, unit;
  double value = 0, low = 0, high = 0;
};

/// An entry of the case with what was left out, and its 95 % interval [SI].
struct CorrectedEntry {
  std::string entry, unit;
  double value = 0, low = 0, high = 0;
  std::string text;  ///< as a case file takes it, where that is more than the value

  /// "0.05 J/m^2"
  std::string written() const;
  /// "95 %: 0.04 to 0.06 J/m^2", or that it was taken and not found.
  std::string interval() const;
};

/// An effect with its parameters and what speaks for it.
struct DiagnosedEffect {
  std::string id, title, equation, source, meaning;
  EffectKind kind = EffectKind::contact;
  double probability = 0;  ///< that it belongs to the explanation, among those that were compared
  std::vector<DiagnosedParameter> parameters;
  std::vector<CorrectedEntry> case_entries;  ///< that stand for it in a case of finite elements
  std::string form;  ///< how it entered a case of finite elements; empty: by its reduced law alone
};

/// An effect that nothing was said of, and why, as the end of a sentence.
struct UntriedEffect {
  std::string effect, why;
};

/// A part of the data where the residual is not noise.
struct MismatchRegion {
  std::string table, channel, segment, variable, unit;
  double from = 0, to = 0;   ///< of the variable
  double size_in_noise = 0;  ///< mean residual in the region over the noise of one sample
  double p_value = 1;        ///< of a departure as large as this by noise alone, anywhere in the data
  double share = 0;          ///< of the excess squared residual
};

/// The noise of one channel.
struct NoiseEstimate {
  double value = 0;  ///< standard deviation of one sample
  std::string unit;
  std::string from;  ///< "given", "given by row", "repeats", "high frequencies"
};

/// How well one model does. Chi-square is beyond what is likely of another realisation of a case's surface
/// (docs/diagnosis.md), the deviations are not.
struct FitQuality {
  double chi2_reduced = 0;            ///< of all samples [-]
  std::map<std::string, double> rms;  ///< of the residual, by channel, in its unit
  double held_out_chi2_reduced = 0;   ///< of data kept out of the fit [-]
  std::size_t samples = 0;            ///< that count
};

/// Another set of effects that the data allow.
struct AlternativeExplanation {
  std::vector<DiagnosedEffect> effects;
  double probability = 0;
  double held_out_chi2_reduced = 0;
  std::string told_apart_by;
};

/// One table's numbers for pictures: recorded, simulated before and after (where nothing is named, with what
/// is nearest).
struct ComparedTable {
  std::string table, channel, unit, variable, variable_unit;
  std::vector<double> x, recorded, before, after, sd;
  std::vector<int> curve;            ///< number of the run and segment each sample belongs to
  std::vector<std::string> segment;  ///< of each sample
  bool is_series = false;
};

/// The response that a simulation gives for each row of one table; NaN: the row drives no simulation.
struct SimulatedRows {
  std::vector<double> before, after;  ///< without what was left out, and with it [SI]
};

/// The simulation that was diagnosed, where it was a case of finite elements.
struct SolvedSimulation {
  bool by_finite_elements = false;
  std::string case_file;              ///< as it was named
  std::string before, after;          ///< where the solutions are: of the case as it was, and as corrected
  int solves = 0;                     ///< cases that the answer rests on, those solved earlier included
  double error = 0;                   ///< of mesh and load steps, as the solution of the case states it
  std::string error_of = "approach";  ///< [m]; "friction", "rolling resistance": as a part of it

  bool is_error_of_approach() const { return error_of == "approach"; }
  /// "its approach is off by 0.05 nm", "its friction is off by 1.2 %".
  std::string off_by() const;
};

struct Diagnosis {
  Verdict verdict = Verdict::unexplained;
  std::string in_words;  ///< the verdict in a sentence or two
  std::map<std::string, NoiseEstimate> noise;
  std::vector<DiagnosedParameter>
      calibrated;  ///< the simulation's own parameters, as calibrated before physics is added
  FitQuality baseline, improved;
  std::vector<MismatchRegion> mismatch, remaining;
  std::vector<DiagnosedEffect> left_out;
  std::vector<AlternativeExplanation> alternatives;
  /// What fits best where the verdict is `unexplained`: to look at, and no answer. Empty: nothing takes
  /// anything away.
  std::vector<DiagnosedEffect> nearest;
  FitQuality with_nearest;
  std::vector<std::string> remarks;  ///< what limits the answer, in sentences
  /// The rows lie on the simulation to a small part of their own deviations: points of a curve fitted to
  /// measurements, and no measurements.
  bool rows_are_points_of_a_curve = false;
  /// What the data could show and the simulation cannot say, or too few values of what it depends on test.
  std::vector<UntriedEffect> not_tried;
  std::vector<ComparedTable> compared;
  std::vector<SimulatedRows> simulated;  ///< one for each table of the recording
  SolvedSimulation simulation;

  /// Entries of the case with all that was left out.
  std::vector<CorrectedEntry> corrected() const;
};

/// diagnosis.json
std::string diagnosis_json(const Diagnosis& diagnosis);

}  // namespace asperity
