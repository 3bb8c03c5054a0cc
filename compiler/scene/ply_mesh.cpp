#include "compiler/scene/ply_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "compiler/scene/ply_header.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

// The numbers behind the header, one after the other, whatever the format.
class Numbers {
 public:
  Numbers(std::string_view file, MeshText& text, PlyHeader::Format format)
      : file_(file), text_(text), format_(format), position_(text.position()) {}

  double next(PlyType type) {
    return format_ == PlyHeader::Format::text ? next_word() : next_bytes(type);
  }

 private:
  double next_word() {
    if (word_ == words_.size()) words_ = text_.take_words("a number"), word_ = 0;
    return text_.number(words_[word_++]);
  }

  double next_bytes(PlyType type) {
    const std::size_t count = bytes_of(type);
    if (position_ > file_.size() || file_.size() - position_ < count)
      throw MeshError("ends before its data do; export it again");
    std::array<char, 8> bytes{};
    std::copy_n(file_.data() + position_, count, bytes.data());
    position_ += count;
    const bool big = format_ == PlyHeader::Format::big_endian;
    if (big != (std::endian::native == std::endian::big))
      std::reverse(bytes.data(), bytes.data() + count);
    switch (type) {
      case PlyType::int8:
        return as<std::int8_t>(bytes);
      case PlyType::uint8:
        return as<std::uint8_t>(bytes);
      case PlyType::int16:
        return as<std::int16_t>(bytes);
      case PlyType::uint16:
        return as<std::uint16_t>(bytes);
      case PlyType::int32:
        return as<std::int32_t>(bytes);
      case PlyType::uint32:
        return as<std::uint32_t>(bytes);
      case PlyType::float32:
        return static_cast<double>(as_value<float>(bytes));
      default:
        return as_value<double>(bytes);
    }
  }
  template <typename Value>
  static Value as_value(const std::array<char, 8>& bytes) {
    Value value{};
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }
  template <typename Value>
  static double as(const std::array<char, 8>& bytes) {
    return static_cast<double>(as_value<Value>(bytes));
  }

  std::string_view file_;
  MeshText& text_;
  PlyHeader::Format format_;
  std::size_t position_;
  std::vector<std::string_view> words_;
  std::size_t word_ = 0;
};

// Where an element keeps its colour.
struct Channels {
  explicit Channels(const PlyElement& element)
      : at{element.find({"red", "diffuse_red", "r"}), element.find({"green", "diffuse_green", "g"}),
           element.find({"blue", "diffuse_blue", "b"})} {
    for (const std::size_t k : at) there = there && k < element.properties.size();
    if (there) scale = full_scale(element.properties[at[0]].type);
  }
  Vector3d of(const std::vector<double>& row) const {
    return Vector3d(row[at[0]], row[at[1]], row[at[2]]) / scale;
  }

  std::array<std::size_t, 3> at;
  bool there = true;
  double scale = 1;
};

class PlyReader {
 public:
  PlyReader(std::string_view file, MeshText& text)
      : header_(read_ply_header(text)), numbers_(file, text, header_.format) {
    mesh_.parts.push_back({});
  }

  ColouredMesh read() {
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        skip(element);
    }
    if (!coloured_) mesh_.warnings.push_back("holds no colours; all of it is grey");
    return std::move(mesh_);
  }

 private:
  // One element's numbers by property; of lists the last number of the one at `list`.
  void read_row(const PlyElement& element, std::size_t list) {
    row_.assign(element.properties.size(), 0);
    for (std::size_t k = 0; k < row_.size(); ++k) {
      const PlyProperty& property = element.properties[k];
      if (!property.list) {
        row_[k] = numbers_.next(property.type);
        continue;
      }
      const double count = numbers_.next(property.count_type);
      if (!(count >= 0 && count <= static_cast<double>(ColouredMesh::kMaxFaceCorners)))
        throw MeshError(fmt::format("a list of {:g} numbers, at most {} are read", count,
                                    ColouredMesh::kMaxFaceCorners));
      if (k == list) list_.clear();
      for (int left = static_cast<int>(count); left > 0; --left) {
        const double value = numbers_.next(property.type);
        if (k == list) list_.push_back(value);
      }
    }
  }

  void read_vertices(const PlyElement& element) {
    const std::array<std::size_t, 3> at = {element.find({"x"}), element.find({"y"}),
                                           element.find({"z"})};
    for (const std::size_t k : at)
      if (k == element.properties.size()) throw MeshError("vertices without x, y and z");
    const Channels channels(element);
    coloured_ = coloured_ || channels.there;
    for (std::size_t left = element.count; left > 0; --left) {
      read_row(element, element.properties.size());
      add_vertex(mesh_, {row_[at[0]], row_[at[1]], row_[at[2]]});
      vertex_colours_.push_back(channels.there ? channels.of(row_) : kUncoloured);
    }
  }

  void read_faces(const PlyElement& element) {
    const std::size_t list = element.find({"vertex_indices", "vertex_index"});
    if (list == element.properties.size() || !element.properties[list].list)
      throw MeshError("faces without a list vertex_indices; export it again");
    const Channels channels(element);
    coloured_ = coloured_ || channels.there;
    std::vector<std::uint32_t> corners;
    for (std::size_t left = element.count; left > 0; --left) {
      read_row(element, list);
      corners.clear();
      Vector3d mean = Vector3d::Zero();
      for (const double index : list_) {
        if (!(index >= 0 && index < static_cast<double>(mesh_.vertices.size())))
          throw MeshError(fmt::format("a face has vertex {:g}, but there are {}; export it again",
                                      index, mesh_.vertices.size()));
        corners.push_back(static_cast<std::uint32_t>(index));
        mean += vertex_colours_[corners.back()] / static_cast<double>(list_.size());
      }
      add_face(mesh_, corners, channels.there ? channels.of(row_) : mean, 0);
    }
  }

  void skip(const PlyElement& element) {
    for (std::size_t left = element.count; left > 0; --left)
      read_row(element, element.properties.size());
  }

  PlyHeader header_;
  Numbers numbers_;
  ColouredMesh mesh_;
  std::vector<Vector3d> vertex_colours_;
  std::vector<double> row_, list_;
  bool coloured_ = false;
};

}  // namespace

ColouredMesh parse_ply(std::string_view file) {
  MeshText text(file);
  return PlyReader(file, text).read();
}

bool is_textured_ply(std::string_view file) {
  MeshText text(file);
  return read_ply_header(text).textured;
}

}  // namespace aspect
