#include "half_space/case_contact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/attraction_zone.h"
#include "core/error.h"
#include "core/hertz_separation.h"
#include "core/quantity.h"
#include "core/shear_moduli.h"
#include "core/threads.h"
#include "surfaces/surface_of_entry.h"

namespace asperity::half_space {
namespace {

/// Both surfaces of a case over a square, from which gaps are made.
class Surfaces {
 public:
  Surfaces(const CaseInput& input, double half_width) : radius_(input.radius) {
    for (const BodyInput* body : {&input.particle, &input.substrate})
      if (!body->topography.is_smooth()) heights_.push_back(heights_over(body->topography, 2 * half_width));
  }
  Field gap(const Grid& grid) const {
    Field gap(grid.cells());
    constexpr int rows_at_a_time = 4;
    for_parts(grid.ny, rows_at_a_time, [&](int iy, int end) {
      for (; iy < end; ++iy)
        for (int ix = 0; ix < grid.nx; ++ix) {
          const double x = grid.x(ix), y = grid.y(iy), r2 = x * x + y * y;
          double g = r2 / (radius_ + std::sqrt(radius_ * radius_ - r2));
          for (const auto& heights : heights_) g -= heights.height(x, y);
          gap[static_cast<std::size_t>(iy) * grid.nx + ix] = g;
        }
    });
    return gap;
  }

 private:
  double radius_;
  std::vector<HeightSampler> heights_;
};

std::vector<FilmOnBody> films_of(const CaseInput& input) {
  std::vector<FilmOnBody> films;
  for (const BodyInput* body : {&input.particle, &input.substrate})
    if (body->film.is_there())
      films.push_back({elastic_film(body->film), elastic_body(*body), body->film.thickness});
  return films;
}

double rms_of_both(const CaseInput& input) {
  return std::hypot(topography_scales(input.particle.topography).rms,
                    topography_scales(input.substrate.topography).rms);
}

/// What presses, for sizes of grids: attraction as between smooth bodies of small deformation.
double largest_load(const CaseInput& input, const std::optional<Attraction>& attraction = std::nullopt) {
  const double load = input.experiment.control == ExperimentInput::Control::force
                          ? largest_contact_force(input)
                          : hertz_of(input).force(input.experiment.normal_approach);
  return load + (attraction ? 2 * M_PI * input.radius * attraction->work : 0);
}

/// Cells along a side: no fewer than the spacing takes, in numbers that transforms and coarser grids like.
int cells_for(double half_width, double spacing, int most) {
  int n = 128;
  for (const int cells :
       {128, 160, 192, 256, 320, 384, 512, 640, 768, 1024, 1280, 1536, 2048, 2560, 3072, 4096}) {
    if (cells > most) break;
    n = cells;
    if (cells * spacing >= 2 * half_width) break;
  }
  return n;
}

/// The given gap with what has flowed under the hardness removed.
Field with_imprint(const NormalContact& half_spaces, const NormalContactSolution& pressed, double hardness) {
  Field gap = half_spaces.gap();
  for (std::size_t k = 0; k < gap.size(); ++k)
    if (pressed.pressure[k] >= hardness) gap[k] += std::max(0.0, -pressed.gap[k]);
  return gap;
}

/// Presses surfaces that attract each other, and separates them.
void press_and_separate(const NormalContact& half_spaces, const CaseInput& input,
                        const CaseContactOptions& options, const NormalContactOptions& how,
                        CaseContact& contact) {
  const bool by_force = input.experiment.control == ExperimentInput::Control::force;
  const Attraction& attraction = *options.attraction;
  const AdhesiveContact adhesive(half_spaces, attraction);
  AdhesiveSolution pressed =
      by_force ? adhesive.at_force(largest_contact_force(input), how)
               : adhesive.at_approach(contact.first_touch + input.experiment.normal_approach, how);
  contact.attracting = pressed.contact.force - pressed.force;
  contact.attraction_in_touch = attraction.opening(0);
  const auto separate = [&](const AdhesiveContact& from) {
    if (options.with_pull_off) contact.pull_off = from.pull_off(pressed, how, options.on_separation);
    if (options.with_stiffness && !options.edge_is_held) contact.stiffness = from.stiffness(pressed, how);
  };
  if (std::isinf(how.hardness)) {
    separate(adhesive);
  } else {
    const NormalContact imprinted(half_spaces.grid(), Boundary::free, half_spaces.modulus(),
                                  with_imprint(half_spaces, pressed.contact, how.hardness),
                                  half_spaces.films());
    separate(AdhesiveContact(imprinted, attraction));
  }
  contact.solution = std::move(pressed.contact);
}

CaseContact contact_on(const CaseInput& input, const Surfaces& surfaces, const Grid& grid,
                       const CaseContactOptions& options) {
  CaseContact contact;
  contact.grid = grid;
  Field gap = surfaces.gap(grid);
  contact.first_touch = *std::min_element(gap.begin(), gap.end());
  const NormalContact half_spaces(grid, Boundary::free, hertz_of(input).reduced_modulus, std::move(gap),
                                  films_of(input));
  NormalContactOptions how;
  // What yields feels the pressure less the attraction, which is that of separation where bodies touch.
  how.hardness = options.hardness + (options.attraction ? options.attraction->opening(0) : 0);
  const auto& experiment = input.experiment;
  if (options.attraction)
    press_and_separate(half_spaces, input, options, how, contact);
  else if (experiment.control == ExperimentInput::Control::force)
    contact.solution = half_spaces.at_force(largest_contact_force(input), how);
  else
    contact.solution = half_spaces.at_approach(contact.first_touch + experiment.normal_approach, how);
  // An attraction that is told as a force acts like more load, and opens nothing by itself (DMT).
  if (const double force = input.interface.attraction_force;
      force > 0 && experiment.control == ExperimentInput::Control::force) {
    contact.attracting += force, contact.beyond_contact = force;
    if (!options.attraction) contact.pull_off = PullOff{force, contact.first_touch, 0};
  }
  contact.shape = contact_shape(grid, contact.solution.pressure, how.hardness);
  if (options.with_shear_stiffness && !has_films(input)) {
    const StuckContact stuck(grid, shear_compliance(input));
    contact.lateral_stiffness = stuck.lateral_stiffness(contact.solution.pressure);
    contact.torsion_stiffness = stuck.torsion_stiffness(contact.solution.pressure);
  }
  const bool as_it_stands = !options.attraction || options.edge_is_held;
  if (options.with_stiffness && as_it_stands && !contact.shape.reaches_edge)
    contact.stiffness = half_spaces.stiffness(contact.solution);
  return contact;
}

/// By the grid that the case would be solved on.
bool is_resolved(const CaseInput& input, const Attraction& attraction, int most_cells) {
  const double half_width = derived_half_width(input, attraction);
  const int n = cells_for(half_width, derived_spacing(input, attraction), most_cells);
  return 2 * half_width / n <= attraction_zone(input, attraction) / 2;
}

double relative_difference(double one, double other) { return std::abs(one - other) / std::abs(one); }

}  // namespace

ShearCompliance shear_compliance(const CaseInput& input) {
  ShearCompliance sum;
  for (const BodyInput* body : {&input.particle, &input.substrate}) {
    const double nu = body->poisson_ratio, shear = shear_modulus(elastic_body(*body));
    sum.across += (1 - nu) / shear, sum.along += nu / shear;
  }
  return sum;
}

double shortest_wave(const CaseInput& input) {
  return std::min(topography_scales(input.particle.topography).shortest_wave,
                  topography_scales(input.substrate.topography).shortest_wave);
}

Field gap_of_case(const CaseInput& input, const Grid& grid) {
  return Surfaces(input, 0.5 * std::max(grid.nx * grid.dx, grid.ny * grid.dy)).gap(grid);
}

double derived_spacing(const CaseInput& input, const std::optional<Attraction>& attraction) {
  constexpr double cells_per_radius = 24, cells_per_wave = 16, cells_per_film = 8, cells_per_zone = 4;
  const Hertz hertz = hertz_of(input);
  double spacing = std::min(hertz.contact_radius(largest_load(input, attraction)) / cells_per_radius,
                            shortest_wave(input) / cells_per_wave);
  for (const BodyInput* body : {&input.particle, &input.substrate})
    if (body->film.is_there()) spacing = std::min(spacing, body->film.thickness / cells_per_film);
  if (attraction) spacing = std::min(spacing, attraction_zone(input, *attraction) / cells_per_zone);
  return spacing;
}

double attraction_zone(const CaseInput& input, const Attraction& attraction) {
  return asperity::attraction_zone(hertz_of(input).reduced_modulus, attraction.work, attraction.opening(0));
}

double derived_half_width(const CaseInput& input, const std::optional<Attraction>& attraction) {
  const double a = hertz_of(input).contact_radius(largest_load(input, attraction));
  return 1.05 * hertz_reach(a, input.radius, 3 * rms_of_both(input) + (attraction ? attraction->range : 0));
}

CaseContact contact_of_case(const CaseInput& input, const CaseContactOptions& options) {
  constexpr int most_times = 4;
  constexpr double larger = 1.3;
  double half_width =
      options.half_width > 0 ? options.half_width : derived_half_width(input, options.attraction);
  const double spacing = options.spacing > 0 ? options.spacing : derived_spacing(input, options.attraction);
  for (int enlarged = 0;; half_width *= larger) {
    if (half_width > input.radius / 2)
      throw InputError(input.file + ": the contact goes beyond " +
                       format_quantity(input.radius / 2, Dimension::length) +
                       " from the axis, half the Radius, where bodies are no half-spaces; lower the load");
    const bool carries =
        options.hardness * 4 * half_width * half_width > largest_load(input, options.attraction);
    if (!carries && input.experiment.control == ExperimentInput::Control::force) continue;
    const int n = cells_for(half_width, spacing, options.most_cells);
    CaseContact contact = contact_on(input, Surfaces(input, half_width), square_grid(half_width, n), options);
    contact.enlarged = enlarged++;
    if (!contact.shape.reaches_edge) return contact;
    if (contact.enlarged == most_times)
      throw InputError(input.file + ": the contact still reaches the edge of a square of " +
                       format_quantity(2 * half_width, Dimension::length) +
                       ", several times what load and roughness suggest; is the topography levelled?");
  }
}

std::vector<CaseContact> contacts_under(CaseInput input, const std::vector<double>& forces,
                                        const CaseContactOptions& options) {
  input.experiment.control = ExperimentInput::Control::force;
  input.experiment.normal_load = *std::max_element(forces.begin(), forces.end());
  const Grid grid = contact_of_case(input, options).grid;
  const Surfaces surfaces(input, 0.5 * grid.nx * grid.dx);
  std::vector<CaseContact> contacts;
  for (const double force : forces) {
    input.experiment.normal_load = force;
    contacts.push_back(contact_on(input, surfaces, grid, options));
  }
  return contacts;
}

CasePreview preview_of_case(const CaseInput& input, double hardness,
                            const std::optional<Attraction>& attraction, const OnSeparation& on_separation) {
  CasePreview preview;
  CaseContactOptions options;
  options.on_separation = on_separation;
  constexpr int most_cells_with_attraction = 512;  // separation takes some two hundred contacts
  if (attraction && is_resolved(input, *attraction, most_cells_with_attraction)) {
    options.attraction = attraction;
    options.most_cells = most_cells_with_attraction;
  }
  options.with_shear_stiffness = true;
  preview.fine = contact_of_case(input, options);
  const Grid& grid = preview.fine.grid;
  preview.resolution = grid.dx / shortest_wave(input);
  options.half_width = 0.5 * grid.nx * grid.dx;
  options.spacing = 2 * grid.dx;
  options.most_cells = grid.nx / 2;
  const Surfaces surfaces(input, options.half_width);
  preview.coarse = contact_on(input, surfaces, square_grid(options.half_width, grid.nx / 2), options);
  if (hardness < preview.fine.largest_pressure()) {
    options.hardness = hardness;
    options.spacing = grid.dx;
    options.most_cells = grid.nx;
    preview.capped = contact_of_case(input, options);
  }
  return preview;
}

double CasePreview::error_of_area() const { return relative_difference(fine.shape.area, coarse.shape.area); }
double CasePreview::error_of_largest_pressure() const {
  // Measured: 5 % with eight cells over the shortest wave, 2 % with sixteen, and the power through both; at
  // two spacings the same by chance.
  const double measured = 0.02 * std::pow(16 * resolution, std::log2(0.05 / 0.02));
  return std::max(relative_difference(fine.largest_pressure(), coarse.largest_pressure()), measured);
}
double CasePreview::error_of_stiffness() const {
  return relative_difference(fine.stiffness, coarse.stiffness);
}
double CasePreview::error_of_pull_off() const {
  return fine.pull_off && coarse.pull_off && fine.pull_off->force > 0
             ? relative_difference(fine.pull_off->force, coarse.pull_off->force)
             : 0;
}
double CasePreview::error_of_approach() const { return std::abs(fine.approach() - coarse.approach()); }

}  // namespace asperity::half_space
