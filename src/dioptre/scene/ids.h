// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/id.h"

namespace dioptre {

struct Object;
struct Texture;
struct Pigment;
struct Normal;
struct Interior;
struct Function;
struct ImageSource;

using ObjectId = Id<Object>;
using TextureId = Id<Texture>;
using PigmentId = Id<Pigment>;
using NormalId = Id<Normal>;
using InteriorId = Id<Interior>;
using FunctionId = Id<Function>;
using ImageId = Id<ImageSource>;

}  // namespace dioptre
