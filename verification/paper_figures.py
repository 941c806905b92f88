# SPDX-License-Identifier: BSD-3-Clause
"""The figures of the paper from 13 on: what each shows, which verification regenerates it by which
of its pictures, which of its rows judge it and what they compare with. The only place that knows
both; pictures and rows are named by the check.py of the chapter. A row is given by its id without
the name of the chapter, with * for anything."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class PaperFigure:
    """A figure of the paper. A result has a reference and rows; a set-up is described instead."""

    number: int
    shows: str
    chapter: str
    pictures: tuple[str, ...]
    rows: tuple[str, ...] = ()
    reference: str = ""
    set_up: str = ""
    differs: str = ""  # in words, where what comes out is not what the paper shows

    @property
    def is_set_up(self) -> bool:
        return bool(self.set_up)


_OVER_N = ("The series solution (41) by the relative error (42), and the level that the paper "
           "states: below 1 % at n = 100, slope −1. The dotted line is an independent program for "
           "the same scheme on another mesh (strip_error_vs_n.csv), within a factor of 1.35.")

FIGURES = (
    PaperFigure(
        13, "error of finite joints over the factor n, for three permeabilities", "strip",
        ("permeability",), ("permeability.*",), reference=_OVER_N),
    PaperFigure(
        14, "the same for three viscosities", "strip",
        ("viscosity",), ("viscosity.*",), reference=_OVER_N),
    PaperFigure(
        15, "the strip in three element sizes", "strip", ("meshes",),
        set_up="Our meshes of 0.05, 0.03 and 0.01 m. The paper counts 80 triangles of 0.05 m, with "
               "which 0.2 m² cannot be covered; ours has 172."),
    PaperFigure(
        16, "error of finite joints over the factor n, for three element sizes", "strip",
        ("size",), ("size.*",), reference=_OVER_N),
    PaperFigure(
        17, "the strip in three shapes of triangles", "strip", ("shape_meshes",),
        set_up="Our meshes of 0.1 m: irregular, right-angled and crossed triangles."),
    PaperFigure(
        18, "pressure at 0.02 s for three shapes of triangles, n = 100", "strip",
        ("shapes",), ("shape.*",),
        reference="The series solution (41); the paper states less than 0.6 % at every node."),
    PaperFigure(
        19, "the well in its ring of rock", "radial", ("mesh",),
        set_up="Our mesh: 10 MPa on the wall of the well, 0.1 m from the centre, and 1 MPa on the "
               "circle of 1 m radius."),
    PaperFigure(
        20, "steady pressure along the radius and as a field", "radial",
        ("pressure", "field", "gradient"),
        ("criterion_*", "tied", "finite", "finite.balance", "gradient", "order"),
        reference="The logarithm of the radius (43) and its slope (44)."),
    PaperFigure(
        21, "principal stress that is most tensile, and cracks, as the well cracks its ring",
        "pressurised_well", ("stress",), ("tension_*", "compression", "shear"),
        reference="What the paper says of its pictures: tension gathers round the wall before "
                  "cracks run, then moves outward with their tips, while the rock at the wall "
                  "comes under compression. The paper counts steps of 0.14 µs: 0.14 ms is its "
                  "step 1000, 0.35 ms its step 2500. Stress is the effective one.",
        differs="How many joints break depends on damping, mesh and the stress that strength is "
                "compared with, none of which the paper tells in full; the chapter shows them "
                "side by side."),
    PaperFigure(
        22, "pore pressure and cracks as the well cracks its ring", "pressurised_well",
        ("fluid", "growth"),
        ("outward", "tip", "main_cracks", "fluid_follows", "wall_rises", "total.tip"),
        reference="What the paper says of its pictures: radial cracks run outward, high pressure "
                  "follows along them and seeps to their sides, and pores near the wall fill all "
                  "the time."),
    PaperFigure(
        23, "a fracture across a long block of rock", "single_fracture", ("mesh",),
        set_up="Our mesh. The paper does not say where in its 120 m the fracture stands; 20 m from "
               "the left end gives the times at which its figure 24 sees that end."),
    PaperFigure(
        24, "pressure along the block at four times", "single_fracture", ("profiles",),
        ("profile.*", "face.*", "jump.*", "finite"),
        reference="Right of the fracture rock without end behind a film (45), left of it a slab of "
                  "20 m with a sealed end; both tables are computed independently "
                  "(single_fracture_semi_infinite.csv, single_fracture_slab20.csv). The paper's "
                  "statement that the left face ends above the right one has rows of its own.",
        differs="(45) is misprinted: its units do not agree. The table holds the solution of the "
                "same problem."),
    PaperFigure(
        25, "two faults that crop out in two valleys", "double_fracture", ("mesh",),
        set_up="Our mesh of HYDROCOIN level 1, case 2. On the ground the head is its height over "
               "1000 m (46); the other sides are sealed."),
    PaperFigure(
        26, "hydraulic head of the two faults, steady", "double_fracture", ("head",),
        ("peak", "valley", "tied.*", "finite.*"),
        reference="What the paper says: highest under the tops, lowest where the faults crop out. "
                  "In numbers the lines of figure 27, and the balance of what enters and leaves."),
    PaperFigure(
        27, "hydraulic head on three levels", "double_fracture",
        ("y1000", "y800", "y600", "published"),
        ("tied.1000*", "tied.800*", "finite.1000", "finite.800", "mesh.600", "published"),
        reference="On 1000 and 800 m independent finite elements with faults as lines "
                  "(double_fracture_head.csv); on 800 m also the published benchmark "
                  "with faults of their real width (Flemisch et al. 2018). On 600 m there is none "
                  "at hand: two meshes must agree."),
    PaperFigure(
        28, "a block with six fractures", "six_fractures", ("mesh",),
        set_up="Our mesh, 20 MPa on the left and none on the right; letters as in table 2."),
    PaperFigure(
        29, "pressure in the block with six fractures at 0.1, 0.3, 0.5 and 1 h", "six_fractures",
        ("slow_times", "printed_times"), ("tips.*", "slow.*"),
        reference="What the paper says: at 0.1 h the fractures lag behind the rock round the tips "
                  "A, D and E, at 0.3 h they lead round B, F and K, after that the field comes to "
                  "rest. In numbers the line y = 5 m of six_fractures_y5.csv, at a tenth of the "
                  "time.",
        differs="With the storage that the data give, porosity over the bulk modulus of water, all "
                "this is over by 0.1 h (second picture). The paper's times fit a storage ten times "
                "as large, that of porosity 1 (first picture)."),
    PaperFigure(
        30, "the same by a commercial program", "six_fractures", ("fine_times", "fine"),
        ("finite.rms.*", "finite.max.*", "fine.rms.*", "fine.max.*"),
        reference="COMSOL is not at hand. In its place stand independent mixed-dimensional finite "
                  "elements on 172 548 triangles, of which the line y = 5 m is kept "
                  "(six_fractures_y5.csv). The field is ours at half the element size and at a "
                  "tenth of the paper's times, as told for figure 29."),
    PaperFigure(
        31, "pressure on y = 5 m at 3 h", "six_fractures", ("final",),
        ("finite.*.3", "fine.*.3", "plateau"),
        reference="The independent finite elements of figure 30, and the paper's remark that the "
                  "gradient is far smaller from x = −1 to 10 m, in the rock that the fractures "
                  "enclose."),
    PaperFigure(
        32, "three cracks at the side of a block", "three_cracks", ("mesh",),
        set_up="Our mesh with 0.01 m²/s into the mouth of each crack of 0.2 m, 0.3 m apart. What "
               "holds the sides is our choice where the paper's sketch is not at hand."),
    PaperFigure(
        33, "three cracks and the pore pressure as they grow", "three_cracks",
        ("fluid", "paper_storage", "growth"),
        ("0.05_m.*", "0.07_m.*", "as_in_the_paper.*", "mesh.pressure", "work", "paper.work"),
        reference="What the paper says: the outer cracks turn away from the middle one, which goes "
                  "straight on and stays much shorter.",
        differs="The middle crack starts last and lags at 3 ms, but catches up by 7 ms. That it "
                "stays short comes out only with the paper's storage (second picture), where fluid "
                "that a wide crack should hold is left out of the balance: its fluid does more "
                "work than the pumps put in, a row that is there to show it. The shipped case "
                "does not."),
    PaperFigure(
        34, "two cracks across each other in a block", "perpendicular_cracks", ("mesh",),
        set_up="Our mesh. Lengths and places of the cracks are not in the text; ours are 0.8 m "
               "each, and 0.01 m²/s goes into the middle of both."),
    PaperFigure(
        35, "two cracks across each other: their way and the pressure in them",
        "perpendicular_cracks", ("cracks", "injection"),
        ("builds_up", "drops", "meets", "left", "up", "down", "*_bends", "printed.*"),
        reference="What the paper says: pressure builds up to about the tensile strength and drops "
                  "when cracks start; the horizontal crack runs straight into the vertical one and "
                  "on to the left side; both ends of the vertical one bend to the right.",
        differs="With the data as printed nothing breaks: permeable rock takes all the water at "
                "0.52 MPa, a quarter of the strength, as radial flow says (rows printed.*). With a "
                "hundredth of permeability and exchange all of it comes about, but joint by joint: "
                "each that breaks is empty and takes the pressure off all, which then builds up "
                "anew, and towards 1 s to more than the strength, because the sides are held. By "
                "then the ends have come to 0.2 to 0.4 m from the sides, and not through them."),
    PaperFigure(
        36, "two cracks across each other: the pore pressure", "perpendicular_cracks",
        ("fluid", "printed"), ("seeps", "near_cracks", "printed.*"),
        reference="The paper describes it only as its evolution: pressure seeps from the cracks "
                  "into the rock beside them and spreads. The case as printed has radial flow as "
                  "its reference.",
        differs="With a hundredth of the printed permeability and exchange, see figure 35; the "
                "last picture is the case as printed."),
    PaperFigure(
        37, "two cracks across each other on meshes of 0.15 and 0.09 m", "perpendicular_cracks",
        ("meshes",), ("mesh.*", "0.09_m.*"),
        reference="What the paper says: both meshes give nearly the same paths. Here their reach "
                  "at 0.4 s must agree within 0.3 m, two elements, and the cracks must have met.",
        differs="The paths have the same pattern; single ends turn at other places, and on 0.09 m "
                "the cracks meet later (examples/perpendicular_cracks/README.md). The pressure in "
                "the cracks swings with each joint that breaks and is not the same at one moment."),
)
