// SPDX-License-Identifier: GPL-3.0-or-later
// Golden data: certified records a second, per family, at 10 and at 20 points a body, on one core.
// `make` is a base case with all its records (one to three), answered, proved, checked and written;
// `prove` verifies finished records from their texts. After the times: a table of records a second.
#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "verify/families/families.hpp"
#include "verify/golden/records/prove.hpp"
#include "verify/golden/records/record.hpp"

namespace fathom::golden {
namespace {

constexpr std::uint64_t seeds = 16;

std::vector<Record> make(const std::string& family, unsigned size, std::uint64_t seed) {
  return records_of({Source::family, family, size, seed});
}

/// A time is that of one record, on average.
template <class Work>
void add(const std::string& instance, const std::string& contender, Work work) {
  benchmark::RegisterBenchmark((instance + "/" + contender).c_str(), [work](benchmark::State& state) {
    std::size_t records = 0;
    std::uint64_t step = 0;
    for ([[maybe_unused]] auto _ : state) records += work(step++);
    state.counters["records/s"] = benchmark::Counter(static_cast<double>(records), benchmark::Counter::kIsRate);
  })->Unit(benchmark::kMicrosecond);
}

void add_instance(const std::string& family, unsigned size) {
  const std::string instance = family + "/" + std::to_string(size);
  add(instance, "make", [family, size](std::uint64_t step) { return make(family, size, step % seeds).size(); });
  const auto finished = std::make_shared<std::vector<Record>>();
  add(instance, "prove", [family, size, finished](std::uint64_t step) {
    if (finished->empty()) *finished = make(family, size, 1);
    const Record& record = (*finished)[step % finished->size()];
    if (const auto fault = faults_of(record.line, record.certificate))
      std::printf("%s: %s\n", record.id.c_str(), fault->c_str());
    return std::size_t{1};
  });
}

/// Remembers the rates, to print them side by side.
class RateReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (!run.error_occurred) rates_.emplace_back(run.run_name.function_name, run.counters.at("records/s").value);
    }
  }

  void Finalize() override {
    std::printf("\nrecords a second, one core\n");
    for (const auto& [name, rate] : rates_) std::printf("%-44s %8.0f\n", name.c_str(), rate);
  }

 private:
  std::vector<std::pair<std::string, double>> rates_;
};

}  // namespace

void add_all() {
  for (const families::Family& family : families::families()) {
    for (const unsigned size : {10U, 20U}) add_instance(std::string(family.name), size);
  }
}

std::unique_ptr<benchmark::BenchmarkReporter> reporter() { return std::make_unique<RateReporter>(); }

}  // namespace fathom::golden

int main(int argc, char** argv) {
  fathom::golden::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks(fathom::golden::reporter().get());
}
