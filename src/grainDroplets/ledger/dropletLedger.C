/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dropletLedger.H"


Foam::dropletLedger::dropletLedger
(
    const liquidDroplets& droplets,
    const dropletTerm& term,
    const evaporation& vapour
)
:
    droplets_(droplets),
    term_(term),
    vapour_(vapour),
    progress_(droplets.system().mesh().time())
{}


void Foam::dropletLedger::endStep(const vectorField& force)
{
    const grainSystem& system = droplets_.system();
    const grainMotion& motion = system.motion();

    scalar liquid = 0, inside = 0, worst = 0;
    scalarField error(droplets_.size());
    forAll(error, i)
    {
        const scalar volume = system.volume(i);
        liquid += droplets_.mass(i);
        inside += droplets_.inside(i);
        error[i] = mag
        (
            volume - droplets_.mass(i)/droplets_.properties().density
          - droplets_.inside(i)
        )/volume;
        worst = max(worst, error[i]);
    }
    Info<< nl
        << "Droplets  " << droplets_.size() << ", liquid " << liquid
        << " kg, grains inside " << inside << " m^3, vapour "
        << sum(vapour_.lost()) << " kg, heat through the surface "
        << sum(vapour_.fromFluid()) << " J, from grains "
        << sum(vapour_.fromGrains()) << " J, volume error " << worst << endl;

    if (!Pstream::master())
    {
        return;
    }
    if (!file_)
    {
        file_ = progress_.newFile
        (
            "droplets", "droplets.csv",
            "time,droplet,x,y,z,vx,vy,vz,radius,temperature,liquid,inside,fromFluid,"
            "fromGrains,waiting,vapour,diffused,fx,fy,fz,tx,ty,tz,weight,volumeError"
        );
    }
    const char c = ',';
    forAll(error, i)
    {
        const point x(motion.centre(i));
        const vector v(motion.velocity(i));
        const vector thrust(term_.thrust(i));
        file_()
            << system.mesh().time().value() << c << motion.id(i)
            << c << x.x() << c << x.y() << c << x.z()
            << c << v.x() << c << v.y() << c << v.z()
            << c << motion.radius(i) << c << vapour_.temperature(i)
            << c << droplets_.mass(i)
            << c << droplets_.inside(i) << c << vapour_.fromFluid()[i]
            << c << vapour_.fromGrains()[i] << c << vapour_.waiting(i)
            << c << vapour_.lost()[i]
            << c << vapour_.diffused(i)
            << c << force[i].x() << c << force[i].y() << c << force[i].z()
            << c << thrust.x() << c << thrust.y() << c << thrust.z()
            << c << droplets_.mass(i)*mag(motion.g()) << c << error[i] << nl;
    }
    file_() << flush;
}
