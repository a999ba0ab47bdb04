#include "benchmarks/machine_state.h"

#include <sys/sysinfo.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include <thread>

namespace asperity {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown";
}

}  // namespace

nlohmann::json machine_state() {
  double load[3] = {0, 0, 0};
  getloadavg(load, 3);
  struct sysinfo system {};
  sysinfo(&system);
  const std::time_t now = std::time(nullptr);
  char time[32];
  std::strftime(time, sizeof time, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
  return {{"processor", processor_name()},
          {"cores", std::thread::hardware_concurrency()},
          {"memory", static_cast<double>(system.totalram) * system.mem_unit},
          {"load", {load[0], load[1], load[2]}},
          {"time", time},
          {"compiler", __VERSION__}};
}

}  // namespace asperity
