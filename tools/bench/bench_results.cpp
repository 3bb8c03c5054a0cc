#include "tools/bench/bench_results.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace aspect {
namespace {

using Json = nlohmann::json;

// Of repetitions, where the runs themselves are not told.
constexpr const char* kMedian = "median";

// Of at least one.
double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

std::optional<double> us_of(const std::string& unit) {
  for (const auto& [name, us] : {std::pair{"ns", 1e-3}, {"us", 1.0}, {"ms", 1e3}, {"s", 1e6}})
    if (unit == name) return us;
  return std::nullopt;
}

// Nothing of what failed, and of means and deviations.
std::optional<BenchResult> run_of(const Json& entry) {
  if (!entry.is_object() || entry.value("error_occurred", false)) return std::nullopt;
  if (entry.value("run_type", "iteration") != "iteration" &&
      entry.value("aggregate_name", "") != kMedian)
    return std::nullopt;
  const auto unit = us_of(entry.value("time_unit", "ns"));
  const double time = entry.value("cpu_time", -1.0);
  BenchResult run{entry.value("run_name", entry.value("name", "")), 0, {}};
  if (!unit || !(time >= 0) || !std::isfinite(time) || run.name.empty()) return std::nullopt;
  run.cpu_us = time * *unit;
  for (const auto& [key, value] : entry.items())
    if (value.is_number() && std::isfinite(value.get<double>()))
      run.counters[key] = value.get<double>();
  return run;
}

}  // namespace

void BenchResults::add(BenchResult run) {
  for (std::vector<BenchResult>& alike : runs_)
    if (alike.front().name == run.name) return alike.push_back(std::move(run));
  runs_.push_back({std::move(run)});
}

std::vector<BenchResult> BenchResults::medians() const {
  std::vector<BenchResult> all;
  for (const std::vector<BenchResult>& alike : runs_) {
    std::vector<double> times;
    std::map<std::string, std::vector<double>> counters;
    for (const BenchResult& run : alike) {
      times.push_back(run.cpu_us);
      for (const auto& [name, value] : run.counters) counters[name].push_back(value);
    }
    BenchResult& result = all.emplace_back(BenchResult{alike.front().name, median(times), {}});
    for (const auto& [name, values] : counters) result.counters[name] = median(values);
  }
  return all;
}

bool GatheringReporter::ReportContext(const Context& context) {
  shown_.SetOutputStream(&GetOutputStream());
  shown_.SetErrorStream(&GetErrorStream());
  return shown_.ReportContext(context);
}

void GatheringReporter::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.error_occurred) continue;
    if (run.run_type != Run::RT_Iteration && run.aggregate_name != kMedian) continue;
    const double to_us = 1e6 / benchmark::GetTimeUnitMultiplier(run.time_unit);
    BenchResult result{run.run_name.str(), run.GetAdjustedCPUTime() * to_us, {}};
    for (const auto& [name, counter] : run.counters) result.counters[name] = counter.value;
    results_.add(std::move(result));
  }
  shown_.ReportRuns(runs);
}

Result<BenchResults> read_bench_results(const std::filesystem::path& file) {
  constexpr std::uintmax_t kMostBytes = 64U << 20U;
  const auto failed = [&](const char* what) { return Error{file.native() + ": " + what}; };
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(file, unknown))
    return failed("is no file; name one of --benchmark_out");
  if (std::filesystem::file_size(file, unknown) > kMostBytes)
    return failed("is larger than 64 MiB; name one of --benchmark_out");
  std::ifstream in(file);
  const Json json = Json::parse(in, nullptr, false);
  if (json.is_discarded() || !json.is_object() || !json.contains("benchmarks") ||
      !json["benchmarks"].is_array())
    return failed("is no result of aspect-bench --json; measure again");
  BenchResults results;
  try {
    for (const Json& entry : json["benchmarks"])
      if (auto run = run_of(entry)) results.add(std::move(*run));
  } catch (const Json::exception&) {
    return failed("has a field of another kind than aspect-bench writes; measure again");
  }
  return results;
}

}  // namespace aspect
