// Each column by itself: closed forms for finite elements and laws, the paper's numbers, LAMMPS run live.
#include <gtest/gtest.h>

#include "dem_compare/compare/engine_column.h"
#include "dem_compare/compare/finite_element_column.h"
#include "dem_compare/compare/law_column.h"
#include "paper/analysis.h"
#include "paper/published_column.h"
#include "tests/dem_compare/compare/solved_folders.h"
#include "tests/dem_compare/resistance/moving_folder.h"
#include "tests/engines/engine_support.h"

namespace asperity {
namespace {

using test::paper_run;
using test::SolvedFolder;
using test::TemporaryFolder;
using test::write_solved;

constexpr double load = 1e-4, last_digit = 5e-6;

ComparedContact paper_contact() {
  return contact_of(read_contact_parameters(paper_run("parameters_silicon.json")), std::nullopt);
}
PublishedColumn paper() { return PublishedColumn(read_published(paper_run("published"))); }

LawValue named_law(Quantity quantity, const std::string& name,
                   const ComparedContact& contact = paper_contact(), const RailCase* rail = nullptr) {
  for (const auto& law : law_values(quantity, contact, rail ? 5 * load : load, rail))
    if (law.source.find(name) != std::string::npos) return law;
  ADD_FAILURE() << "no law " << name;
  return {};
}

const FiniteElementValue& point(const std::vector<FiniteElementPoint>& points, Quantity quantity) {
  static const FiniteElementValue none;
  for (const auto& one : points)
    if (one.quantity == quantity) return one.value;
  ADD_FAILURE() << "no point of " << display_of(quantity).key;
  return none;
}

std::vector<FiniteElementPoint> points_of(const std::vector<std::filesystem::path>& folders) {
  const CaseCollection collection = collect_cases(folders);
  return finite_element_points(collection, compare_with_hertz(collection, 0.05));
}

TEST(FiniteElementColumn_analytic,
     partial_slip_stores_as_much_as_a_spring_of_five_sixths_however_coarse_the_steps) {
  SolvedFolder solved;
  const double limit = solved.friction * solved.load;
  EXPECT_NEAR(stiffness_to_sliding(history_of(solved), limit) / solved.lateral_stiffness(), 5.0 / 6, 1e-9);
  solved.stiffness = 0.7;
  EXPECT_NEAR(stiffness_to_sliding(history_of(solved), limit) / solved.lateral_stiffness(), 5.0 / 6, 1e-9);
}

TEST(FiniteElementColumn_behaviour, has_no_stiffness_to_sliding_where_nothing_slides) {
  const SolvedFolder solved;
  EXPECT_TRUE(std::isnan(stiffness_to_sliding(history_of(solved), 10 * solved.friction * solved.load)));
}

TEST(FiniteElementColumn_analytic, reads_stiffness_friction_and_their_uncertainty_of_a_sliding_case) {
  const TemporaryFolder folder;
  const SolvedFolder solved;
  const auto points = points_of({write_solved(folder.path / "a", solved)});
  EXPECT_DOUBLE_EQ(point(points, Quantity::lateral_stiffness).value, solved.lateral_stiffness());
  EXPECT_DOUBLE_EQ(point(points, Quantity::lateral_stiffness).sd, 0.03 * solved.lateral_stiffness());
  EXPECT_NEAR(point(points, Quantity::sliding_friction).value, solved.friction, 1e-9);
  EXPECT_NEAR(point(points, Quantity::normal_stiffness).value / solved.hertz().normal_stiffness(load), 1,
              1e-6);
  EXPECT_EQ(point(points, Quantity::normal_stiffness).realisations, 1);
}

TEST(FiniteElementColumn_analytic, takes_mean_and_scatter_over_realisations) {
  const TemporaryFolder folder;
  SolvedFolder a, b;
  b.stiffness = 0.8;
  b.roughness = "generated(rms=0.3 nm, hurst=0.8, rolloff=500 nm, cutoff=72 nm, seed=2)";
  const auto points = points_of({write_solved(folder.path / "a", a), write_solved(folder.path / "b", b)});
  const FiniteElementValue& k = point(points, Quantity::lateral_stiffness);
  EXPECT_EQ(k.realisations, 2);
  EXPECT_NEAR(k.value / a.lateral_stiffness(), 0.9, 1e-12);
  EXPECT_NEAR(k.sd / a.lateral_stiffness(), 0.2 / std::sqrt(2.0), 1e-12);
}

TEST(FiniteElementColumn_analytic,
     does_not_take_realisations_that_agree_by_chance_for_better_than_each_is_known) {
  const TemporaryFolder folder;
  SolvedFolder a, b;
  b.roughness = "generated(rms=0.3 nm, hurst=0.8, rolloff=500 nm, cutoff=72 nm, seed=2)";
  const auto points = points_of({write_solved(folder.path / "a", a), write_solved(folder.path / "b", b)});
  const FiniteElementValue& k = point(points, Quantity::lateral_stiffness);
  EXPECT_EQ(k.realisations, 2);
  EXPECT_NEAR(k.sd / a.lateral_stiffness(), 0.03, 1e-12);
}

TEST(FiniteElementColumn_analytic, gives_torsion_as_moment_over_load_and_radius) {
  const TemporaryFolder folder;
  SolvedFolder solved;
  solved.experiment = "torsion";
  const auto points = points_of({write_solved(folder.path / "a", solved)});
  EXPECT_DOUBLE_EQ(point(points, Quantity::torsion_stiffness).value, solved.torsion_stiffness());
  EXPECT_NEAR(point(points, Quantity::torsion_friction).value,
              3 * M_PI / 16 * solved.friction * solved.hertz().contact_radius(load) / 8.5e-6, 1e-12);
}

TEST(FiniteElementColumn_analytic, rolling_is_what_is_dissipated_and_not_the_moment_of_hills) {
  const TemporaryFolder folder;
  test::MovingFolder made;
  made.experiment = "rolling", made.adhesion = 3e-13, made.friction = 0, made.hills = 20;
  const auto points = points_of({test::write_moving(folder.path / "a", made)});
  const FiniteElementValue& rolling = point(points, Quantity::rolling_friction);
  EXPECT_NEAR(rolling.value / (3e-13 / (made.load * made.radius)), 1, 1e-3);
  EXPECT_LT(rolling.sd, 0.01 * rolling.value);
  for (const auto& one : points)
    EXPECT_NE(one.quantity, Quantity::rolling_stiffness);  // it does not roll back
  // Rolled back over its track, the moment lacks twice the resistance after a step of a twentieth of a
  // contact radius at most.
  made.reverse = true;
  const auto back = points_of({test::write_moving(folder.path / "back", made)});
  EXPECT_GT(point(back, Quantity::rolling_stiffness).value, 0.5 * 3e-13 / (made.unit() / 20));
}

TEST(FiniteElementColumn_behaviour, has_no_rolling_where_the_way_is_too_short_to_be_steady) {
  const TemporaryFolder folder;
  test::MovingFolder made;
  made.experiment = "rolling", made.friction = 1e-13, made.hills = 20, made.path_in_radii = 0.9;
  for (const auto& point : points_of({test::write_moving(folder.path / "a", made)}))
    EXPECT_NE(point.quantity, Quantity::rolling_friction);
}

TEST(LawColumn_other_code, has_the_papers_contact_as_computed_by_hand) {
  EXPECT_NEAR(named_law(Quantity::approach, "Hertz").value, 6.1864e-9, 6.1864e-9 * 1e-5);
  EXPECT_NEAR(named_law(Quantity::lateral_stiffness, "Mindlin without slip").value, 21645.1,
              21645.1 * last_digit);
  EXPECT_NEAR(named_law(Quantity::lateral_stiffness_to_sliding, "Deresiewicz").value, 21645.1 * 5 / 6, 0.2);
  EXPECT_NEAR(named_law(Quantity::torsion_stiffness, "Reissner").value, 1.371e-9, 0.0005e-9);
  EXPECT_NEAR(named_law(Quantity::torsion_stiffness, "8 G* a r^2").value, 1.56385e-6, 1e-11);
  EXPECT_NEAR(named_law(Quantity::torsion_friction, "full slip").value, 3.107e-12 / (load * 8.5e-6), 1e-6);
  EXPECT_NEAR(named_law(Quantity::sliding_friction, "Coulomb").value, 0.23 * 1.12, 1e-12);
  EXPECT_NEAR(named_law(Quantity::rolling_friction, "slider").value, 0.00079 * (1 + 5.714), 1e-9);
}

TEST(LawColumn_other_code, rail_coefficients_are_those_of_eq_murail) {
  const auto rails = paper().rails();
  ASSERT_EQ(rails.size(), 3u);
  const double expected[] = {1.58399e-3, 2.58022e-3, 3.43049e-3};
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(named_law(Quantity::rail_friction, "rail balance", paper_contact(), &rails[i]).value,
                expected[i], 3e-4 * expected[i]);
}

TEST(LawColumn_other_code, rail_force_has_the_offset_of_the_roughness_law_and_simplifications_beside_it) {
  const PaperAnalysis analysis = analyse_paper(read_published(test::paper_run("published")));
  const auto rails = paper().rails();
  const char* names[] = {"25 deg", "45 deg", "60 deg"};
  for (std::size_t i = 0; i < 3; ++i) {
    const double mu =
        analysis.number("Rails", names[i] + std::string(": mu_rail, eq:murail with mu_to = 0.0056"))
            .computed->value;
    const double h =
        analysis.number("Rails", names[i] + std::string(": h_rail with h_to = 0 and eq:frofit refitted"))
            .computed->value;
    // The plate carries 100 uN to 3 mN: each slope 1/(2 cos(theta)) of it.
    EXPECT_NEAR(rails[i].loads.low * 2 * std::cos(rails[i].angle), 1e-4, 1e-12);
    for (const double f : {rails[i].loads.low, rails[i].loads.high}) {
      const auto laws = law_values(Quantity::rail_force, paper_contact(), f, &rails[i]);
      ASSERT_EQ(laws.size(), 3u);
      EXPECT_NEAR(laws[0].value, mu * (1 + h / f), 1e-9 * (1 + h / f));
      EXPECT_LT(laws[1].value, laws[0].value);
      EXPECT_NEAR(laws[2].value, mu, 1e-9);
    }
  }
  const auto without_torsion = law_values(Quantity::rail_friction, paper_contact(), load, &rails[0])[1];
  EXPECT_NEAR(without_torsion.value, 3.43e-4, 5e-7);
}

TEST(LawColumn_analytic, leaving_out_an_offset_leaves_the_coefficient_alone) {
  const auto sliding = law_values(Quantity::sliding_friction, paper_contact(), load);
  ASSERT_EQ(sliding.size(), 2u);
  EXPECT_DOUBLE_EQ(sliding[1].value, 0.23);
  const auto rolling = law_values(Quantity::rolling_friction, paper_contact(), load);
  ASSERT_EQ(rolling.size(), 2u);
  EXPECT_NEAR(rolling[1].value, 7.9e-4, 1e-12);
}

TEST(LawColumn_analytic, textbook_laws_keep_the_bodies_moduli_and_numbers_as_given_stand_beside_them) {
  ComparedContact contact = paper_contact();
  contact.record->reduced_modulus->value *= 1.1;
  contact.record->reduced_shear_modulus->value *= 0.8;
  const auto stiffness = law_values(Quantity::lateral_stiffness, contact, load);
  ASSERT_EQ(stiffness.size(), 2u);
  EXPECT_NEAR(stiffness[0].value, 21645.1, 21645.1 * last_digit);
  // k_l = 8 G* a, a ~ E*^(-1/3)
  EXPECT_NEAR(stiffness[1].value, 21645.1 * 0.8 / std::cbrt(1.1), 0.2);
  const auto approach = law_values(Quantity::approach, contact, load);
  ASSERT_EQ(approach.size(), 2u);
  EXPECT_NEAR(approach[1].value / approach[0].value, std::pow(1.1, -2.0 / 3), 1e-5);
  ASSERT_TRUE(approach[1].engine);
  EXPECT_NEAR(closed_form(approach[1].engine->experiment).approach, approach[1].value, 1e-15);
}

TEST(LawColumn_behaviour, says_why_there_is_no_number) {
  ComparedContact contact = paper_contact();
  contact.record.reset();
  contact.friction = 0;
  for (const Quantity quantity :
       {Quantity::sliding_friction, Quantity::rolling_friction, Quantity::torsion_friction}) {
    const auto laws = law_values(quantity, contact, load);
    ASSERT_EQ(laws.size(), 1u);
    EXPECT_FALSE(laws[0].known());
    EXPECT_NE(laws[0].reason.find("--parameters"), std::string::npos);
  }
}

TEST(PublishedColumn_other_code, gives_table_2_at_the_case_s_roughness_and_load_with_its_uncertainty) {
  const ComparedValue sliding = paper().value(Quantity::sliding_friction, paper_contact(), load);
  EXPECT_NEAR(sliding.value, 0.23 * (1 + 12e-6 / load), 1e-12);
  // (sd_mu (1 + h/f))^2 + (mu sd_h/f)^2
  EXPECT_NEAR(sliding.sd, std::hypot(0.005 * 1.12, 0.23 * 1.2e-6 / load), 1e-9);
  EXPECT_NE(sliding.source.find("Table 2, untreated"), std::string::npos);
  ComparedContact rough = paper_contact();
  rough.rms = 2.5e-9;  // 2.7 +- 0.4 nm
  EXPECT_NEAR(paper().value(Quantity::rolling_friction, rough, 3e-3).value, 3.5e-4 * (1 + 2029.4 / 3000),
              1e-9);
  EXPECT_NEAR(paper().value(Quantity::lateral_stiffness, paper_contact(), load).value, 2219, 0.5);
  const double angle = paper().rails()[1].angle;
  EXPECT_NEAR(paper().rail(Quantity::rail_friction, paper_contact(), angle, 5e-4).value, 2.42e-3, 1e-9);
  EXPECT_NEAR(paper().rail(Quantity::rail_force, paper_contact(), angle, 5e-4).value,
              2.42e-3 * (1 + 57.8 / 500), 1e-9);
}

TEST(PublishedColumn_behaviour, has_a_reason_where_the_case_is_not_the_papers) {
  const auto reason = [](Quantity quantity, const ComparedContact& contact, double at) {
    return paper().value(quantity, contact, at).reason;
  };
  ComparedContact contact = paper_contact();
  EXPECT_EQ(reason(Quantity::sliding_friction, contact, 1e-3), "sliding was measured at 3 uN to 100 uN");
  EXPECT_EQ(reason(Quantity::rolling_friction, contact, 1e-5), "rolling was measured at 100 uN to 3 mN");
  EXPECT_EQ(reason(Quantity::normal_stiffness, contact, load),
            "the paper shows normal loading on silica only");
  contact.rms = 8e-10;
  EXPECT_EQ(reason(Quantity::sliding_friction, contact, load), "no surface of RMS 800 pm was measured");
  contact.rms = 0;
  EXPECT_EQ(reason(Quantity::sliding_friction, contact, load), "no surface of zero roughness was measured");
  contact.rms = NAN;
  EXPECT_EQ(reason(Quantity::sliding_friction, contact, load), "the substrate's RMS is not known");
  contact.radius *= 1.2;
  EXPECT_EQ(reason(Quantity::sliding_friction, contact, load), "these bodies were not measured in the paper");
}

TEST(EngineColumn_other_code, lammps_gives_the_number_of_every_law_within_one_percent) {
  ASPERITY_ENGINE_OR_SKIP(Lammps());
  const TemporaryFolder folder;
  EngineColumn column("lammps", folder.path);
  int count = 0;
  const auto check = [&](Quantity quantity, double at, const RailCase* rail = nullptr) {
    for (const auto& law : law_values(quantity, paper_contact(), at, rail)) {
      if (!law.engine) continue;  // a simplification that engines are not run with
      const ComparedValue value = column.value(law);
      EXPECT_NEAR(value.value / law.value, 1, 0.01)
          << law.source << ", " << display_of(quantity).words << " " << value.reason;
      ++count;
    }
  };
  for (const Quantity quantity :
       {Quantity::approach, Quantity::normal_stiffness, Quantity::lateral_stiffness,
        Quantity::lateral_stiffness_to_sliding, Quantity::sliding_friction, Quantity::rolling_stiffness,
        Quantity::rolling_friction, Quantity::torsion_stiffness, Quantity::torsion_friction})
    check(quantity, load);
  const auto rails = paper().rails();
  for (const auto& rail : rails) {
    check(Quantity::rail_friction, 5 * load, &rail);
    for (const double at : {rail.loads.low, rail.loads.high}) check(Quantity::rail_force, at, &rail);
  }
  EXPECT_EQ(count, 23);
  // 23 laws and 2 loads for the tangent of the normal stiffness ask for 25 runs; what several ask for is run
  // once: the loop with the moduli of the bodies serves four, rolling two, a twist two.
  EXPECT_EQ(column.runs(), 21u);
  EXPECT_EQ(column.failure(), "");
}

TEST(EngineColumn_behaviour, that_is_missing_says_so_once_and_gives_no_numbers) {
  const TemporaryFolder folder;
  EngineRunOptions options;
  options.program = "no-such-lmp";
  EngineColumn column("lammps", folder.path, options);
  for (const Quantity quantity : {Quantity::approach, Quantity::lateral_stiffness}) {
    const ComparedValue value = column.value(law_values(quantity, paper_contact(), load).front());
    EXPECT_FALSE(value.known());
    EXPECT_EQ(value.reason, "LAMMPS failed: see the message at the end");
  }
  EXPECT_EQ(
      column.failure(),
      "LAMMPS is missing: there is no program 'no-such-lmp'; install it with 'apt-get install lammps' or "
      "'./quickstart --engines', or name it with --program");
}

TEST(EngineColumn_behaviour, that_was_not_asked_for_says_how_to_ask) {
  EngineColumn column("", "");
  const ComparedValue value = column.value(law_values(Quantity::approach, paper_contact(), load).front());
  EXPECT_EQ(value.reason, "no engine was asked for (--engine lammps or yade)");
  EXPECT_EQ(column.failure(), "");
}

}  // namespace
}  // namespace asperity
