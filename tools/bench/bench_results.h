// What benchmarks measured, as plots take it.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

struct BenchResult {
  std::string name;                        // as aspect-bench --benchmark_list_tests prints it
  double cpu_us = 0;                       // an iteration; of repetitions the median
  std::map<std::string, double> counters;  // likewise
};

// In the order in which they first appear; of what was run several times the median.
class BenchResults {
 public:
  void add(BenchResult run);
  std::vector<BenchResult> medians() const;

 private:
  std::vector<std::vector<BenchResult>> runs_;  // of one name each
};

// Gathers what passes by.
class GatheringReporter : public benchmark::BenchmarkReporter {
 public:
  GatheringReporter(benchmark::BenchmarkReporter& shown, BenchResults& results)
      : shown_(shown), results_(results) {}
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override { shown_.Finalize(); }

 private:
  benchmark::BenchmarkReporter& shown_;
  BenchResults& results_;
};

// Of a file that aspect-bench wrote with --json or --benchmark_out. Errors name the file.
Result<BenchResults> read_bench_results(const std::filesystem::path& file);

}  // namespace aspect
