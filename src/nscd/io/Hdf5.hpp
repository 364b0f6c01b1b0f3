// SPDX-FileCopyrightText: 2026 The grainFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "nscd/base/Mpi.hpp"

#include <hdf5.h>

#include <cstdint>
#include <string>
#include <vector>

namespace nscd
{

/// A two-dimensional table of numbers, row after row.
template <class T>
struct Table
{
    std::size_t rows, columns;
    std::vector<T> values;
};

/// An HDF5 identifier that closes itself.
class Hdf5Handle
{
public:
    Hdf5Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_), close_(other.close_) { other.id_ = -1; }
    Hdf5Handle(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(const Hdf5Handle&) = delete;
    Hdf5Handle& operator=(Hdf5Handle&&) = delete;
    ~Hdf5Handle() { close(); }

    operator hid_t() const { return id_; }

    /// False when closing, which may be what writes to disc, fails.
    bool close();

private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// An HDF5 file opened by one process.  Tables of double, std::int32_t and std::int64_t; attributes of the root group.
/// Every function throws std::runtime_error with the file's name and HDF5's own reason; HDF5 itself prints nothing.
class Hdf5File
{
public:
    enum class Mode
    {
        read,
        modify,
        create
    };

    Hdf5File(const std::string& name, Mode mode);

    /// Finish a created or modified file; must be called for it to be complete.
    void close();

    /// A '/' in the name makes a group; 'units' becomes an attribute of the data set, e.g. "m/s".
    template <class T>
    void write(const std::string& name, const Table<T>& table, const std::string& units);

    /// A single number is a table of one row and column, as is a list of one.
    template <class T>
    Table<T> read(const std::string& name) const;

    /// Is there a data set or group of this name?
    bool contains(const std::string& name) const;

    /// Take away a data set or a group with all it contains.
    void remove(const std::string& name);

    void writeAttribute(const std::string& name, double value);
    void writeAttribute(const std::string& name, const std::string& text);
    bool hasAttribute(const std::string& name) const;
    double readNumber(const std::string& name) const;
    std::string readText(const std::string& name) const;

private:
    hid_t check(hid_t result, const std::string& action) const;

    /// Switches HDF5's printing of errors off while it lives.
    class Quiet
    {
    public:
        Quiet();
        ~Quiet();
        Quiet(const Quiet&) = delete;
        Quiet& operator=(const Quiet&) = delete;

    private:
        H5E_auto2_t function_ = nullptr;
        void* data_ = nullptr;
    };

    std::string name_;
    bool isNew_;
    Quiet quiet_;
    Hdf5Handle file_;
};

}  // namespace nscd
