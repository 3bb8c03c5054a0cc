#include "tests/compiler/scene/threemf_samples.h"

#include <fmt/format.h>
#include <minizip/zip.h>

#include "tests/temporary_folder.h"

namespace aspect {

const std::string kThreeMfColours =
    "<resources><basematerials id=\"1\"><base name=\"sky\" displaycolor=\"#1180FF\"/><base "
    "name=\"slate\" displaycolor=\"#203040FF\"/></basematerials><m:colorgroup id=\"2\"><m:color "
    "color=\"#FF0000\"/><m:color color=\"#00FF00\"/><m:color color=\"#0000ff\"/></m:colorgroup>";

std::string zip_of(const std::vector<ZipMember>& members) {
  const TemporaryFolder folder;
  const std::string file = (folder / "a.zip").string();
  const zipFile zip = zipOpen64(file.c_str(), 0);
  for (const ZipMember& member : members) {
    const zip_fileinfo when{};
    zipOpenNewFileInZip(zip, member.name.c_str(), &when, nullptr, 0, nullptr, 0, nullptr,
                        Z_DEFLATED, 6);
    zipWriteInFileInZip(zip, member.bytes.data(), static_cast<unsigned>(member.bytes.size()));
    zipCloseFileInZip(zip);
  }
  zipClose(zip, nullptr);
  return read_file(file);
}

std::string tetrahedron(int id, const std::string& attributes,
                        const std::array<std::string, 4>& triangles) {
  constexpr std::array<const char*, 4> kCorners = {
      "v1=\"0\" v2=\"2\" v3=\"1\"", "v1=\"0\" v2=\"1\" v3=\"3\"", "v1=\"0\" v2=\"3\" v3=\"2\"",
      "v1=\"1\" v2=\"2\" v3=\"3\""};
  std::string text = fmt::format(
      "<object id=\"{}\" {}><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" "
      "y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"2\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"3\"/>"
      "</vertices><triangles>",
      id, attributes);
  for (std::size_t k = 0; k < 4; ++k)
    text += fmt::format("<triangle {} {}/>", kCorners[k], triangles[k]);
  return text + "</triangles></mesh></object>";
}

std::string model_text(const std::string& content, const std::string& attributes) {
  return fmt::format(
      "<model {} xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
      "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\" "
      "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">{}</model>",
      attributes, content);
}

std::vector<ZipMember> threemf_of(const std::string& content, const std::string& attributes) {
  return {
      {"_rels/.rels",
       "<Relationships "
       "xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
       "Target=\"/3D/3dmodel.model\" Id=\"r\" "
       "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
      {"3D/3dmodel.model", model_text(content, attributes)}};
}

}  // namespace aspect
