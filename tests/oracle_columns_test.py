"""Every column of every oracle table is read by a test, or it stands here why none does; errors of
the oracle itself are far below what the tests ask for."""

import csv
import pathlib
import re
import unittest

TESTS = pathlib.Path(__file__).resolve().parent
TABLES = sorted((TESTS / "data" / "oracle").glob("*.csv"))
NAME = re.compile(r'"((?:in|out)\.[\w.]+)"')
UNREAD = {
    ("cplane_hit", "out.ph"): "how far off its lamp's axis a hit is: follows from v, which is read",
    ("fresnel", "out.schlick"): "Schlick's approximation, which Keiko does without",
    ("fresnel", "out.theta_t_deg"): "the refracted direction is read from the table refract",
    ("lamp_eq1_error", "out.E_over_L_true_tot"): "with shining caps: read from lamp_irradiance",
    ("lamp_eq1_error", "out.relerr_rect_tot"): "the same",
    ("lamp_eq1_error", "out.relerr_tan_lat"): "an approximation that no model of Keiko is",
    ("lamp_irradiance", "out.E_eq1_literal_swapped"): "a misprint, shown for what it would do",
    **{("glass_ball", f"out.{c}"): "a step on the way to the light, of which out.weight is read; or a lens's own"
       for c in "F X1 X3 bfl d1 d3 path weight3".split()},
    **{("glass_block", f"out.{c}"): "a step on the way to the light, of which out.weight is read"
       for c in "X_in crit_deg n_tir path".split()},
    **{("glass_plate", f"out.{c}"): "of polarised light, of cut trees or on the way to out.R_mean and out.T_mean"
       for c in "R_depth R_pol Rp Rs T_depth T_pol shift tau theta_t_deg".split()},
    ("glass_plate", "in.depth"): "of trees that are cut by depth: Keiko's are cut by weight",
    **{("glass_prism", f"out.{c}"): "on the way to the deviation, which is read, or of polarised light"
       for c in "T_pol i2_deg min_deviation_deg r1_deg".split()},
    **{("ray_tree_plate", c): "of trees that are cut by depth, or counts of rays: Keiko's are cut by weight"
       for c in "in.depth out.L_depth out.n_rays out.n_weight".split()},
    **{("hemicube", f"out.{c}"): "of the midpoint rule: Keiko's cells have exact form factors"
       for c in ("dF_mid", "sum_mid")},
    ("line_irradiance", "out.E_iso"): "a line that shines alike in all directions: no lamp of Keiko",
    ("mirror_jacobian", "out.stripe_angle_deg"): "follows from the Jacobian, which is read",
    ("polygon_irradiance", "out.F"): "out.E over pi L",
    ("reflect_hits", "in.Rt"): "the camera's right hand: across forward and up, which are read",
}
UNREAD |= {
    **{(table, "in.Rt"): "the camera's right hand: across forward and up, which are read"
       for table in ("stereo_mirror", "stereo_points")},
    **{("stereo_mirror", c): "of the mirror itself: both reflection points are read"
       for c in "in.p out.V out.gap out.z_par out.z_surface".split()},
    ("box_contour", "out.contour_solid"): "solid angles of polygons are read from the tables of lights",
    **{("box_contour", f"out.{c}"): "of the faces: their contour edges, which follow from it, are read"
       for c in ("front", "n_front")},
    **{("outline_points", c): "names the point on the outline, whose place is read"
       for c in ("in.angle_deg", "in.branch", "out.n_sol")},
    **{("stereo_points", f"out.{c}"): "follows from the pixels, which are read" for c in "in_L in_R par_deg".split()},
}
# Of its own value, what the oracle may be off by: far below what any test asks of it.
WELL_KNOWN = 1e-13
NOTHING = 1e-12  # in the value's unit: what tests take for 0
LESS_WELL = {
    ("form_factor_occluded", "err.F12"): 3e-6,  # asked to 1e-3
    ("form_factor_occluded", "err.F12_free"): 1e-12,  # asked to 1e-9
    ("lobe_norm", "err.albedo"): 1e-10,  # asked to 1e-6
    ("sky", "err.E"): 1e-12,  # the same
    ("sky_window", "err.E_sky"): 1e-9,  # asked to 1e-8 and, of clear skies, to 1e-6
    ("sky_window", "err.E_free"): 1e-9,
    # The ephemeris states 0.01 degrees, to which it is asked; some angles are small.
    ("sun_position", "err.alt_deg"): 0.03,
    ("sun_position", "err.az_deg"): 0.01,
    ("sun_position", "err.declination_deg"): 5,
}


def rows_of(table):
    """By column, without units."""
    with open(table, newline="") as file:
        rows = list(csv.reader(file))
    names = [name.split("[")[0] for name in rows[0]]
    return [dict(zip(names, row)) for row in rows[1:]]


def columns_of(table):
    """What is for programs, not for people; errors have a test of their own below."""
    return [name for name in rows_of(table)[0] if name.startswith(("in.", "out."))]


def sources():
    return [p.read_text() for p in sorted(TESTS.rglob("*")) if p.suffix in (".cpp", ".h")]


def names_read(table, texts):
    """What the sources that name a table ask rows for, and the headers that may do it for them."""
    asking = [text for text in texts if f'"{table}"' in text]
    helpers = [text for text in texts if "OracleRow&" in text and "TEST" not in text]
    return {name for text in asking + helpers for name in NAME.findall(text)}


def stem_of(column):
    """A vector is asked for by what its components have in common."""
    return re.sub(r"_[xyz]$", "", column)


class OracleColumns(unittest.TestCase):
    def test_each_is_read_or_known_not_to_be(self):
        texts = sources()
        unread = set()
        for table in TABLES:
            names = names_read(table.stem, texts)
            unread |= {
                (table.stem, stem_of(column))
                for column in columns_of(table)
                if column not in names and stem_of(column) not in names
            }
        self.assertEqual(unread, set(UNREAD))

    def test_are_known_far_better_than_they_are_asked_for(self):
        known = 0
        for table in TABLES:
            for row in rows_of(table):
                for column in row:
                    value = row.get(column.replace("err.", "out."))
                    if not column.startswith("err.") or not row[column]:
                        continue
                    limit = LESS_WELL.get((table.stem, column), WELL_KNOWN)
                    least = limit * abs(float(value)) or NOTHING
                    self.assertLessEqual(float(row[column]), least, row["id"])
                    known += 1
        self.assertGreater(known, 100)


if __name__ == "__main__":
    unittest.main()
