// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "nscd/dynamics/State.hpp"

#include "nscd/io/Hdf5.hpp"
#include "nscd/io/ReplaceFile.hpp"
#include "nscd/shape/Members.hpp"

#include <sstream>
#include <stdexcept>

namespace nscd
{

namespace
{

const std::string format = "grainFoam grains";
constexpr int version = 2;

template <class V>
Table<double> toTable(const std::vector<V>& vectors)
{
    constexpr int columns = V::RowsAtCompileTime;
    Table<double> table{vectors.size(), columns, {}};
    for (const V& v : vectors)
    {
        table.values.insert(table.values.end(), v.data(), v.data() + columns);
    }
    return table;
}

template <int D>
Table<double> toTable(const Orientations<D>& orientations)
{
    if constexpr (D == 2)
    {
        Table<double> table{orientations.size(), 1, {}};
        for (const auto& o : orientations)
        {
            table.values.push_back(o.angle());
        }
        return table;
    }
    else
    {
        Table<double> table{orientations.size(), 4, {}};
        for (const auto& o : orientations)
        {
            table.values.insert(table.values.end(), {o.w(), o.x(), o.y(), o.z()});
        }
        return table;
    }
}

template <int D>
Orientations<D> toOrientations(const Table<double>& table)
{
    Orientations<D> orientations;
    for (const double* q = table.values.data(); q != table.values.data() + table.values.size(); q += table.columns)
    {
        if constexpr (D == 2)
        {
            orientations.emplace_back(q[0]);
        }
        else
        {
            orientations.emplace_back(q[0], q[1], q[2], q[3]);
        }
    }
    return orientations;
}

template <class To, class From>
Table<To> toColumn(const std::vector<From>& values)
{
    return {values.size(), 1, std::vector<To>(values.begin(), values.end())};
}

template <class T>
Table<T> readTable(const Hdf5File& in, const std::string& file, const std::string& name, std::size_t rows,
                   std::size_t columns)
{
    Table<T> table = in.read<T>(name);
    if (table.rows != rows || table.columns != columns)
    {
        throw std::runtime_error(file + ": " + name + " is " + std::to_string(table.rows) + " x " +
                                 std::to_string(table.columns) + " instead of " + std::to_string(rows) + " x " +
                                 std::to_string(columns));
    }
    return table;
}

template <class V>
std::vector<V> toVectors(const Table<double>& table)
{
    std::vector<V> vectors(table.rows);
    for (std::size_t i = 0; i < table.rows; ++i)
    {
        std::copy_n(table.values.data() + i * table.columns, table.columns, vectors[i].data());
    }
    return vectors;
}

void append(Table<double>& table, double t)
{
    table.values.push_back(t);
}

void append(Table<double>& table, const Vector<3>& t)
{
    table.values.insert(table.values.end(), {t.x(), t.y(), t.z()});
}

template <int D>
Tangent<D> tangentAt(const Table<double>& table, std::size_t row)
{
    const double* t = table.values.data() + row * table.columns;
    if constexpr (D == 2)
    {
        return *t;
    }
    else
    {
        return {t[0], t[1], t[2]};
    }
}

std::string joined(const std::vector<std::string>& names)
{
    std::string lines;
    for (const std::string& name : names)
    {
        lines += (lines.empty() ? "" : "\n") + name;
    }
    return lines;
}

std::vector<std::string> lines(const std::string& text)
{
    std::vector<std::string> result;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
    {
        result.push_back(line);
    }
    return result;
}

template <int D>
void writeContacts(Hdf5File& out, const std::vector<NamedImpulse<D>>& impulses)
{
    constexpr std::size_t columns = sizeof(Tangent<D>) / sizeof(double);
    Table<std::int64_t> pair{impulses.size(), 2, {}};
    Table<double> normal{impulses.size(), 1, {}};
    Table<double> tangential{impulses.size(), columns, {}};
    Table<double> rolling{impulses.size(), columns, {}};
    Table<double> age{impulses.size(), 1, {}};
    Table<double> attraction{impulses.size(), 1, {}};
    for (const NamedImpulse<D>& i : impulses)
    {
        pair.values.insert(pair.values.end(), {i.a, i.b});
        normal.values.push_back(i.impulse.normal);
        age.values.push_back(i.impulse.age);
        attraction.values.push_back(i.impulse.attraction);
        append(tangential, i.impulse.tangential);
        append(rolling, i.impulse.rolling);
    }
    out.write("contacts/pair", pair, "member, counted grain by grain; -1-w for wall w");
    out.write("contacts/normalImpulse", normal, "N s");
    out.write("contacts/rollingImpulse", rolling, "N m s, on the second of the pair");
    out.write("contacts/age", age, "s");
    out.write("contacts/attraction", attraction, "N s, in the normal impulse");
    out.write("contacts/tangentialImpulse", tangential, "N s, on the second of the pair");
}

template <int D>
std::vector<NamedImpulse<D>> readContacts(const Hdf5File& in, const std::string& file, std::size_t members)
{
    const std::size_t n = in.read<std::int64_t>("contacts/pair").rows;
    const Table<std::int64_t> pair = readTable<std::int64_t>(in, file, "contacts/pair", n, 2);
    const Table<double> normal = readTable<double>(in, file, "contacts/normalImpulse", n, 1);
    const Table<double> rolling =
        readTable<double>(in, file, "contacts/rollingImpulse", n, sizeof(Tangent<D>) / sizeof(double));
    const Table<double> age = readTable<double>(in, file, "contacts/age", n, 1);
    // Older states do not have it
    const Table<double> attraction = in.contains("contacts/attraction")
        ? readTable<double>(in, file, "contacts/attraction", n, 1)
        : Table<double>{n, 1, std::vector<double>(n, 0.0)};
    const Table<double> tangential =
        readTable<double>(in, file, "contacts/tangentialImpulse", n, sizeof(Tangent<D>) / sizeof(double));
    std::vector<NamedImpulse<D>> impulses;
    for (std::size_t c = 0; c < n; ++c)
    {
        const std::int64_t a = pair.values[2 * c];
        const std::int64_t b = pair.values[2 * c + 1];
        const auto count = static_cast<std::int64_t>(members);
        if (a < 0 || a >= count || b >= count || a == b)
        {
            throw std::runtime_error(file + ": contact " + std::to_string(c) + " is between rows " +
                                     std::to_string(a) + " and " + std::to_string(b) + " of " +
                                     std::to_string(members) + " members");
        }
        NamedImpulse<D> impulse{static_cast<int>(a), static_cast<int>(b), {}};
        impulse.impulse.normal = normal.values[c];
        impulse.impulse.age = age.values[c];
        impulse.impulse.attraction = attraction.values[c];
        impulse.impulse.tangential = tangentAt<D>(tangential, c);
        impulse.impulse.rolling = tangentAt<D>(rolling, c);
        impulses.push_back(impulse);
    }
    return impulses;
}

template <int D>
void writeClusters(Hdf5File& out, const std::vector<Cluster<D>>& clusters)
{
    Table<std::int64_t> members{clusters.size(), 1, {}};
    Table<double> volume{clusters.size(), 1, {}};
    Spins<D> inertia;
    Vectors<D> centre;
    Table<double> radius{0, 1, {}};
    for (const Cluster<D>& c : clusters)
    {
        members.values.push_back(static_cast<std::int64_t>(c.radius.size()));
        volume.values.push_back(c.volume);
        inertia.push_back(c.inertia);
        centre.insert(centre.end(), c.centre.begin(), c.centre.end());
        radius.values.insert(radius.values.end(), c.radius.begin(), c.radius.end());
    }
    radius.rows = radius.values.size();
    out.write("clusters/members", members, "1");
    out.write("clusters/volume", volume, "over that of radius^D");
    out.write("clusters/inertia", toTable(inertia), "over mass radius^2");
    out.write("clusters/centre", toTable(centre), "over radius");
    out.write("clusters/radius", radius, "over radius");
}

template <int D>
std::vector<Cluster<D>> readClusters(const Hdf5File& in, const std::string& file)
{
    const Table<std::int64_t> members = in.read<std::int64_t>("clusters/members");
    std::size_t total = 0;
    for (const std::int64_t m : members.values)
    {
        total += static_cast<std::size_t>(m);
    }
    const Table<double> volume = readTable<double>(in, file, "clusters/volume", members.rows, 1);
    const auto inertia = toVectors<Spin<D>>(
        readTable<double>(in, file, "clusters/inertia", members.rows, Spin<D>::RowsAtCompileTime));
    const auto centre = toVectors<Vector<D>>(readTable<double>(in, file, "clusters/centre", total, D));
    const Table<double> radius = readTable<double>(in, file, "clusters/radius", total, 1);
    std::vector<Cluster<D>> clusters;
    std::size_t first = 0;
    for (std::size_t c = 0; c < members.rows; ++c)
    {
        const std::size_t last = first + static_cast<std::size_t>(members.values[c]);
        clusters.push_back({{centre.begin() + first, centre.begin() + last},
                            {radius.values.begin() + first, radius.values.begin() + last},
                            volume.values[c],
                            inertia[c]});
        first = last;
    }
    return clusters;
}

template <int D>
void checkShapes(const Grains<D>& grains, const std::string& file)
{
    for (std::size_t i = 0; i < grains.size(); ++i)
    {
        if (grains.shape[i] < -1 || grains.shape[i] >= static_cast<int>(grains.clusters.size()))
        {
            throw std::runtime_error(file + ": grain " + std::to_string(grains.id[i]) + " has shape " +
                                     std::to_string(grains.shape[i]) + " of " +
                                     std::to_string(grains.clusters.size()));
        }
    }
}

template <int D>
void writeWallBodies(Hdf5File& out, const std::string& group, const std::vector<WallBody<D>>& bodies)
{
    Vectors<D> position, velocity;
    Orientations<D> orientation;
    Spins<D> spin;
    for (const WallBody<D>& b : bodies)
    {
        position.push_back(b.position);
        velocity.push_back(b.velocity);
        orientation.push_back(b.orientation);
        spin.push_back(b.spin);
    }
    out.write(group + "/position", toTable(position), "m");
    out.write(group + "/velocity", toTable(velocity), "m/s");
    out.write(group + "/orientation", toTable<D>(orientation), D == 2 ? "rad" : "1");
    out.write(group + "/spin", toTable(spin), "rad/s");
}

template <int D>
std::vector<WallBody<D>> readWallBodies(const Hdf5File& in, const std::string& file, const std::string& group)
{
    const Table<double> position = in.read<double>(group + "/position");
    const auto read = [&](const char* name, std::size_t columns)
    { return readTable<double>(in, file, group + name, position.rows, columns); };
    const auto velocity = toVectors<Vector<D>>(read("/velocity", D));
    const auto orientation = toOrientations<D>(read("/orientation", D == 2 ? 1 : 4));
    const auto spin = toVectors<Spin<D>>(read("/spin", Spin<D>::RowsAtCompileTime));
    std::vector<WallBody<D>> bodies(position.rows);
    for (std::size_t b = 0; b < bodies.size(); ++b)
    {
        bodies[b].position = Eigen::Map<const Vector<D>>(position.values.data() + D * b);
        bodies[b].velocity = velocity[b];
        bodies[b].orientation = orientation[b];
        bodies[b].spin = spin[b];
    }
    return bodies;
}

}  // namespace

template <int D>
void writeState(const std::string& file, const State<D>& s)
{
    const std::string temporary = file + ".part";
    Hdf5File out(temporary, Hdf5File::Mode::create);
    out.writeAttribute("format", format);
    out.writeAttribute("version", version);
    out.writeAttribute("dimension", D);
    out.writeAttribute("time", s.time);
    out.writeAttribute("lastTimeStep", s.lastTimeStep);
    out.writeAttribute("lastSubStep", s.lastSubStep);
    out.writeAttribute("candidateReachOfWalls", s.candidateReach.ofWalls);
    if (!s.materials.empty())
    {
        out.writeAttribute("materials", joined(s.materials));
    }
    if (!s.wallNames.entries.empty())
    {
        out.writeAttribute("walls", joined(s.wallNames.entries));
        out.write("wallNames/ofWall", toColumn<std::int64_t>(s.wallNames.ofWall), "line of walls");
        out.write("wallNames/ofBody", toColumn<std::int64_t>(s.wallNames.ofBody), "line of walls");
    }
    out.write("id", toColumn<std::int64_t>(s.grains.id), "1");
    out.write("position", toTable(s.grains.position), "m");
    out.write("velocity", toTable(s.grains.velocity), "m/s");
    out.write("orientation", toTable<D>(s.grains.orientation), D == 2 ? "rad" : "1");
    out.write("spin", toTable(s.grains.spin), "rad/s");
    out.write("shape", toColumn<std::int64_t>(s.grains.shape), "row of clusters; -1 for none");
    out.write("radius", toColumn<double>(s.grains.radius), "m");
    out.write("mass", toColumn<double>(s.grains.mass), "kg");
    out.write("material", toColumn<std::int64_t>(s.grains.material), "1");
    out.write("temperature", toColumn<double>(s.grains.temperature), "K");
    out.write("contactImpulse", toTable(s.contactImpulse), "N s");
    out.write("contactSpinImpulse", toTable(s.contactSpinImpulse), "N m s");
    out.write("unexpectedImpulse", toTable(s.unexpected.force), "N s");
    out.write("unexpectedSpinImpulse", toTable(s.unexpected.torque), "N m s");
    out.write("owedImpulse", toTable(s.owed.force), "N s");
    out.write("owedSpinImpulse", toTable(s.owed.torque), "N m s");
    out.write("lastingForce", toTable(s.lasting.force), "N");
    out.write("lastingTorque", toTable(s.lasting.torque), "N m");
    out.write("earlierForce", toTable(s.earlier.force), "N");
    out.write("earlierTorque", toTable(s.earlier.torque), "N m");
    out.write("candidatePosition", toTable(s.candidatePosition), "m");
    out.write("candidateOrientation", toTable<D>(s.candidateOrientation), D == 2 ? "rad" : "1");
    out.write("candidateReach", toColumn<double>(s.candidateReach.ofGrain), "m");
    writeClusters<D>(out, s.grains.clusters);
    writeWallBodies<D>(out, "wallBodies", s.wallBodies);
    writeWallBodies<D>(out, "candidateWalls", s.candidateWalls);
    writeContacts<D>(out, s.impulses);
    out.close();
    replaceFile(temporary, file);
}

template <int D>
State<D> readState(const std::string& file)
{
    const Hdf5File in(file, Hdf5File::Mode::read);
    if (in.readText("format") != format)
    {
        throw std::runtime_error(file + ": its format is '" + in.readText("format") + "' instead of '" + format + "'");
    }
    const auto expect = [&](const std::string& attribute, int wanted)
    {
        const double found = in.readNumber(attribute);
        if (found != wanted)
        {
            throw std::runtime_error(file + ": its " + attribute + " is " + std::to_string(static_cast<int>(found)) +
                                     " instead of " + std::to_string(wanted));
        }
    };
    expect("version", version);
    expect("dimension", D);

    State<D> s;
    s.time = in.readNumber("time");
    s.lastTimeStep = in.readNumber("lastTimeStep");
    s.lastSubStep = in.readNumber("lastSubStep");
    const std::size_t n = in.read<std::int64_t>("id").rows;
    const auto column = [&](const std::string& name) { return readTable<double>(in, file, name, n, 1).values; };
    const auto integers = [&](const std::string& name) { return readTable<std::int64_t>(in, file, name, n, 1).values; };
    const auto vectors = [&](const std::string& name)
    { return toVectors<Vector<D>>(readTable<double>(in, file, name, n, D)); };
    const auto orientations = [&](const std::string& name)
    { return toOrientations<D>(readTable<double>(in, file, name, n, D == 2 ? 1 : 4)); };
    const auto spins = [&](const std::string& name)
    { return toVectors<Spin<D>>(readTable<double>(in, file, name, n, Spin<D>::RowsAtCompileTime)); };

    s.grains.id = integers("id");
    s.grains.position = vectors("position");
    s.grains.velocity = vectors("velocity");
    s.grains.orientation = orientations("orientation");
    s.grains.spin = spins("spin");
    const std::vector<std::int64_t> shape = integers("shape");
    s.grains.shape.assign(shape.begin(), shape.end());
    s.grains.radius = column("radius");
    s.grains.mass = column("mass");
    const std::vector<std::int64_t> material = integers("material");
    s.grains.material.assign(material.begin(), material.end());
    if (in.hasAttribute("materials"))
    {
        s.materials = lines(in.readText("materials"));
    }
    if (in.hasAttribute("walls"))
    {
        const auto numbers = [&](const std::string& name)
        {
            const std::vector<std::int64_t> values = in.read<std::int64_t>(name).values;
            return std::vector<int>(values.begin(), values.end());
        };
        s.wallNames = {lines(in.readText("walls")), numbers("wallNames/ofWall"), numbers("wallNames/ofBody")};
    }
    s.grains.temperature = column("temperature");
    s.contactImpulse = vectors("contactImpulse");
    s.contactSpinImpulse = spins("contactSpinImpulse");
    if (in.contains("unexpectedImpulse"))
    {
        s.unexpected = {vectors("unexpectedImpulse"), spins("unexpectedSpinImpulse")};
    }
    if (in.contains("owedImpulse"))
    {
        s.owed = {vectors("owedImpulse"), spins("owedSpinImpulse")};
    }
    if (in.contains("lastingForce"))
    {
        s.lasting = {vectors("lastingForce"), spins("lastingTorque")};
        s.earlier = {vectors("earlierForce"), spins("earlierTorque")};
    }
    s.candidatePosition = vectors("candidatePosition");
    s.candidateOrientation = orientations("candidateOrientation");
    if (in.hasAttribute("candidateSkin"))   // of states with one distance for all
    {
        const double reach = 0.5 * in.readNumber("candidateSkin");
        s.candidateReach = {std::vector<double>(n, reach), reach};
    }
    else
    {
        s.candidateReach = {column("candidateReach"), in.readNumber("candidateReachOfWalls")};
    }
    s.grains.clusters = readClusters<D>(in, file);
    s.wallBodies = readWallBodies<D>(in, file, "wallBodies");
    s.candidateWalls = readWallBodies<D>(in, file, "candidateWalls");
    checkShapes(s.grains, file);
    s.impulses = readContacts<D>(in, file, Members<D>(s.grains).size());
    return s;
}

template void writeState<2>(const std::string&, const State<2>&);
template void writeState<3>(const std::string&, const State<3>&);
template State<2> readState<2>(const std::string&);
template State<3> readState<3>(const std::string&);

}  // namespace nscd
