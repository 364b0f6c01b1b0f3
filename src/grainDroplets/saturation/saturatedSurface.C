/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "saturatedSurface.H"

#include "dictionaryInput.H"
#include "keepUnmarked.H"

namespace
{

using namespace Foam;

const dictionary& checkedSurface(const dictionary& dict)
{
    dictionaryInput::checkKeywords
    (
        dict, {"curve", "pressure", "molarMasses", "temperature"}
    );
    return dict;
}

}


Foam::saturatedSurface::saturatedSurface
(
    const dictionary& dict,
    const liquid& properties,
    const label nDroplets,
    const std::function<IOobject(const word&)>& file
)
:
    liquid_(properties),
    curve_
    (
        saturationCurve::New(dictionaryInput::subDict(checkedSurface(dict), "curve"))
    ),
    pressure_(dictionaryInput::getPositive(dict, "pressure", dimPressure)),
    molarMasses_(dictionaryInput::getPositive(dict, "molarMasses", dimless)),
    initial_
    (
        dictionaryInput::getScalar
        (
            dict, "temperature", dimTemperature, SMALL,
            liquid_.boilingTemperature
        )
    ),
    temperature_(file("dropletTemperature")),
    waiting_(file("dropletVapour")),
    flow_(file("dropletVapourFlow")),
    left_(file("dropletHeatLeft"))
{
    checkCurve(dict);
    temperature_.resize(nDroplets, initial_);
    waiting_.resize(nDroplets, 0);
    flow_.resize(nDroplets, 0);
    left_.resize(nDroplets, 0);
}


void Foam::saturatedSurface::checkCurve(const dictionary& dict) const
{
    const scalar ofStart = curve_->pressure(initial_);
    if (!(ofStart < pressure_))
    {
        dictionaryInput::badValue
        (
            dict, "pressure", name(pressure_),
            "more than the vapour's of 'curve' at 'temperature', "
          + name(ofStart) + " Pa"
        );
    }
    const scalar boiling = liquid_.boilingTemperature;
    const scalar ofBoiling = curve_->pressure(boiling);
    if (mag(ofBoiling/pressure_ - 1) > 0.1)
    {
        WarningInFunction
            << "The curve of " << dict.name() << " has " << ofBoiling
            << " Pa at boilingTemperature, " << boiling << " K, and 'pressure' is "
            << pressure_ << " Pa: are its coefficients for the units of doc/theory, "
            << "eq. 10.10?" << endl;
    }
}


Foam::scalar Foam::saturatedSurface::share(const scalar T) const
{
    const scalar moles = curve_->pressure(T)/pressure_;
    if (moles >= 1)
    {
        return most;
    }
    return min(molarMasses_*moles/(molarMasses_*moles + 1 - moles), most);
}


Foam::scalar Foam::saturatedSurface::slope(const scalar T) const
{
    const scalar dT = 1e-3;
    return (share(T + dT) - share(T - dT))/(2*dT);
}


Foam::scalar Foam::saturatedSurface::diffusing
(
    const scalar share,
    const scalar psi
)
{
    const scalar b = 1/flow(share, psi);
    const scalar x = (1 - share)/b - 1;
    // Its limit, where the logarithm has no digits
    return psi <= share || x < 1e-6 ? 1 : std::log1p(x)/x;
}


Foam::scalar Foam::saturatedSurface::flow(const scalar share, const scalar psi)
{
    return 1/(1 - min(max(share, psi), most));
}


Foam::scalar Foam::saturatedSurface::evaporate
(
    const label i,
    const scalar mass,
    const scalar liquidMass,
    const scalar stiffness,
    scalar& heat
)
{
    // Without, the temperature of a droplet that has little liquid left swings
    constexpr scalar damping = 0.5;
    // Of a change in which the vapour at the surface becomes half as much again
    constexpr scalar largest = 0.5;

    const scalar capacity = liquidMass*liquid_.Cp;
    scalar& T = temperature_[i];
    waiting_[i] = 0;
    flow_[i] = 0;

    // Heat that it does not take now waits, which is stable at any step
    const scalar excess = heat - mass*liquid_.latentHeat;
    const scalar limit = largest*share(T)/max(slope(T), VSMALL);
    scalar dT =
        (excess - (1 - damping)*left_[i])/(capacity + stiffness);
    dT = min(max(dT, -limit), limit);
    scalar boiled = 0;
    if (T + dT > liquid_.boilingTemperature)
    {
        const scalar most = liquid_.boilingTemperature - T;
        boiled = (dT - most)*capacity/liquid_.latentHeat;
        dT = most;
    }
    T += dT;
    heat = excess - dT*capacity - boiled*liquid_.latentHeat;
    left_[i] = heat;
    return mass + boiled;
}


void Foam::saturatedSurface::follow
(
    const List<liquidDroplets::fate>& fates,
    const label nDroplets
)
{
    scalarField T(nDroplets, Zero), waiting(T), flow(T), left(T), known(T);
    forAll(fates, i)
    {
        T[fates[i].now] += fates[i].share*temperature_[i];
        known[fates[i].now] += fates[i].share;
        waiting[fates[i].now] += waiting_[i];
        flow[fates[i].now] += flow_[i];
        left[fates[i].now] += left_[i];
    }
    // The rest of it has come just now
    T += (1 - known)*initial_;
    temperature_ = T;
    waiting_ = waiting;
    flow_ = flow;
    left_ = left;
}


void Foam::saturatedSurface::remove(const std::vector<bool>& gone)
{
    keepUnmarked(temperature_, gone);
    keepUnmarked(waiting_, gone);
    keepUnmarked(flow_, gone);
    keepUnmarked(left_, gone);
}
