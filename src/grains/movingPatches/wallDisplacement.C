/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallDisplacement.H"

#include "dictionaryInput.H"
#include "IOdictionary.H"
#include "nscd/walls/WallMotion.hpp"
#include "prescribedMotion.H"
#include "wallPieces.H"

namespace
{

using namespace Foam;

template<int D>
class displacementOf
:
    public wallDisplacement
{
    const grainSpace<D> space_;

    const autoPtr<wallMotion<D>> motion_;

    const wallMotions::prescribed<D>* prescribed_;

public:

    displacementOf(const fvMesh& mesh, const dictionary& motion)
    :
        space_(mesh),
        motion_(wallMotion<D>::New(motion, space_)),
        prescribed_
        (
            dynamic_cast<const wallMotions::prescribed<D>*>(motion_.get())
        )
    {
        if (!prescribed_)
        {
            dictionaryInput::badValue
            (
                motion, "type", motion.get<word>("type"),
                "a prescribed motion, where the patch's displacement is of"
                " type 'grainWallMotion'"
            );
        }
    }

    virtual tmp<vectorField> at(const pointField& x, const scalar t) const
    {
        const nscd::RigidMotion<D> motion
        (
            prescribed_->body(), prescribed_->bodyAt(t)
        );
        tmp<vectorField> result(new vectorField(x.size()));
        forAll(x, i)
        {
            const nscd::Vector<D> from(space_.fromSpace(x[i]));
            result.ref()[i] =
                space_.toSpace(nscd::Vector<D>(motion(from) - from));
        }
        return result;
    }
};

}


Foam::autoPtr<Foam::wallDisplacement> Foam::wallDisplacement::New
(
    const fvMesh& mesh,
    const polyPatch& patch
)
{
    const IOdictionary properties
    (
        IOobject
        (
            "grainProperties",
            mesh.time().constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const dictionary& walls = dictionaryInput::subDict(properties, "walls");
    for (const word& name : walls.toc())
    {
        const dictionary& wall = dictionaryInput::subDict(walls, name);
        if
        (
            wall.getOrDefault<word>("type", "none") == "patches"
         && wall.found("motion")
         && wallPieces::selectedPatches(wall, mesh).found(patch.index())
        )
        {
            const dictionary& motion = wall.subDict("motion");
            return
                isPlanar(mesh)
              ? autoPtr<wallDisplacement>(new displacementOf<2>(mesh, motion))
              : autoPtr<wallDisplacement>(new displacementOf<3>(mesh, motion));
        }
    }
    FatalIOErrorInFunction(walls)
        << "Keyword 'walls': no wall with a 'motion' has the patch '"
        << patch.name() << "', whose displacement is of type 'grainWallMotion'"
        << nl << "    allowed: an entry of type 'patches' with this patch and a"
        << " 'motion'" << exit(FatalIOError);

    return nullptr;
}
