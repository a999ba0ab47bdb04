// What a case's entry `Topography` says, as a value: smooth, a measured scan, or a generated surface.
// surfaces/ makes heights of it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>

#include "core/self_affine_spectrum.h"

namespace asperity {

/// What is taken off a scan: mean, plane (1, x, y) and quadratic (1, x, y, x^2, xy, y^2) over the whole map;
/// rows0, rows1, rows2: a polynomial of that degree along x for each row on its own.
enum class Level { mean, plane, quadratic, rows0, rows1, rows2 };

/// "plane" and so on; throws InputError listing the names there are.
Level parse_level(const std::string& name);
std::string level_name(Level level);

/// What lies beyond the edge of a map that is not periodic.
enum class Outside { refuse, mirror };

/// random: real and imaginary parts of each amplitude are Gaussian (a sample of the Gaussian field; Sq and
/// PSD scatter from seed to seed). fixed: |a_q| = sqrt(C/(lx ly)), only the phase is random (Sq is met
/// exactly on the period).
enum class Amplitudes { random, fixed };

/// What the user knows better than the file of a scan.
struct ReadOptions {
  std::optional<double> size_x_m;      ///< physical width [m]; wins over the file's
  std::optional<double> size_y_m;      ///< physical height [m]; where only one is given, pixels are square
  std::optional<std::string> channel;  ///< name of a channel, or its number counted from 0 as in the file
  std::optional<std::string> height_unit;  ///< unit of heights in a text file that names none, such as "nm"
};

/// A measured scan: FILE, or scan(FILE, size=2.5 um, channel=Height, unit=nm, level=plane, cutoff=20 nm,
/// outside=mirror) where the file alone does not say enough.
struct ScanParameters {
  std::string file;
  ReadOptions options;
  Level level = Level::plane;         ///< what is taken off before the scan is used
  double cutoff = 0;                  ///< waves shorter than this are taken out [m]; 0: none are
  Outside outside = Outside::refuse;  ///< beyond the scan's edge

  /// The entry of a case file: the file's name alone where nothing else is given.
  std::string text() const;
};

/// A Gaussian surface with a self-affine spectrum: generated(rms=1.5 nm, hurst=0.8, rolloff=200 nm, cutoff=20
/// nm, seed=3).
struct GeneratorParameters {
  SelfAffineSpectrum spectrum{0.0, 0.8, 200e-9, 20e-9};
  std::uint64_t seed = 1;
  Amplitudes amplitudes = Amplitudes::random;
  /// Side of the scans in which spectrum.rms was measured [m] (512 x 512 pixels, mean plane removed, mean
  /// over many scans: surfaces/virtual_afm.h); 0: spectrum.rms is that of the whole surface.
  double window = 0;
  /// Side of the periodic square that the surface repeats [m]; 0: that of default_period
  /// (surfaces/generated_surface.h).
  double size = 0;

  /// The entry of a case file.
  std::string text() const;
  /// The same without the seed: that of all realisations of one surface.
  std::string text_without_seed() const;
};

/// Reads the scan's forms. Throws InputError naming the argument that is unknown or wrong. The file need not
/// exist.
ScanParameters parse_scan(const std::string& text);
/// Reads "generated(key=value, ...)". Keys: rms (needed), window, hurst, rolloff, cutoff, size, seed,
/// amplitudes (random or fixed). Throws InputError naming the key that is unknown, missing, twice there, or
/// has a value out of range.
GeneratorParameters parse_generator(const std::string& text);

/// Smooth, a scan or generated: what an entry of a case file says of a surface.
class TopographySpec {
 public:
  TopographySpec() = default;  ///< smooth
  /// Reads what a case file says; implicit, for an entry is written as text. Throws InputError as parse_scan
  /// and parse_generator do.
  TopographySpec(const std::string& text);
  TopographySpec(const char* text) : TopographySpec(std::string(text)) {}
  TopographySpec(const ScanParameters& scan) : surface_(scan), text_(scan.text()) {}
  TopographySpec(const GeneratorParameters& generator) : surface_(generator), text_(generator.text()) {}

  bool is_smooth() const { return std::holds_alternative<std::monostate>(surface_); }
  /// null: no scan
  const ScanParameters* scan() const& { return std::get_if<ScanParameters>(&surface_); }
  /// null: not generated
  const GeneratorParameters* generator() const& { return std::get_if<GeneratorParameters>(&surface_); }
  // Of a value that is gone with the statement they would point nowhere.
  const ScanParameters* scan() const&& = delete;
  const GeneratorParameters* generator() const&& = delete;
  /// As it was written.
  const std::string& text() const { return text_; }
  /// In one way of writing, whatever its units and the order of its arguments.
  std::string canonical() const;
  /// The same without the seed: realisations of one surface have the same.
  std::string family() const;
  /// RMS as given [m]: 0 where smooth; NaN for a scan, whose RMS follows from its heights only.
  double rms() const;

 private:
  std::variant<std::monostate, ScanParameters, GeneratorParameters> surface_;
  std::string text_ = "smooth";
};

}  // namespace asperity
