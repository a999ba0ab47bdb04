#include "diagnosis/challenge/challenge.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/joined.h"
#include "core/json_text.h"
#include "core/printed.h"
#include "diagnosis/challenge/nominal_case.h"
#include "diagnosis/diagnose.h"

namespace asperity {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
constexpr const char* score_file = "score.json";

/// A score of this program, if there is one already.
std::optional<ChallengeScore> earlier_score(const fs::path& folder, const std::string& program) {
  if (!fs::exists(folder / score_file)) return std::nullopt;
  try {
    const Json json = parse_json(read_file(folder / score_file), score_file);
    if (json.at("program") != program) return std::nullopt;
    return score_from(json.at("score"));
  } catch (const std::exception&) {
    return std::nullopt;  // cut short or of an older form
  }
}

/// Another realisation of the spectrum that was concealed.
std::string another_surface(const Truth& truth) {
  const auto& spectrum = truth.effects.at(0).parameters;
  return printed("generated(rms=%.6g m, hurst=0.8, rolloff=%.6g m, cutoff=%.6g m, seed=%u)",
                 spectrum.at("rms").value, spectrum.at("rolloff").value, spectrum.at("cutoff").value,
                 truth.seed + 500000);
}

/// What rolling loses to adhesion, with a range whose zone the mesh resolves.
void add_lost_work(const Truth& truth, std::vector<std::string>& entries) {
  entries.push_back(printed("Interface/Work of adhesion on separation=%.6g J/m^2",
                            truth.effects.at(0).parameters.at("work_lost").value));
  entries.insert(entries.end(), {"Interface/Adhesion range=0.6 nm", "Mesh/Interface spacing=24 nm"});
}

/// As a user would have it; a case's friction is what the recording guesses, or what it really is.
Diagnosis diagnose_item(const ChallengeItem& item, Recording recording, const Truth& truth,
                        const fs::path& folder, const ChallengeOptions& options) {
  if (!item.simulation) return diagnose(recording);
  fs::path file = item.simulation->file;
  std::vector<std::string> entries = item.simulation->entries;
  if (item.knows_spectrum) entries.push_back("Substrate/Topography=" + another_surface(truth));
  if (item.knows_adhesion) add_lost_work(truth, entries);
  if (file.empty()) {
    file = folder / "case.prm";
    if (item.knows_friction)
      recording.simulation.parameters["sliding_friction"].value = truth.coefficients.at("sliding_friction");
    write_file_atomically(file, nominal_case(recording));
  }
  // The case is the simulation, with a friction of its own.
  recording.simulation_is_given = false;
  recording.simulation = {};
  write_recording(recording, folder);
  return options.diagnose_by_case(read_recording(folder), file, entries, folder / "solves");
}

ChallengeScore new_score(const ChallengeItem& item, const fs::path& folder, const ChallengeOptions& options) {
  const auto began = std::chrono::steady_clock::now();
  const ConcealedRecording concealed = conceal(item);
  write_concealed(concealed, folder);
  ChallengeScore score;
  try {
    // Read back: what is diagnosed is what a user would have.
    const Recording recording = read_recording(folder);
    const Diagnosis diagnosis = diagnose_item(item, recording, concealed.truth, folder, options);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    write_file_atomically(folder / "diagnosis.json", diagnosis_json(diagnosis));
    score = score_of(item, {recording, concealed.truth}, diagnosis);
    score.seconds = seconds;
    score.baselines = user_baselines(recording);
  } catch (const std::exception& error) {
    score.name = item.name, score.family = item.family, score.mode = name_of(item.options.mode),
    score.noise = item.options.noise;
    score.truth = item.right_answer();
    score.verdict = "failed";
    score.failure = error.what();
  }
  return score;
}

}  // namespace

std::vector<ChallengeItem> items_of(const ChallengeOptions& options) {
  std::vector<ChallengeItem> items = options.diagnose_by_case
                                         ? case_challenge_matrix(options.quick, options.seed)
                                         : challenge_matrix(options.quick, options.seed);
  items.erase(
      std::remove_if(items.begin(), items.end(),
                     [&](const auto& item) { return item.name.find(options.only) == std::string::npos; }),
      items.end());
  if (items.empty()) throw InputError("no recording of the challenge has '" + options.only + "' in its name");
  return items;
}

std::vector<ChallengeScore> run_challenge(const ChallengeOptions& options) {
  const std::vector<ChallengeItem> items = items_of(options);
  std::vector<ChallengeScore> scores(items.size());
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex talking;
  const auto work = [&] {
    for (std::size_t i = next++; i < items.size(); i = next++) {
      const fs::path folder = options.output / items[i].name;
      const auto earlier = earlier_score(folder, options.program);
      scores[i] = earlier ? *earlier : new_score(items[i], folder, options);
      if (!earlier)
        write_file_atomically(
            folder / score_file,
            Json{{"program", options.program}, {"score", score_json(scores[i])}}.dump(1) + "\n");
      const std::string head = printed("%3zu/%zu %5.1f s  ", ++done, items.size(), scores[i].seconds);
      const std::lock_guard<std::mutex> lock(talking);
      if (options.progress)
        options.progress(head + items[i].name + ": " + scores[i].verdict + ", " +
                         joined(scores[i].named, " + ", "nothing") +
                         (scores[i].is_right() ? "" : "  <- wrong") +
                         (scores[i].failure.empty() ? "" : " (" + scores[i].failure + ")"));
    }
  };
  std::vector<std::thread> workers;
  for (int j = 1; j < options.jobs; ++j) workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();
  return scores;
}

}  // namespace asperity
