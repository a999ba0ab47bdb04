#include "tests/readme/readme_lines.h"

#include <fstream>
#include <regex>

namespace asperity::test {
namespace {

/// Contacts of some 100 nm on meshes of some 10,000 unknowns.
constexpr const char* small_contact =
    " --set 'Experiment/Normal load=20 uN' --set 'Experiment/Load steps=2' --set 'Experiment/Unload=false' "
    "--set 'Mesh/Layers=1'"
    " --set 'Mesh/Interface spacing=25 nm'";
/// Moving contacts of the paper's bodies: a smoother surface, a smaller load, some ten steps.
constexpr const char* small_motion =
    " --set 'Substrate/Topography=generated(rms=0.3 nm, cutoff=160 nm, seed=7)' --set 'Mesh/Interface "
    "spacing=36 nm' --set 'Mesh/Layers=1'"
    " --set 'Mesh/Contact region=260 nm' --set 'Experiment/Normal load=20 uN' --set 'Experiment/Load "
    "steps=2' --set 'Experiment/Motion steps=5'"
    " --set 'Experiment/Reverse=false' --set 'Experiment/Unload=false' --set 'Output/Fields=false'";

ReadmeGroup one_case() {
  return {"OneCase",
          {{"build/asperity surface measure scan.spm --level plane", "", "", "Sq (RMS height)", ""},
           {"build/asperity surface generate --rms \"1.5 nm\" --size \"2.5 um\" --pixels 512 --seed 3 "
            "--output rough.gsf",
            "", "", "512 x 512", "rough.gsf"},
           {"build/asperity surface afm --help", "", "", "--rms", ""},
           {"build/asperity characterise scan.spm --particle \"borosilicate, 8.5 um\" --substrate silicon "
            "--loads "
            "\"30 uN to 300 uN\" --engine lammps --output characterised",
            " --plan", "what it would do, nothing solved", "cases by finite elements", ""},
           {"build/asperity materials", "", "", "silicon", ""},
           {"build/asperity case-template > case.prm", "", "", "", "case.prm"},
           {"build/asperity preview case.prm", small_contact, "a smaller load", "real contact area", ""},
           {"build/asperity mesh case.prm --output meshes", small_contact, "a smaller load, a coarser mesh",
            "", "meshes"},
           {"build/asperity solve case.prm --output result", small_contact,
            "a smaller load, a coarser mesh, two steps", "step 2/2", "result/result.json"},
           {"build/asperity solve case.prm --output result --resume", small_contact, "as the line before",
            "holds the finished result", "result/case.prm"},
           {"mpirun -np 2 build/asperity solve case.prm --output parallel", small_contact,
            "as the line before", "step 2/2", "parallel/result.json"}}};
}

ReadmeGroup paper() {
  const std::string smaller =
      " --set 'Experiment/Normal load=10 uN' --set 'Experiment/Load steps=2' --set 'Experiment/Unload "
      "steps=2'"
      " --set 'Mesh/Layers=1' --set 'Mesh/Interface spacing=18 nm' --set 'Output/Fields=false'"
      " --set 'Study/Realisations=1' --only 'smooth|untreated'";
  return {
      "Paper",
      {{"build/asperity study runs/paper/surfaces.prm --output output/paper", smaller,
        "two of its surfaces on one coarser mesh, a smaller load, two steps up and two down",
        "2 of 2 chosen cases done", "output/paper/study.csv"},
       {"build/asperity study runs/paper/pull_off.prm --preview --output pull_off --set "
        "\"Study/Realisations=20\"",
        " --only '60_mJ_m_2-3_nm-0.3_nm_500_nm-r[12]$'", "two of its 720 surfaces",
        "2 of 720 cases previewed", "pull_off/previews.csv"},
       {"build/asperity compare output/paper", "", "of the two cases solved", "Hertz",
        "output/paper/comparison.html"},
       {"build/asperity compare output/paper --parameters runs/paper/parameters_silicon.json --engine lammps",
        "", "of the two cases solved", "LAMMPS", ""},
       {"build/asperity report output/paper", "", "of the two cases solved", "report.html",
        "output/paper/report.html"}}};
}

ReadmeGroup motions() {
  return {"Motions",
          {{"build/asperity solve runs/paper/sliding.prm --output sliding",
            std::string(small_motion) + " --set 'Experiment/Distance=100 nm' --set 'Experiment/Load steps=5' "
                                        "--set 'Experiment/Motion steps=12'",
            "a smoother surface, a smaller load, a third of the distance in steps that balance its energy, "
            "for derive below",
            "wrote sliding/result.json", "sliding/history.csv"},
           {"build/asperity solve runs/paper/rolling.prm --output rolling",
            std::string(small_motion) + " --set 'Experiment/Distance=100 nm'",
            "a smoother surface, a smaller load, a sixth of the distance in few steps",
            "wrote rolling/result.json", "rolling/history.csv"},
           {"build/asperity solve runs/paper/program.prm --output program",
            std::string(small_motion) + " --set 'Experiment/Program=slide 30 nm and spin 10 mrad in 2 steps; "
                                        "press 10 uN; indenter 60 nm in 2 steps'",
            "a smoother surface, a smaller load, a shorter program", "wrote program/result.json",
            "program/history.csv"},
           {"build/asperity derive sliding --output parameters.json", "", "of the case solved", "liding",
            "parameters.json"}}};
}

/// Studies of hours: everything is read and checked, nothing solved.
ReadmeGroup long_studies() {
  return {"LongStudies",
          {{"build/asperity study runs/paper/motions.prm --output motions", " --check",
            "all cases read and checked, none solved", "cases of 'runs/paper/motions.prm' are accepted", ""},
           {"build/asperity study runs/paper/rails.prm --output rails", " --check",
            "all cases read and checked, none solved", "all 15 cases", ""},
           {"build/asperity study runs/paper/motions.prm --output motions --only torsion", " --check",
            "all cases read and checked, none solved", "are accepted", ""},
           {"build/asperity study runs/paper/motions.prm --output motions --plan", " --check",
            "all cases read and checked, none planned", "are accepted", ""}}};
}

ReadmeGroup one_particle() {
  const std::string silicon = "runs/paper/parameters_silicon.json";
  return {
      "OneParticle",
      {{"build/asperity paper", "", "", "sigma", ""},
       {"build/asperity laws", "", "", "Hertz", ""},
       {"build/asperity experiment " + silicon + " --type glued", "", "", "plateau of the lateral force", ""},
       {"build/asperity law-curve " + silicon + " --law 'jkr, work_of_adhesion = 50 mJ/m^2' --reach 10e-9",
        "", "", "contact_radius [m]", ""},
       {"build/asperity engine " + silicon + " --engine lammps --experiment glued --output loop", "", "", "",
        "loop/engine.json"},
       {"build/asperity engine-input " + silicon + " --engine yade --output contact.py", "", "", "",
        "contact.py"},
       {"build/asperity engine-input " + silicon +
            " --engine lammps --box 1000 --restitution 0.8 --output box",
        "", "", "box of 1000 particles", "box/in.box"}}};
}

ReadmeGroup recordings() {
  return {"Recordings",
          {{"build/asperity import scan.hld --radius \"150 nm\" --substrate-modulus \"72 GPa\" "
            "--substrate-poisson 0.17 --output recording",
            "", "", "samples", "recording/recording.json"},
           {"build/asperity diagnose runs/paper/recordings/sliding_offset_untreated --output diagnosis", "",
            "", "", "diagnosis/report.html"},
           {"build/asperity conceal --effect adhesion --mode normal --noise 0.01 --seed 1 --output concealed",
            "", "", "rows", "concealed/truth.json"},
           {"build/asperity challenge --output challenge", " --quick --only single-rolling",
            "a few recordings of some 200", "", "challenge/challenge.md"},
           {"build/asperity challenge --case --output challenge_by_case",
            " --quick --only single-normal-instrument", "one recording of some 50", "",
            "challenge_by_case/challenge.md"}}};
}

}  // namespace

std::vector<std::string> lines_of_readme(const std::filesystem::path& readme) {
  std::ifstream stream(readme);
  std::vector<std::string> lines;
  bool in_section = false, in_block = false;
  const std::regex comment("\\s+#.*$");
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("## ", 0) == 0) in_section = line == "## The program";
    if (line.rfind("```", 0) == 0)
      in_block = in_section && !in_block;
    else if (in_block && !line.empty())
      lines.push_back(std::regex_replace(line, comment, ""));
  }
  return lines;
}

const std::vector<ReadmeGroup>& groups_of_readme() {
  static const std::vector<ReadmeGroup> groups{one_case(),     paper(),        motions(),
                                               long_studies(), one_particle(), recordings()};
  return groups;
}

}  // namespace asperity::test
