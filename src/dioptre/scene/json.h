// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "dioptre/core/result.h"
#include "dioptre/scene/scene.h"

namespace dioptre {

/// The scene as JSON text: every field under its name, ids as numbers (none: null), enumerators by
/// name, alternatives as objects with a "type". Numbers keep every bit; those that JSON cannot say
/// are the strings "inf", "-inf" and "nan". `read_json(write_json(s)) == s` for scenes without NaN.
std::string write_json(const Scene& scene);

/// Reads what write_json writes; a field left out has its default. The error names the place, by
/// byte offset in text that is not JSON and by JSON pointer ("/objects/3/transform") in JSON that
/// is no scene. The result has passed `validate`.
Result<Scene> read_json(std::string_view text);

}  // namespace dioptre
