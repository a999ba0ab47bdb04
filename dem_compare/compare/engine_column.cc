#include "dem_compare/compare/engine_column.h"

#include "core/error.h"

namespace asperity {

EngineColumn::EngineColumn(const std::string& name, std::filesystem::path folder, EngineRunOptions options)
    : engine_(name.empty() ? nullptr : &engine_of(name)),
      folder_(std::move(folder)),
      options_(std::move(options)) {}

const EngineRun& EngineColumn::run(const EngineExperiment& experiment) {
  const std::string input = engine_->input(experiment, plan_motion(experiment));
  const auto known = done_.find(input);
  if (known != done_.end()) return known->second;
  const std::string name = engine_experiment_name(experiment.type) + "_" + std::to_string(done_.size() + 1);
  return done_.emplace(input, run_engine(*engine_, experiment, folder_ / name, options_)).first->second;
}

double EngineColumn::measured(const EngineRequest& request) {
  if (!(request.load_step > 0))
    return named(run(request.experiment).measurements, request.measurement).measured / request.divisor;
  EngineExperiment low = request.experiment, high = request.experiment;
  low.load *= 1 - request.load_step;
  high.load *= 1 + request.load_step;
  return (high.load - low.load) / (named(run(high).measurements, request.measurement).measured -
                                   named(run(low).measurements, request.measurement).measured);
}

ComparedValue EngineColumn::value(const LawValue& law) {
  if (!engine_)
    return absent("no engine was asked for (--engine " + list_runnable_engines(&Engine::key, " or ") + ")");
  if (!law.engine) return absent(law.no_engine.empty() ? law.reason : law.no_engine);
  if (!failure_.empty()) return absent(engine_->name() + " failed: see the message at the end");
  try {
    return {measured(*law.engine), NAN, engine_->name(), ""};
  } catch (const WorkError& error) {
    failure_ = error.what();
    return absent(engine_->name() + " failed: see the message at the end");
  } catch (const InputError& error) {  // an experiment this engine cannot do with these numbers
    return absent(error.what());
  }
}

}  // namespace asperity
