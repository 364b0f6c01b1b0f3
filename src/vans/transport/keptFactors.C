/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "keptFactors.H"

#include "Time.H"

#include <vector>

namespace Foam
{
    defineTypeNameAndDebug(keptFactors, 0);
}


Foam::keptFactors::keptFactors(const objectRegistry& mesh)
:
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh))
{}


const Foam::keptFactors& Foam::keptFactors::of(const lduMatrix& matrix)
{
    const objectRegistry& mesh = matrix.mesh().thisDb();
    if (!mesh.foundObject<keptFactors>(typeName))
    {
        regIOobject::store(new keptFactors(mesh));
    }
    keptFactors& result = mesh.lookupObjectRef<keptFactors>(typeName);
    if (!result.areOf(matrix))
    {
        result.factorise(matrix);
    }
    return result;
}


void Foam::keptFactors::factorise(const lduMatrix& matrix)
{
    diag_ = matrix.diag();
    upper_ = matrix.upper();
    const labelUList& l = matrix.lduAddr().lowerAddr();
    const labelUList& u = matrix.lduAddr().upperAddr();

    // Eigen reads the lower triangle
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(diag_.size() + upper_.size());
    forAll(diag_, celli)
    {
        entries.emplace_back(celli, celli, diag_[celli]);
    }
    forAll(upper_, facei)
    {
        entries.emplace_back(u[facei], l[facei], upper_[facei]);
    }
    Eigen::SparseMatrix<double> lower(diag_.size(), diag_.size());
    lower.setFromTriplets(entries.begin(), entries.end());
    factors_.compute(lower);
    if (factors_.info() != Eigen::Success)
    {
        FatalErrorInFunction
            << "Cholesky's factors of a singular matrix were asked for"
            << exit(FatalError);
    }
}


void Foam::keptFactors::solve
(
    solveScalarField& x,
    const solveScalarField& b
) const
{
    if (b.empty())
    {
        return;
    }
    using vector = Eigen::Matrix<solveScalar, Eigen::Dynamic, 1>;
    Eigen::Map<vector>(x.data(), x.size()) =
        factors_.solve(Eigen::Map<const vector>(b.cdata(), b.size()));
}
