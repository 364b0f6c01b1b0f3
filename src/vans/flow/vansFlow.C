/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2011-2016 OpenFOAM Foundation
    SPDX-FileCopyrightText: 2019 OpenCFD Ltd.
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vansFlow.H"

#include "crossingGrains.H"
#include "dictionaryInput.H"
#include "findRefCell.H"
#include "fvc.H"
#include "referenceHeight.H"
#include "registeredLaminar.H"
#include "timeScheme.H"
#include "writeForALook.H"

namespace
{

using namespace Foam;

//- Fatal if it is a porosity whose law asks for a viscosity that is not there
void requireViscosity(const fv::options& options, const fv::option& source)
{
    const word law("DarcyForchheimer");
    if (source.coeffs().getOrDefault<word>("type", word::null) != law)
    {
        return;
    }
    const dictionary& coeffs = source.coeffs().optionalSubDict(law + "Coeffs");
    const fvMesh& mesh = source.mesh();
    if
    (
        !mesh.foundObject<volScalarField>(coeffs.getOrDefault<word>("nu", "nu"))
     && !mesh.foundObject<volScalarField>
        (
            coeffs.getOrDefault<word>("mu", "thermo:mu")
        )
    )
    {
        FatalIOErrorInFunction(options)
            << "Entry '" << source.name().c_str() << "' (" << law << ") needs the"
            << " fluid's viscosity as OpenFOAM's transport model has it" << nl
            << "    allowed: transportModel Newtonian; in"
            << " constant/transportProperties" << exit(FatalIOError);
    }
}


//- Fatal if it is the weight of the fluid, which p_rgh leaves out and p has: grains would float
//  with twice their buoyancy
void refuseWeight(const fv::options& options, const fv::option& source)
{
    if (source.type() == "buoyancyForce")
    {
        FatalIOErrorInFunction(options)
            << "Entry '" << source.name().c_str() << "' has the type buoyancyForce: the"
            << " weight of the fluid is in its equations without it" << nl
            << "    allowed: other sources of momentum; gravity in constant/g"
            << exit(FatalIOError);
    }
}


//- Fatal if it is the acceleration of a frame, which grains would not have
void refuseFrame(const fv::options& options, const fv::option& source)
{
    if (source.type() == "tabulatedAccelerationSource")
    {
        FatalIOErrorInFunction(options)
            << "Entry '" << source.name().c_str() << "' has the type "
            << source.type() << ": the frame of the case is at rest" << nl
            << "    allowed: a mesh that moves, by constant/dynamicMeshDict; of a"
            << " steady acceleration, gravity less it in constant/g"
            << exit(FatalIOError);
    }
}


//- Fatal if one of them acts on no velocity
void requireSourcesOf(const volVectorField& U, const fv::options& options)
{
    for (const fv::option& source : static_cast<const PtrList<fv::option>&>(options))
    {
        if (source.active() && source.applyToField(U.name()) == -1)
        {
            FatalIOErrorInFunction(options)
                << "Entry '" << source.name().c_str() << "' has nothing to do"
                << " with " << U.name() << nl
                << "    allowed: sources and constraints of " << U.name()
                << ", those of other fields are not there; active no"
                << exit(FatalIOError);
        }
        if (source.active())
        {
            refuseWeight(options, source);
            refuseFrame(options, source);
            requireViscosity(options, source);
        }
    }
}


// OpenFOAM's kinds of options are in a library that takes longer to load than
// all others together: only where a case has the dictionary
fv::options& optionsOf(const volVectorField& U)
{
    const fvMesh& mesh = U.mesh();
    const Time& time = mesh.time();
    for (const word& folder : {time.constant(), time.system()})
    {
        IOobject io(fv::options::typeName, folder, mesh);
        if (io.typeHeaderOk<IOdictionary>(false))
        {
            const_cast<Time&>(time).libs().open(fileName("libfvOptions.so"));
        }
    }
    fv::options& options = fv::options::New(mesh);
    requireSourcesOf(U, options);
    return options;
}

} // End namespace

Foam::vansFlow::vansFlow
(
    vansFields& fields,
    const carrier& fluid,
    const effectiveViscosity& viscosity,
    const exchangeFields& grains,
    resolvedTerm& resolved,
    const dimensionedVector& g,
    const dictionary& control
)
:
    mesh_(fields.U.mesh()),
    fields_(fields),
    fluid_(fluid),
    viscosity_(viscosity),
    grains_(grains),
    resolved_(resolved),
    laminar_(registeredLaminar::New(fluid, fields.U, fields.phiU)),
    control_(control),
    g_(g),
    gh_(heightTimesGravity()),
    p_
    (
        IOobject
        (
            "p",
            mesh_.time().timeName(),
            mesh_,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        fields.p_rgh + fluid.rhoWeight()*gh_()
    ),
    options_(optionsOf(fields.U)),
    pRefCell_(0),
    pRefValue_(0),
    areFluxesOfU_(!fields.areOfStep),
    isFirst_(!fields.areOfStep),
    gradP_
    (
        IOobject("gradP", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedVector(dimPressure/dimLength, Zero)
    )
{
    // Before the first step, for its check of ddtSchemes
    isSecondOrderInTime(mesh_);

    setRefCell(p_, fields.p_rgh, control, pRefCell_, pRefValue_);
    mesh_.setFluxRequired(fields.p_rgh.name());
}


Foam::vansFlow::~vansFlow() = default;


Foam::volScalarField* Foam::vansFlow::heightTimesGravity() const
{
    return new volScalarField("gh", (g_ & mesh_.C()) - ghRef(mesh_, g_));
}


void Foam::vansFlow::startStep()
{
    isFirst_ = !fields_.areOfStep;
    // A body whose own faces have changed begins with one flow all around it
    if
    (
        keptFaces_.valid()
     && gMax(((1 - keptFaces_())*resolved_.lockedFaces())().primitiveField()) > 0.5
    )
    {
        keptFaces_() == dimensionedScalar(dimless, Zero);
        for (surfaceScalarField* flux : fields_.fluxes())
        {
            remakeFlux(fvc::flux(fields_.U), flux->oldTime());
        }
    }
    for (surfaceScalarField* flux : fields_.fluxes())
    {
        flux->oldTime();
        if (areFluxesOfU_)
        {
            surfaceScalarField ofSurface(flux->oldTime());
            resolved_.setSurfaceFlux(ofSurface);
            if (keptFaces_.valid())
            {
                remakeFlux(ofSurface, flux->oldTime());
            }
            else
            {
                flux->oldTime() = ofSurface;
            }
        }
    }
    if (isSecondOrderInTime(mesh_))
    {
        // The inertia of a face has that of the last two steps
        fields_.phiMomentum.oldTime().oldTime();
    }
    areFluxesOfU_ = false;
    keptFaces_.clear();
    // Faces of resolved grains see none, and none what is not of each cell alone
    tmp<fvVectorMatrix> bySources(sources());
    const bool areSeen =
        bySources.valid()
     && !resolved_.isActive()
     && !bySources().hasUpper()
     && !bySources().hasLower();
    step_.reset
    (
        new stepCoefficients
        (
            grains_, resolved_, fluid_, viscosity_, fields_,
            areSeen ? &bySources() : nullptr
        )
    );
    if (areSeen)
    {
        bySources.clear();
    }
    const surfaceScalarField share(upwindShare());
    const tmp<volVectorField> asForce(convectionAsForce(share));
    if (asForce.valid())
    {
        step_->addForce(-asForce());
    }
    setMomentumEquation(bySources, share, asForce);
}


Foam::tmp<Foam::surfaceScalarField> Foam::vansFlow::relativePhiU() const
{
    return
        mesh_.moving()
      ? fields_.phiU - mesh_.phi()
      : tmp<surfaceScalarField>(fields_.phiU);
}


Foam::tmp<Foam::surfaceScalarField> Foam::vansFlow::fluidFlux
(
    const volScalarField& eps
) const
{
    surfaceScalarField open("open", fvc::interpolate(eps));
    forAll(open.boundaryField(), patchi)
    {
        // The velocity is that of the mixture
        if
        (
            !mesh_.boundary()[patchi].coupled()
         && !grains_.freePatches.found(patchi)
        )
        {
            open.boundaryFieldRef()[patchi] = 1;
        }
    }
    tmp<surfaceScalarField> tflux
    (
        resolved_.fluxOfVolume(open, relativePhiU(), fields_.phiOpen)
    );
    forAllConstIters(grains_.crossing, iter)
    {
        fvsPatchScalarField& flux = tflux.ref().boundaryFieldRef()[iter.key()];
        flux -= crossingGrains::limited(iter.val(), flux);
    }
    return tflux;
}


void Foam::vansFlow::checkFinite() const
{
    const volVectorField& U = fields_.U;
    const volScalarField& p = fields_.p_rgh;

    label bad = -1;
    forAll(U, celli)
    {
        if (!std::isfinite(mag(U[celli])) || !std::isfinite(p[celli]))
        {
            bad = celli;
            break;
        }
    }
    if (returnReduce(bad, maxOp<label>()) < 0)
    {
        return;
    }

    const Time& runTime = mesh_.time();
    const bool isWritten =
        writeForALook(runTime, "The fluid's solution is not finite");

    if (bad >= 0)
    {
        const scalarField sumPhi
        (
            fvc::surfaceSum(mag(fields_.phiU.oldTime()))().primitiveField()
        );
        FatalErrorInFunction
            << "The fluid's solution is not finite at time "
            << runTime.timeName() << ", first in cell " << bad << " at "
            << mesh_.C()[bad] << ": U = " << U[bad] << ", p_rgh = " << p[bad]
            << nl << "    the Courant number was "
            << 0.5*max(sumPhi/mesh_.V().field())*runTime.deltaTValue()
            << (isWritten ? "; the fields are written for a look" : "")
            << "; a run continues from the last complete time"
            << exit(FatalError);
    }
}
