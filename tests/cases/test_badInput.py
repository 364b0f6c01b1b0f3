# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input stops before the first time step and names file, keyword and what is allowed."""

import pytest
from grain_box import grain_box, replace

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"
CSV = "constant/grains.csv"
CONTROL = "system/controlDict"
SCHEMES = "system/fvSchemes"
BLOCKS = "system/blockMeshDict"
HEADER = "x,y,z,radius"
GOOD = "0.03,0.03,0.005,0.004"


def swap(file, old, new):
    """Replace a text in a file."""
    return lambda case: replace(case, file, old, new)


def drop(file, text):
    return swap(file, text, "")


def cut(file, text):
    """End a file before a text."""

    def spoil(case):
        path = case.path / file
        path.write_text(path.read_text().partition(text)[0])

    return spoil


def csv(*lines):
    """Other grains."""
    return lambda case: (case.path / CSV).write_text("".join(line + "\n" for line in lines))


def remove(file):
    return lambda case: (case.path / file).unlink()


def meshed(*spoils):
    """Several changes, then a new mesh."""

    def spoil(case):
        for one in spoils:
            one(case)
        case.run("blockMesh")

    return spoil


def both(*spoils):
    return lambda case: [one(case) for one in spoils]


def damaged_state(case):
    """grains.h5 of the start time cut in the middle."""
    replace(case, CONTROL, "endTime         0.05", "endTime         0.001")
    replace(case, CONTROL, "writeInterval   50", "writeInterval   1")
    case.run("grainFoam")
    state = case.path / "0.001/grains.h5"
    state.write_bytes(state.read_bytes()[: state.stat().st_size // 2])
    replace(case, CONTROL, "endTime         0.001", "endTime         0.002")


# In a box without empty patches, U and p_rgh need other conditions
NO_EMPTY = both(swap("0/U", "empty", "slip"), swap("0/p_rgh", "empty", "zeroGradient"))

WEDGE_BACK = "(0 0 -0.01) (0.1 0 -0.02) (0.1 0.1 -0.02) (0 0.1 -0.01)"
WEDGE_FRONT = "(0 0 0.01) (0.1 0 0.02) (0.1 0.1 0.02) (0 0.1 0.01)"

# Opposite walls joined by interpolation
AMI = [
    swap(
        BLOCKS,
        f"{name}\n    {{\n        type    wall;",
        f"{name}\n    {{\n        type    cyclicAMI; neighbourPatch {partner};"
        f" transform translational; separationVector ({shift} 0 0);",
    )
    for name, partner, shift in [("left", "right", 0.1), ("right", "left", -0.1)]
]
AMI_FIELDS = [
    swap(f"0/{field}", '"left|right|bottom|top"', '"left|right" { type cyclicAMI; } "bottom|top"')
    for field in ("U", "p_rgh")
]

# A source of what the solver does not solve for
OTHER_SOURCE = """FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
heater
{
    type scalarSemiImplicitSource;
    selectionMode all;
    volumeMode specific;
    injectionRateSuSp { T (1 0); }
}
"""


# The weight of the fluid once more
WEIGHT = """FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
weight { type buoyancyForce; buoyancyForceCoeffs { fields (U); selectionMode all; } }
"""


def weight(case):
    (case.path / "system/fvOptions").write_text(WEIGHT)


# The frame of a vehicle
FRAME = """FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
sway { type tabulatedAccelerationSource; timeDataFileName "constant/acceleration"; }
"""


def frame(case):
    (case.path / "system/fvOptions").write_text(FRAME)
    (case.path / "constant/acceleration").write_text("((0 ((1 0 0) (0 0 0) (0 0 0))))\n")


def other_source(case):
    (case.path / "system/fvOptions").write_text(OTHER_SOURCE)


# A porosity whose law asks for OpenFOAM's transport model
POROSITY = """FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
plug
{
    type explicitPorositySource;
    explicitPorositySourceCoeffs
    {
        selectionMode cellZone;
        cellZone porous;
        type DarcyForchheimer;
        d (1e5 1e5 1e5);
        f (0 0 0);
        coordinateSystem { origin (0 0 0); e1 (1 0 0); e2 (0 1 0); }
    }
}
"""
EVERYWHERE = "source boxToCell; box (0 0 0) (1 1 1);"
ZONE = f"actions ({{ name porous; type cellZoneSet; action new; {EVERYWHERE} }});"


def porosity(case):
    (case.path / "system/fvOptions").write_text(POROSITY)
    header = "FoamFile { version 2.0; format ascii; class dictionary; object topoSetDict; }"
    (case.path / "system/topoSetDict").write_text(f"{header}\n{ZONE}\n")
    case.run("topoSet")


# The box turned into a wedge of 11 degrees about an axis outside of it
WEDGE = [
    swap(BLOCKS, "(0   0   0) (0.1 0   0) (0.1 0.1 0) (0   0.1 0)", WEDGE_BACK),
    swap(BLOCKS, "(0   0   0.01) (0.1 0   0.01) (0.1 0.1 0.01) (0   0.1 0.01)", WEDGE_FRONT),
    swap(
        BLOCKS,
        "frontAndBack\n    {\n        type    empty;\n        faces   ((0 3 2 1) (4 5 6 7));",
        "back { type wedge; faces ((0 3 2 1)); } front { type wedge; faces ((4 5 6 7));",
    ),
    swap("0/U", "frontAndBack\n    {\n        type    empty", '"back|front" { type wedge'),
    swap("0/p_rgh", "frontAndBack\n    {\n        type    empty", '"back|front" { type wedge'),
]

METHODS = ["centroid", "exactOverlap"]
COLUMNS = ["x y z radius"]

# name, how the good case is spoilt, what the message holds
TABLE = [
    ("noShape", swap(GRAINS, "shape   disc;\n\nm", "m"), [GRAINS, "'shape'"]),
    (
        "shape",
        swap(GRAINS, "\nshape   disc", "\nshape   cube"),
        [GRAINS, "'shape'", "cube", "disc"],
    ),
    ("noMaterials", swap(GRAINS, "\nmaterials\n", "\nmaterial\n"), [GRAINS, "'materials'"]),
    ("noDensity", drop(GRAINS, "density 2500;"), [GRAINS, "glass", "'density'"]),
    ("noFriction", drop(GRAINS, "friction    0.3;"), [GRAINS, "glassOnGlass", "'friction'"]),
    ("noWalls", swap(GRAINS, "\nwalls\n", "\nwall\n"), [GRAINS, "'walls'"]),
    ("noInitialGrains", swap(GRAINS, "\ninitialGrains", "\ngrains"), [GRAINS, "initialGrains"]),
    ("noFile", drop(GRAINS, 'file        "constant/grains.csv";'), [GRAINS, "'file'"]),
    ("noContact", swap(GRAINS, "\ncontact\n", "\ncontacts\n"), [GRAINS, "'contact'"]),
    ("noTolerance", drop(GRAINS, "tolerance   1e-7;"), [GRAINS, "contact", "'tolerance'"]),
    ("noCoupling", cut(GRAINS, "\ncoupling\n"), [GRAINS, "'coupling'"]),
    (
        "dragShape",
        swap(GRAINS, "        shape   disc;\n", "        shape   cube;\n"),
        [GRAINS, "drag", "'shape'", "cube", "disc sphere"],
    ),
    (
        "dragOfSpheresOnDiscs",
        swap(GRAINS, "DallavalleDiFelice;\n        shape   disc;", "Beetstra;"),
        [GRAINS, "drag", "'type'", "value Beetstra", "a law of discs", "shape sphere;"],
    ),
    (
        "liftOfSpheresOnDiscs",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ lift { one { type Magnus; } }"),
        [GRAINS, "one", "'type'", "value Magnus", "shape sphere;"],
    ),
    (
        "largeTolerance",
        swap(GRAINS, "1e-7", "1"),
        [GRAINS, "contact", "'tolerance'", "value 1", "to 0.0004", "smallest diameter"],
    ),
    (
        "smallTolerance",
        swap(GRAINS, "1e-7", "1e-18"),
        [GRAINS, "contact", "'tolerance'", "value 1e-18", "round-off"],
    ),
    ("noGrainProperties", remove(GRAINS), [GRAINS]),
    (
        "voidFraction",
        swap(GRAINS, "exactOverlap", "exactOverlaps"),
        [GRAINS, "'type'", "exactOverlaps", *METHODS],
    ),
    (
        "dragLaw",
        swap(GRAINS, "DallavalleDiFelice", "Stoke"),
        [GRAINS, "'type'", "Stoke", "DallavalleDiFelice"],
    ),
    (
        "contactLaw",
        swap(GRAINS, "Coulomb;\n        friction    0.2", "Hertz;\n        friction    0.2"),
        [GRAINS, "'type'", "Hertz", "Coulomb"],
    ),
    (
        "source",
        swap(GRAINS, "csv;", "spreadsheet;"),
        [GRAINS, "'type'", "spreadsheet", "csv"],
    ),
    ("negativeRadius", csv(HEADER, "0,0,0,-0.004"), [CSV, "line 2", "'radius'", "-0.004", "> 0"]),
    ("zeroRadius", csv(HEADER, GOOD, "0,0,0,0"), [CSV, "line 3", "'radius'", "> 0"]),
    ("nan", csv(HEADER, "0.03,nan,0,0.004"), [CSV, "line 2", "'y'", "nan", "finite number"]),
    ("hugeRadius", csv(HEADER, "0,0,0,1e300"), [CSV, "line 2", "'radius'", "at most 1e15"]),
    ("coldGrain", csv(f"{HEADER},temperature", f"{GOOD},-3"), [CSV, "'temperature'", "-3", "> 0"]),
    (
        "clusterAcrossTheMesh",
        swap(
            GRAINS,
            "\nwalls\n",
            "\nshapes { rod { type cluster; centres ((0 0 0) (0 0 1)); radii (1 1); } }\nwalls\n",
        ),
        [GRAINS, "rod", "'centres'", "one plane"],
    ),
    ("hugeDensity", swap(GRAINS, "2500", "1e300"), [GRAINS, "'density'", "1e+300", "1e100"]),
    ("tinyGap", swap(FLUID, "rho ", "HeleShaw { gap 1e-200; }\nrho "), [FLUID, "'gap'", "1e-200"]),
    ("hugeLength", swap(GRAINS, "exactOverlap;", "diffused; length 1e200;"), [GRAINS, "'length'"]),
    ("maxDisplacement", swap(GRAINS, "200;", "200; maxDisplacement 1e-30;"), ["'maxDisplacement'"]),
    ("text", csv(HEADER, "0.03,0.03,0,4mm"), [CSV, "line 2", "'radius'", "4mm", "finite number"]),
    ("tooLarge", csv(HEADER, "1e999,0,0,0.004"), [CSV, "line 2", "'x'", "1e999", "finite number"]),
    ("missingColumn", csv("x,y,radius", "0,0,1"), [CSV, "'z'", "missing", *COLUMNS]),
    ("unknownColumn", csv("x,y,z,diameter", GOOD), [CSV, "'diameter'", *COLUMNS, "vx"]),
    ("doubleColumn", csv("x,y,z,x,radius", "0,0,0,0,1"), [CSV, "'x'", "twice", "once"]),
    ("shortLine", csv(HEADER, GOOD, "0.03,0.03"), [CSV, "line 3", "2 columns", "4"]),
    ("longLine", csv(HEADER, GOOD + ",1"), [CSV, "line 2", "5 columns", "4"]),
    ("noCsv", remove(CSV), [GRAINS, "'file'", CSV, "readable", *COLUMNS]),
    ("emptyCsv", csv(), [GRAINS, "'file'", CSV, "header", *COLUMNS]),
    (
        "unknownGrainMaterial",
        csv(HEADER + ",material", GOOD + ",gold"),
        [CSV, "'material'", "gold", "glass steel"],
    ),
    (
        "overlap",
        csv(HEADER, GOOD, "0.037,0.03,0.005,0.004"),
        [GRAINS, "'initialGrains'", "grain 0", "grain 1", "overlap", "allowedOverlap"],
    ),
    (
        "overlapWithWall",
        csv(HEADER, GOOD, "0.003,0.03,0.005,0.004"),
        [GRAINS, "'initialGrains'", "grain 1", "wall", "allowedOverlap"],
    ),
    (
        "outside",
        csv(HEADER, GOOD, "0.13,0.03,0.005,0.004"),
        [GRAINS, "'initialGrains'", "grain 1", "outside the mesh", "(0.1 0.1 0.01)"],
    ),
    (
        "velocityAcross",
        csv(HEADER + ",vz", GOOD + ",0.1"),
        [CSV, "line 2", "vz", "no velocity across"],
    ),
    (
        "spinInPlane",
        csv(HEADER + ",wx", GOOD + ",0.1"),
        [CSV, "line 2", "wx", "normal of the mesh"],
    ),
    ("dimensionsOfRho", swap(FLUID, "[1 -3 0", "[1 -2 0"), [FLUID, "rho", "[1 -3 0 0 0 0 0]"]),
    ("dimensionsOfNu", swap(FLUID, "[0 2 -1", "[0 2 -2"), [FLUID, "nu", "[0 2 -1 0 0 0 0]"]),
    ("dimensionsOfG", swap("constant/g", "-2 0", "-1 0"), ["constant/g", "[0 1 -2 0 0 0 0]"]),
    (
        "dimensionsOfDensity",
        swap(GRAINS, "density 2500", "density [1 -2 0 0 0 0 0] 2500"),
        [GRAINS, "density", "[1 -3 0 0 0 0 0]"],
    ),
    ("textForDensity", swap(GRAINS, "2500", "heavy"), [GRAINS, "'density'", "heavy", "a number"]),
    ("dimensionsOfU", swap("0/U", "[0 1 -1", "[0 1 -2"), ["0/U", "[0 1 -1 0 0 0 0]"]),
    ("dimensionsOfP", swap("0/p_rgh", "[1 -1", "[0 -1"), ["0/p_rgh", "[1 -1 -2 0 0 0 0]"]),
    ("negativeDensity", swap(GRAINS, "2500", "-2500"), [GRAINS, "'density'", "-2500", "> 0"]),
    ("negativeRho", swap(FLUID, "0] 1000", "0] -1000"), [FLUID, "'rho'", "-1000", "> 0"]),
    ("negativeNu", swap(FLUID, "1e-4", "-1e-4"), [FLUID, "'nu'", "-0.0001", "> 0"]),
    ("noNu", swap(FLUID, "nu ", "mu "), [FLUID, "'nu'"]),
    ("negativeFriction", swap(GRAINS, "0.3;", "-0.3;"), [GRAINS, "'friction'", "-0.3", ">= 0"]),
    ("zeroTolerance", swap(GRAINS, "1e-7", "0"), [GRAINS, "'tolerance'", "> 0"]),
    ("zeroDeltaT", swap(CONTROL, "1e-3", "0"), [CONTROL, "'deltaT'", "> 0"]),
    ("negativeDeltaT", swap(CONTROL, "1e-3", "-1e-3"), [CONTROL, "'deltaT'", "> 0"]),
    (
        "maxGrainCo",
        swap(CONTROL, "1e-3;", "1e-3; adjustTimeStep yes; maxGrainCo 0;"),
        [CONTROL, "'maxGrainCo'", "value 0", "> 0"],
    ),
    (
        "maxDeltaT",
        swap(CONTROL, "1e-3;", "1e-3; adjustTimeStep yes; maxDeltaT -1;"),
        [CONTROL, "'maxDeltaT'", "value -1", "> 0"],
    ),
    (
        "minDeltaT",
        swap(CONTROL, "1e-3;", "1e-3; adjustTimeStep yes; minDeltaT 0;"),
        [CONTROL, "'minDeltaT'", "value 0", "> 0"],
    ),
    (
        "minAboveMaxDeltaT",
        swap(CONTROL, "1e-3;", "1e-3; adjustTimeStep yes; maxDeltaT 1e-3; minDeltaT 1e-2;"),
        [CONTROL, "'minDeltaT'", "value 0.01", "up to maxDeltaT = 0.001"],
    ),
    ("hugeG", swap("constant/g", "-9.81", "-1e200"), ["constant/g", "(0 -1e+200 0)", "1e15"]),
    (
        "sweepsNotWhole",
        swap(GRAINS, "200", "2.5"),
        [GRAINS, "'maxSweeps'", "value 2.5", "a whole number"],
    ),
    ("maxSweeps", swap(GRAINS, "200", "0"), [GRAINS, "'maxSweeps'", "value 0", ">= 1"]),
    (
        "blocks",
        swap(GRAINS, "maxSweeps   200;", "blocks 3;"),
        [GRAINS, "'blocks'", "value 3", "power of two"],
    ),
    (
        "mesh3D",
        meshed(NO_EMPTY, swap(BLOCKS, "empty", "patch")),
        [GRAINS, "'shape'", "disc", "sphere, as this mesh is three-dimensional"],
    ),
    (
        "twoCellsThick",
        meshed(swap(BLOCKS, "(10 10 1)", "(10 10 2)")),
        ["mesh", "Cell 0", "two 'empty' faces", "one layer of cells"],
    ),
    (
        "unknownPatch",
        swap(GRAINS, "bottom top)", "bottom lid)"),
        [GRAINS, "'patches'", "lid", "left right bottom top"],
    ),
    (
        "emptyPatch",
        swap(GRAINS, "bottom top)", "bottom frontAndBack)"),
        [GRAINS, "'patches'", "frontAndBack", "'empty'"],
    ),
    (
        "wallType",
        swap(GRAINS, "type        patches", "type        cube"),
        [GRAINS, "'type'", "cube", "patches surface plane"],
    ),
    (
        "noLaw",
        swap(GRAINS, "(glass steel)", "(steel steel)"),
        [GRAINS, "'contactLaws'", "glass and steel", "materials (glass steel)"],
    ),
    (
        "unknownMaterial",
        swap(GRAINS, "material    glass", "material    glas"),
        [GRAINS, "'material'", "glas", "glass steel"],
    ),
    (
        "unknownMaterialOfLaw",
        swap(GRAINS, "(glass glass)", "(glass gold)"),
        [GRAINS, "'materials'", "gold", "glass steel"],
    ),
    ("typo", swap(GRAINS, "shape   disc;\n\n", "shape disc;\nshpae disc;\n"), [GRAINS, "'shpae'"]),
    ("typoInMaterial", swap(GRAINS, "2500;", "2500; colour 1;"), ["glass", "'colour'", "density"]),
    ("typoInLaw", swap(GRAINS, "0.3;", "0.3; mu 1;"), ["glassOnGlass", "'mu'", "friction"]),
    ("typoInWall", swap(GRAINS, "type        patches;", "type patches; x 1;"), ["box", "'x'"]),
    ("typoInSource", swap(GRAINS, "csv;", "csv; x 1;"), ["initialGrains", "'x'", "file"]),
    ("typoInContact", swap(GRAINS, "200;", "200; x 1;"), ["contact", "'x'", "maxSweeps"]),
    ("typoInCoupling", swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ x 1;"), ["coupling", "'x'"]),
    (
        "typoInVoidFraction",
        swap(GRAINS, "exactOverlap;", "exactOverlap; x 1;"),
        ["voidFraction", "'x'", "allowed"],
    ),
    (
        "viscosityLaw",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ viscosity { type Krieger; }"),
        [GRAINS, "viscosity", "Krieger", "Batchelor Einstein KriegerDougherty none"],
    ),
    (
        "form",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ form C;"),
        [GRAINS, "'form'", "value C", "A B"],
    ),
    (
        "motion",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion frozen;"),
        [GRAINS, "'motion'", "value frozen", "free fixed"],
    ),
    (
        "fixedAndMoving",
        both(
            swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;"),
            csv(f"{HEADER},vy", f"{GOOD},0.1"),
        ),
        [GRAINS, "'motion'", "value fixed", "grain 0 has a velocity of 0.1 m/s"],
    ),
    (
        "fixedAndInjected",
        swap(GRAINS, "\ncoupling\n{", "\ninjections {}\ncoupling\n{ motion fixed;"),
        [GRAINS, "'motion'", "value fixed", "free", "'injections'"],
    ),
    (
        "ddtScheme",
        swap(SCHEMES, "Euler", "CrankNicolson 0.9"),
        [SCHEMES, "'default'", "CrankNicolson", "Euler backward"],
    ),
    (
        "noDictionary",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ resolvedGrains locked;"),
        [GRAINS, "'resolvedGrains'", "locked", "dictionary"],
    ),
    (
        "addedMass",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ addedMass -1;"),
        [GRAINS, "'addedMass'", "value -1", ">= 0"],
    ),
    (
        "resolvedGrains",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ resolvedGrains { type forced; }"),
        [GRAINS, "'type'", "value forced", "locked cutCells none"],
    ),
    (
        "noTypeOfResolvedGrains",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ resolvedGrains { from 5; }"),
        [GRAINS, "resolvedGrains", "'type' is missing", "locked cutCells none"],
    ),
    (
        "resolvedByCentroids",
        both(
            swap(GRAINS, "exactOverlap", "centroid"),
            swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ resolvedGrains { type locked; }"),
        ),
        [GRAINS, "'type'", "value locked", "none, with the chosen type of voidFraction"],
    ),
    (
        "undisturbedWidth",
        both(
            swap(GRAINS, "exactOverlap;", "diffused; length 0.02;"),
            swap(
                GRAINS,
                "\ncoupling\n{",
                "\ncoupling\n{ undisturbedFlow { type none; width 100; }",
            ),
        ),
        [GRAINS, "'width'", "value 100", "1 to 20"],
    ),
    (
        "noTypeOfDrag",
        drop(GRAINS, "type    DallavalleDiFelice;"),
        [GRAINS, "drag", "'type' is missing", "Rong"],
    ),
    (
        "resolvedCoarse",
        swap(
            GRAINS,
            "\ncoupling\n{",
            "\ncoupling\n{ coarseGraining 2; resolvedGrains { type locked; }",
        ),
        [GRAINS, "'type'", "value locked", "none, with coarseGraining"],
    ),
    (
        "coarseGraining",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ coarseGraining 0.5;"),
        [GRAINS, "'coarseGraining'", "value 0.5", "1 to 100"],
    ),
    (
        "resolvedFrom",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ resolvedGrains { type locked; from 1; }"),
        [GRAINS, "'from'", "value 1", "2"],
    ),
    (
        "lift",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ lift { one { type Saffman; } }"),
        [GRAINS, "Saffman", "Magnus SaffmanMei"],
    ),
    (
        "lubrication",
        swap(GRAINS, "\ncoupling\n{", "\ncoupling\n{ lubrication { type Davis; }"),
        [GRAINS, "'roughness'"],
    ),
    ("gap", swap(FLUID, "rho ", "HeleShaw { gap 0; }\nrho "), [FLUID, "'gap'", "value 0", "> 0"]),
    (
        "viscosityModelBetweenPlates",
        swap(
            FLUID,
            "nu ",
            "HeleShaw { gap 0.01; } transportModel powerLaw;"
            " powerLawCoeffs { k 1e-4; n 0.5; nuMin 1e-7; nuMax 1; }\n// ",
        ),
        [FLUID, "'transportModel'", "value powerLaw", "allowed: Newtonian, as there is HeleShaw"],
    ),
    (
        "platesInThreeDimensions",
        meshed(
            NO_EMPTY,
            swap(BLOCKS, "empty", "patch"),
            swap(GRAINS, "\nshape   disc", "\nshape   sphere"),
            swap(GRAINS, "        shape   disc;\n", "        shape   sphere;\n"),
            swap(FLUID, "rho ", "HeleShaw { gap 0.01; }\nrho "),
        ),
        [FLUID, "'HeleShaw'", "one cell thick, between patches of type empty"],
    ),
    ("typoInDrag", swap(GRAINS, "DiFelice;", "DiFelice; x 1;"), ["drag", "'x'", "shape"]),
    (
        "gravityAcross",
        swap("constant/g", "(0 -9.81 0)", "(0 -9.81 1)"),
        ["constant/g", "'value'", "(0 -9.81 1)", "in the plane"],
    ),
    ("damagedState", damaged_state, ["0.001/grains.h5", "cannot be opened"]),
    ("noU", remove("0/U"), ["0/U"]),
    ("noG", remove("constant/g"), ["constant/g"]),
    ("noPatchOfU", swap("0/U", '"left|right|bottom|top"', '"left|right|top"'), ["0/U", "bottom"]),
    (
        "trackedGrain",
        swap(CONTROL, "grainTracks;", "grainTracks;\n        grains (0 7);"),
        [CONTROL, "'grains'", "7", "ids of grains"],
    ),
    (
        "trackedGrains",
        swap(CONTROL, "grainTracks;", "grainTracks;\n        grains all;"),
        [CONTROL, "'grains'", "value all", "(0 17 42)"],
    ),
    (
        "numberOfTrackedGrains",
        swap(CONTROL, "grainTracks;", "grainTracks;\n        grains (0 1.5);"),
        [CONTROL, "'grains'", "value ( 0 1.5 )", "(0 17 42)"],
    ),
    (
        "dragOfDiscsOnSpheres",
        meshed(
            NO_EMPTY,
            swap(BLOCKS, "empty", "patch"),
            swap(GRAINS, "\nshape   disc", "\nshape   sphere"),
        ),
        [GRAINS, "drag", "'shape'", "value disc", "sphere, as this mesh is three-dimensional"],
    ),
    ("wedge", meshed(*WEDGE), ["front", "'wedge'", "'empty'"]),
    (
        "cyclicAMI",
        meshed(*AMI, *AMI_FIELDS),
        ["polyMesh/boundary", "left", "'cyclicAMI'", "'cyclic'"],
    ),
    (
        "setTimeStep",
        both(
            swap(CONTROL, "purgeWrite", "adjustTimeStep yes;\npurgeWrite"),
            swap(
                CONTROL,
                "functions\n{",
                "functions\n{ steps { type setTimeStep; deltaT 1e-4;"
                ' libs ("libutilityFunctionObjects.so"); }',
            ),
        ),
        [CONTROL, "functions.steps", "'type'", "setTimeStep", "maxDeltaT"],
    ),
    (
        "cloudInfoOfGrains",
        swap(
            CONTROL,
            "functions\n{",
            "functions\n{ info { type cloudInfo; clouds (grains);"
            ' libs ("liblagrangianFunctionObjects.so"); }',
        ),
        [CONTROL, "functions.info", "'type'", "cloudInfo", "postProcessing/ledger"],
    ),
    (
        "sourceOfAnother",
        other_source,
        ["system/fvOptions", "'heater'", "sources and constraints of U"],
    ),
    (
        "weightTwice",
        weight,
        ["system/fvOptions", "'weight'", "buoyancyForce", "constant/g"],
    ),
    (
        "frameThatMoves",
        frame,
        ["system/fvOptions", "'sway'", "tabulatedAccelerationSource", "constant/dynamicMeshDict"],
    ),
    (
        "porosityWithoutModel",
        porosity,
        ["system/fvOptions", "'plug'", "DarcyForchheimer", "transportModel Newtonian"],
    ),
    (
        "relaxation",
        swap(
            "system/fvSolution",
            "solvers\n{",
            "relaxationFactors { equations { U 0.7; } }\n\nsolvers\n{",
        ),
        ["system/fvSolution", "'U'", "value 0.7", "allowed: a value from 1 to 1"],
    ),
    (
        "relaxationOfOldForm",
        swap("system/fvSolution", "solvers\n{", "relaxationFactors { U 0.7; }\n\nsolvers\n{"),
        ["system/fvSolution", "'U'", "value 0.7", "allowed: a value from 1 to 1"],
    ),
    (
        "boundedConvection",
        swap(SCHEMES, "U)   Gauss linear", "U)   bounded Gauss linear"),
        [SCHEMES, "bounded Gauss linear", "the scheme without 'bounded'"],
    ),
]


@pytest.mark.parametrize("spoil, fragments", [row[1:] for row in TABLE], ids=[r[0] for r in TABLE])
def test_bad_input_is_refused(clone, spoil, fragments):
    case = grain_box(clone, [(0.03, 0.03), (0.06, 0.05)])
    spoil(case)
    before = case.times
    assert case.run("grainFoam", check=False, timeout=60) == 1
    log = case.log
    for fragment in fragments:
        assert fragment in log, f"no '{fragment}' in\n{log[log.find('-->') :]}"
    assert "\nTime = " not in log
    assert case.times == before
    assert "printStack" not in log and "sigFpe" not in log


def test_good_input_is_accepted(clone):
    case = grain_box(clone, [(0.03, 0.03), (0.06, 0.05)])
    case.run("grainFoam")
    assert case.times == ["0", "0.05"]
