#include <cmath>
#include <functional>

#include "core/quantity.h"
#include "core/shear_moduli.h"
#include "core/wait_text.h"
#include "report/preview/preview_report.h"

namespace asperity::report {
namespace {

using half_space::CaseContact;
using half_space::CasePreview;
using Say = std::function<void(const std::string&)>;

std::string quantity(double value, Dimension dimension, int digits = 3) {
  return format_quantity(value, dimension, digits);
}
std::string percent(double share) { return quantity(100 * share, Dimension::none, 2) + " %"; }
std::string area_text(double area) { return quantity(area * 1e12, Dimension::none) + " um^2"; }
std::string stiffness_text(double stiffness) { return quantity(stiffness, Dimension::stiffness, 4); }

std::string grid_text(const CaseInput& input, const CaseContact& contact) {
  const auto& grid = contact.grid;
  std::string text = "half-spaces: a square of " + quantity(grid.nx * grid.dx, Dimension::length) + " in " +
                     std::to_string(grid.nx) + " x " + std::to_string(grid.ny) + " cells of " +
                     quantity(grid.dx, Dimension::length);
  const double wave = half_space::shortest_wave(input);
  if (std::isfinite(wave))
    text += ", " + quantity(wave / grid.dx, Dimension::none, 2) + " over the shortest wave of " +
            quantity(wave, Dimension::length);
  if (contact.enlarged > 0)
    text += ", enlarged " + std::to_string(contact.enlarged) + " times until it held the contact";
  return text;
}

void say_yielding(const CaseInput& input, const PreviewedCase& preview, const Say& say) {
  const double largest = preview.contact.fine.largest_pressure();
  bool yields = false;
  for (const auto& body : preview.yielding) {
    const double first = body.first_yield;
    yields = yields || largest > first;
    say(std::string(body.name) + ": a smooth one yields from " +
        quantity(hertz_of(input).force_at_peak_pressure(first), Dimension::force) +
        " on (Hertz); asperities do from about " + quantity(first, Dimension::pressure) + " on, and " +
        (largest > first ? "will here" : "will not here"));
  }
  if (yields) say("the numbers above are those of elastic bodies; where they yield the area is larger");
  if (!preview.contact.capped) {
    if (yields && std::isfinite(preview.hardness))
      say("no pressure reaches the hardness of " + quantity(preview.hardness, Dimension::pressure));
    else if (yields)
      say("a contact of three times the yield stress would go beyond half the Radius, which half-spaces do "
          "not tell");
    return;
  }
  const auto& capped = *preview.contact.capped;
  const std::string pull_off = capped.pull_off ? ", pull-off force from its imprint " +
                                                     quantity(capped.pull_off->force, Dimension::force)
                                               : "";
  say("with pressures up to a hardness of " + quantity(preview.hardness, Dimension::pressure) + ": area " +
      area_text(capped.shape.area) + ", of which " +
      percent(capped.shape.area_at_bound / capped.shape.area_of_cells) + " carries the hardness, approach " +
      quantity(capped.approach(), Dimension::length) + ", stiffness of unloading " +
      stiffness_text(capped.stiffness) + pull_off + " (on one grid, so without an error)");
}

std::string off(double fine, double coarse) { return percent(std::abs(fine - coarse) / fine); }

/// Of smooth bodies that stick together, under a force above 0 (Mindlin 1949; Reissner & Sagoci 1944).
struct SmoothShear {
  double lateral, torsion;  ///< [N/m], [N m]
};
SmoothShear smooth_shear(const CaseInput& input, double force) {
  const double a = hertz_of(input).contact_radius(force);
  const ElasticBody one = elastic_body(input.particle), other = elastic_body(input.substrate);
  return {mindlin_factor * a * reduced_shear_modulus(one, other),
          16.0 / 3 * a * a * a * torsion_modulus(one, other)};
}

void say_shear(const CaseInput& input, const PreviewedCase& preview, const Say& say) {
  const CaseContact &fine = preview.contact.fine, &coarse = preview.contact.coarse;
  const double force = fine.force();
  const auto torsion_text = [](double stiffness) {
    return quantity(stiffness * 1e9, Dimension::none) + " nN m/rad";
  };
  const bool pressed = force > 0;
  const SmoothShear smooth = pressed ? smooth_shear(input, force) : SmoothShear{};
  if (fine.lateral_stiffness > 0)
    say("stuck together: lateral stiffness " + stiffness_text(fine.lateral_stiffness) + " (" +
        off(fine.lateral_stiffness, coarse.lateral_stiffness) +
        (pressed ? "; " + stiffness_text(smooth.lateral) : "") + "), torsion stiffness " +
        torsion_text(fine.torsion_stiffness) + " (" + off(fine.torsion_stiffness, coarse.torsion_stiffness) +
        (pressed ? "; " + torsion_text(smooth.torsion) : "") + ")");
  if (!preview.slip) return;
  const FullSlip &slip = *preview.slip, &coarse_slip = *preview.coarse_slip;
  say("slipping all over: lateral force " + quantity(slip.lateral_force, Dimension::force) + " (" +
      off(slip.lateral_force, coarse_slip.lateral_force) + ")" +
      (pressed ? ", " + quantity(slip.lateral_force / force, Dimension::none) + " of the normal force" : "") +
      ", moment about the axis " + quantity(slip.torsion_moment * 1e12, Dimension::none) + " pN m (" +
      off(slip.torsion_moment, coarse_slip.torsion_moment) + ")");
  for (const SlipPoint& point : preview.partial_slip)
    say("shifted by " + quantity(point.shift, Dimension::length) + ": lateral force " +
        quantity(point.force, Dimension::force) + ", " + quantity(100 * point.slipping, Dimension::none) +
        " % of what touches slips (on half as many cells, without an error)");
}

void say_adhesion(const CaseInput& input, const PreviewedCase& preview, const Say& say) {
  const CaseContact& contact = preview.contact.fine;
  if (!contact.pull_off) return;
  const double unit = M_PI * preview.work_of_separation * input.radius;
  say("attraction of " + quantity(contact.attracting, Dimension::force) +
      ", which the contact carries beside the load; pull-off force " +
      quantity(contact.pull_off->force, Dimension::force) +
      (unit > 0
           ? " (" + percent(preview.contact.error_of_pull_off()) + "; 1.5 to 2 pi w R are " +
                 quantity(1.5 * unit, Dimension::force) + " to " + quantity(2 * unit, Dimension::force) + ")"
           : ", as the case says"));
}

void say_mesh(const PreviewedCase& preview, const Say& say) {
  if (!preview.mesh) return say("asperity solve would refuse it: " + preview.refusal);
  const MeshPreview& mesh = *preview.mesh;
  say("to solve it by finite elements: nodes every " + quantity(mesh.spacing, Dimension::length) +
      " within ±" + quantity(mesh.region, Dimension::length) + ", some " +
      quantity(mesh.unknowns / 1e6, Dimension::none, 2) + " million unknowns, " +
      quantity(mesh.memory / (1 << 30), Dimension::none, 2) + " GiB, " + std::to_string(mesh.steps) +
      " steps in about " + wait_text(mesh.seconds) + " on two cores");
  const double reach = preview.contact.fine.shape.reach;
  if (reach > mesh.region)
    say("the contact reaches to " + quantity(reach, Dimension::length) +
        " from the axis, beyond that region; set Mesh/Contact region");
}

}  // namespace

std::vector<std::string> left_out_sentences(const LeftOutOfPreview& left_out) {
  std::vector<std::string> sentences;
  if (left_out.motion)
    sentences.push_back("of " + name_of(*left_out.motion) +
                        " the pressing down is previewed, on the axes of both meshes; the motion is not");
  if (left_out.adhesion)
    sentences.push_back(
        "adhesion is left out: it acts in a zone at the edge of the contact that is too small for cells, as "
        "in JKR's limit; of smooth bodies the pull-off force is 1.5 pi w R there");
  if (left_out.shear_of_films)
    sentences.push_back(
        "lateral and torsion stiffness are left out: half-spaces with films are solved under normal load "
        "alone");
  if (left_out.relaxation)
    sentences.push_back(
        "bodies relax with time: this is the contact right after fast loading, and it gives way from there");
  if (left_out.yielding_films)
    sentences.push_back(
        "the film is taken as elastic: how hard it is depends on the body below it, which half-spaces do "
        "not tell");
  if (left_out.finite_bodies)
    sentences.push_back(
        "the approach is that of half-spaces from first touch: what the finite bodies give way in the case "
        "is left out");
  return sentences;
}

std::vector<std::string> preview_lines(const CaseInput& input, const PreviewedCase& preview) {
  std::vector<std::string> lines = left_out_sentences(preview.left_out);
  const Say say = [&](const std::string& line) { lines.push_back(line); };
  const CasePreview& contact = preview.contact;
  const auto& shape = contact.fine.shape;
  const Hertz hertz = hertz_of(input);
  const double force = contact.fine.force();
  say(grid_text(input, contact.fine));
  // Surfaces that attract each other may have to be held apart: smooth ones under a tension are not Hertz'.
  const bool pressed = force > 0;
  const auto beside = [&](const std::string& error, const std::string& of_hertz) {
    return " (" + error + (pressed ? "; " + of_hertz : "") + ")";
  };
  say("normal force " + quantity(force, Dimension::force) +
      "; beside each number, how far half as many cells along a side are off" +
      (pressed ? ", and Hertz' of smooth bodies" : ""));
  say("stiffness " + stiffness_text(contact.fine.stiffness) +
      beside(percent(contact.error_of_stiffness()), stiffness_text(hertz.normal_stiffness(force))));
  say("approach of the mean surfaces " + quantity(contact.fine.approach(), Dimension::length) +
      beside(quantity(contact.error_of_approach(), Dimension::length, 2),
             quantity(hertz.approach(force), Dimension::length)) +
      ", from first touch " +
      quantity(contact.fine.approach() - contact.fine.first_touch, Dimension::length));
  say("real contact area " + area_text(shape.area) +
      beside(percent(contact.error_of_area()), area_text(hertz.contact_area(force))) + " in " +
      std::to_string(shape.spots) + " spots");
  say("mean pressure " + quantity(contact.fine.mean_pressure(), Dimension::pressure) + ", largest " +
      quantity(contact.fine.largest_pressure(), Dimension::pressure) +
      beside(percent(contact.error_of_largest_pressure()),
             quantity(hertz.peak_pressure(force), Dimension::pressure)));
  say_shear(input, preview, say);
  say_adhesion(input, preview, say);
  say_yielding(input, preview, say);
  say_mesh(preview, say);
  return lines;
}

}  // namespace asperity::report
