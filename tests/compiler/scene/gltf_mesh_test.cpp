// glTF: colours as displayed from the light that the file has, numbers of every type, and every
// colour that is lost told.
#include <catch2/catch.hpp>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/scene_reader.h"
#include "mesh_samples.h"
#include "scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Eigen::Vector3d;

template <typename Value>
std::string bytes_of(std::initializer_list<Value> values) {
  std::string bytes;
  for (const Value value : values)
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

// What the accessors of gltf_with() are.
constexpr int kFloatPlaces = 0, kFloatUv = 1, kByteColours = 2, kFloatColours = 3, kShortPlaces = 4,
              kShortUv = 5;

// One triangle with these attributes of accessors and, behind "primitives" and the like, these
// lists; uv is in the left half of a picture, its middle row.
std::string gltf_with(const std::string& attributes, const std::string& lists,
                      const std::string& primitive = "\"material\":0") {
  const std::string buffer =
      bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}) +                                // 0, 36 bytes
      bytes_of<float>({.1f, .4f, .4f, .4f, .1f, .6f}) +                             // 36, 24
      bytes_of<std::uint8_t>({255, 128, 0, 255, 255, 128, 0, 9, 255, 128, 0, 0}) +  // 60, 12
      bytes_of<float>({.5f, .25f, 1, .5f, .25f, 1, .5f, .25f, 1}) +                 // 72, 36
      bytes_of<std::int16_t>({-32767, 0, 0, 0, 32767, 0, 0, 0, 0, 32767, 0, 0}) +   // 108, 24
      bytes_of<std::uint16_t>({6554, 26214, 26214, 26214, 6554, 39321});            // 132, 12
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{)" +
         attributes + "}" + (primitive.empty() ? "" : ",") + primitive + "}]}]" + lists +
         R"(,"accessors":[)"
         R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},)"
         R"({"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC2"},)"
         R"({"bufferView":0,"byteOffset":60,"componentType":5121,"normalized":true,"count":3,)"
         R"("type":"VEC4"},)"
         R"({"bufferView":0,"byteOffset":72,"componentType":5126,"count":3,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5122,"normalized":true,"count":3,"type":"VEC3"},)"
         R"({"bufferView":0,"byteOffset":132,"componentType":5123,"normalized":true,"count":3,)"
         R"("type":"VEC2"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":144},)"
         R"({"buffer":0,"byteOffset":108,"byteLength":24,"byteStride":8}],)"
         R"("buffers":[{"byteLength":144,"uri":"data:application/octet-stream;base64,)" +
         base64(buffer) + "\"}]}";
}

std::string attribute(const char* name, int accessor) {
  return "\"" + std::string(name) + "\":" + std::to_string(accessor);
}

const std::string kPlaces = attribute("POSITION", kFloatPlaces);
const std::string kTexturedPlaces = kPlaces + "," + attribute("TEXCOORD_0", kFloatUv);

std::string material(const std::string& pbr) {
  return ",\"materials\":[{\"name\":\"m\",\"pbrMetallicRoughness\":{" + pbr + "}}]";
}

// Left 217 25 25, right 0 0 255.
std::string halves_png() {
  cv::Mat picture(4, 8, CV_8UC3, cv::Scalar(25, 25, 217));
  picture.colRange(4, 8) = cv::Scalar(255, 0, 0);
  std::vector<std::uint8_t> png;
  cv::imencode(".png", picture, png);
  return {png.begin(), png.end()};
}

std::string textured(const std::string& pbr_info = "", const std::string& sampler = "") {
  return material("\"baseColorTexture\":{\"index\":0" + pbr_info + "}") +
         R"(,"textures":[{"source":0,"sampler":0}],"samplers":[{)" + sampler +
         R"(}],"images":[{"uri":"data:image/png;base64,)" + base64(halves_png()) + "\"}]";
}

Scene scene_of(const std::string& text, const SceneReading& reading = {}) {
  const TemporaryFolder folder;
  Result<Scene> scene = read_scene(folder.write("a.gltf", text), reading);
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

Vector3d colour_of(const std::string& text) {
  const Scene scene = scene_of(text);
  REQUIRE(scene.surfaces.size() == 1);
  return scene.surfaces[0].diffuse;
}

std::string refusal(const std::string& text) {
  const TemporaryFolder folder;
  const Result<Scene> scene = read_scene(folder.write("a.gltf", text));
  return scene.ok() ? "no error" : scene.error();
}

void check_told(const std::string& text, const std::string& what) {
  INFO(what);
  CHECK_THAT(refusal(text), Contains("a.gltf: " + what) && Contains("--missing-colour R,G,B"));
  SceneReading reading;
  reading.colours.missing = Vector3d(.25, .5, .75);
  const Scene scene = scene_of(text, reading);
  REQUIRE(scene.surfaces.size() == 1);
  CHECK(scene.surfaces[0].diffuse.isApprox(Vector3d(.25, .5, .75)));
  REQUIRE(scene.missing_colours.size() == 1);
  CHECK_THAT(line_of(scene.missing_colours[0]), Contains(what));
}

constexpr double kClose = 1e-4;

}  // namespace

TEST_CASE("a base colour is light: what it shows is its sRGB") {
  // The bytes 217, 25 and 128 by the table of IEC 61966-2-1.
  const Vector3d seen =
      colour_of(gltf_with(kPlaces, material("\"baseColorFactor\":[0.693872,0.009721,0.215861,1]")));
  CHECK((255 * seen).isApprox(Vector3d(217, 25, 128), kClose));
  CHECK(colour_of(gltf_with(kPlaces, material(""))) == Vector3d(1, 1, 1));
}

TEST_CASE("colours of vertices are light, of any type, times the base colour") {
  // sRGB of .5, .25 and 128 / 255.
  const double half = .735357, quarter = .537099, byte = .736550;
  const auto with = [&](int accessor) { return kPlaces + "," + attribute("COLOR_0", accessor); };
  CHECK(colour_of(gltf_with(with(kFloatColours), "", ""))
            .isApprox(Vector3d(half, quarter, 1), kClose));
  CHECK(colour_of(gltf_with(with(kByteColours), "", "")).isApprox(Vector3d(1, byte, 0), kClose));
  CHECK(colour_of(gltf_with(with(kFloatColours), material("\"baseColorFactor\":[1,1,0.5,1]")))
            .isApprox(Vector3d(half, quarter, half), kClose));
}

TEST_CASE("a picture shows as it is, and what multiplies it multiplies its light") {
  CHECK((255 * colour_of(gltf_with(kTexturedPlaces, textured()))).isApprox(Vector3d(217, 25, 25)));
  const std::string dark =
      material("\"baseColorFactor\":[0.5,0.5,1,1],\"baseColorTexture\":{\"index\":0}");
  const std::string plain = material("\"baseColorTexture\":{\"index\":0}");
  std::string lists = textured();
  lists.replace(lists.find(plain), plain.size(), dark);
  // sRGB of half the light of 217 and 25.
  CHECK(colour_of(gltf_with(kTexturedPlaces, lists))
            .isApprox(Vector3d(.623722, .060163, 25 / 255.), 1e-3));
}

TEST_CASE("the diffuse colour of specular-glossiness wins and is light as well") {
  const std::string lists =
      R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0,0,1,1]},"extensions":{)"
      R"("KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0.5,0.25,1,1]}}}],)"
      R"("extensionsRequired":["KHR_materials_pbrSpecularGlossiness"])";
  CHECK(colour_of(gltf_with(kPlaces, lists)).isApprox(Vector3d(.735357, .537099, 1), kClose));
}

TEST_CASE("quantised places and texture coordinates are read right") {
  const std::string quantised =
      attribute("POSITION", kShortPlaces) + "," + attribute("TEXCOORD_0", kShortUv);
  const Scene scene = scene_of(
      gltf_with(quantised, textured() + R"(,"extensionsRequired":["KHR_mesh_quantization"])"));
  REQUIRE(scene.surfaces.size() == 1);
  CHECK((255 * scene.surfaces[0].diffuse).isApprox(Vector3d(217, 25, 25)));
  // From -1 to 1 and from 0 to 1: of the middle and half the diagonal.
  CHECK(scene.source_from_object.translation.isApprox(Vector3d(0, .5, 0)));
}

TEST_CASE("an extension that is required and not read is refused with its name") {
  for (const std::string name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                                 "KHR_texture_basisu", "EXT_mesh_gpu_instancing", "ACME_new"})
    CHECK_THAT(refusal(gltf_with(kPlaces, material("") +
                                              R"(,"extensionsUsed":["KHR_materials_ior",")" + name +
                                              R"("],"extensionsRequired":[)"
                                              R"("KHR_materials_ior",")" +
                                              name + "\"]")),
               Contains("requires " + name + ", which is not read; export it without"));
  CHECK(colour_of(gltf_with(kPlaces, material("") + R"(,"extensionsUsed":["ACME_new"])")) ==
        Vector3d(1, 1, 1));
}

TEST_CASE("a material, texture or image that is not there is told") {
  check_told(gltf_with(kPlaces, material(""), "\"material\":3"),
             "materials[3], which meshes[0].primitives[0] names, is not there");
  const std::string pbr = material("\"baseColorTexture\":{\"index\":0}");
  const std::string uri = R"(,"textures":[{"source":0}],"images":[{"uri":"none%20here.png"}])";
  check_told(gltf_with(kTexturedPlaces, material("\"baseColorTexture\":{\"index\":7}")),
             "textures[7] is not there");
  check_told(gltf_with(kTexturedPlaces, pbr + R"(,"textures":[{"source":4}])"),
             "textures[0] names images[4], which is not there");
  check_told(gltf_with(kTexturedPlaces, pbr + R"(,"textures":[{}])"), "textures[0] names no image");
  check_told(gltf_with(kTexturedPlaces,
                       pbr + R"(,"textures":[{"extensions":{"KHR_texture_basisu":{"source":0}}}])"),
             "textures[0] has an image of KHR_texture_basisu alone");
  check_told(gltf_with(kTexturedPlaces, pbr + uri), "images[0] is not there");
  check_told(
      gltf_with(kTexturedPlaces,
                pbr + R"(,"textures":[{"source":0}],"images":[{"uri":"data:;base64,AAAA"}])"),
      "images[0] is no picture that is read");
  check_told(gltf_with(kTexturedPlaces, textured(",\"texCoord\":1")),
             "textures[0] is on faces without TEXCOORD_1");
}

TEST_CASE("a picture beside the file is found by its percents, case and backslashes") {
  const TemporaryFolder folder;
  folder.write("my tex.png", halves_png());
  for (const std::string uri :
       {"my%20tex.png", "my tex.png", "My%20Tex.png", "C:\\\\t\\\\my tex.png"}) {
    const auto file = folder.write(
        "a.gltf", gltf_with(kTexturedPlaces,
                            material("\"baseColorTexture\":{\"index\":0}") +
                                R"(,"textures":[{"source":0}],"images":[{"uri":")" + uri + "\"}]"));
    const Result<Scene> scene = read_scene(file);
    INFO(uri << (scene.ok() ? "" : scene.error()));
    REQUIRE(scene.ok());
    CHECK((255 * scene.value().surfaces.at(0).diffuse).isApprox(Vector3d(217, 25, 25)));
  }
}

TEST_CASE("texture coordinates are moved and beyond 0 to 1 repeated, clamped or mirrored") {
  const Vector3d left(217, 25, 25), right(0, 0, 255);
  const auto moved = [&](const std::string& transform, const std::string& sampler = "") {
    return (255 * colour_of(gltf_with(
                      kTexturedPlaces,
                      textured(",\"extensions\":{\"KHR_texture_transform\":{" + transform + "}}",
                               sampler))))
        .eval();
  };
  const std::string clamp = "\"wrapS\":33071", mirror = "\"wrapS\":33648";
  CHECK(moved("").isApprox(left));
  CHECK(moved("\"offset\":[0.5,0]").isApprox(right));
  CHECK(moved("\"offset\":[1,0]").isApprox(left));
  CHECK(moved("\"offset\":[1,0]", clamp).isApprox(right));
  CHECK(moved("\"offset\":[1,0]", mirror).isApprox(right));
  CHECK(moved("\"offset\":[0,0.5]").isApprox(left));
  // Half a turn about the corner: -u.
  CHECK(moved("\"rotation\":3.14159265").isApprox(right));
  CHECK(moved("\"scale\":[-1,1]").isApprox(right));
  CHECK(moved("\"offset\":[-3,0],\"texCoord\":0").isApprox(left));
}

TEST_CASE("nodes move, turn and scale what they hold, by parts or by a matrix") {
  const auto place = [](const std::string& node) {
    std::string text = gltf_with(kPlaces, material(""));
    const std::string plain = "\"nodes\":[{\"mesh\":0}]";
    text.replace(text.find(plain), plain.size(),
                 "\"nodes\":[{\"children\":[1]," + node + "},{\"mesh\":0}]");
    const TemporaryFolder folder;
    const Result<ColouredMesh> mesh = read_coloured_mesh(folder.write("a.gltf", text));
    if (!mesh) FAIL(mesh.error());
    return mesh.value().vertices.at(1);  // 1 0 0 in its own coordinates
  };
  const std::string half = std::to_string(std::numbers::sqrt2 / 2);
  CHECK(place("\"translation\":[1,2,3],\"rotation\":[0,0," + half + "," + half +
              "],\"scale\":[2,1,1]")
            .isApprox(Vector3d(1, 4, 3), 1e-6));
  CHECK(place("\"matrix\":[0,2,0,0,-1,0,0,0,0,0,1,0,1,2,3,1]").isApprox(Vector3d(1, 4, 3)));
}

TEST_CASE("strips and fans are triangles that are wound alike") {
  for (const int mode : {5, 6}) {
    // A square: as a strip 0 1 3 2, as a fan 0 1 2 3.
    const std::string buffer = mode == 5 ? bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0})
                                         : bytes_of<float>({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    const std::string text =
        R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
        R"({"POSITION":0},"mode":)" +
        std::to_string(mode) +
        R"(}]}],"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"}],)"
        R"("bufferViews":[{"buffer":0,"byteLength":48}],"buffers":[{"byteLength":48,)"
        R"("uri":"data:;base64,)" +
        base64(buffer) + "\"}]}";
    const TemporaryFolder folder;
    const Result<ColouredMesh> mesh = read_coloured_mesh(folder.write("a.gltf", text));
    if (!mesh) FAIL(mesh.error());
    REQUIRE(mesh.value().triangles.size() == 2);
    for (const auto& [a, b, c] : mesh.value().triangles) {
      const auto& v = mesh.value().vertices;
      CHECK((v[b] - v[a]).cross(v[c] - v[a]).isApprox(Vector3d(0, 0, 1)));
    }
    CHECK(mesh.value().warnings.size() == 1);
  }
}

TEST_CASE("sparse accessors replace single elements") {
  const std::string buffer =
      bytes_of<std::uint8_t>({1, 2, 0, 0}) + bytes_of<float>({5, 0, 0, 0, 5, 0});
  const std::string text =
      R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":)"
      R"({"POSITION":0}}]}],"accessors":[{"componentType":5126,"count":3,"type":"VEC3","sparse":)"
      R"({"count":2,"indices":{"bufferView":0,"componentType":5121},"values":{"bufferView":0,)"
      R"("byteOffset":4}}}],"bufferViews":[{"buffer":0,"byteLength":28}],)"
      R"("buffers":[{"byteLength":28,"uri":"data:;base64,)" +
      base64(buffer) + "\"}]}";
  const TemporaryFolder folder;
  const Result<ColouredMesh> mesh = read_coloured_mesh(folder.write("a.gltf", text));
  if (!mesh) FAIL(mesh.error());
  CHECK(mesh.value().vertices ==
        std::vector<Vector3d>{Vector3d(0, 0, 0), Vector3d(5, 0, 0), Vector3d(0, 5, 0)});
}

TEST_CASE("what a glTF file only claims is not believed") {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = gltf_with(kPlaces, material(""));
    const std::size_t at = text.find(from);
    REQUIRE(at != std::string::npos);
    return refusal(text.replace(at, from.size(), to));
  };
  CHECK_THAT(changed("\"count\":3", "\"count\":4000000"), Contains("larger than its bufferView"));
  CHECK_THAT(changed("\"count\":3", "\"count\":400000000000"), Contains("at most"));
  CHECK_THAT(changed("\"byteLength\":144}", "\"byteLength\":145}"),
             Contains("bufferViews[0] is larger than its buffer"));
  CHECK_THAT(changed("\"bufferView\":0", "\"bufferView\":9"), Contains("bufferViews[9]"));
  CHECK_THAT(changed("\"mesh\":0", "\"mesh\":1"), Contains("meshes[1], which is not there"));
  CHECK_THAT(changed("\"mesh\":0", "\"children\":[0],\"mesh\":0"), Contains("is in two places"));
  CHECK_THAT(changed("\"POSITION\":0", "\"POSITION\":1"), Contains("has too few numbers"));
  CHECK_THAT(changed("\"version\":\"2.0\"", "\"version\":\"1.0\""), Contains("version '1.0'"));
  CHECK_THAT(changed("{\"asset\"", "glTF\x01{\"asset\""), Contains("no binary glTF of version 2"));
}

}  // namespace aspect
