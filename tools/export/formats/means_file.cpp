#include "tools/export/formats/means_file.h"

#include <fmt/format.h>

namespace aspect {
namespace {

std::vector<AttributeVector> read_means(TextLines& lines) {
  lines.need_next("the number of types");
  const std::int64_t count = lines.whole_word("number of types", 0, kMostId);
  lines.end_line();
  std::vector<AttributeVector> means;
  while (lines.next()) {
    means.push_back(read_attributes(lines));
    lines.end_line();
  }
  if (static_cast<std::int64_t>(means.size()) != count)
    lines.fail(fmt::format("{} types, where the first line says {}", means.size(), count));
  return means;
}

}  // namespace

std::string means_text(const std::vector<AttributeVector>& means) {
  std::string text = fmt::format("{}\n", means.size());
  for (const AttributeVector& mean : means) {
    append_attributes(mean, text);
    text += '\n';
  }
  return text;
}

Result<std::vector<AttributeVector>> parse_means(std::string_view text, std::string_view name) {
  return parsed_text(text, name,
                     "the first line is the number of types, the others ten attributes each",
                     read_means);
}

}  // namespace aspect
