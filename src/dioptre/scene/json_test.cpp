// SPDX-License-Identifier: Apache-2.0
#include "dioptre/scene/json.h"

#include <gtest/gtest.h>

#include <limits>

#include "dioptre/core/fields.h"
#include "dioptre/scene/enum_names.h"
#include "dioptre/scene/validate.h"

namespace dioptre {
namespace {

/// Gives every field of any description a value that follows from a counter; alternatives and
/// enumerators take turns.
class Fill {
 public:
  explicit Fill(std::uint32_t seed) : next_(seed) {}

  template <class T>
  void operator()(const char*, T& value) {
    fill(value);
  }
  void fill(bool& v) { v = ++next_ % 2 == 0; }
  void fill(double& v) {
    ++next_;
    v = 1.0 / next_ * (next_ % 5 == 0 ? -1e300 : 1.1);
  }
  void fill(float& v) { v = 1.0f / static_cast<float>(++next_); }
  void fill(std::uint8_t& v) { v = static_cast<std::uint8_t>(++next_); }
  void fill(std::uint32_t& v) { v = ++next_; }
  void fill(std::int32_t& v) { v = -static_cast<std::int32_t>(++next_); }
  void fill(std::string& v) { v = "a\"\\\n\xc3\xa4" + std::to_string(++next_); }
  void fill(Vec2& v) { fill(v.x), fill(v.y); }
  void fill(Vec3& v) { fill(v.x), fill(v.y), fill(v.z); }
  void fill(Color& v) { fill(v.r), fill(v.g), fill(v.b); }
  void fill(PigmentColor& v) { fill(v.color), fill(v.filter), fill(v.transmit); }
  template <class T>
  void fill(Id<T>& v) {
    v = {};
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void fill(Enum& v) {
    do {
      v = static_cast<Enum>(++next_ % enum_names::kLimit);
    } while (!enum_name(v));
  }
  template <class T>
  void fill(Shared<T>& v) {
    T value;
    fill(value);
    v = Shared<T>(std::move(value));
  }
  template <class T>
  void fill(std::vector<T>& v) {
    v.resize(2);
    for (T& element : v) fill(element);
  }
  template <class T, std::size_t N>
  void fill(std::array<T, N>& v) {
    for (T& element : v) fill(element);
  }
  template <class... T>
  void fill(std::variant<T...>& v) {
    fill_alternative(v, next_++ % sizeof...(T), std::index_sequence_for<T...>());
  }
  void fill(Expression& v) { v = {{{Step::Code::kConstant, 0, 0, 0, 0, 0.1, {}}}, {}}; }
  void fill(ImageData& v) { v = {2, 1, 2, {0.1f, 0.2f, 0.3f, 1}}; }
  void fill(Csg& v) { v.operation = CsgOperation::kDifference; }
  template <HasFields T>
  void fill(T& v) {
    T::fields(v, *this);
  }

 private:
  template <class Variant, std::size_t... I>
  void fill_alternative(Variant& v, std::size_t index, std::index_sequence<I...>) {
    ((index == I ? fill(v.template emplace<I>()) : void()), ...);
  }
  std::uint32_t next_;
};

/// A scene in which every alternative of every variant occurs.
Scene full_scene() {
  Scene scene;
  const auto fill_all = [](auto& values) {
    values.resize(80);
    for (std::uint32_t k = 0; k < values.size(); ++k) Fill(k).fill(values[k]);
  };
  fill_all(scene.objects);
  fill_all(scene.textures);
  fill_all(scene.pigments);
  fill_all(scene.normals);
  fill_all(scene.functions);
  fill_all(scene.images);
  fill_all(scene.lights);
  fill_all(scene.interiors);
  for (std::uint32_t k = 0; k < 80; ++k) {
    ColorMapPigment map;
    Fill(k).fill(map.pattern);
    scene.pigments.push_back({map, {}, false});
    Fill fill(k);
    ShapeData shape;
    fill.fill(shape);
    scene.objects[k].geometry = shape;
    scene.objects[k].clipped_by.clear();
  }
  scene.objects.push_back({});
  scene.objects.back().geometry = Csg{CsgOperation::kIntersection, {{0}, {1}}, false};
  scene.roots = {{80}};
  Fill(1).fill(scene.camera);
  Fill(2).fill(scene.atmosphere);
  Fill(3).fill(scene.settings);
  scene.settings.assumed_gamma = std::numeric_limits<double>::infinity();
  return scene;
}

TEST(SceneJson, WhatIsWrittenIsReadBackExactly) {
  const Scene scene = full_scene();
  const auto read = read_json(write_json(scene));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(*read == scene);
  EXPECT_EQ(write_json(*read), write_json(scene));
}

TEST(SceneJson, BytesThatAreNotUtf8Survive) {
  Scene scene;
  scene.objects.emplace_back();
  scene.objects[0].name = "\xff\xfe";
  const auto read = read_json(write_json(scene));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(*read == scene);
}

TEST(SceneJson, FieldsLeftOutHaveTheirDefaults) {
  const auto read = read_json("{}");
  ASSERT_TRUE(read);
  EXPECT_TRUE(*read == Scene{});
}

TEST(SceneJson, ErrorsNameThePlace) {
  const std::pair<std::string, std::string> cases[] = {
      {"{", "byte 2: this is not JSON"},
      {"[]", "/: expected an object"},
      {R"({"camera":{"kind":"round"}})", "/camera/kind: unknown name"},
      {R"({"camera":{"location":[1,2]}})", "/camera/location: expected 3 numbers"},
      {R"({"camera":{"location":[1,2,"x"]}})", "/camera/location/2: expected a number"},
      {R"({"camera":{"lens":1}})", "/camera/lens: unknown field"},
      {R"({"objects":[{"geometry":{"type":"blub"}}]})", "/objects/0/geometry/type: unknown type"},
      {R"({"roots":[-1]})", "/roots/0: the number is out of range"},
      {R"({"roots":[0]})", "/roots/0: refers to what is not there"},
      {R"({"camera":{"location":[1e999,0,0]}})", "a number is out of range"},
  };
  for (const auto& [text, message] : cases) {
    const auto read = read_json(text);
    ASSERT_FALSE(read) << text;
    EXPECT_EQ(read.error().message, message);
  }
}

TEST(SceneJson, DeepNestingIsRefused) {
  EXPECT_FALSE(read_json(std::string(1000000, '[')));
  EXPECT_FALSE(read_json(std::string(1000000, '{')));
}

TEST(SceneJson, CutTextNeverCrashes) {
  Scene scene;
  scene.objects.resize(2);
  const std::string text = write_json(scene);
  for (std::size_t size = 0; size < text.size() - 2; size += 7) {
    EXPECT_FALSE(read_json(std::string_view(text).substr(0, size))) << size;
  }
}

TEST(Validate, NothingContainsItself) {
  Scene scene;
  scene.pigments.push_back({AveragePigment{{{0, PigmentId{0}}}, {}}, {}, false});
  EXPECT_EQ(validate(scene).error().message, "/pigments/0: needs itself");
  Scene solids;
  solids.objects.resize(1);
  solids.objects[0].geometry = Csg{CsgOperation::kUnion, {{0}}, true};
  EXPECT_FALSE(validate(solids));
}

TEST(Validate, SolidsAreNestedOnlySoDeep) {
  Scene scene;
  scene.objects.resize(kDeepestSolid + 1);
  for (std::uint32_t i = 1; i < scene.objects.size(); ++i) {
    scene.objects[i].geometry = Csg{CsgOperation::kUnion, {{i - 1}}, true};
  }
  EXPECT_EQ(validate(scene).error().message,
            "/objects/4000: solids are nested more than 4000 deep");
  scene.objects.pop_back();
  EXPECT_TRUE(validate(scene));
}

TEST(Validate, ExpressionsReferToEarlierSteps) {
  Scene scene;
  Step step;
  step.code = Step::Code::kAdd;
  scene.functions.push_back({"f", {}, ExpressionFunction{{{step}, {}}}});
  EXPECT_FALSE(validate(scene));
}

TEST(EnumNames, AreTheEnumeratorsInSnakeCase) {
  EXPECT_EQ(enum_name(Camera::Kind::kUltraWideAngle), "ultra_wide_angle");
  EXPECT_EQ(enum_name(Step::Code::kProduct), "product");
  EXPECT_EQ(enum_name(static_cast<Camera::Kind>(50)), std::nullopt);
  EXPECT_EQ(enum_value<ImageSource::Interpolation>("normalized_distance"),
            ImageSource::Interpolation::kNormalizedDistance);
}

}  // namespace
}  // namespace dioptre
