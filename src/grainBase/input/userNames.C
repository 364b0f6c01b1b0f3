/*---------------------------------------------------------------------------*\
    SPDX-FileCopyrightText: 2026 The grainFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "userNames.H"

#include "Pstream.H"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <regex>
#include <sstream>

namespace
{

using namespace Foam;

struct textOfDictionary
{
    std::string own;
    std::string included;
};

std::string withoutComments(const fileName& file)
{
    std::stringstream stream;
    stream << std::ifstream(file).rdbuf();
    const std::string text(stream.str());

    std::string result;
    for (std::size_t i = 0; i < text.size();)
    {
        const bool isLine = text.compare(i, 2, "//") == 0;
        if (isLine || text.compare(i, 2, "/*") == 0)
        {
            const std::size_t end = text.find(isLine ? "\n" : "*/", i + 2);
            i = end == std::string::npos ? text.size() : end + (isLine ? 0 : 2);
        }
        else
        {
            result += text[i++];
        }
    }
    return result;
}


// Texts of the files that a text includes, one after the other
std::string includedBy(const std::string& text, const fileName& dir, const int depth = 0)
{
    static const std::regex directive
    (
        R"(#(?:s?include|includeIfPresent)\s+"([^"]+)\")"
    );
    std::string result;
    for
    (
        std::sregex_iterator found(text.begin(), text.end(), directive), end;
        found != end && depth < 10;
        ++found
    )
    {
        fileName file((*found)[1].str());
        file.expand();
        if (!file.isAbsolute())
        {
            file = dir/file;
        }
        const std::string more(withoutComments(file));
        result += more + '\n' + includedBy(more, file.path(), depth + 1);
    }
    return result;
}


textOfDictionary textOf(const dictionary& dict)
{
    const fileName file(dict.topDict().name());
    textOfDictionary result;
    result.own = withoutComments(file);
    result.included = includedBy(result.own, file.path());
    return result;
}


// Does a $ name it, alone or in a path, as in $name, ${name}, $:walls.name?
bool isUsed(const std::string& text, const std::string& name)
{
    static const std::regex reference(R"(\$[\w.:{}!^/]+)");
    static const std::regex part(R"(\w+)");
    for
    (
        std::sregex_iterator found(text.begin(), text.end(), reference), end;
        found != end;
        ++found
    )
    {
        const std::string path(found->str());
        for
        (
            std::sregex_iterator one(path.begin(), path.end(), part);
            one != end;
            ++one
        )
        {
            if (one->str() == name)
            {
                return true;
            }
        }
    }
    return false;
}


bool hasWord(const std::string& text, const std::string& name)
{
    static const std::regex wordChars(R"(\w+)");
    const std::sregex_iterator begin(text.begin(), text.end(), wordChars), end;
    return std::any_of
    (
        begin, end, [&](const std::smatch& m) { return m.str() == name; }
    );
}

}


Foam::label Foam::dictionaryInput::editDistance
(
    const std::string& a,
    const std::string& b
)
{
    // Of the letters of a so far from each beginning of b
    std::vector<label> distance(b.size() + 1);
    std::iota(distance.begin(), distance.end(), label(0));

    for (std::size_t i = 0; i < a.size(); ++i)
    {
        label diagonal = distance[0]++;
        for (std::size_t j = 0; j < b.size(); ++j)
        {
            const label changed = diagonal + (a[i] != b[j]);
            diagonal = distance[j + 1];
            distance[j + 1] =
                std::min({changed, diagonal + 1, distance[j] + 1});
        }
    }
    return distance.back();
}


bool Foam::dictionaryInput::isUserName
(
    const dictionary& dict,
    const word& keyword,
    const wordList& known
)
{
    // The master has the file, and has looked at the same entries
    if (Pstream::parRun() && !Pstream::master())
    {
        return true;
    }
    const textOfDictionary text(textOf(dict));
    if (isUsed(text.own, keyword) || isUsed(text.included, keyword))
    {
        return true;
    }
    const label near = std::min<label>(2, keyword.size()/3);
    return
        hasWord(text.included, keyword)
     && !hasWord(text.own, keyword)
     && std::none_of
        (
            known.begin(), known.end(),
            [&](const word& k) { return editDistance(k, keyword) <= near; }
        );
}
