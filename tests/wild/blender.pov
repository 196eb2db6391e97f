#version 3.7;
global_settings {
    assumed_gamma 1.0
    ambient_light rgbt<0.2, 0.2, 0.2, 1>
    max_trace_level 7
    charset utf8
    noise_generator 2
}
background {
    rgbt<0.05, 0.05, 0.06, 0.75>
}
#declare shader_1_PIG = pigment {
}
#declare shader_Material =
    texture {
        pigment {rgbft<0.8, 0.2, 0.1, 0.0, 0>}
        finish {
            phong 0.5
            phong_size 40
            ambient rgb<0.1, 0.1, 0.1>
            diffuse 0.8 0.2
            specular 0.25
            roughness 0.05
            conserve_energy
        }
    }
#declare DATACube =
mesh2 {
    vertex_vectors {
        8
        , <1.000000, 1.000000, -1.000000>, <1.000000, -1.000000, -1.000000>, <-1.000000, -1.000000, -1.000000>, <-1.000000, 1.000000, -1.000000>
        , <1.000000, 0.999999, 1.000000>, <0.999999, -1.000001, 1.000000>, <-1.000000, -1.000000, 1.000000>, <-1.000000, 1.000000, 1.000000>
    }
    texture_list {
        1
        texture {shader_Material}
    }
    face_indices {
        12
        , <0, 1, 2>, 0, <0, 2, 3>, 0, <4, 7, 6>, 0, <4, 6, 5>, 0
        , <0, 4, 5>, 0, <0, 5, 1>, 0, <1, 5, 6>, 0, <1, 6, 2>, 0
        , <2, 6, 7>, 0, <2, 7, 3>, 0, <4, 0, 3>, 0, <4, 3, 7>, 0
    }
}
object {
    DATACube
    interior { ior 1.5 }
    matrix <0.866025, 0.5, 0.000000, -0.5, 0.866025, 0.000000, 0.000000, 0.000000, 1.000000, 0.000000, 0.000000, 0.000000>
}
sphere {
    0, 1
    texture { pigment { shader_1_PIG } finish { diffuse 0.8 } }
    matrix <1, 0, 0, 0, 1, 0, 0, 0, 1.4, -2.600000, 0.000000, 0.300000>
}
camera {
    location <0, 0, 0>
    look_at <0, 0, -1>
    right <-1.333333333333333, 0, 0>
    up <0, 1, 0>
    angle 49.134343
    rotate <0, 0, 0>
    matrix <0.685881, 0.727634, -0.010817, -0.317370, 0.312469, 0.895343, 0.654862, -0.610666, 0.445245, 7.481132, -6.507640, 5.343665>
}
light_source {
    < 0,0,0 >
    color rgb<1.2, 1.2, 1.2>
    fade_distance 29.999983
    fade_power 2
    matrix <-0.290865, -0.771101, 0.566393, -0.055189, 0.604525, 0.794672, 0.955171, -0.199883, 0.218391, 4.076245, -1.005454, 5.903862>
}
