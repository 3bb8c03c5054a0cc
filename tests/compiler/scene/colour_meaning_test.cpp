// Every line of the table of colour sources against a file with a known value.
#include "compiler/scene/colour_meaning.h"

#include <catch2/catch.hpp>
#include <map>
#include <opencv2/imgcodecs.hpp>

#include "compiler/scene/scene_reader.h"
#include "mesh_samples.h"
#include "scene_samples.h"
#include "tests/compiler/scene/threemf_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

struct Sample {
  std::string name, bytes;
  Vector3d seen;  // in bytes, as a viewer shows it
};

std::string number_bytes(std::uint64_t value, std::size_t count) {
  std::string bytes;
  for (std::size_t k = 0; k < count; ++k) bytes += static_cast<char>(value >> 8 * k & 255u);
  return bytes;
}
std::string float_bytes(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers)
    bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
  return bytes;
}

std::string ply(const std::string& type, const std::string& rgb) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex 3\n";
  for (const char* name : {"x", "y", "z"}) text += "property float " + std::string(name) + "\n";
  for (const char* name : {"red", "green", "blue"})
    text += "property " + type + " " + std::string(name) + "\n";
  text += "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (const char* at : {"0 0 0 ", "1 0 0 ", "0 1 0 "}) text += at + rgb + "\n";
  return text + "3 0 1 2\n";
}

std::string stl(const std::string& head, unsigned attribute) {
  std::string header = head;
  header.resize(80, ' ');
  return header + number_bytes(1, 4) + float_bytes({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) +
         number_bytes(attribute, 2);
}

std::string gltf(const std::string& attributes, const std::string& material) {
  const std::string buffer =
      float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0, .5f, .25f, 0, .5f, .25f, 0, .5f, .25f, 0});
  return R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[)"
         R"({"material":0,"attributes":{"POSITION":0)" +
         attributes + R"(}}]}],"materials":[{)" + material +
         R"(}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
         R"({"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":72}],"buffers":[{"byteLength":72,)"
         R"("uri":"data:;base64,)" +
         base64(buffer) + "\"}]}";
}

std::string chunk(unsigned id, const std::string& content) {
  return number_bytes(id, 2) + number_bytes(content.size() + 6, 4) + content;
}

std::string tds() {
  using namespace std::string_literals;
  const std::string colour = chunk(0x0011, "\xD9\x19\x80"s);
  const std::string material = chunk(0xAFFF, chunk(0xA000, "m\0"s) + chunk(0xA020, colour));
  const std::string vertices =
      chunk(0x4110, number_bytes(3, 2) + float_bytes({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const std::string faces =
      chunk(0x4120, number_bytes(1, 2) + number_bytes(0, 2) + number_bytes(1, 2) +
                        number_bytes(2, 2) + number_bytes(0, 2) +
                        chunk(0x4130, "m\0"s + number_bytes(1, 2) + number_bytes(0, 2)));
  const std::string object = chunk(0x4000, "part\0"s + chunk(0x4100, vertices + faces));
  return chunk(0x4D4D, chunk(0x0002, number_bytes(3, 4)) + chunk(0x3D3D, material + object));
}

std::string dxf(const std::string& colour) {
  return "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\n0\n" + colour +
         "10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n0\n22\n1\n32\n0\n13\n0\n23\n1\n33\n0\n"
         "0\nENDSEC\n0\nEOF\n";
}

std::string threemf(const std::string& group) {
  return zip_of(threemf_of(kThreeMfColours +
                           tetrahedron(5, "pid=\"" + group + "\" pindex=\"0\"", {}) +
                           "</resources><build><item objectid=\"5\"/></build>"));
}

std::string png() {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", cv::Mat(2, 2, CV_8UC3, cv::Scalar(128, 25, 217)), bytes);
  return {bytes.begin(), bytes.end()};
}

constexpr const char* kObj =
    "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";

// By format and place. The light of the bytes 217 and 25 is .693872 and .009721, of .5 the byte
// 187.516 and of .25 136.960 (IEC 61966-2-1); CIE's sRGB red is .4124 .2126 .0193; 31 parts are
// all.
std::map<std::string, Sample> samples() {
  const std::string off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 ";
  const Vector3d seen(217, 25, 128);
  return {
      {"b surface",
       {"a.b",
        "surface { diffuse .5 .25 0 } sphere { center 0 0 0 radius .1 }",
        {127.5, 63.75, 0}}},
      {"obj Kd of MTL", {"newmtl m\nKd .5 .25 0\n", kObj, {127.5, 63.75, 0}}},
      {"obj Kd xyz of MTL", {"newmtl m\nKd xyz .4124 .2126 .0193\n", kObj, {255, 0, 0}}},
      {"obj vertex",
       {"", "v 0 0 0 .5 .25 0\nv 1 0 0 .5 .25 0\nv 0 1 0 .5 .25 0\nf 1 2 3\n", {127.5, 63.75, 0}}},
      {"any picture", {"newmtl m\nmap_Kd a.png\n", kObj, seen}},
      {"gltf baseColorFactor",
       {"a.gltf",
        gltf("", R"("pbrMetallicRoughness":{"baseColorFactor":[0.693872,0.009721,0,1]})"),
        {217, 25, 0}}},
      {"gltf COLOR_0", {"a.gltf", gltf(",\"COLOR_0\":1", ""), {187.516, 136.960, 0}}},
      {"gltf diffuseFactor",
       {"a.gltf",
        gltf(
            "",
            R"("extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.693872,0.009721,0,1]}})"),
        {217, 25, 0}}},
      {"ply whole", {"a.ply", ply("uchar", "217 25 128"), seen}},
      {"ply float", {"a.ply", ply("float", "0.5 0.25 0"), {127.5, 63.75, 0}}},
      {"stl VisCAM", {"a.stl", stl("", 1u << 15 | 31u << 10 | 31u), {255, 0, 255}}},
      {"stl Magics", {"a.stl", stl("COLOR=\x10\x20\x30\xff", 31u), {255, 0, 0}}},
      {"off whole", {"a.off", off + "217 25 128\n", seen}},
      {"off float", {"a.off", off + "0.5 0.25 0.0\n", {127.5, 63.75, 0}}},
      {"3ds COLOR_24", {"a.3ds", tds(), seen}},
      {"3mf displaycolor", {"a.3mf", threemf("1"), {0x11, 0x80, 0xff}}},
      {"3mf colorgroup", {"a.3mf", threemf("2"), {255, 0, 0}}},
      {"dxf index (62)", {"a.dxf", dxf("62\n30\n"), {255, 127, 0}}},
      {"dxf true colour (420)", {"a.dxf", dxf("420\n14227840\n"), seen}},
  };
}

}  // namespace

TEST_CASE("every source of colours in the table shows as its specification or viewer has it") {
  const std::map<std::string, Sample> all = samples();
  CHECK(all.size() + 1 == kColourSources.size());
  const TemporaryFolder folder;
  folder.write("a.png", png());
  for (const ColourSource& source : kColourSources) {
    const std::string name = std::string(source.format) + " " + std::string(source.place);
    INFO(name);
    if (source.format == "step") continue;  // see step_colour_test.cpp: it needs OpenCASCADE
    REQUIRE(all.contains(name));
    const Sample& sample = all.at(name);
    const bool is_obj = !sample.name.starts_with("a.");
    if (is_obj) folder.write("a.mtl", sample.name);
    const Result<Scene> scene =
        read_scene(folder.write(is_obj ? "a.obj" : sample.name, sample.bytes));
    if (!scene) FAIL(scene.error());
    REQUIRE(scene.value().surfaces.size() == 1);
    CHECK((255 * scene.value().surfaces[0].diffuse - sample.seen).cwiseAbs().maxCoeff() <= .5);
  }
}

}  // namespace aspect
