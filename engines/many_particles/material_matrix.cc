#include "engines/many_particles/material_matrix.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/printable.h"
#include "core/shear_moduli.h"
#include "engines/elastoplastic/luding_numbers.h"
#include "engines/input_notes.h"

namespace asperity {
namespace {

constexpr double default_restitution = 0.5;
constexpr double restitution_beside_yielding = 0.99;  // yielding dissipates by itself

/// What two records say of one number: the same, or an error.
void agree(double& known, double said, const std::string& what, const std::string& file) {
  constexpr double same = 1e-6;
  if (!std::isfinite(said)) return;
  if (std::isfinite(known) && std::abs(said / known - 1) > same)
    throw InputError(file + ": " + what +
                     " is another one than in a record before; all records of a matrix must agree");
  known = said;
}

std::size_t enter(std::vector<MatrixMaterial>& materials, const ContactBody& body, const char* where,
                  const std::string& file) {
  if (body.material.empty())
    throw InputError(file + ": '" + where +
                     "/material' is missing; in a matrix each material needs its name");
  const std::string name = printable(body.material);
  auto found = std::find_if(materials.begin(), materials.end(),
                            [&](const MatrixMaterial& m) { return m.name == body.material; });
  if (found == materials.end()) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    materials.push_back({body.material, unknown, unknown, unknown, false});
    found = materials.end() - 1;
  }
  agree(found->youngs_modulus, body.youngs_modulus, "Young's modulus of '" + name + "'", file);
  agree(found->poissons_ratio, body.poissons_ratio, "Poisson's ratio of '" + name + "'", file);
  agree(found->density, body.density, "the density of '" + name + "'", file);
  found->is_plane = found->is_plane || body.is_plane();
  return std::size_t(found - materials.begin());
}

LudingPair luding_of(InputNotes& notes) {
  const double R = notes.effective_radius();
  const LudingNumbers luding = luding_numbers(notes, {"k1", "k_p", "k_c", "phi_f"});
  return {luding.k1 / R, luding.kp / R, luding.kc / R, luding.phi, luding.lateral / R};
}

/// The record's law; what it cannot hold is noted.
MaterialPair pair_of(const ContactParameters& record, const MatrixOptions& options) {
  EngineInputOptions at_load;
  at_load.load = options.load;
  InputNotes notes(record, at_load, "an engine");
  const double R = notes.effective_radius();
  MaterialPair pair;
  pair.origin = record.file;
  pair.law.reduced_modulus = record.hertz().reduced_modulus;
  pair.law.shear_modulus = notes.shear_modulus();
  pair.law.sliding = notes.sliding();
  if (options.normal_law == "luding") pair.law.luding = luding_of(notes);
  if (notes.has_rolling()) {
    pair.law.rolling_stiffness = notes.constant_rolling_stiffness() / (R * R);
    pair.law.rolling = pair.law.rolling_stiffness > 0 ? notes.rolling() / R : 0;
  }
  if (notes.has_torsion()) {
    pair.law.torsion_stiffness = notes.constant_torsion_stiffness() / (R * R);
    pair.law.torsion = pair.law.torsion_stiffness > 0 ? notes.torsion() / R : 0;
  }
  if (!pair.law.luding) notes.leaves_out_pull_off("the laws of a matrix do not attract");
  pair.not_expressed = notes.not_expressed();
  return pair;
}

using Pairs = std::map<std::pair<std::size_t, std::size_t>, MaterialPair>;

std::pair<std::size_t, std::size_t> key(std::size_t i, std::size_t j) {
  return {std::min(i, j), std::max(i, j)};
}

LudingPair added(const LudingPair& sum, const LudingPair& law, double weight) {
  return {sum.k1 + weight * law.k1, sum.kp + weight * law.kp, sum.kc + weight * law.kc,
          sum.phi + weight * law.phi, sum.lateral + weight * law.lateral};
}

/// Mean of what records say of a material: of its pair with itself where there is one, else of all its pairs.
/// A resistance to rolling or torsion that one of them lacks is zero: nothing is made up. Friction is in
/// every record, and zero is a value of it.
PairLaw mean_of(const Pairs& found, std::size_t material) {
  std::vector<PairLaw> laws;
  if (const auto like = found.find({material, material}); like != found.end())
    laws = {like->second.law};
  else
    for (const auto& [pair, entry] : found)
      if (pair.first == material || pair.second == material) laws.push_back(entry.law);
  const auto mean = [&](double PairLaw::*member) {
    double sum = 0;
    for (const PairLaw& law : laws) {
      if (law.*member == 0 && member != &PairLaw::sliding) return 0.0;
      sum += law.*member;
    }
    return sum / double(laws.size());
  };
  PairLaw law{0,
              0,
              mean(&PairLaw::sliding),
              mean(&PairLaw::rolling),
              mean(&PairLaw::rolling_stiffness),
              mean(&PairLaw::torsion),
              mean(&PairLaw::torsion_stiffness)};
  for (const PairLaw& one : laws)
    if (one.luding)
      law.luding = added(law.luding.value_or(LudingPair{}), *one.luding, 1.0 / double(laws.size()));
  return law;
}

MaterialPair mixed(const MaterialMatrix& matrix, const Pairs& found, std::size_t i, std::size_t j) {
  for (const std::size_t k : {i, j}) {
    const MatrixMaterial& m = matrix.materials[k];
    if (!std::isfinite(m.youngs_modulus) || !std::isfinite(m.poissons_ratio))
      throw InputError(matrix.files.front() + ": no record has the pair of '" +
                       printable(matrix.materials[i].name) + "' and '" + printable(matrix.materials[j].name) +
                       "', and it cannot be mixed: no record has youngs_modulus and poissons_ratio of '" +
                       printable(m.name) + "'; add them, or a record of this pair");
  }
  const MatrixMaterial &a = matrix.materials[i], &b = matrix.materials[j];
  const ElasticBody of_a{a.youngs_modulus, a.poissons_ratio}, of_b{b.youngs_modulus, b.poissons_ratio};
  const PairLaw mean_a = mean_of(found, i), mean_b = mean_of(found, j);
  const auto between = [&](double PairLaw::*member) {
    const bool both_have = mean_a.*member > 0 && mean_b.*member > 0;
    return both_have || member == &PairLaw::sliding ? (mean_a.*member + mean_b.*member) / 2 : 0;
  };
  MaterialPair pair;
  pair.is_mixed = true;
  pair.law = {reduced_modulus(of_a, of_b),          reduced_shear_modulus(of_a, of_b),
              between(&PairLaw::sliding),           between(&PairLaw::rolling),
              between(&PairLaw::rolling_stiffness), between(&PairLaw::torsion),
              between(&PairLaw::torsion_stiffness)};
  if (mean_a.luding && mean_b.luding)
    pair.law.luding = added(added({}, *mean_a.luding, 0.5), *mean_b.luding, 0.5);
  pair.origin =
      std::string("mixed, no record has this pair: ") +
      (pair.law.luding ? "k1, k_p, k_c, k_l over R_e and phi_f, "
                       : "E* and G* from both bodies' E and nu, ") +
      "friction, rolling and torsion as the mean of both materials', each from its pair with itself "
      "or else all its pairs; solve this pair to know";
  return pair;
}

void choose_radii_and_load(MaterialMatrix& matrix, const std::vector<ContactParameters>& records,
                           const MatrixOptions& options) {
  for (const ContactParameters& record : records) {
    for (const ContactBody* body : {&record.particle, &record.target}) {
      if (body->is_plane()) continue;
      matrix.smallest_radius =
          matrix.smallest_radius > 0 ? std::min(matrix.smallest_radius, body->radius) : body->radius;
      matrix.largest_radius = std::max(matrix.largest_radius, body->radius);
    }
    for (const auto& entry : quantity_entries())
      if (const auto& quantity = record.*entry.member; quantity && quantity->load_range)
        matrix.load = std::max(matrix.load, quantity->load_range->high);
  }
  if (options.radii) matrix.smallest_radius = options.radii->low, matrix.largest_radius = options.radii->high;
  if (!(matrix.smallest_radius > 0 && matrix.largest_radius >= matrix.smallest_radius))
    throw InputError("the radii of the particles must be above zero, the smallest first");
  if (options.load) matrix.load = *options.load;
  matrix.load_is_given = options.load.has_value();
  if (!(matrix.load > 0))
    throw InputError(matrix.files.front() +
                     ": no record has a load_range; give the highest load between particles with --load");
  matrix.restitution_is_given = options.restitution.has_value();
  matrix.restitution =
      options.restitution.value_or(matrix.yields() ? restitution_beside_yielding : default_restitution);
  if (!(matrix.restitution > 0 && matrix.restitution <= 1))
    throw InputError("the restitution must be above 0 and at most 1");
}

}  // namespace

const MaterialPair& MaterialMatrix::pair(std::size_t i, std::size_t j) const {
  const auto [row, column] = key(i, j);
  std::size_t index = 0;
  for (std::size_t k = 0; k < row; ++k) index += materials.size() - k;
  return pairs.at(index + column - row);
}

void MaterialMatrix::require_elasticity(const std::string& engine) const {
  for (const MatrixMaterial& m : materials)
    if (!std::isfinite(m.youngs_modulus) || !std::isfinite(m.poissons_ratio))
      throw InputError(files.front() + ": " + engine +
                       " makes E* and G* from E and nu, and no record has them of '" + printable(m.name) +
                       "'; add youngs_modulus and poissons_ratio to that body");
}

std::size_t MaterialMatrix::wall() const {
  for (std::size_t i = 0; i < materials.size(); ++i)
    if (materials[i].is_plane) return i;
  return materials.size() - 1;
}

MaterialMatrix material_matrix(const std::vector<ContactParameters>& records, const MatrixOptions& options) {
  MaterialMatrix matrix;
  matrix.normal_law = options.normal_law;
  if (matrix.yields() && matrix.normal_law != "luding")
    throw InputError("--normal-law " + printable(matrix.normal_law) +
                     " is written for one contact at a time; of many particles it is hertz or luding");
  Pairs found;
  for (const ContactParameters& record : records) {
    matrix.files.push_back(record.file);
    const std::size_t i = enter(matrix.materials, record.particle, "particle", record.file),
                      j = enter(matrix.materials, record.target, "target", record.file);
    if (!found.emplace(key(i, j), pair_of(record, options)).second)
      throw InputError(record.file + ": the pair of '" + printable(record.particle.material) + "' and '" +
                       printable(record.target.material) + "' is in a record before; give each pair once");
  }
  choose_radii_and_load(matrix, records, options);
  each_pair(matrix, [&](std::size_t i, std::size_t j) {
    const auto entry = found.find({i, j});
    matrix.pairs.push_back(entry != found.end() ? entry->second : mixed(matrix, found, i, j));
  });
  return matrix;
}

}  // namespace asperity
