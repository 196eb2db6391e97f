// SPDX-License-Identifier: Apache-2.0
// mesh and mesh2.
#include <cmath>

#include "dioptre/io/pov/syntax/grammar.h"

namespace dioptre::pov {
namespace {

constexpr std::int64_t kMostElements = std::int64_t{1} << 28;

using Face = MeshData::Face;

bool is_degenerate(const MeshData& data, const Face& face) {
  const Vec3 a = data.corners[face.corners[0]];
  return cross(data.corners[face.corners[1]] - a, data.corners[face.corners[2]] - a) == Vec3{};
}

/// The parts of one object's textures, by the numbers that faces use.
std::uint32_t part_texture(Object& object, TextureId texture) {
  auto& parts = object.part_textures;
  for (std::size_t i = parts.size(); i-- > 0 && parts.size() - i <= 16;) {
    if (parts[i] == texture) return static_cast<std::uint32_t>(i);
  }
  parts.push_back(texture);
  return static_cast<std::uint32_t>(parts.size() - 1);
}

/// Reads `mesh`: triangles one by one, each with its own corners.
class MeshParser {
 public:
  MeshParser(Parser& parser, Object& object) : parser_(parser), object_(object) {}

  Mesh parse() {
    Mesh mesh;
    for (;;) {
      if (parser_.accept(Keyword::kTriangle)) {
        parse_triangle(false);
      } else if (parser_.accept(Keyword::kSmoothTriangle)) {
        parse_triangle(true);
      } else if (parser_.accept(Keyword::kInsideVector)) {
        mesh.inside_vector = parser_.parse_vec3();
      } else if (!parser_.accept(',')) {
        break;
      }
    }
    finish_normals();
    mesh.data = Shared<MeshData>(std::move(data_));
    return mesh;
  }

 private:
  void parse_triangle(bool smooth) {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after triangle");
    Face face;
    Vec3 normals[3];
    for (std::size_t i = 0; i < 3; ++i) {
      face.corners[i] = static_cast<std::uint32_t>(data_.corners.size());
      data_.corners.push_back(parser_.parse_vec3());
      parser_.skip_comma();
      if (!smooth) continue;
      normals[i] = parser_.parse_vec3();
      parser_.skip_comma();
    }
    parse_extras(face);
    parser_.expect('}', "after the triangle");
    if (is_degenerate(data_, face)) {
      data_.corners.resize(data_.corners.size() - 3);
      return;
    }
    if (smooth) {
      for (std::size_t i = 0; i < 3; ++i) {
        face.normals[i] = static_cast<std::uint32_t>(data_.normals.size());
        data_.normals.push_back(normals[i]);
      }
    }
    smooth_.push_back(smooth);
    data_.faces.push_back(face);
  }

  void parse_extras(Face& face) {
    for (;;) {
      if (parser_.accept(Keyword::kTexture)) {
        face.textures.fill(part_texture(object_, parse_texture(parser_)));
      } else if (parser_.accept(Keyword::kTextureList)) {
        parse_texture_list(face);
      } else if (parser_.accept(Keyword::kUvVectors)) {
        parse_uvs(face);
      } else if (!parser_.accept(',')) {
        return;
      }
    }
  }

  void parse_texture_list(Face& face) {
    parser_.expect('{', "after texture_list");
    for (std::size_t i = 0; i < 3; ++i) {
      parser_.accept(Keyword::kTexture);
      const auto texture = parser_.at('{') ? parse_texture(parser_) : take_texture();
      face.textures[i] = part_texture(object_, texture);
      parser_.skip_comma();
    }
    parser_.expect('}', "after three textures");
  }

  TextureId take_texture() {
    const auto texture = take<TextureId>(parser_);
    if (!texture) parser_.fail_expected("a texture");
    return *texture;
  }

  void parse_uvs(Face& face) {
    if (data_.uvs.empty()) data_.uvs.push_back({});
    for (std::uint32_t& index : face.uvs) {
      index = static_cast<std::uint32_t>(data_.uvs.size());
      data_.uvs.push_back(parser_.parse_vec2());
      parser_.skip_comma();
    }
  }

  /// If some triangles are smooth, the others get the normals of their planes.
  void finish_normals() {
    if (data_.normals.empty()) return;
    for (std::size_t i = 0; i < data_.faces.size(); ++i) {
      if (smooth_[i]) continue;
      Face& face = data_.faces[i];
      const Vec3 a = data_.corners[face.corners[0]];
      face.normals.fill(static_cast<std::uint32_t>(data_.normals.size()));
      data_.normals.push_back(
          cross(data_.corners[face.corners[2]] - a, data_.corners[face.corners[1]] - a));
    }
  }

  Parser& parser_;
  Object& object_;
  MeshData data_;
  std::vector<bool> smooth_;
};

/// Reads `mesh2`: lists of corners, and of faces that index them.
class Mesh2Parser {
 public:
  Mesh2Parser(Parser& parser, Object& object) : parser_(parser), object_(object) {}

  Mesh parse() {
    Mesh mesh;
    const SourcePosition where = parser_.position();
    for (;;) {
      if (parser_.accept(Keyword::kVertexVectors)) {
        list("vertex_vectors", [&] { data_.corners.push_back(parser_.parse_vec3()); });
      } else if (parser_.accept(Keyword::kNormalVectors)) {
        list("normal_vectors", [&] { data_.normals.push_back(parser_.parse_vec3()); });
      } else if (parser_.accept(Keyword::kUvVectors)) {
        list("uv_vectors", [&] { data_.uvs.push_back(parser_.parse_vec2()); });
      } else if (parser_.accept(Keyword::kTextureList)) {
        list("texture_list", [&] { parse_list_texture(); });
      } else if (parser_.accept(Keyword::kFaceIndices)) {
        list("face_indices", [&] { parse_face(); });
        has_faces_ = true;
      } else if (parser_.accept(Keyword::kNormalIndices)) {
        parse_face_lists(&Face::normals, data_.normals.size(), "normal_indices", has_normals_);
      } else if (parser_.accept(Keyword::kUvIndices)) {
        parse_face_lists(&Face::uvs, data_.uvs.size(), "uv_indices", has_uvs_);
      } else if (parser_.accept(Keyword::kInsideVector)) {
        mesh.inside_vector = parser_.parse_vec3();
      } else if (!parser_.accept(',')) {
        break;
      }
    }
    if (data_.corners.empty()) parser_.fail_at(where, "the mesh2 has no vertex_vectors");
    if (!has_faces_) parser_.fail_at(where, "the mesh2 has no face_indices");
    finish();
    mesh.data = Shared<MeshData>(std::move(data_));
    return mesh;
  }

 private:
  /// `{ COUNT, element, ... }`
  template <class Element>
  void list(const std::string& name, Element element) {
    const Parser::Nesting nesting(parser_);
    parser_.expect('{', "after " + name);
    const std::int64_t count = parse_whole(parser_, 0, kMostElements);
    for (std::int64_t i = 0; i < count; ++i) {
      parser_.skip_comma();
      element();
    }
    parser_.skip_comma();
    parser_.expect('}', "after the " + std::to_string(count) + " elements of " + name);
  }

  void parse_list_texture() {
    parser_.accept(Keyword::kTexture);
    if (parser_.at('{')) {
      object_.part_textures.push_back(parse_texture(parser_));
    } else if (const auto texture = take<TextureId>(parser_)) {
      object_.part_textures.push_back(*texture);
    } else {
      parser_.fail_expected("a texture");
    }
  }

  std::uint32_t index_below(double value, std::size_t size, std::string_view what) {
    if (!(value >= 0 && value < static_cast<double>(size))) {
      parser_.fail("an index into the " + std::string(what) + " is out of range: there are " +
                   std::to_string(size));
    }
    return static_cast<std::uint32_t>(value);
  }

  std::array<std::uint32_t, 3> parse_indices(std::size_t size, std::string_view what) {
    const Vec3 v = parser_.parse_vec3();
    return {index_below(v.x, size, what), index_below(v.y, size, what),
            index_below(v.z, size, what)};
  }

  std::array<std::uint32_t, 3> corners_of(Vec3 v) {
    const std::size_t size = data_.corners.size();
    return {index_below(v.x, size, "vertex_vectors"), index_below(v.y, size, "vertex_vectors"),
            index_below(v.z, size, "vertex_vectors")};
  }

  /// A face and the numbers of its textures. What is no number is the next face.
  void parse_face() {
    Face face;
    face.corners = corners_of(next_face_ ? *next_face_ : parser_.parse_vec3());
    next_face_.reset();
    std::uint32_t given = 0;
    std::uint32_t textures[3] = {};
    while (given < 3 && !object_.part_textures.empty()) {
      parser_.skip_comma();
      if (parser_.at('<') || !parser_.at_expression()) break;
      const Numeric n = parser_.parse_numeric();
      if (n.size > 1) {
        next_face_ = {n.v[0], n.v[1], n.v[2]};
        break;
      }
      textures[given++] = index_below(n.v[0], object_.part_textures.size(), "texture_list");
    }
    for (std::uint32_t i = 0; i < 3 && given > 0; ++i) {
      face.textures[i] = textures[given == 3 ? i : 0];
    }
    data_.faces.push_back(face);
  }

  void parse_face_lists(std::array<std::uint32_t, 3> Face::*member, std::size_t size,
                        const std::string& name, bool& given) {
    std::size_t face = 0;
    list(name, [&] {
      const auto indices = parse_indices(size, name);
      if (face < data_.faces.size()) data_.faces[face].*member = indices;
      ++face;
    });
    given = true;
  }

  /// Faces without indices of their own use those of the corners; flat ones are left out.
  void finish() {
    if (data_.normals.size() != data_.corners.size() && !has_normals_) data_.normals.clear();
    if (data_.uvs.size() != data_.corners.size() && !has_uvs_) data_.uvs.clear();
    for (Face& face : data_.faces) {
      if (!has_normals_ && !data_.normals.empty()) face.normals = face.corners;
      if (!has_uvs_ && !data_.uvs.empty()) face.uvs = face.corners;
    }
    std::erase_if(data_.faces, [&](const Face& face) { return is_degenerate(data_, face); });
  }

  Parser& parser_;
  Object& object_;
  MeshData data_;
  std::optional<Vec3> next_face_;  ///< read already while looking for textures
  bool has_faces_ = false, has_normals_ = false, has_uvs_ = false;
};

void set_mesh(Item& item, Mesh mesh) {
  if (mesh.data->faces.empty()) item.drawn = false;
  item.object.geometry = ShapeData{std::move(mesh)};
}

}  // namespace

void parse_mesh(Parser& parser, Item& item) {
  set_mesh(item, MeshParser(parser, item.object).parse());
}

void parse_mesh2(Parser& parser, Item& item) {
  set_mesh(item, Mesh2Parser(parser, item.object).parse());
}

}  // namespace dioptre::pov
