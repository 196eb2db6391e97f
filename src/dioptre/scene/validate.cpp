// SPDX-License-Identifier: Apache-2.0
#include "dioptre/scene/validate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "dioptre/core/fields.h"
#include "dioptre/scene/id_graph.h"

namespace dioptre {
namespace {

/// How many values of each kind there are.
std::size_t count(const Scene& s, ObjectId) { return s.objects.size(); }
std::size_t count(const Scene& s, TextureId) { return s.textures.size(); }
std::size_t count(const Scene& s, PigmentId) { return s.pigments.size(); }
std::size_t count(const Scene& s, NormalId) { return s.normals.size(); }
std::size_t count(const Scene& s, InteriorId) { return s.interiors.size(); }
std::size_t count(const Scene& s, FunctionId) { return s.functions.size(); }
std::size_t count(const Scene& s, ImageId) { return s.images.size(); }

bool finite(const Affine& m) {
  return is_finite(m.x) && is_finite(m.y) && is_finite(m.z) && is_finite(m.o);
}

/// Walks everything a scene holds by its fields and keeps the first problem.
class Walk {
 public:
  explicit Walk(const Scene& scene) : scene_(scene) {}
  const std::string& problem() const { return problem_; }

  template <class T>
  void operator()(const char* name, const T& value) {
    if (!problem_.empty()) return;
    const std::size_t length = path_.size();
    path_ += "/";
    path_ += name;
    check(value);
    path_.resize(length);
  }

 private:
  template <class T>
  void check(Id<T> id) {
    if (id && id.index >= count(scene_, id)) problem_ = path_ + ": refers to what is not there";
  }
  template <class T>
  void check(const std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, Vec3>) return;
    std::uint32_t index = 0;
    for (const T& value : values) {
      if (!problem_.empty()) return;
      (*this)(std::to_string(index++).c_str(), value);
    }
  }
  template <class... T>
  void check(const std::variant<T...>& value) {
    std::visit([&](const auto& alternative) { check(alternative); }, value);
  }
  void check(const Affine& value) {
    if (!finite(value)) problem_ = path_ + ": the transform is not finite";
  }
  void check(const Expression& body) {
    if (!well_formed(body)) problem_ = path_ + ": a step refers to none before it";
    for (const Step& step : body.steps) (*this)("function", step.function);
  }
  void check(const MeshData&) {}  // large; checked when prepared
  void check(const ImageData& image) {
    const std::uint64_t pixels = std::uint64_t{image.width} * image.height;
    if (image.channels < 1 || image.channels > 5) {
      problem_ = path_ + ": an image has 1 to 5 channels";
    } else if (pixels > image.pixels.size() || pixels * image.channels != image.pixels.size()) {
      problem_ = path_ + ": the number of pixels does not fit the size";
    }
  }
  template <class T>
  void check(const Shared<T>& value) {
    check(*value);
  }
  template <class T>
  void check(const T& value) {
    if constexpr (HasFields<T>) T::fields(value, *this);
  }

  static bool well_formed(const Expression& body);

  const Scene& scene_;
  std::string path_;
  std::string problem_;
};

/// The number of a, b, c that are places of earlier steps.
int operand_count(Step::Code code) {
  using Code = Step::Code;
  if (code == Code::kConstant || code == Code::kParameter || code == Code::kCall) return 0;
  if (code == Code::kSelect) return 3;
  if (code == Code::kNegate || (code >= Code::kNot && code <= Code::kTanh)) return 1;
  return 2;
}

bool Walk::well_formed(const Expression& body) {
  for (std::uint32_t at = 0; at < body.steps.size(); ++at) {
    const Step& step = body.steps[at];
    const int operands = operand_count(step.code);
    if (operands > 0 && step.a >= at) return false;
    if (operands > 1 && step.b >= at) return false;
    if (operands > 2 && (step.c >= at || step.extra >= at)) return false;
    if (step.code == Step::Code::kParameter && step.a > 255) return false;
    if (step.code != Step::Code::kCall) continue;
    if (std::uint64_t{step.a} + step.b > body.arguments.size()) return false;
    for (std::uint32_t k = 0; k < step.b; ++k) {
      if (body.arguments[step.a + k] >= at) return false;
    }
  }
  return true;
}

/// Every part of `object` must come before it in the list.
std::string parts_problem(const Object& object, std::uint32_t index) {
  const auto late = [&](const std::vector<ObjectId>& parts) {
    for (const ObjectId part : parts) {
      if (part.index >= index) return true;
    }
    return false;
  };
  const Csg* csg = std::get_if<Csg>(&object.geometry);
  if ((csg != nullptr && late(csg->children)) || late(object.clipped_by)) {
    return "/objects/" + std::to_string(index) + ": parts must come before their wholes";
  }
  return {};
}

std::string order_problem(const Scene& scene) {
  for (std::uint32_t index = 0; index < scene.objects.size(); ++index) {
    std::string problem = parts_problem(scene.objects[index], index);
    if (!problem.empty()) return problem;
  }
  for (std::size_t k = 0; k < scene.roots.size(); ++k) {
    if (!scene.roots[k]) return "/roots/" + std::to_string(k) + ": names no object";
  }
  return {};
}

std::string depth_problem(const Scene& scene) {
  std::vector<std::uint32_t> levels;
  append_levels(scene, levels);
  const auto deep = std::find_if(levels.begin(), levels.end(),
                                 [](std::uint32_t count) { return count > kDeepestSolid; });
  if (deep == levels.end()) return {};
  return "/objects/" + std::to_string(deep - levels.begin()) + ": solids are nested more than " +
         std::to_string(kDeepestSolid) + " deep";
}

}  // namespace

void append_levels(const Scene& scene, std::vector<std::uint32_t>& levels) {
  for (std::size_t index = levels.size(); index < scene.objects.size(); ++index) {
    const Object& object = scene.objects[index];
    std::uint32_t below = 0;
    const auto look = [&](const std::vector<ObjectId>& parts) {
      for (const ObjectId part : parts) below = std::max(below, levels[part.index]);
    };
    if (const Csg* csg = std::get_if<Csg>(&object.geometry)) look(csg->children);
    look(object.clipped_by);
    levels.push_back(below + 1);
  }
}

Result<void> validate(const Scene& scene) {
  Walk walk(scene);
  Scene::fields(scene, walk);
  if (!walk.problem().empty()) return fail(walk.problem());
  if (const std::string problem = order_problem(scene); !problem.empty()) return fail(problem);
  if (const std::string problem = depth_problem(scene); !problem.empty()) return fail(problem);
  if (const std::string problem = find_cycle(scene); !problem.empty()) return fail(problem);
  return {};
}

}  // namespace dioptre
