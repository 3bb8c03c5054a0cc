#include "tools/replay/bop_rows.h"

#include <fmt/format.h>
#include <cctype>
#include <charconv>
#include <chrono>

namespace aspect {

std::optional<std::uint64_t> bop_image_id(std::string_view frame_name) {
  std::string_view name = frame_name.substr(frame_name.rfind('/') + 1);
  if (const std::size_t dot = name.rfind('.');
      dot != std::string_view::npos && name.find('#', dot) == std::string_view::npos)
    name = name.substr(0, dot);
  std::size_t begin = name.size();
  while (begin > 0 && std::isdigit(static_cast<unsigned char>(name[begin - 1])) != 0) --begin;
  std::uint64_t id = 0;
  const auto parsed = std::from_chars(name.data() + begin, name.data() + name.size(), id);
  if (parsed.ec != std::errc() || begin == name.size()) return std::nullopt;
  return id;
}

Result<std::string> BopRows::rows(std::string_view frame_name, const Recognition& recognition) {
  const auto image = bop_image_id(frame_name);
  if (!image)
    return Error{fmt::format(
        "{}: no number at the end of its name, which --bop takes for im_id; name it 000123.png",
        frame_name)};
  if (!images_.insert(*image).second)
    return Error{fmt::format("{}: im_id {} has been written; give each scene's frames alone",
                             frame_name, *image)};
  const double time_s = std::chrono::duration<double>(recognition.elapsed).count();
  std::string text;
  for (const SeenObject& object : recognition.objects) {
    const Verdict verdict = object.judgement.verdict;
    if (verdict != Verdict::match && verdict != Verdict::ambiguous) continue;
    const Hypothesis& best = object.hypotheses.front();
    if (best.pose == nullptr) continue;
    const RigidPose& pose = best.pose->refined.pose;
    const auto r = pose.rotation.rows();
    const Vector3d t = ids_.unit_mm * pose.translation;
    text += fmt::format("{},{},{},{},{} {} {} {} {} {} {} {} {},{} {} {},{}\n", ids_.scene, *image,
                        ids_.objects.at(best.index), object.judgement.probability, r[0][0], r[0][1],
                        r[0][2], r[1][0], r[1][1], r[1][2], r[2][0], r[2][1], r[2][2], t[0], t[1],
                        t[2], time_s);
  }
  return text;
}

}  // namespace aspect
