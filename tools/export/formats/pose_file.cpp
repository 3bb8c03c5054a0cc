#include "tools/export/formats/pose_file.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <iterator>

namespace aspect {
namespace {

bool is_written_as_is(char c) {
  return c > ' ' && c != '%' && c != '\x7f';
}

void append_name(std::string_view name, std::string& text) {
  for (std::size_t k = 0; k < name.size(); ++k) {
    // A backslash at the end would take the next line for a part of this one.
    const bool plain = (is_written_as_is(name[k]) || (name[k] & 0x80) != 0) &&
                       (name[k] != '\\' || k + 1 < name.size());
    if (plain)
      text += name[k];
    else
      fmt::format_to(std::back_inserter(text), "%{:02X}", static_cast<unsigned char>(name[k]));
  }
}

std::string read_name(TextLines& lines, std::string_view word) {
  std::string name;
  for (; !word.empty(); word.remove_prefix(1)) {
    if (word.front() != '%') {
      name += word.front();
      continue;
    }
    unsigned code = 0;
    const char* digits = word.data() + 1;
    const bool is_whole = word.size() >= 3;
    const auto parsed = std::from_chars(digits, digits + (is_whole ? 2 : 0), code, 16);
    if (!is_whole || parsed.ec != std::errc() || parsed.ptr != digits + 2)
      lines.fail("a % in a picture's name without two digits");
    name += static_cast<char>(code);
    word.remove_prefix(2);
  }
  return name;
}

RegionMatch read_match(TextLines& lines) {
  RegionMatch match;
  match.seen = lines.whole("region", 0, kMostId);
  lines.expect("-");
  match.known = lines.whole("region", 0, kMostId);
  lines.expect("(");
  const std::string_view weight = lines.run_of("0123456789+-.e", "a weight");
  const auto parsed = std::from_chars(weight.data(), weight.data() + weight.size(), match.weight);
  if (parsed.ec != std::errc() || parsed.ptr != weight.data() + weight.size() ||
      !std::isfinite(match.weight) || match.weight < 0)
    lines.fail(excerpt_of(weight) + " is no weight");
  lines.expect(")");
  return match;
}

std::vector<UnknownPicture> read_poses(TextLines& lines) {
  std::vector<UnknownPicture> pictures;
  while (lines.next()) {
    const std::string_view first = lines.word("a picture's name");
    if (lines.at_line_end()) {
      pictures.push_back({read_name(lines, first), {}});
      continue;
    }
    if (pictures.empty()) lines.fail("a proposal before the first picture");
    PoseProposal proposal;
    const auto parsed = std::from_chars(first.data(), first.data() + first.size(), proposal.pose);
    if (parsed.ec != std::errc() || parsed.ptr != first.data() + first.size() ||
        proposal.pose < 0 || proposal.pose > kMostId)
      lines.fail(excerpt_of(first) + " is no class");
    proposal.score = lines.real_word("score");
    while (!lines.at_line_end()) proposal.matches.push_back(read_match(lines));
    pictures.back().proposals.push_back(std::move(proposal));
  }
  return pictures;
}

}  // namespace

void append_picture(const UnknownPicture& picture, std::string& text) {
  append_name(picture.name, text);
  text += '\n';
  for (const PoseProposal& proposal : picture.proposals) {
    fmt::format_to(std::back_inserter(text), "{} {}", proposal.pose, proposal.score);
    for (const RegionMatch& match : proposal.matches)
      fmt::format_to(std::back_inserter(text), " {}-{}({})", match.seen, match.known, match.weight);
    text += '\n';
  }
}

std::string poses_text(const std::vector<UnknownPicture>& pictures) {
  std::string text;
  for (const UnknownPicture& picture : pictures) append_picture(picture, text);
  return text;
}

Result<std::vector<UnknownPicture>> parse_poses(std::string_view text, std::string_view name) {
  return parsed_text(text, name, "a line is PICTURE or CLASS SCORE SEEN-KNOWN(WEIGHT)...",
                     read_poses);
}

}  // namespace aspect
