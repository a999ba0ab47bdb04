#include "engines/yade_contacts.h"

#include "engines/text_number.h"

namespace asperity {

const char* const yade_contact_functions = R"(
if 'asperity_contacts' not in globals(): asperity_contacts = {}  # by the labels of both materials
asperity_known = {}  # contacts of the step before

def asperity_add(i, force, moment):
    # to the forces of this step: force and moment of the first body on the second
    for body, sign, arm in ((i.id1, -1, i.geom.refR1), (i.id2, 1, -i.geom.refR2)):
        lever = i.geom.contactPoint - O.bodies[body].state.pos
        if O.periodic:  # the bodies may stand in different cells
            lever = i.geom.normal*(arm*(1 - i.geom.penetrationDepth/2/abs(arm)))
        O.forces.addF(body, sign*force)
        O.forces.addT(body, sign*(lever.cross(force) + moment))

def asperity_radius(i):
    # of a wall or facet that of the sphere, which the functor takes for two spheres
    radii = [O.bodies[b].shape.radius for b in (i.id1, i.id2) if isinstance(O.bodies[b].shape, Sphere)]
    return radii[0]*radii[1]/(radii[0] + radii[1]) if len(radii) == 2 else radii[0]
)";

namespace {
const char* const mindlin_functions = R"(
def asperity_begin(i, numbers):
    # the law has acted once with the functor's numbers: that is taken back, and the record's act in
    # the same step
    phys, n = i.phys, i.geom.normal
    stiffer = numbers['kno']/phys.kno if phys.kno > 0 else 1
    force, moment = phys.normalForce + phys.shearForce, phys.momentBend + phys.momentTwist
    for key, value in numbers.items():
        setattr(phys, key, value)
    phys.normalViscous = phys.normalViscous*stiffer**0.5
    phys.normalForce = n*max(0, phys.kno*max(0, i.geom.penetrationDepth)**1.5 - n.dot(phys.normalViscous))
    phys.shearElastic = phys.shearForce = phys.shearViscous = phys.usElastic = phys.usTotal = Vector3.Zero
    phys.momentBend = phys.momentTwist = Vector3.Zero
    asperity_add(i, phys.normalForce - force, -moment)

def asperity_relax(i):
    # lateral stiffness goes with the contact radius: as that falls, so does the lateral force that is held
    apart = i.geom.normal.dot(O.bodies[i.id2].state.vel - O.bodies[i.id1].state.vel)*O.dt
    depth = max(0, i.geom.penetrationDepth)
    if apart > 0:
        i.phys.shearElastic = i.phys.shearElastic*(depth/(depth + apart))**0.5

def asperity_held(moment, most):
    return moment*(most/moment.norm()) if moment.norm() > most*(1 + 1e-12) else moment

def asperity_limit(i, twist_limit):
    # MindlinPhys has no limit of torsion, and none of rolling where that is zero
    phys, F = i.phys, i.phys.normalForce.norm()
    bend, twist = (asperity_held(phys.momentBend, phys.maxBendPl*F),
                   asperity_held(phys.momentTwist, twist_limit*F))
    change = bend + twist - phys.momentBend - phys.momentTwist
    if change.norm() > 0:
        phys.momentBend, phys.momentTwist = bend, twist
        asperity_add(i, Vector3.Zero, change)

def asperity_find(i):
    # numbers and torsion limit of a contact of this record's materials; None: other materials keep their own
    contact = asperity_contacts.get(frozenset(O.bodies[b].material.label for b in (i.id1, i.id2)))
    if contact is None:
        return None
    numbers, size = dict(contact['numbers']), asperity_radius(i)/contact['radius']
    numbers['kno'] *= size**0.5
    numbers['kso'] *= size**0.5
    moments = size if contact.get('goes_with_size') else 1
    numbers['kr'] *= moments**2
    numbers['ktw'] *= moments**2
    numbers['maxBendPl'] *= moments
    if any(getattr(i.phys, key) != value for key, value in numbers.items()):
        asperity_begin(i, numbers)
    return contact['twist_limit']*moments

def asperity_step():
    global asperity_known
    if not asperity_known:
        for label in set().union(*asperity_contacts):
            O.materials[label]  # an error where no material has this label
    now = {}
    for i in O.interactions:
        key = (i.id1, i.id2, i.iterMadeReal)
        now[key] = twist_limit = asperity_known[key] if key in asperity_known else asperity_find(i)
        if twist_limit is not None:
            asperity_relax(i)
            asperity_limit(i, twist_limit)
    asperity_known = now
)";
}  // namespace

std::string yade_functions() { return std::string(yade_contact_functions) + mindlin_functions; }

std::string yade_contact_entry(const std::string& label, const std::string& other_label, double radius,
                               const YadeContact& contact) {
  return "asperity_contacts[frozenset([" + label + ", " + other_label +
         "])] = dict(\n    radius=" + text_number(radius) + ", twist_limit=" + text_number(contact.twist) +
         ", goes_with_size=" + (contact.goes_with_size ? "True" : "False") +
         ",\n    numbers=dict(kno=" + text_number(contact.kno) + ", kso=" + text_number(contact.kso) +
         ", tangensOfFrictionAngle=" + text_number(contact.friction) +
         ",\n                 kr=" + text_number(contact.kr) + ", ktw=" + text_number(contact.ktw) +
         ", maxBendPl=" + text_number(contact.bend) + "))\n";
}

}  // namespace asperity
