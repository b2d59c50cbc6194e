#include "cli/run_record.h"

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <unistd.h>

namespace gabarit {

static std::string host() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

static std::string utc(std::time_t time) {
  std::tm parts{};
  gmtime_r(&time, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

static long peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024;  // Linux counts in KiB.
}

std::string run_json(const RunRecord& record, const std::vector<Stage>& stages) {
  using Json = nlohmann::ordered_json;
  Json times = Json::array();
  for (const Stage& stage : stages) times.push_back({{"stage", stage.name}, {"seconds", stage.seconds}});
  const Json json = {
      {"schema", "gabarit.run/1"},         {"started", utc(record.started)}, {"host", host()},
      {"threads", record.threads},         {"command", record.command},      {"stages", std::move(times)},
      {"peak_memory_bytes", peak_memory()}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gabarit
