/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "grainProfiles.H"

#include "addToRunTimeSelectionTable.H"
#include "combineOverRanks.H"
#include "dictionaryInput.H"
#include "exactOverlaps.H"
#include "functionKeywords.H"
#include "tableDirectory.H"

#include <limits>

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(grainProfiles, 0);
    addToRunTimeSelectionTable(functionObject, grainProfiles, dictionary);
}
}


Foam::functionObjects::grainProfiles::grainProfiles
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict)
{
    read(dict);
}


bool Foam::functionObjects::grainProfiles::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    checkFunctionKeywords(dict, {"direction", "number", "fields"});

    const string aVector("a vector that is not zero, as (0 1 0)");
    direction_ = dictionaryInput::getAs<vector>(dict, "direction", aVector);
    if (!(mag(direction_) > 0))
    {
        dictionaryInput::badValue
        (
            dict, "direction", dictionaryInput::written(dict, "direction"),
            aVector
        );
    }
    direction_ /= mag(direction_);
    number_ = dictionaryInput::getLabelOrDefault(dict, "number", 1, 1, 1000000);

    const string names
    (
        "a list of scalar and vector fields of the solver, as (T U); () where it"
        " has no fluid"
    );
    fields_.clear();
    if (dict.found("fields"))
    {
        fields_ = dictionaryInput::getAs<wordList>(dict, "fields", names);
    }
    if (postProcess)
    {
        // The fields come later
        return true;
    }
    for (const word& field : fields_)
    {
        if
        (
            !mesh_.foundObject<volScalarField>("eps")
         || !(
                mesh_.foundObject<volScalarField>(field)
             || mesh_.foundObject<volVectorField>(field)
            )
        )
        {
            dictionaryInput::badValue(dict, "fields", field, names);
        }
    }
    return true;
}


Foam::labelList Foam::functionObjects::grainProfiles::sliceOfCells()
{
    const scalarField along(mesh_.points() & direction_);
    begin_ = gMin(along);
    end_ = gMax(along);

    const scalarField x(mesh_.C().primitiveField() & direction_);
    labelList result(x.size());
    forAll(x, celli)
    {
        const scalar share = (x[celli] - begin_)/(end_ - begin_);
        result[celli] = min(max(label(number_*share), label(0)), number_ - 1);
    }
    return result;
}


Foam::scalarField Foam::functionObjects::grainProfiles::sumOf
(
    const labelList& slice,
    const scalarField& ofCells
) const
{
    scalarField result(number_, Zero);
    forAll(slice, celli)
    {
        result[slice[celli]] += ofCells[celli];
    }
    sumOverRanks(result);
    return result;
}


void Foam::functionObjects::grainProfiles::addGrains
(
    const labelList& slice,
    List<column>& columns
) const
{
    const grainMotion& grains =
        refCast<const grainMotion>(grainView::of(mesh_, name()));
    const overlapList overlaps(exactOverlaps(grains));
    const grainTemperatures* T = grains.temperatures();

    scalarField volume(slice.size(), Zero), heat(slice.size(), Zero);
    vectorField flow(slice.size(), Zero);
    for (label graini = 0; graini < overlaps.nGrains(); ++graini)
    {
        for (const cellOverlap& o : overlaps.of(graini))
        {
            volume[o.cell] += o.volume;
            flow[o.cell] += o.volume*grains.motion(graini).velocity;
            heat[o.cell] += T ? o.volume*T->temperature(graini) : 0;
        }
    }
    const scalarField ofGrains(sumOf(slice, volume));
    columns.append
    (
        column{"packing", ofGrains, sumOf(slice, mesh_.V().field())}
    );
    for (direction i = 0; i < vector::nComponents; ++i)
    {
        columns.append
        (
            column
            {
                word("UGrains_") + vector::componentNames[i],
                sumOf(slice, flow.component(i)),
                ofGrains
            }
        );
    }
    if (T)
    {
        columns.append(column{"TGrains", sumOf(slice, heat), ofGrains});
    }
}


template<class Type>
bool Foam::functionObjects::grainProfiles::addField
(
    const word& name,
    const labelList& slice,
    const scalarField& weight,
    List<column>& columns
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    if (!mesh_.foundObject<fieldType>(name))
    {
        return false;
    }
    const scalarField whole(sumOf(slice, weight));
    const Field<Type>& values =
        mesh_.lookupObject<fieldType>(name).primitiveField();
    for (direction i = 0; i < pTraits<Type>::nComponents; ++i)
    {
        const word part(pTraits<Type>::componentNames[i]);
        columns.append
        (
            column
            {
                pTraits<Type>::nComponents > 1 ? word(name + '_' + part) : name,
                sumOf(slice, weight*values.component(i)),
                whole
            }
        );
    }
    return true;
}


void Foam::functionObjects::grainProfiles::addFields
(
    const labelList& slice,
    List<column>& columns
) const
{
    if (fields_.empty())
    {
        return;
    }
    const scalarField weight
    (
        mesh_.V().field()
       *mesh_.lookupObject<volScalarField>("eps").primitiveField()
    );
    for (const word& field : fields_)
    {
        addField<scalar>(field, slice, weight, columns)
     || addField<vector>(field, slice, weight, columns);
    }
}


bool Foam::functionObjects::grainProfiles::write()
{
    const labelList slice(sliceOfCells());
    const scalarField volume(sumOf(slice, mesh_.V().field()));
    List<column> columns;
    addGrains(slice, columns);
    addFields(slice, columns);
    if (!Pstream::master())
    {
        return true;
    }
    if (!file_)
    {
        file_.reset(new OFstream(tableDirectory(time_, name())/"profiles.csv"));
        file_().precision(12);
        file_() << "time,x,volume";
        for (const column& c : columns)
        {
            file_() << ',' << c.name.c_str();
        }
        file_() << nl;
    }
    for (label i = 0; i < number_; ++i)
    {
        file_()
            << time_.value() << ','
            << begin_ + (i + 0.5)*(end_ - begin_)/number_ << ',' << volume[i];
        for (const column& c : columns)
        {
            file_()
                << ','
                << (
                    c.weight[i] > 0
                  ? c.sum[i]/c.weight[i]
                  : std::numeric_limits<scalar>::quiet_NaN()
                );
        }
        file_() << nl;
    }
    file_().flush();
    return true;
}
