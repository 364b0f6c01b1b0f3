# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input of heat: stops before the first step, names file, keyword, value, what is allowed."""

import pytest
from grain_box import control, grain_box, replace
from heat_box import fix_grains, with_heat, with_psi
from sphere_box import sphere_box

GRAINS = "constant/grainProperties"
FLUID = "constant/transportProperties"
T = "0/T"
CENTRES = [(0.03, 0.03), (0.06, 0.05)]


def swap(file, old, new):
    """Replace a text in a file."""
    return lambda case: replace(case, file, old, new)


def drop(file, text):
    return swap(file, text, "")


def both(*spoils):
    return lambda case: [spoil(case) for spoil in spoils]


def add(file, text):
    def spoil(case):
        path = case.path / file
        path.write_text(path.read_text() + text + "\n")

    return spoil


def near(text):
    """Heat without contacts."""
    return swap(GRAINS, "conductance none;", f"conductance none; {text}")


def remove(file):
    return lambda case: (case.path / file).unlink()


CP, KAPPA = "Cp 1000.0;", "kappa 0.6;"
HEAT, LAW = "heat { conductance none; }", "heatTransfer { type RanzMarshall; shape sphere; }"
CONDUCTORS = [
    swap(GRAINS, density, f"{density} conductivity 1; youngsModulus 1e9;")
    for density in ("density 2500;", "density 7800;")
]
PLATES = "HeleShaw { gap 0.01; heatTransfer %s; %s }"

# name, how the good case is spoilt, what the message holds
TABLE = [
    *(
        (
            name,
            swap("system/controlDict", "functions\n{", f"functions\n{{ out {{ type {name}; }}"),
            ["functions.out", "'type'", name, "postProcessing/heatLedger"],
        )
        for name in ("wallHeatFlux", "heatTransferCoeff")
    ),
    # Temperature of the fluid
    ("noT", remove(T), ["0/T"]),
    ("dimensionsOfT", swap(T, "[0 0 0 1", "[0 0 1 0"), ["T", "[0 0 1 0 0 0 0]", "[0 0 0 1 0 0 0]"]),
    ("zeroT", swap(T, "uniform 300.0", "uniform 0"), [T, "internalField", "value 0", "> 0 [K]"]),
    (
        "celsius",
        swap(T, "uniform 300.0", "uniform -5"),
        [T, "internalField", "value -5", "> 0 [K]"],
    ),
    (
        "wallBelowZero",
        swap(
            T,
            "top\" { type zeroGradient; }",
            "nothing\" { type zeroGradient; } top { type fixedValue; value uniform -5; }",
        ),
        [T, "top", "value -5", "> 0 [K]"],
    ),
    ("noPatchOfT", drop(T, '"left|right|bottom|top" { type zeroGradient; }'), [T, "left"]),
    # Of the fluid
    ("noCp", drop(FLUID, CP), [FLUID, "'Cp'", "missing", "[0 2 -2 -1 0 0 0]"]),
    ("zeroCp", swap(FLUID, CP, "Cp 0;"), [FLUID, "'Cp'", "value 0", "> 0"]),
    ("wordCp", swap(FLUID, CP, "Cp water;"), [FLUID, "'Cp'", "water", "[0 2 -2 -1 0 0 0]"]),
    (
        "dimensionsOfCp",
        swap(FLUID, CP, "Cp [0 2 -2 0 0 0 0] 1000;"),
        [FLUID, "'Cp'", "[0 2 -2 0 0 0 0]", "[0 2 -2 -1 0 0 0]"],
    ),
    ("noKappa", drop(FLUID, KAPPA), [FLUID, "'kappa'", "missing", "> 0", "function"]),
    ("zeroKappa", swap(FLUID, KAPPA, "kappa 0;"), [FLUID, "'kappa'", "value 0", "> 0"]),
    (
        "dimensionsOfKappa",
        swap(FLUID, KAPPA, "kappa [1 1 -3 0 0 0 0] 0.6;"),
        [FLUID, "'kappa'", "[1 1 -3 0 0 0 0]", "[1 1 -3 -1 0 0 0]"],
    ),
    ("functionOfCp", swap(FLUID, CP, "Cp tables ((300 1) (400 2));"),
     [FLUID, "'Cp'", "tables", "function of the temperature"]),
    ("functionOfCpBelowZero", swap(FLUID, CP, "Cp polynomial ((400 0) (-1 1));"),
     [FLUID, "'Cp'", "value 0 at 400 K", "> 0"]),
    ("functionOfKappa", swap(FLUID, KAPPA, "kappa tables ((300 1) (400 2));"),
     [FLUID, "'kappa'", "tables", "function of the temperature"]),
    ("functionBelowZero", swap(FLUID, KAPPA, "kappa polynomial ((-1 0));"),
     [FLUID, "'kappa'", "value -1 at 300 K", "> 0"]),
    ("zeroMu", both(drop(FLUID, "nu      [0 2 -1 0 0 0 0] 1e-4;"), add(FLUID, "mu 0;")),
     [FLUID, "'mu'", "value 0", "> 0"]),
    ("muAndNu", add(FLUID, "mu 1e-3;"), [FLUID, "'nu'", "0.0001", "as there is mu"]),
    ("dimensionsOfBeta", add(FLUID, "beta [0 0 0 1 0 0 0] 1e-3; TRef 300;"),
     [FLUID, "'beta'", "[0 0 0 1 0 0 0]", "[0 0 0 -1 0 0 0]"]),
    ("noTRef", add(FLUID, "beta 1e-3;"), [FLUID, "'TRef'", "missing", "[0 0 0 1 0 0 0]"]),
    ("zeroTRef", add(FLUID, "beta 1e-3; TRef 0;"), [FLUID, "'TRef'", "value 0", "> 0"]),
    ("zeroPrt", add(FLUID, "Prt 0;"), [FLUID, "'Prt'", "value 0", "> 0"]),
    ("zeroSct", add(FLUID, "Sct 0;"), [FLUID, "'Sct'", "value 0", "> 0"]),
    ("unknownEntry", add(FLUID, "cp 1000;"), [FLUID, "'cp'", "Cp"]),
    # Of the plates
    ("noTemperatureOfPlates", add(FLUID, PLATES % (350, "")),
     [FLUID, "HeleShaw", "'temperature'", "missing", "[0 0 0 1 0 0 0]"]),
    ("zeroTemperatureOfPlates", add(FLUID, PLATES % (350, "temperature 0;")),
     [FLUID, "HeleShaw", "'temperature'", "value 0", "> 0"]),
    ("negativeTransferOfPlates", add(FLUID, PLATES % (-1, "temperature 300;")),
     [FLUID, "HeleShaw", "'heatTransfer'", "value -1"]),
    ("unknownEntryOfPlates", add(FLUID, PLATES % (350, "temperature 300; T 1;")),
     [FLUID, "HeleShaw", "'T'", "temperature"]),
    # Of the grains
    ("noHeat", drop(GRAINS, HEAT), [GRAINS, "'heat'", "missing", "conductance"]),
    ("unknownConductance", swap(GRAINS, "conductance none", "conductance full"),
     [GRAINS, "heat", "'conductance'", "full", "none", "strip"]),
    ("unknownEntryOfHeat", swap(GRAINS, "conductance none;", "conductance none; law x;"),
     [GRAINS, "heat", "'law'", "conductance"]),
    ("noHeatCapacity", drop(GRAINS, "heatCapacity 800.0;"),
     [GRAINS, "glass", "'heatCapacity'", "> 0"]),
    ("zeroHeatCapacity", swap(GRAINS, "heatCapacity 800.0;", "heatCapacity 0;"),
     [GRAINS, "glass", "'heatCapacity'", "value 0"]),
    ("noTemperature", drop(GRAINS, "temperature 400;"),
     [GRAINS, "'temperature'", "grain 0", "> 0", "initialGrains"]),
    ("zeroTemperature", swap(GRAINS, "temperature 400;", "temperature 0;"),
     [GRAINS, "'temperature'", "value 0", "> 0"]),
    ("wallWithoutConductance",
     swap(GRAINS, "material    steel;\n    }", "material steel; temperature 300; }"),
     [GRAINS, "heat", "'conductance'", "none", "box"]),
    ("contactWithoutConductivity", swap(GRAINS, "conductance none", "conductance strip"),
     [GRAINS, "glass", "'conductivity'", "missing", "[1 1 -3 -1 0 0 0]"]),
    ("contactsOfFixedGrains",
     both(fix_grains, swap(GRAINS, "conductance none", "conductance strip"), *CONDUCTORS),
     [GRAINS, "heat", "'conductance'", "value strip with 'motion fixed'", "none", "throughFluid",
      "motion free"]),
    ("contactsOfFixedGrainsByDefault",
     both(fix_grains, drop(GRAINS, "conductance none;"), *CONDUCTORS),
     [GRAINS, "heat", "'conductance'", "value strip, the default, with 'motion fixed'"]),
    ("unknownInside", swap(GRAINS, "conductance none;", "conductance none; inside solid;"),
     [GRAINS, "heat", "'inside'", "solid", "conducting", "isothermal"]),
    ("movingGrainsConductInside",
     swap(GRAINS, "conductance none;", "conductance none; inside conducting;"),
     [GRAINS, "'inside'", "conducting", "isothermal", "fixed"]),
    ("insideWithoutConductivity",
     both(fix_grains, swap(GRAINS, "conductance none;", "conductance none; inside conducting;")),
     [GRAINS, "'inside'", "conducting", "conductivity [W/m/K]"]),
    # Without contacts
    ("unknownGapLaw", near("throughFluid { type spheres; conductivity 1; }"),
     [GRAINS, "throughFluid", "'type'", "spheres", "cylinders", "rowOfSpheres"]),
    ("gapWithoutConductivity", near("throughFluid { type cylinders; }"),
     [GRAINS, "throughFluid", "'conductivity'", "missing", "[1 1 -3 -1 0 0 0]"]),
    ("negativeLens", near("throughFluid { type cylinders; conductivity 1; lens -0.1; }"),
     [GRAINS, "throughFluid", "'lens'", "value -0.1"]),
    ("zeroGap", near("throughFluid { type cylinders; conductivity 1; leastGap 0; }"),
     [GRAINS, "throughFluid", "'leastGap'", "value 0", "> 0"]),
    ("noEmissivity", near("radiation { type cylinders; }"),
     [GRAINS, "glass", "'emissivity'", "missing", "[0 0 0 0 0 0 0]"]),
    ("emissivityAboveOne", both(near("radiation { type cylinders; }"),
                                swap(GRAINS, "density 2500;", "density 2500; emissivity 1.1;")),
     [GRAINS, "glass", "'emissivity'", "value 1.1", "at most 1"]),
    ("rangeOfRadiation", near("radiation { type cylinders; range 9; }"),
     [GRAINS, "radiation", "'range'", "value 9"]),
    ("unknownEntryOfRadiation", near("radiation { type cylinders; reach 2; }"),
     [GRAINS, "radiation", "'reach'", "range"]),
    # Laws
    ("noHeatTransfer", drop(GRAINS, LAW), [GRAINS, "coupling", "'heatTransfer'", "missing"]),
    ("noLaw", swap(GRAINS, "type RanzMarshall;", ""),
     [GRAINS, "heatTransfer", "'type'", "missing", "Gunn"]),
    ("unknownLaw", swap(GRAINS, "RanzMarshall", "Nusselt"),
     [GRAINS, "heatTransfer", "'type'", "Nusselt", "ChurchillBernstein", "Gunn", "Henry", "LiMason",
      "RanzMarshall", "WakaoKaguei"]),
    ("lawOfSpheresForDiscs", swap(GRAINS, "RanzMarshall; shape sphere;", "RanzMarshall;"),
     [GRAINS, "heatTransfer", "'type'", "value RanzMarshall", "a law of discs", "shape sphere;"]),
    ("lawOfDiscsForSpheres", swap(GRAINS, "RanzMarshall", "ChurchillBernstein"),
     [GRAINS, "heatTransfer", "'type'", "ChurchillBernstein", "a law of spheres"]),
    ("unknownEntryOfLaw", swap(GRAINS, "RanzMarshall;", "RanzMarshall; n 2;"),
     [GRAINS, "heatTransfer", "'n'", "type"]),
    ("dipOfHenry", swap(GRAINS, "RanzMarshall;", "Henry; dip 3;"),
     [GRAINS, "heatTransfer", "'dip'", "value 3", "1.8"]),
]


VAPOUR = "vapour { D 1e-5; }"
PSI = "0/psi"
NO_FLUX = "{ type zeroGradient; }"

TABLE_OF_VAPOUR = [
    ("noPsi", remove(PSI), [PSI]),
    ("dimensionsOfPsi", swap(PSI, "[0 0 0 0", "[0 0 0 1"),
     ["psi", "[0 0 0 1 0 0 0]", "[0 0 0 0 0 0 0]"]),
    ("negativePsi", swap(PSI, "uniform 0.5", "uniform -0.1"),
     [PSI, "'internalField'", "value -0.1", "0 to 1"]),
    ("psiAboveOne",
     swap(PSI, '|top" {', f'" {NO_FLUX} top {{ type fixedValue; value uniform 1.5; }} x {{'),
     [PSI, "'boundaryField.top'", "value 1.5", "0 to 1"]),
    ("noD", swap(FLUID, "D 1e-5;", ""), [FLUID, "vapour", "'D'", "missing", "[0 2 -1 0 0 0 0]"]),
    ("negativeD", swap(FLUID, "D 1e-5;", "D -1;"), [FLUID, "vapour", "'D'", "value -1"]),
    ("unknownEntryOfVapour", swap(FLUID, "D 1e-5;", "D 1e-5; Sc 1;"),
     [FLUID, "vapour", "'Sc'", "D"]),
]


def hot_box(clone, **heat):
    return with_heat(grain_box(clone, CENTRES), **heat)


def assert_refused(case, fragments, application="grainThermalFoam"):
    before = case.times
    assert case.run(application, check=False, timeout=60) == 1
    log = case.log
    for fragment in fragments:
        assert fragment in log, f"no '{fragment}' in\n{log[log.find('-->') :]}"
    assert "\nTime = " not in log
    assert case.times == before
    assert "printStack" not in log and "sigFpe" not in log


@pytest.mark.parametrize("spoil, fragments", [row[1:] for row in TABLE], ids=[r[0] for r in TABLE])
def test_bad_input_is_refused(clone, spoil, fragments):
    case = hot_box(clone)
    spoil(case)
    assert_refused(case, fragments)


@pytest.mark.parametrize(
    "spoil, fragments", [row[1:] for row in TABLE_OF_VAPOUR], ids=[r[0] for r in TABLE_OF_VAPOUR]
)
def test_bad_input_of_vapour_is_refused(clone, spoil, fragments):
    case = hot_box(clone, fluid=f"{CP} {KAPPA} {VAPOUR}")
    sides = '"left|right|bottom|top" { type zeroGradient; } frontAndBack { type empty; }'
    with_psi(case, 0.5, sides)
    spoil(case)
    assert_refused(case, fragments)


@pytest.mark.parametrize(("law", "words"), [
    ("Gunn", None),
    # At most two thirds of a cell are fluid, and the law is one of lone spheres
    ("RanzMarshall", "fluid fractions from 0.9 and superficial Reynolds numbers up to 1000"),
])
def test_law_outside_its_range_says_so_once(clone, law, words):
    case = hot_box(clone, law=f"type {law}; shape sphere;")
    control(case, endTime=0.005, writeInterval=5)
    case.run("grainThermalFoam")
    assert case.log.count("coupling/heatTransfer was found for") == (1 if words else 0)
    assert words is None or words in case.log


def test_law_above_its_reynolds_number_says_so_once(clone):
    case = hot_box(clone, law="type Gunn; shape sphere;")
    replace(case, FLUID, "1e-4;", "1e-9;")
    control(case, endTime=0.005, writeInterval=5)
    case.run("grainThermalFoam")
    assert case.log.count("superficial Reynolds numbers up to 100000") == 1


def test_good_input_is_accepted(clone):
    case = hot_box(clone)
    control(case, endTime=0.002, writeInterval=2)
    case.run("grainThermalFoam")
    assert case.times == ["0", "0.002"]


def test_disc_laws_are_refused_for_spheres(clone):
    centres = [(0.03, 0.03, 0.03)]
    case = with_heat(sphere_box(clone, centres), law="type ChurchillBernstein;", empty="")
    replace(case, T, "left|right|bottom|top", ".*")
    assert_refused(
        case, [GRAINS, "heatTransfer", "'type'", "value ChurchillBernstein", "a law of spheres"]
    )


def test_entries_of_heat_are_refused_by_grainFoam(clone):
    case = hot_box(clone)
    assert_refused(case, [FLUID, "'Cp'"], "grainFoam")
    replace(case, FLUID, f"{CP} {KAPPA}", "")
    assert_refused(case, [GRAINS, "'heat'"], "grainFoam")
    replace(case, GRAINS, HEAT, "")
    replace(case, GRAINS, "temperature 400;", "")
    assert_refused(case, [GRAINS, "'heatTransfer'", "grainThermalFoam"], "grainFoam")
