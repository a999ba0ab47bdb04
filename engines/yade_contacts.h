// Python that gives contacts of YADE the numbers of a record, for the named materials alone.
// Ip2_FrictMat_FrictMat_MindlinPhys takes rolling and torsion from one number for all materials, and no hook
// of YADE stands between it and the law. So its own numbers act in the step in which a contact comes into
// being: a function called behind the law takes their forces back in the same step and acts with those of the
// record. It also lays on what the law lacks: a limit of torsion, one of rolling where no force presses, and
// less lateral force as an unloading contact shrinks (Thornton, Cummins & Cleary 2013, Powder Technol. 233;
// without it a spinning impact gains energy).
#pragma once

#include <string>

namespace asperity {

/// Numbers of one contact as attributes of MindlinPhys.
struct YadeContact {
  double kno = 0;             ///< [N/m^(3/2)]
  double kso = 0;             ///< [N/m^(3/2)]
  double friction = 0;        ///< tangensOfFrictionAngle [-]
  double kr = 0, bend = 0;    ///< [N m/rad], maxBendPl [m]; zero: no rolling resistance
  double ktw = 0, twist = 0;  ///< [N m/rad], torsion limit over normal force [m]; zero: none
  bool goes_with_size =
      false;  ///< at other radii kr and ktw go with R_e^2, bend and twist with R_e; else fixed
};

/// Defines asperity_contacts, a dictionary, and asperity_step(), for PyRunner behind InteractionLoop and
/// before NewtonIntegrator, at every step and with initRun=True (else the first step is left out). Twice in
/// one program is as good as once.
std::string yade_functions();

/// The part of it that serves other laws: asperity_contacts, asperity_known, the R_e of a contact, and force
/// and moment on top of what a law has done in this step.
extern const char* const yade_contact_functions;

/// Enters the contact of two materials, given by expressions of their labels (names of variables, or
/// literals); `radius` is the effective radius that kno and kso belong to [m].
std::string yade_contact_entry(const std::string& label, const std::string& other_label, double radius,
                               const YadeContact& contact);

}  // namespace asperity
