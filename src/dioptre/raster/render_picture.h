// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/integrators/render_image.h"

namespace dioptre {

/// The name of the rasteriser among the integrators.
inline constexpr std::string_view kZBuffer = "zbuffer";

/// Renders a compiled scene face by face: each face is projected, each pixel of its projection
/// keeps what is nearest, and then every pixel is shaded once by the light that its surface sends
/// back by itself, exactly as the integrator "appel" does. The image does not depend on the number
/// of threads. An error for layers and for antialiasing, which are made of rays, and for a camera
/// that is neither perspective nor orthographic.
Result<RenderResult> render_zbuffer(const RenderScene& scene, const RenderOptions& options,
                                    const RenderContext& context);

/// Compiles a scene and renders it by the integrator that is named, or by "zbuffer". An unknown
/// name is an error that lists all names.
Result<RenderResult> render_picture(const Scene& scene, const CompileOptions& compile_options,
                                    const RenderOptions& options, const RenderContext& context);

}  // namespace dioptre
