/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainFluidExchange.H"

#include "fvcGrad.H"

void Foam::grainFluidExchange::setKnownForce(const volVectorField& U)
{
    const overlapList& overlaps = grains_.overlaps();
    const scalar deltaT = mesh_.time().deltaTValue();

    e_.resize(overlaps.size());
    e_ = Zero;
    if (addedMass_ == 0 && lift_.empty())
    {
        return;
    }

    const volTensorField gradU(fvc::grad(U));

    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        const grainMotion::twist motion(grains_.motion().motion(graini));
        const scalar d = grains_.fluidDiameter(graini);

        for
        (
            label k = overlaps.start[graini];
            k < overlaps.start[graini + 1];
            ++k
        )
        {
            const label celli = overlaps.cell[k];
            const tensor& grad = gradU[celli];
            const vector w(U[celli] - motion.at(overlaps.arm[k]));

            e_[k] = -dragOfAddedMass()*(w - deltaT*(U[celli] & grad));

            const vector vorticity
            (
                grad.yz() - grad.zy(),
                grad.zx() - grad.xz(),
                grad.xy() - grad.yx()
            );
            for (const liftLaw& law : lift_)
            {
                e_[k] += law.force
                (
                    w, vorticity, motion.spin, d, rho_.value(), mu_.value()
                );
            }
        }
    }
}
