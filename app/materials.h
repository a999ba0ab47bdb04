// Materials by name, for `asperity characterise`: elastic constants and hardness with their spread and where
// they are from. `asperity materials` lists them; docs/materials.md is its output.
#pragma once

#include <string>
#include <vector>

namespace asperity {

/// A number with the range in which published values lie, in the unit of the number.
struct PublishedNumber {
  double value = 0, low = 0, high = 0;

  /// Half the range, relative to the value [-].
  double relative_spread() const { return (high - low) / (2 * value); }
};

/// An isotropic elastic body that yields at a third of its hardness (Tabor 1951).
struct Material {
  std::string name;
  PublishedNumber youngs_modulus;  ///< E [Pa]
  double poisson_ratio = 0;        ///< [-]
  PublishedNumber hardness;        ///< of indentation [Pa]; infinite: the body stays elastic
  double density = 0;              ///< [kg/m^3]; 0: not known
  std::string source;              ///< of the numbers, in words

  /// Initial uniaxial yield stress [Pa].
  double yield_stress() const;
  bool yields() const;
};

/// All that have a name, in alphabetical order.
const std::vector<Material>& named_materials();

/// "silicon", or the numbers themselves: "E=71 GPa, nu=0.17, hardness=9 GPa, density=2230 kg/m^3" (hardness
/// may be left out: the body then stays elastic; density too, which dynamic engines need). Throws InputError
/// naming the material that was meant, or the number that is missing or out of range.
Material material_of(const std::string& text);

/// The sphere of `--particle`: a material and its radius, "borosilicate, 8.5 um".
struct ParticleText {
  Material material;
  double radius = 0;  ///< [m]
};
/// The radius stands last, alone or as R=8.5 um. Throws InputError as material_of does.
ParticleText particle_of(const std::string& text);

/// The materials as a page of Markdown.
std::string materials_page();

}  // namespace asperity
