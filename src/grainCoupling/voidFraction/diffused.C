/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "diffused.H"

#include "addToRunTimeSelectionTable.H"
#include "dictionaryInput.H"
#include "fvmSup.H"
#include "gaussLaplacianScheme.H"
#include "linear.H"
#include "uncorrectedSnGrad.H"
#include "zeroGradientFvPatchFields.H"

namespace Foam
{
namespace voidFractionMethods
{
    defineTypeNameAndDebug(diffused, 0);
    addToRunTimeSelectionTable(voidFractionMethod, diffused, dictionary);
}
}


Foam::voidFractionMethods::diffused::diffused
(
    const dictionary& dict,
    const grainCells& cells
)
:
    exactOverlap(cells),
    length_(dictionaryInput::getPositive(dict, "length", dimLength)),
    steps_(dictionaryInput::getLabelOrDefault(dict, "steps", 3, 1, 100))
{
    dictionaryInput::checkKeywords(dict, {"type", "length", "steps"});
}


void Foam::voidFractionMethods::diffused::smooth(scalarField& x) const
{
    const fvMesh& mesh = cells_.mesh();

    volScalarField field
    (
        IOobject
        (
            "diffused", mesh.time().timeName(), mesh,
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        mesh,
        dimensionedScalar("zero", dimless, 0),
        zeroGradientFvPatchScalarField::typeName
    );
    field.primitiveFieldRef() = x;
    field.correctBoundaryConditions();

    // Without correction for skewed cells, which would not be symmetric
    fv::gaussLaplacianScheme<scalar, scalar> laplacian
    (
        mesh,
        tmp<surfaceInterpolationScheme<scalar>>(new linear<scalar>(mesh)),
        tmp<fv::snGradScheme<scalar>>(new fv::uncorrectedSnGrad<scalar>(mesh))
    );
    const surfaceScalarField spread
    (
        IOobject("spread", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("spread", dimArea, sqr(length_)/(4*steps_))
    );

    dictionary solver;
    solver.add("solver", word("PCG"));
    solver.add("preconditioner", word("DIC"));
    solver.add("tolerance", 1e-13);
    solver.add("relTol", 0);

    const dimensionedScalar one("one", dimless, 1);
    const int report = solverPerformance::debug;
    solverPerformance::debug = 0;
    for (label step = 0; step < steps_; ++step)
    {
        const volScalarField before("before", field);
        fvScalarMatrix equation
        (
            fvm::Sp(one, field) - laplacian.fvmLaplacian(spread, field)
         == before
        );
        equation.solve(solver);
    }
    solverPerformance::debug = report;

    x = field.primitiveField();
}
