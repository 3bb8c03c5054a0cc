#include "compiler/scene/dxf_groups.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace aspect {
namespace {

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
}

[[noreturn]] void bad_number(const DxfRecord& record, const DxfGroup& group) {
  throw MeshError(fmt::format("group {} of {} is '{}' and no number; export it again", group.code,
                              shown(record.kind), shown(group.value)),
                  record.line);
}

}  // namespace

std::string_view DxfRecord::text(int code) const {
  for (const DxfGroup& group : groups)
    if (group.code == code) return group.value;
  return {};
}

double DxfRecord::number_in(const DxfGroup& group) const {
  double value = 0;
  const std::string_view digits =
      group.value.starts_with('+') ? group.value.substr(1) : group.value;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    bad_number(*this, group);
  return value;
}

double DxfRecord::number(int code, double otherwise) const {
  for (const DxfGroup& group : groups)
    if (group.code == code) return number_in(group);
  return otherwise;
}

int DxfRecord::whole(int code, int otherwise) const {
  const double value = number(code, otherwise);
  if (std::abs(value) > 2e9) return otherwise;
  return static_cast<int>(value);
}

Eigen::Vector3d DxfRecord::point(int code) const {
  return {number(code, 0), number(code + 10, 0), number(code + 20, 0)};
}

std::vector<DxfRecord> read_dxf_records(std::string_view file) {
  if (file.starts_with("AutoCAD Binary DXF"))
    throw MeshError("binary DXF is not read; export it as ASCII DXF");
  MeshText text(file);
  std::vector<DxfRecord> records;
  while (!text.at_end()) {
    const std::string_view code_line = trimmed(text.take_line());
    if (code_line.empty() && text.at_end()) break;
    int code = 0;
    const char* end = code_line.data() + code_line.size();
    const auto read = std::from_chars(code_line.data(), end, code);
    if (read.ec != std::errc{} || read.ptr != end)
      text.fail(
          fmt::format("'{}' where a group code should be; is it a DXF file?", shown(code_line)));
    if (text.at_end()) text.fail("ends behind a group code; export it again");
    const std::string_view value = trimmed(text.take_line());
    if (code == 0 && value == "EOF") return records;
    if (code == 0)
      records.push_back({value, text.line(), {}});
    else if (!records.empty())
      records.back().groups.push_back({code, value});
  }
  throw MeshError("ends without EOF; export it again");
}

}  // namespace aspect
