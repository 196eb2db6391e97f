// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "dioptre/core/color.h"

namespace dioptre {

/// The local light model of a surface.
struct Finish {
  Color ambient{0.1f, 0.1f, 0.1f};
  Color emission;
  double diffuse = 0.6;
  double diffuse_back = 0;      ///< for light from behind
  bool diffuse_albedo = false;  ///< the amount is the share of light sent back
  double brilliance = 1;
  double crand = 0;
  double phong = 0;
  double phong_size = 40;
  bool phong_albedo = false;
  double specular = 0;
  double roughness = 0.05;
  bool specular_albedo = false;
  double metallic = 0;
  Color reflection_min;
  Color reflection_max;
  double reflection_falloff = 1;
  double reflection_exponent = 1;
  double reflection_metallic = 0;
  bool reflection_fresnel = false;
  bool conserve_energy = false;
  double irid = 0;            ///< amount of the colours of a thin film
  double irid_thickness = 0;  ///< of the film; as irid_wavelength has it
  double irid_turbulence = 0;
  double ior = 0;  ///< of what wears it, as old files give it; 0: not given
  bool operator==(const Finish&) const = default;

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit("ambient", self.ambient);
    visit("emission", self.emission);
    visit("diffuse", self.diffuse);
    visit("diffuse_back", self.diffuse_back);
    visit("diffuse_albedo", self.diffuse_albedo);
    visit("brilliance", self.brilliance);
    visit("crand", self.crand);
    visit("phong", self.phong);
    visit("phong_size", self.phong_size);
    visit("phong_albedo", self.phong_albedo);
    visit("specular", self.specular);
    visit("roughness", self.roughness);
    visit("specular_albedo", self.specular_albedo);
    visit("metallic", self.metallic);
    visit("reflection_min", self.reflection_min);
    visit("reflection_max", self.reflection_max);
    visit("reflection_falloff", self.reflection_falloff);
    visit("reflection_exponent", self.reflection_exponent);
    visit("reflection_metallic", self.reflection_metallic);
    visit("reflection_fresnel", self.reflection_fresnel);
    visit("conserve_energy", self.conserve_energy);
    visit("irid", self.irid);
    visit("irid_thickness", self.irid_thickness);
    visit("irid_turbulence", self.irid_turbulence);
    visit("ior", self.ior);
  }
};

}  // namespace dioptre
