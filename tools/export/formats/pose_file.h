// .index: results of pose estimation (thesis A.2.11): what findclass proposes for unknown pictures.
//
//   +0.015+0.442+0.897                                                picture
//   38 5001664 0-0(482) 2-2(207) 3-3(90) 1-1(237) 4-4(648)            class, score, matches
//
// The best class first. A match is a region of the picture, one of the class (both from 0 on), and
// its weight: in how many graphs of the class the region is of that type. The example's scores are
// those of equation 4.2 to the last digit. Classes count from 1, as in .class. What the appendix
// leaves open: a line with a single word is a picture; blanks, control characters and % in its name
// are written %20 and so on.
#pragma once

#include <string>
#include <vector>

#include "tools/export/formats/text_lines.h"

namespace aspect {

struct RegionMatch {
  std::int64_t seen = 0, known = 0;
  double weight = 0;

  bool operator==(const RegionMatch&) const = default;
};

struct PoseProposal {
  std::int64_t pose = 0;
  double score = 0;
  std::vector<RegionMatch> matches;

  bool operator==(const PoseProposal&) const = default;
};

struct UnknownPicture {
  std::string name;
  std::vector<PoseProposal> proposals;

  bool operator==(const UnknownPicture&) const = default;
};

std::string poses_text(const std::vector<UnknownPicture>& pictures);
void append_picture(const UnknownPicture& picture, std::string& text);
Result<std::vector<UnknownPicture>> parse_poses(std::string_view text, std::string_view name);

}  // namespace aspect
