// One effect that a simulation may have left out: what it is called, what it says, and how it changes the
// mechanics. Each is a class in a file of effects/ with the effect's name, registered at that file's end;
// nothing else knows of it.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/typeset.h"
#include "diagnosis/forward/forward_model.h"
#include "diagnosis/mechanics/mechanics.h"
#include "diagnosis/outcome/diagnosis.h"

namespace asperity {

/// One number of an effect's law.
struct EffectParameter {
  std::string name, unit, meaning;
  double low = 0, high = 0;    ///< physical bounds, in `unit`
  bool logarithmic = false;    ///< positive over decades: searched for in its logarithm
  std::vector<double> starts;  ///< values from which a search begins
  /// A value at either bound means something; otherwise it says that the law is not the right one.
  bool bounds_are_meant = false;
  /// Value with which there is no effect, in `unit`: an interval that holds it names none. NaN: there is no
  /// such value.
  double no_effect = std::numeric_limits<double>::quiet_NaN();
  /// Value with which the law does without the parameter, in `unit`: it is free, counts and is said only
  /// where the data earn it. NaN: it always is.
  double absent = std::numeric_limits<double>::quiet_NaN();
  /// What it may be off by at 95 %, as a part of its value, where that is not what its law is off by: of a
  /// period, which data show whatever the form of what repeats. NaN: what the law is off by.
  /// A share [-].
  double off_by = std::numeric_limits<double>::quiet_NaN();
};

/// What an effect says of itself.
struct EffectDescription {
  std::string id, title, equation, source;
  std::string meaning;  ///< for the reader of a report: what it means physically
  EffectKind kind = EffectKind::contact;
  std::vector<Motion> modes;
  /// Parameters of the simulation that have no meaning any more with this effect.
  std::vector<std::string> replaces{};
  /// Parts of the mechanics that only one effect can hold at once.
  std::vector<std::string> slots{};
  bool takes(const std::string& slot) const {
    return std::find(slots.begin(), slots.end(), slot) != slots.end();
  }
  /// Effects are put together in this order: geometry, laws, what stands around them.
  int order = 2;
  /// False where the response jumps as a parameter moves (a snap of the contact, an event of slip, comes a
  /// sample earlier).
  bool is_smooth = true;
  /// What its law may be off by, as a part of what it changes: published laws of the same physics differ by
  /// as much.
  /// A share [-].
  double accuracy = usual_accuracy;
  static constexpr double usual_accuracy = 0.05;  ///< of a law that is exact but for the bodies' own ways
  /// The same as a part of the whole response, for laws that part where what they change is still small.
  /// A share [-].
  double accuracy_of_response = 0;  ///< at most accuracy times the largest change of the run
};

/// With fewer different values of a variable, an effect's parameters pass through whatever was recorded, and
/// nothing tests its law.
struct NeededValues {
  std::string channel;
  int count = 0;
};

/// Where an effect enters a simulation by finite elements.
enum class EntersBy {
  measurement,      ///< it acts on any history: compliance, offset, drift, tilt
  in_series,        ///< by its own reduced law, as a displacement beside that of the solved contact
  beside,           ///< by its own reduced law, as a force beside that of the solved contact
  on_friction,      ///< by its own reduced law, as a change of the friction that was solved
  on_force,         ///< by its own reduced law, as a change in time of the normal force that was solved
  finite_elements,  ///< entries of the case
  reduced_law_only  ///< it has no form there yet
};

/// One starting point of a search, a value for each parameter.
using EffectStart = std::vector<double>;

/// An effect by its name, with points from which a search for its parameters begins.
struct SimplerForm {
  std::string effect;
  std::vector<EffectStart> starts;
};

class Effect {
 public:
  virtual ~Effect() = default;
  /// What it says of itself.
  virtual const EffectDescription& description() const = 0;
  /// Free numbers with bounds and starts that suit the experiment.
  virtual std::vector<EffectParameter> parameters(const Experiment& experiment) const = 0;
  /// Whether such a recording can show it at all (holds, reversals, several speeds, ...).
  virtual bool can_show(const Experiment&) const { return true; }
  /// What a recording must vary for it, and how often.
  virtual NeededValues needs() const { return {}; }
  /// What would show the effect beyond doubt and was not recorded, as advice to the experimenter; empty where
  /// it was. Without it, other causes look alike: the effect is a candidate and no answer.
  virtual std::string not_recorded(const Experiment&) const { return ""; }
  /// Whether it gives a number of the simulation another value, and adds no physics: in the evidence it
  /// counts by its parameters alone, and it is no second law that would only mend what the first is off by.
  virtual bool is_another_value() const { return false; }
  /// Whether parameters found stand for this effect, and not for a simpler one that it holds as a limit, nor
  /// for something else whose form the recording shows.
  virtual bool is_itself(const Experiment&, const double*) const { return true; }
  /// That simpler effect near these parameters; without a name where there is none.
  virtual SimplerForm simpler_form(const Experiment&, const double*) const { return {}; }
  /// How many effects its law stands for [-]: of one that holds another's as a limit both, so that in the
  /// evidence what it adds to that counts as an effect of its own.
  virtual int effects_held() const { return 1; }
  /// Whether its law has no history: its error at a load is then the same on loading, on unloading and in
  /// each run.
  virtual bool is_one_curve(const Experiment&) const { return false; }
  /// How many numbers its law takes from parts of the recording itself beside its parameters [-]; each counts
  /// as a parameter that the samples of its part tell.
  virtual double numbers_read_off(const Experiment&, const double*) const { return 0; }
  /// Further starting points read off the residuals before physics is added.
  virtual std::vector<EffectStart> starts(const Samples&, const std::vector<double>&) const { return {}; }
  /// What the simulation's own laws leave open of each parameter: half a 95 % interval, in its unit; empty:
  /// nothing.
  virtual std::vector<double> left_open(const Experiment&) const { return {}; }
  /// How it enters a case of finite elements that is pressed as this experiment is.
  virtual EntersBy enters_by(const Experiment&) const {
    return description().kind == EffectKind::instrument ? EntersBy::measurement : EntersBy::reduced_law_only;
  }
  /// Its parameters where the case has it already, as the case is; empty where it has not.
  virtual std::vector<double> values_in_case(const Experiment&) const { return {}; }
  /// Whether a contact with it comes back on another curve than it went, so that the unloading from each
  /// turning point is a solution of its own. (Of surfaces that attract, that from the largest load is solved,
  /// to where they part, and stands for the others.)
  virtual bool returns_on_another_curve() const { return false; }
  /// How far beyond first touch a contact with these parameters has to be pulled until it is open [m]; 0: it
  /// does not attract. One that does is driven by displacement.
  virtual double opening_distance(const Experiment&, const double*) const { return 0; }
  /// Entries of the case that stand for these parameters; empty for EntersBy other than finite elements.
  virtual std::vector<CaseChange> case_changes(const Experiment&, const double*) const { return {}; }
  /// The parameters of the case that case_changes() makes: others where its mesh does not resolve these, of
  /// which the reduced law then says the difference.
  virtual std::vector<double> values_as_solved(const Experiment& experiment, const double* values) const {
    return {values, values + parameters(experiment).size()};
  }
  /// Entries of a corrected case that stand for what was found, with intervals; those of case_changes() over
  /// all corners of the parameters' intervals where nothing else is said.
  virtual std::vector<CorrectedEntry> corrected_entries(const Experiment& experiment,
                                                        const std::vector<DiagnosedParameter>& found) const;
  /// Why these parameters stand for no entry of a corrected case, as a sentence; empty: nothing speaks
  /// against.
  virtual std::string why_no_entry(const Experiment&, const std::vector<DiagnosedParameter>&) const {
    return "";
  }
  /// Why it has no form of finite elements, as the end of a sentence; empty where it has one.
  virtual std::string why_not_by_finite_elements(const Experiment&) const {
    return "there is no form of it for finite elements yet";
  }
  /// Changes the mechanics.
  virtual void assemble(Mechanics& mechanics, const double* parameters) const = 0;

  const std::string& id() const { return description().id; }
  /// Whether it can act in recordings of this motion.
  bool acts_in(Motion mode) const {
    for (const Motion known : description().modes)
      if (known == mode) return true;
    return false;
  }
  /// Whether the recording varies what the effect is known by.
  bool has_what_it_needs(const Experiment& experiment) const {
    const auto varied = experiment.different.find(needs().channel);
    return (varied == experiment.different.end() ? 0 : varied->second) >= needs().count;
  }
  bool is_shown_by(const Experiment& experiment) const {
    return acts_in(experiment.mode) && has_what_it_needs(experiment) && can_show(experiment);
  }
};

/// Why an effect cannot be tried in a case of finite elements, as the end of a sentence; empty where it can.
std::string why_without_form(const Effect& effect, const Experiment& experiment);

/// All effects, by name.
const std::vector<std::unique_ptr<Effect>>& effect_catalogue();
/// Throws InputError with the nearest name.
const Effect& effect_of(const std::string& id);
/// The manual page of all effects in Markdown.
std::string effects_manual(Equations equations = Equations::plain);

}  // namespace asperity

/// Registers a class as the effect of the file `id`.cc; the build finds the file.
#define ASPERITY_EFFECT(id, Class)                                          \
  namespace asperity::effects {                                             \
  std::unique_ptr<Effect> make_##id() { return std::make_unique<Class>(); } \
  }
