/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "warnOfShearedCells.H"

#include "cellSizes.H"
#include "surfaceFields.H"
#include "unitConversion.H"

namespace
{

// A disc was stable at a ratio of 100 for 31 degrees, at 1000 for 6 degrees
constexpr Foam::scalar mostRatio = 100;

constexpr Foam::scalar mostTangent = 0.12;

}


void Foam::warnOfShearedCells
(
    const grainSystem& grains,
    const carrier& fluid,
    const scalar from
)
{
    const fvMesh& mesh = grains.mesh();
    if (grains.motion().isFixed())
    {
        return;
    }
    const scalar tangent =
        gMax(mag(mesh.nonOrthCorrectionVectors())().primitiveField());
    const word scheme(mesh.snGradScheme("snGrad(p_rgh)"));
    if (tangent <= mostTangent || scheme != "corrected")
    {
        return;
    }

    const scalar least = from*gMin(cellSizes(mesh));
    const scalar rho = gMin(fluid.rho().primitiveField());
    for (label i = 0; i < grains.size(); ++i)
    {
        const scalar ratio = grains.motion().density(i)/rho;
        if (grains.fluidDiameter(i) >= least && ratio > mostRatio)
        {
            WarningInFunction
                << "Bodies that the flow is resolved around have " << ratio
                << " times the density of the fluid, and faces of the mesh are up to "
                << radToDeg(std::atan(tangent)) << " degrees off the line of their"
                << " cells" << nl
                << "    'corrected' in laplacianSchemes and snGradSchemes of"
                << " system/fvSchemes is unstable then; 'limited corrected 0.33' is"
                << " not, but does not keep two fluids at rest" << endl;
            return;
        }
    }
}
