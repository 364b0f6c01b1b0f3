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

namespace
{

using namespace Foam;

//- Entries of the lower triangle, which Eigen reads
class entries
{
    DynamicList<label> rows_;
    DynamicList<label> columns_;
    DynamicList<scalar> values_;

public:

    void add(const label row, const label column, const scalar value)
    {
        if (row >= column)
        {
            rows_.append(row);
            columns_.append(column);
            values_.append(value);
        }
    }

    //- Those of all ranks, on the master, of a matrix of so many rows
    Eigen::SparseMatrix<double> gathered(const label size) const
    {
        const globalIndex all(values_.size());
        labelList rows;
        labelList columns;
        scalarList values;
        all.gather(rows_, rows);
        all.gather(columns_, columns);
        all.gather(values_, values);

        std::vector<Eigen::Triplet<double>> triplets;
        triplets.reserve(values.size());
        forAll(values, i)
        {
            triplets.emplace_back(rows[i], columns[i], values[i]);
        }
        Eigen::SparseMatrix<double> result(size, size);
        result.setFromTriplets(triplets.begin(), triplets.end());
        return result;
    }
};


//- Cells on the other side of the faces of each coupled boundary, out of all ranks'
List<labelField> neighbours
(
    const lduInterfaceFieldPtrsList& interfaces,
    const labelUList& cells
)
{
    const auto commsType = Pstream::commsTypes::nonBlocking;
    const label start = Pstream::nRequests();
    forAll(interfaces, i)
    {
        if (interfaces.set(i))
        {
            interfaces[i].interface().initInternalFieldTransfer(commsType, cells);
        }
    }
    Pstream::waitRequests(start);

    List<labelField> result(interfaces.size());
    forAll(interfaces, i)
    {
        if (interfaces.set(i))
        {
            result[i] =
                interfaces[i].interface().internalFieldTransfer(commsType, cells);
        }
    }
    return result;
}

}


Foam::keptFactors::keptFactors(const objectRegistry& mesh)
:
    regIOobject(IOobject(typeName, mesh.time().timeName(), mesh))
{}


const Foam::keptFactors& Foam::keptFactors::of(const lduMatrix::solver& solver)
{
    const objectRegistry& mesh = solver.matrix().mesh().thisDb();
    if (!mesh.foundObject<keptFactors>(typeName))
    {
        regIOobject::store(new keptFactors(mesh));
    }
    keptFactors& result = mesh.lookupObjectRef<keptFactors>(typeName);

    List<scalarField> coupled(solver.interfaces().size());
    forAll(coupled, i)
    {
        if (solver.interfaces().set(i))
        {
            coupled[i] = solver.interfaceBouCoeffs()[i];
        }
    }
    if (!result.areOf(solver.matrix(), coupled))
    {
        result.coupled_ = coupled;
        result.factorise(solver.matrix(), solver.interfaces());
    }
    return result;
}


bool Foam::keptFactors::areOf
(
    const lduMatrix& matrix,
    const List<scalarField>& coupled
) const
{
    return returnReduce
    (
        matrix.diag() == diag_
     && matrix.upper() == upper_
     && coupled == coupled_,
        andOp<bool>()
    );
}


void Foam::keptFactors::factorise
(
    const lduMatrix& matrix,
    const lduInterfaceFieldPtrsList& interfaces
)
{
    diag_ = matrix.diag();
    upper_ = matrix.upper();
    cells_.reset(diag_.size());
    const labelUList& l = matrix.lduAddr().lowerAddr();
    const labelUList& u = matrix.lduAddr().upperAddr();

    labelList own(diag_.size());
    entries lower;
    forAll(diag_, celli)
    {
        own[celli] = cells_.toGlobal(celli);
        lower.add(own[celli], own[celli], diag_[celli]);
    }
    forAll(upper_, facei)
    {
        lower.add(own[u[facei]], own[l[facei]], upper_[facei]);
    }
    const List<labelField> other(neighbours(interfaces, own));
    forAll(other, i)
    {
        forAll(other[i], facei)
        {
            const label celli = interfaces[i].interface().faceCells()[facei];
            lower.add(own[celli], other[i][facei], -coupled_[i][facei]);
        }
    }

    const auto whole = lower.gathered(cells_.size());
    if (Pstream::master())
    {
        factors_.compute(whole);
        if (factors_.info() != Eigen::Success)
        {
            FatalErrorInFunction
                << "Cholesky's factors of a singular matrix were asked for"
                << exit(FatalError);
        }
    }
}


void Foam::keptFactors::solve
(
    solveScalarField& x,
    const solveScalarField& b
) const
{
    using vector = Eigen::Matrix<solveScalar, Eigen::Dynamic, 1>;
    solveScalarField all;
    cells_.gather(b, all);
    if (Pstream::master())
    {
        Eigen::Map<vector> values(all.data(), all.size());
        values = factors_.solve(values).eval();
    }
    cells_.scatter(all, x);
}
