/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fluidInput.H"

#include "dictionaryInput.H"
#include "functionEntries.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"

void Foam::checkTransportProperties
(
    const dictionary& dict,
    const wordList& others
)
{
    const word Newtonian("Newtonian");
    const word model(dict.getOrDefault<word>("transportModel", Newtonian));
    wordList allowed
    ({
        "FoamFile", "rho", "transportModel", model + "Coeffs", "HeleShaw",
        "scalars", "Sct"
    });
    allowed.append(dictionaryInput::functionKeywords(dict, others));
    if (dict.found("mu") && others.found("mu"))
    {
        for (const word& name : {word("transportModel"), word("nu")})
        {
            if (dict.found(name))
            {
                dictionaryInput::badValue
                (
                    dict, name, dictionaryInput::written(dict, name),
                    "nothing, as there is mu"
                );
            }
        }
    }
    else if (model == Newtonian)
    {
        dictionaryInput::getPositive
        (
            dict.optionalSubDict(model + "Coeffs"), "nu", dimViscosity
        );
        allowed.append("nu");
    }
    dictionaryInput::checkKeywords(dict, allowed);
}


void Foam::checkSolvers(const dictionary& fvSolution)
{
    const dictionary& all = dictionaryInput::subDict(fvSolution, "solvers");
    for (const entry& e : all)
    {
        if (!e.isDict())
        {
            continue;
        }
        dictionaryInput::getLabelOrDefault(e.dict(), "maxIter", 1, 1);
        const scalar relTol =
            dictionaryInput::getScalarOrDefault(e.dict(), "relTol", dimless, 0, 0);
        if (relTol >= 1)
        {
            dictionaryInput::badValue
            (
                e.dict(), "relTol", dictionaryInput::written(e.dict(), "relTol"),
                "a value from 0 to less than 1, with which the equation is solved"
            );
        }
    }
}


void Foam::refuseRelaxation(const dictionary& fvSolution)
{
    const dictionary* factors = fvSolution.findDict("relaxationFactors");
    if (!factors)
    {
        return;
    }
    // As OpenFOAM has them, and as it once had them
    for
    (
        const dictionary* dict
      : {factors, factors->findDict("fields"), factors->findDict("equations")}
    )
    {
        if (!dict)
        {
            continue;
        }
        for (const entry& e : *dict)
        {
            if (!e.isDict())
            {
                dictionaryInput::getScalarOrDefault
                (
                    *dict, e.keyword(), dimless, 1, 1, 1
                );
            }
        }
    }
}


void Foam::requireDivScheme(const fvMesh& mesh, const word& scheme)
{
    const dictionary& dict =
        dictionaryInput::subDict(mesh.schemesDict(), "divSchemes");
    const bool hasDefault =
        dict.found("default", keyType::LITERAL)
     && dictionaryInput::written(dict, "default") != "none";
    if (!hasDefault && !dict.found(scheme, keyType::REGEX))
    {
        dictionaryInput::missing
        (
            dict, scheme,
            "a scheme, as in etc/caseDicts, or a 'default' other than none"
        );
    }
}


void Foam::refuseBounded(const fvMesh& mesh, const word& scheme)
{
    const dictionary& dict =
        dictionaryInput::subDict(mesh.schemesDict(), "divSchemes");
    const entry* found = dict.findEntry(scheme, keyType::REGEX);
    const word name(found ? scheme : word("default"));
    if (!found)
    {
        found = dict.findEntry(name, keyType::LITERAL);
    }
    if (found && found->isStream() && found->stream().size())
    {
        const token& first = found->stream()[0];
        if (first.isWord() && first.wordToken() == "bounded")
        {
            dictionaryInput::badValue
            (
                dict, name, dictionaryInput::written(dict, name),
                "the scheme without 'bounded': what it takes away is not in the"
                " equation, and momentum or content would be lost"
            );
        }
    }
}


void Foam::checkPISO
(
    const dictionary& fvSolution,
    const wordList& others,
    const word& name
)
{
    const dictionary& dict = dictionaryInput::subDict(fvSolution, name);
    checkSolvers(fvSolution);
    refuseRelaxation(fvSolution);

    wordList allowed
    ({
        "nCorrectors", "nNonOrthogonalCorrectors", "momentumPredictor",
        "closeMomentum", "pRefCell", "pRefPoint", "pRefValue"
    });
    allowed.append(others);
    dictionaryInput::checkKeywords(dict, allowed);

    dictionaryInput::getLabelOrDefault(dict, "nCorrectors", 1, 1);
    dictionaryInput::getLabelOrDefault(dict, "nNonOrthogonalCorrectors", 0, 0);
    dictionaryInput::getWordOrDefault(dict, "closeMomentum", "no", {"yes", "no"});
}


void Foam::checkFluidInput
(
    const fvMesh& mesh,
    const dictionary& transportProperties,
    const wordList& others
)
{
    checkTransportProperties(transportProperties, others);
    checkPISO(mesh.solutionDict());
    refuseFiles(mesh.time(), {"MRFProperties"});
}


void Foam::requireDictionaries(const Time& runTime, const wordList& files)
{
    for (const word& dir : {runTime.constant(), runTime.system()})
    {
        for (const word& name : files)
        {
            const fileName file(runTime.globalPath()/dir/name);
            if (isFile(file))
            {
                IOobject io(name, dir, runTime);
                if (!io.typeHeaderOk<IOdictionary>(true, false))
                {
                    FatalErrorInFunction
                        << "The file " << file << " is no dictionary of OpenFOAM:"
                        << " its header cannot be read" << nl
                        << "    allowed: a file that begins with FoamFile { ..."
                        << " class dictionary; ... }, or a case without it"
                        << exit(FatalError);
                }
            }
        }
    }
}


void Foam::refuseFiles(const Time& runTime, const wordList& files)
{
    for (const word& dir : {runTime.constant(), runTime.system()})
    {
        for (const word& name : files)
        {
            const fileName file(runTime.globalPath()/dir/name);
            if (isFile(file))
            {
                FatalErrorInFunction
                    << "What the file " << file << " asks for is not in this"
                    << " solver, which would pass over it" << nl
                    << "    allowed: a case without " << name
                    << exit(FatalError);
            }
        }
    }
}
