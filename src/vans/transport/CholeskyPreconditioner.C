/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "CholeskyPreconditioner.H"

namespace Foam
{
    defineTypeNameAndDebug(CholeskyPreconditioner, 0);

    lduMatrix::preconditioner::addsymMatrixConstructorToTable
    <
        CholeskyPreconditioner
    >
        addCholeskyPreconditionerSymMatrixConstructorToTable_;
}
