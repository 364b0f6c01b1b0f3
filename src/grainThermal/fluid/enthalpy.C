/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "enthalpy.H"

#include "heatDimensions.H"

Foam::enthalpy::enthalpy(const dictionary& dict)
:
    capacity_(dict, "Cp", dimHeatCapacity),
    first_(T0)
{
    capacity_.at(T0);
    c_.append(1);
    H_.append(T0);
}


Foam::label Foam::enthalpy::node(const scalar T) const
{
    if (!(T > 0 && T < 10000))
    {
        FatalErrorInFunction
            << "The fluid has a temperature of " << T << " K" << nl
            << "    allowed: above 0 and below 10000 K, as Cp depends on it"
            << exit(FatalError);
    }
    const label whole = label(T);
    const scalar reference = capacity_.at(T0);
    if (whole < first_)
    {
        const label more = first_ - whole;
        DynamicList<scalar> c(more + c_.size()), H(more + H_.size());
        c.setSize(more);
        H.setSize(more);
        c.append(c_);
        H.append(H_);
        for (label i = more - 1; i >= 0; --i)
        {
            c[i] = capacity_.at(whole + i)/reference;
            H[i] = H[i + 1] - 0.5*(c[i] + c[i + 1]);
        }
        c_.transfer(c);
        H_.transfer(H);
        first_ = whole;
    }
    while (whole + 1 >= first_ + c_.size())
    {
        c_.append(capacity_.at(first_ + c_.size())/reference);
        H_.append(H_.last() + 0.5*(c_[c_.size() - 2] + c_.last()));
    }
    return whole - first_;
}


Foam::scalar Foam::enthalpy::of(const scalar T) const
{
    const label i = node(T);
    const scalar x = T - (first_ + i);
    return H_[i] + x*(c_[i] + 0.5*x*(c_[i + 1] - c_[i]));
}


Foam::scalar Foam::enthalpy::slope(const scalar T) const
{
    const label i = node(T);
    const scalar x = T - (first_ + i);
    return c_[i] + x*(c_[i + 1] - c_[i]);
}


Foam::scalar Foam::enthalpy::value(const scalar H) const
{
    scalar T = T0;
    for (label i = 0; i < 100; ++i)
    {
        const scalar change = (H - of(T))/slope(T);
        T = min(max(T + change, 0.5*T), 2*T);
        if (mag(change) < 1e-14*T)
        {
            break;
        }
    }
    return T;
}
