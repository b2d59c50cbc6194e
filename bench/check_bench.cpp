// The whole `gabarit check` as a user runs it on the example motorcycle, process start to exit, with PDF, STL
// and JSON: wall time, processor time and peak memory.
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "bench/motorcycle_mesh.h"
#include "report/write_stl.h"

namespace gabarit {
namespace {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gabarit-bench-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder can be made");
    path_ = name;
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

const TemporaryFolder& folder() {
  static const TemporaryFolder all;
  return all;
}

std::string stl_of(std::int64_t facets) {
  static std::map<std::int64_t, std::string> written;
  std::string& file = written[facets];
  if (!file.empty()) return file;
  file = (folder().path() / (std::to_string(facets) + ".stl")).string();
  const Model model = motorcycle_mesh(static_cast<std::size_t>(facets));
  std::vector<FacetId> all(model.mesh.facet_count());
  for (FacetId f = 0; f < all.size(); ++f) all[f] = f;
  OutputFile out(file);
  write_stl(model.mesh, all, "motorcycle", out);
  out.commit();
  return file;
}

// What the process took. Throws when it did not find the violations of the example.
rusage run_check(const std::string& model, int threads) {
  std::array<std::string, 10> words{GABARIT_PROGRAM,
                                    "check",
                                    model,
                                    "--rules",
                                    GABARIT_SOURCE_DIR "/rules/library/motorcycle-column.yaml",
                                    "--out",
                                    (folder().path() / "out").string(),
                                    "--threads",
                                    std::to_string(threads),
                                    "--quiet"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawn(&child, words[0].c_str(), nullptr, nullptr, arguments.data(), environ) != 0)
    throw std::runtime_error("gabarit cannot be started");
  int status = 0;
  rusage used{};
  if (wait4(child, &status, 0, &used) != child || !WIFEXITED(status) || WEXITSTATUS(status) != 1)
    throw std::runtime_error("gabarit did not end with exit code 1");
  return used;
}

double seconds(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

void check(benchmark::State& state) {
  const std::string model = stl_of(state.range(0));
  rusage used{};
  for (auto _ : state) used = run_check(model, static_cast<int>(state.range(1)));
  state.counters["cpu_s"] = seconds(used.ru_utime) + seconds(used.ru_stime);
  state.counters["peak_MB"] = static_cast<double>(used.ru_maxrss) / 1000;
}

BENCHMARK(check)
    ->ArgNames({"facets", "threads"})
    ->ArgsProduct({{440'000, 2'700'000}, {1, 2}})
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

}  // namespace
}  // namespace gabarit
