// What a user pastes into an engine, from parameters.json: each coefficient with the lever arm, effective
// radius and unit that the engine means, and in the header what it cannot express with the error this makes
// at both ends of the fitted loads.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engines/folding.h"
#include "engines/parameters/contact_parameters.h"

namespace asperity {

/// What a user may choose.
struct EngineInputOptions {
  /// Load at which the limits are right [N]; without one, as much too large at one end of the fitted loads as
  /// too small at the other.
  std::optional<double> load;
  std::string normal_law = "hertz";  ///< or the engine's elasto-plastic one
};

class InputNotes;
struct MaterialMatrix;
struct ParticleBox;

/// An engine whose input asperity writes.
class WrittenEngine {
 public:
  virtual ~WrittenEngine() = default;
  virtual std::string key() const = 0;   ///< as it is named on the command line: "lammps"
  virtual std::string name() const = 0;  ///< "LAMMPS"
  /// What a user pastes for the contact of the notes. Throws InputError for a record that lacks what is
  /// needed.
  virtual std::string contact_input(InputNotes& notes) const = 0;
  /// Its elasto-plastic normal law, "luding" or "mdr"; empty where asperity writes none for it.
  virtual std::string elastoplastic_law() const { return ""; }
  /// As contact_input(), with that law.
  virtual std::string elastoplastic_input(InputNotes& notes) const;
  /// The contacts of all pairs of materials; throws InputError where that is not written for this engine.
  virtual std::string matrix_input(const MaterialMatrix& matrix) const;
  /// The same where the matrix's normal law yields.
  virtual std::string elastoplastic_matrix_input(const MaterialMatrix& matrix) const;
  /// What the file of these is called beside a box.
  virtual std::string matrix_file() const { return "contacts." + key(); }
  /// Whether it has box_files().
  virtual bool writes_boxes() const { return false; }
  /// Name and text of each file that, beside that of the matrix, runs a box of particles; throws InputError
  /// where that is not written for this engine.
  virtual std::vector<std::pair<std::string, std::string>> box_files(const MaterialMatrix& matrix,
                                                                     const ParticleBox& box) const;
};

/// By its key; throws InputError for an engine that is not known, naming what was meant.
const WrittenEngine& written_engine_of(const std::string& key);

/// Keys of all engines, in alphabetical order.
std::vector<std::string> engine_input_names();

/// Throws InputError for an engine that is not known, naming what was meant, and for a record that lacks what
/// is needed.
std::string engine_input(const std::string& engine, const ContactParameters& parameters,
                         const EngineInputOptions& options = {});

}  // namespace asperity
