// The commands, one file NAME_command.cc each: what they take, and what they do with it. main.cc and
// solver_main.cc say which program has them.
#pragma once

namespace CLI {
class App;
}

namespace asperity {

/// asperity surface measure | generate | afm: topographies measured, made, and judged as a microscope would
/// see them.
void add_surface_command(CLI::App& app);
/// asperity surface afm: which Gaussian surfaces have a published RMS and peak to valley, as a microscope
/// would see them. Adds `afm` to the subcommand `surface`.
void add_surface_afm_command(CLI::App& surface);
/// asperity characterise SCAN: from a scan to the numbers and the input of a discrete element model.
void add_characterise_command(CLI::App& app);
/// asperity materials: those that characterise knows by name, the page of docs/materials.md.
void add_materials_command(CLI::App& app);
/// asperity preview CASE.prm: stiffness, area, pressure and the mesh that a case needs, in seconds.
void add_preview_command(CLI::App& app);
/// asperity mesh CASE.prm --output DIR: the meshes of a case, their quality, and the surfaces for other
/// programs.
void add_mesh_command(CLI::App& app);
/// asperity solve CASE.prm --output DIR [--set "Section/Entry=value"]... [--resume]: solves one case.
void add_solve_command(CLI::App& app);
/// asperity study STUDY.prm --output DIR [--resume]: solves a matrix of cases.
void add_study_command(CLI::App& app);
/// asperity derive DIR...: from solved cases to parameters.json.
void add_derive_command(CLI::App& app);
/// asperity compare DIR...: solved cases and studies against Hertz.
void add_compare_command(CLI::App& app);
/// asperity import: an instrument's own text as a recording.
void add_import_command(CLI::App& app);
/// asperity diagnose RECORDING: where recording and simulation part, and what was left out.
void add_diagnose_command(CLI::App& app);
/// asperity conceal: a recording in which an effect is hidden, with its sealed truth.
void add_conceal_command(CLI::App& app);
/// asperity challenge: the proof of the diagnosis on concealed effects.
void add_challenge_command(CLI::App& app);
/// `asperity experiment`: one of the paper's experiments with one particle, by the reduced laws; `asperity
/// laws`: their manual.
void add_experiment_commands(CLI::App& app);
/// asperity engine: one experiment run by LAMMPS or YADE; asperity engine-input: what a user pastes into an
/// engine.
void add_engine_commands(CLI::App& app);
/// asperity paper: the paper's own analysis from its published numbers.
void add_paper_command(CLI::App& app);
/// asperity report DIR: report.html of a solved case or a study.
void add_report_command(CLI::App& app);
/// asperity case-template, case-reference: how to write a case file.
void add_case_commands(CLI::App& app);

}  // namespace asperity
