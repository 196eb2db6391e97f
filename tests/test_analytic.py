# SPDX-License-Identifier: Apache-2.0
"""Scenes whose pictures are known without rendering, written in the scene language."""

import math
import unittest

from program import ProgramTest, images

HEADER = "#version 3.7; global_settings { assumed_gamma 1 }\n"
# Four units wide and high, seen along +z; what is there is white.
WINDOW = (HEADER.replace("{", "{{").replace("}", "}}") +
          "camera {{ orthographic location <0,0,-{away}> right 4*x up 4*y direction z }}\n"
          "#default {{ pigment {{ rgb 1 }} finish {{ ambient 1 diffuse 0 }} }}\n")
# By name: a solid of about the size of the unit sphere.
SOLIDS = {
    "box": "box { -1, 1 }",
    "sphere": "sphere { 0, 1 }",
    "cylinder": "cylinder { -y, y, 0.8 }",
    "cone": "cone { -y, 1, y, 0.3 }",
    "torus": "torus { 0.8, 0.3 rotate 70*x }",
    "mesh": ("mesh { triangle { <0,1,0>, <1,-1,-1>, <-1,-1,-1> } triangle { <0,1,0>, <-1,-1,-1>, <0,-1,1> }"
             " triangle { <0,1,0>, <0,-1,1>, <1,-1,-1> } triangle { <1,-1,-1>, <0,-1,1>, <-1,-1,-1> }"
             " inside_vector y }"),
    "superellipsoid": "superellipsoid { <0.4, 0.7> }",
    "blob": "blob { threshold 0.4 sphere { 0, 1.5, 1 } sphere { 0.5*x, 1, 1 } }",
    "prism": "prism { -1, 1, 5, <-1,-1>, <1,-1>, <1,1>, <-0.3,0.4>, <-1,-1> }",
    "lathe": "lathe { cubic_spline 6, <0,-2>, <0.2,-1>, <0.9,0>, <0.3,0.8>, <0,1>, <0,2> }",
    "sor": "sor { 6, <0.5,-1.2>, <0.6,-1>, <0.9,0>, <0.3,0.8>, <0.2,1>, <0.1,1.2> }",
    "ovus": "ovus { 0.7, 0.4 }",
    "quadric": "quadric { <1,2,1>, <0,0,0>, <0,0,0>, -1 }",
    "sphere_sweep": "sphere_sweep { linear_spline 3, <-0.7,0,0>, 0.3, <0.2,0.6,0>, 0.4, <0.6,-0.5,0.2>, 0.2 }",
}
# One scene of several shapes, moved and scaled as a whole.
MIXED = """#declare S = {scale}; #declare T = {shift};
camera {{ location T + S*<0, 1.5, -5> look_at T + S*<0, 0.3, 0> }}
light_source {{ T + S*<-4, 7, -6>, 1 }}
background {{ rgb <.2,.3,.5> }}
union {{
  difference {{ box {{ <-2,-.4,-.6>, <-.8,.8,.6> }} cylinder {{ <-1.4,-.5,0>, <-1.4,.9,0>, .4 }}
    pigment {{ rgb <1,.5,.2> }} }}
  torus {{ .5, .2 rotate <60,20,0> translate <1.4,.3,0> pigment {{ rgb <.2,.8,.4> }} finish {{ phong .6 }} }}
  intersection {{ sphere {{ 0, .7 }} box {{ <-.5,-.5,-.5>, <.5,.5,.5> }} rotate 30*y translate .2*y
    pigment {{ rgbf <.9,.9,1,.7> }} interior {{ ior 1.4 }} finish {{ reflection .2 }} }}
  cone {{ <.6,-.45,-1>, .4, <.6,.4,-1>, 0 pigment {{ rgb <.7,.3,.8> }} }}
  plane {{ y, -.5 pigment {{ rgb .8 }} }}
  scale S translate T
}}
"""


class KnownPictures(ProgramTest):
    def picture(self, scene, width=100, height=100, *options):
        """The pixels of a scene, as rows of values from 0 to 255."""
        self.write("a.pov", scene)
        outcome = self.dioptre("+Ia.pov", "+Oa.ppm", "+FP", "-D", f"+W{width}", f"+H{height}", *options)
        self.assertEqual(outcome.status, 0, outcome.output)
        return images.read_ppm(self.folder / "a.ppm")

    def hits(self, objects, size=100, away=5):
        """How many pixels of the window show something."""
        scene = WINDOW.format(away=away)
        return sum(1 for p in pixels(self.picture(scene + objects, size, size)) if any(p))

    def test_a_solid_less_itself_is_empty(self):
        for name, solid in SOLIDS.items():
            for turn in ("", "rotate <10,20,30>", "scale 1e-4 scale 1e4"):
                placed = f"object {{ {solid} {turn} }}"
                with self.subTest(solid=name, turn=turn):
                    self.assertGreater(self.hits(placed), 100)
                    self.assertEqual(self.hits(f"difference {{ {placed} {placed} }}"), 0)

    def test_solids_that_share_a_face_have_nothing_in_common(self):
        halves = "box { <-1,-1,-1>, <1,1,0> } box { <-1,-1,0>, <1,1,1> }"
        self.assertEqual(self.hits(f"intersection {{ {halves} }}"), 0)

    def test_a_union_less_itself_is_empty(self):
        both = f"union {{ {SOLIDS['box']} {SOLIDS['torus']} {SOLIDS['sphere']} }}"
        self.assertEqual(self.hits(f"difference {{ {both} {both} }}"), 0)

    def test_a_drill_flush_with_both_faces_makes_a_clean_hole(self):
        solid = "difference { box { -1, 1 } box { <-.5,-.5,-1>, <.5,.5,1> } }"
        self.assertEqual(self.hits(solid, 200), 10000 - 2500)

    def test_crossed_cylinders_have_no_seam(self):
        crossed = "intersection { cylinder { -2*x, 2*x, 1 } cylinder { -2*y, 2*y, 1 } }"
        self.assertEqual(self.hits(crossed, 200), 10000)

    def test_a_mesh_cuts_as_the_box_it_is(self):
        faces = []
        for axis in range(3):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            for side in (-1, 1):
                corner = []
                for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
                    p = [0, 0, 0]
                    p[axis], p[u], p[v] = side, a, b
                    corner.append("<%d,%d,%d>" % tuple(p))
                faces.append("triangle { %s, %s, %s }" % (corner[0], corner[1], corner[2]))
                faces.append("triangle { %s, %s, %s }" % (corner[0], corner[2], corner[3]))
        mesh = "mesh { " + " ".join(faces) + " inside_vector <0.3,0.5,0.8> }"
        scene = (HEADER + "camera { location <2.5,3,-4> look_at 0 } light_source { <4,6,-9>, 1 }\n"
                 "difference { %s sphere { <1,1,-1>, 1.2 } pigment { rgb 1 } }")
        self.assertEqual(self.picture(scene % "box { -1, 1 }"), self.picture(scene % mesh))

    def test_rewritten_operators_give_the_same_picture(self):
        a, b = "sphere { -0.4*x, 1 }", "box { <-0.5,-0.7,-0.9>, <1.1,0.6,0.5> }"
        c = "cylinder { -2*y, 2*y, 0.4 }"
        pairs = (
            (f"difference {{ {a} {b} }}", f"intersection {{ {a} object {{ {b} inverse }} }}"),
            (f"difference {{ {a} {b} {c} }}", f"difference {{ {a} merge {{ {b} {c} }} }}"),
            (f"difference {{ {a} intersection {{ {b} {c} }} }}",
             f"merge {{ difference {{ {a} {b} }} difference {{ {a} {c} }} }}"),
            (f"merge {{ {a} merge {{ {b} {c} }} }}", f"merge {{ merge {{ {c} {a} }} {b} }}"),
            (f"union {{ {a} {b} {c} }}", f"object {{ {a} }} object {{ {c} }} object {{ {b} }}"),
            (f"object {{ {a} }}", f"object {{ {a} scale 1 rotate 0 translate 0 }}"),
        )
        scene = (HEADER + "camera { location <2,3,-4> look_at 0 } light_source { <4,6,-9>, 1 }\n"
                 "#default { pigment { rgb 1 } }\n")
        for one, other in pairs:
            with self.subTest(one=one):
                self.assertEqual(self.picture(scene + one), self.picture(scene + other))

    def test_size_and_place_do_not_matter(self):
        plain = self.picture(HEADER + MIXED.format(scale=1, shift=0), 120, 90)
        places = [(10.0 ** k, "0") for k in range(-6, 7)]
        places += [(1, "10e%d*<1,1,1>" % k) for k in (2, 5, 8)]
        for scale, shift in places:
            with self.subTest(scale=scale, shift=shift):
                other = self.picture(HEADER + MIXED.format(scale=repr(scale), shift=shift), 120, 90)
                off = [max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(pixels(plain), pixels(other))]
                self.assertEqual(sum(1 for d in off if d > 1), 0)

    def test_the_disc_of_a_sphere_has_its_size(self):
        scene = (HEADER + "camera { location -5*z direction 0.5*z right x up y }\n"
                 "sphere { 0, 1 pigment { rgb 1 } finish { ambient 1 } }")
        size = 1000
        radius = size / 2 * math.tan(math.asin(1 / 5))
        seen = sum(1 for p in pixels(self.picture(scene, size, size)) if any(p))
        self.assertAlmostEqual(seen / (math.pi * radius ** 2), 1, delta=1e-3)


def pixels(picture):
    """The pixels of a picture, row by row, as triples."""
    rgb = picture.rgb
    return [rgb[i:i + 3] for i in range(0, len(rgb), 3)]


if __name__ == "__main__":
    unittest.main()
