// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace dioptre::internal_functions {

/// A built-in function of x, y, z (a[0] to a[2]) and its own parameters (from a[3]).
using Function = double (*)(const double* a);

// Algebraic surfaces: the field strength a[3] times a polynomial, held within -10 and 10.
double bicorn(const double* a);
double bifolia(const double* a);
double boy_surface(const double* a);
double crossed_trough(const double* a);
double cubic_saddle(const double* a);
double cushion(const double* a);
double devils_curve(const double* a);
double dupin_cyclid(const double* a);
double enneper(const double* a);
double folium_surface(const double* a);
double glob(const double* a);
double heart(const double* a);
double hunt_surface(const double* a);
double hyperbolic_torus(const double* a);
double kampyle_of_eudoxus(const double* a);
double klein_bottle(const double* a);
double kummer_surface_v1(const double* a);
double kummer_surface_v2(const double* a);
double lemniscate_of_gerono(const double* a);
double mitre(const double* a);
double nodal_cubic(const double* a);
double odd(const double* a);
double ovals_of_cassini(const double* a);
double paraboloid(const double* a);
double parabolic_torus(const double* a);
double pillow(const double* a);
double piriform(const double* a);
double quartic_paraboloid(const double* a);
double quartic_saddle(const double* a);
double quartic_cylinder(const double* a);
double steiners_roman(const double* a);
double strophoid(const double* a);
double torus2(const double* a);
double torus_gumdrop(const double* a);
double umbrella(const double* a);
double witch_of_agnesi(const double* a);

// Plane curves, extruded along z or revolved about y.
double algebraic_cylinder_1(const double* a);
double algebraic_cylinder_2(const double* a);
double algebraic_cylinder_3(const double* a);
double algebraic_cylinder_4(const double* a);
double devils_curve_2d(const double* a);
double folium_surface_2d(const double* a);
double kampyle_of_eudoxus_2d(const double* a);
double lemniscate_of_gerono_2d(const double* a);
double piriform_2d(const double* a);
double strophoid_2d(const double* a);
double witch_of_agnesi_2d(const double* a);

// Distances, coordinates and blobs.
double blob(const double* a);
double blob2(const double* a);
double comma(const double* a);
double cross_ellipsoids(const double* a);
double ellipsoid(const double* a);
double flange_cover(const double* a);
double isect_ellipsoids(const double* a);
double polar_angle(const double* a);
double poly4(const double* a);
double quantum(const double* a);
double radius(const double* a);
double rounded_box(const double* a);
double sphere(const double* a);
double spikes(const double* a);
double spikes_2d(const double* a);
double superellipsoid(const double* a);
double azimuth(const double* a);
double torus(const double* a);

// Tubes wound about an axis or a circle, and lattices of them.
double helical_torus(const double* a);
double helix_1(const double* a);
double helix_2(const double* a);
double hexagonal_columns(const double* a);
double hexagonal_lines(const double* a);
double polytubes(const double* a);
double spiral(const double* a);
double woven_mesh(const double* a);

// Noise and sums of noise.
double hetero_mf(const double* a);
double noise_3d(const double* a);
double noise_of_generator(const double* a);
double ridge(const double* a);
double ridged_mf(const double* a);

}  // namespace dioptre::internal_functions
