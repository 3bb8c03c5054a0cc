#include "tools/score/result_lines.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace aspect {
namespace {

using Json = nlohmann::json;

FoundObject object_of(const Json& seen) {
  const Json& best = seen.at("hypotheses").at(0);
  FoundObject found;
  found.box = seen.at("box").get<PixelBox>();
  found.is_named = seen.value("verdict", "match") == "match";
  found.object = best.at("object").get<std::string>();
  const auto view = best.at("view").get<std::array<double, 3>>();
  found.view = Eigen::Vector3d(view[0], view[1], view[2]).normalized();
  return found;
}

FoundFrame frame_of(const Json& line) {
  FoundFrame frame;
  frame.frame = line.at("frame").get<std::string>();
  frame.sequence = line.value("sequence", std::uint64_t{0});
  if (line.contains("elapsed_ms")) frame.elapsed_ms = line.at("elapsed_ms").get<double>();
  for (const Json& seen : line.at("objects"))
    if (seen.contains("hypotheses") && !seen.at("hypotheses").empty())
      frame.objects.push_back(object_of(seen));
  return frame;
}

}  // namespace

Result<std::vector<FoundFrame>> parse_results(std::string_view text, const std::string& name) {
  std::vector<FoundFrame> frames;
  for (int number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.empty()) continue;
    try {
      frames.push_back(frame_of(Json::parse(line)));
    } catch (const Json::exception& error) {
      return Error{fmt::format("{}:{}: not a line of aspect-replay ({}); give its output", name,
                               number, error.what())};
    }
  }
  return frames;
}

Result<std::vector<FoundFrame>> read_results(const std::filesystem::path& file) {
  const Result<std::string> text = read_text(file);
  if (!text) return Error{text.error()};
  return parse_results(text.value(), file.native());
}

}  // namespace aspect
