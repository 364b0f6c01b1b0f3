/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainDynamics.H"

#include "grainChecks.H"
#include "nscd/contact/LeveredContact.hpp"
#include "nscd/dynamics/RigidMotion.hpp"

#include <numeric>

template<int D>
Foam::label Foam::grainDynamics<D>::countOf(const dictionary& source) const
{
    const nscd::Grains<D> some(properties_.grains(source));
    const grainChecks<D> checks(properties_, some, source, source.dictName());
    checks.requireInside();
    checks.requireNoOverlap();
    return label(some.size());
}


template<int D>
void Foam::grainDynamics<D>::add
(
    const dictionary& source,
    const label firstId
)
{
    nscd::Grains<D> some(properties_.grains(source));
    std::iota(some.id.begin(), some.id.end(), firstId);
    add(some, source);
}


template<int D>
void Foam::grainDynamics<D>::merge
(
    const label graini,
    const label grainj,
    const scalar radius
)
{
    const nscd::Grains<D>& all = grains();
    const label i = all.mass[graini] < all.mass[grainj] ? grainj : graini;
    const label j = graini + grainj - i;

    nscd::Grains<D> one;
    one.resize(1);
    one.id[0] = all.id[i];
    one.radius[0] = radius;
    one.mass[0] = all.mass[i] + all.mass[j];
    one.material[0] = all.material[i];
    one.temperature[0] = all.temperature[i];
    one.orientation[0] = all.orientation[i];

    // Of the second, seen from the first
    nscd::Vector<D> arm(all.position[j] - all.position[i]);
    const auto& period = properties_.contact().period;
    for (int d = 0; d < D; ++d)
    {
        if (period[d] > 0)
        {
            arm[d] -= period[d]*std::round(arm[d]/period[d]);
        }
    }
    const scalar share = all.mass[j]/one.mass[0];
    const nscd::Vector<D> slip(all.velocity[j] - all.velocity[i]);
    one.position[0] = all.position[i] + share*arm;
    one.velocity[0] = all.velocity[i] + share*slip;

    const nscd::Spin<D> turning
    (
        nscd::angularMomentum(all, i, all.spin[i])
      + nscd::angularMomentum(all, j, all.spin[j])
      + (1 - share)*all.mass[j]*nscd::momentOf(arm, slip)
    );
    one.spin[0] = nscd::spinOf<D>(one, 0, one.orientation[0], turning);

    std::vector<bool> gone(all.size(), false);
    gone[i] = gone[j] = true;
    remove(gone);
    add(one, properties_.dict());
}


template Foam::label Foam::grainDynamics<2>::countOf(const dictionary&) const;
template Foam::label Foam::grainDynamics<3>::countOf(const dictionary&) const;
template void Foam::grainDynamics<2>::add(const dictionary&, const label);
template void Foam::grainDynamics<3>::add(const dictionary&, const label);
template void Foam::grainDynamics<2>::merge
(
    const label, const label, const scalar
);
template void Foam::grainDynamics<3>::merge
(
    const label, const label, const scalar
);
