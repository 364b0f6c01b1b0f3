/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeFields.H"

#include "directFvPatchFieldMapper.H"

Foam::timeFields::timeFields(const fvMesh& old, const fvMesh& fresh)
:
    old_(old),
    fresh_(fresh),
    objects_(old, old.time().timeName())
{
    for (const char* name : {"U", "p_rgh", "T"})
    {
        if (!objects_.found(name))
        {
            FatalErrorInFunction
                << "There is no field " << name << " at the last time, "
                << old.time().timePath() << nl
                << "    allowed: a last time with the fields of grainDropletFoam;"
                << " of a case that is decomposed, after reconstructPar"
                << exit(FatalError);
        }
    }
}


template<class Type>
void Foam::timeFields::map
(
    const conservativeMap& map,
    const scalarField& oldShare,
    const scalarField& freshShare
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    for (const word& name : objects_.sortedNames(fieldType::typeName))
    {
        // The first step on a new mesh is one of Euler's
        if (name.endsWith("_0"))
        {
            outdated_.append(objects_[name]->objectPath());
            continue;
        }
        const fieldType x(*objects_[name], old_);
        const Field<Type> values(map.map(x, fresh_.nCells()));
        const IOobject io(name, fresh_.time().timeName(), fresh_);
        const DimensionedField<Type, volMesh> inside
        (
            io, fresh_, x.dimensions(), values
        );

        // Faces of patches are as they were
        PtrList<fvPatchField<Type>> patches(fresh_.boundary().size());
        forAll(patches, patchi)
        {
            const labelList same(identity(fresh_.boundary()[patchi].size()));
            patches.set
            (
                patchi,
                fvPatchField<Type>::New
                (
                    x.boundaryField()[patchi], fresh_.boundary()[patchi], inside,
                    directFvPatchFieldMapper(same)
                )
            );
        }
        mapped_.append
        (
            new fieldType(io, fresh_, x.dimensions(), values, patches)
        );

        const scalarField& V = old_.V();
        const scalarField& freshV = fresh_.V();
        Info<< name << ": carried by fluid "
            << gSum(oldShare*V*x.primitiveField()) << " before, "
            << gSum(freshShare*freshV*values) << " after" << nl;
    }
}


void Foam::timeFields::map
(
    const conservativeMap& map,
    const scalarField& oldShare,
    const scalarField& freshShare
)
{
    this->map<scalar>(map, oldShare, freshShare);
    this->map<vector>(map, oldShare, freshShare);
    this->map<sphericalTensor>(map, oldShare, freshShare);
    this->map<symmTensor>(map, oldShare, freshShare);
    this->map<tensor>(map, oldShare, freshShare);

    forAllConstIters(objects_, iter)
    {
        const word& type = iter()->headerClassName();
        if
        (
            type.startsWith("surface") || type.startsWith("point")
         || type.endsWith("::Internal")
        )
        {
            outdated_.append(iter()->objectPath());
        }
    }
}


void Foam::timeFields::write() const
{
    for (const regIOobject& field : mapped_)
    {
        field.write();
    }
    for (const fileName& file : outdated_)
    {
        rm(file);
    }
}
