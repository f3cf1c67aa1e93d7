#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Read a Cinema database as its specification says (Spec D, 1.2), and nothing else of whoever wrote it.

usage: read_cinema.py DATABASE.cdb

Prints the columns with their types, and the number of rows. Ends with 1 and a sentence if it is no such database.
"""

import pathlib
import sys
import urllib.parse

TABLE = "data.csv"
#: Columns whose names begin so have the names of files.
FILES = "FILE"


class WrongDatabase(Exception):
    """What the specification does not allow."""


class Text(str):
    """A value in quotation marks. Only such an empty one is a string; else it is a missing value."""


def records_of(text):
    """The records of a text by RFC 4180: lists of values."""
    records, record, value = [], [], ""
    at, is_quoted, is_open = 0, False, False
    while at < len(text):
        character = text[at]
        if is_open:
            if character != '"':
                value += character
            elif text[at + 1:at + 2] == '"':
                value += '"'
                at += 1
            else:
                is_open = False
        elif character == '"':
            if value or is_quoted:
                raise WrongDatabase("A quotation mark stands within a value.")
            is_quoted = is_open = True
        elif character in ",\n" or text[at:at + 2] == "\r\n":
            record.append(Text(value) if is_quoted else value)
            value, is_quoted = "", False
            if character != ",":
                at += character == "\r"
                records.append(record)
                record = []
        elif is_quoted:
            raise WrongDatabase("A value goes on behind its quotation mark.")
        else:
            value += character
        at += 1
    if is_open:
        raise WrongDatabase("A quotation mark is not closed.")
    if record or value or is_quoted:
        records.append([*record, Text(value) if is_quoted else value])
    return records


def type_of(value):
    """int, float or str, in this order; None for a missing value."""
    if value == "" and not isinstance(value, Text):
        return None
    for kind in (int, float):
        try:
            kind(value)
            # These read more than C does.
            if "_" not in value and value == value.strip():
                return kind
        except ValueError:
            pass
    return str


def types_of(header, rows):
    """The type of each column: that of its first value. All others must have it, too."""
    types = []
    for index, name in enumerate(header):
        kinds = [type_of(row[index]) for row in rows]
        kind = next((kind for kind in kinds if kind is not None), str)
        for number, other in enumerate(kinds, 1):
            if other not in (kind, None):
                raise WrongDatabase(f"Column {name} has the type {kind.__name__}, but {rows[number - 1][index]} of row "
                                    f"{number} has the type {other.__name__}.")
        types.append(kind)
    return types


def check_header(header):
    """Names are unique, and those of files come last."""
    if not header or any(name == "" for name in header) or len(set(header)) != len(header):
        raise WrongDatabase("A column has no name, or the name of another one.")
    are_files = [name.startswith(FILES) for name in header]
    if are_files != sorted(are_files):
        raise WrongDatabase("Columns of files are not the last ones.")


def read_database(folder):
    """The rows of a database, each a dictionary: numbers, texts, None for missing values, and paths of files that are
    there."""
    folder = pathlib.Path(folder)
    if not folder.name.endswith(".cdb") or not (folder / TABLE).is_file():
        raise WrongDatabase(f"{folder} is no folder with a name that ends in .cdb and a {TABLE}.")
    try:
        # Not text mode, which would change ends of lines.
        records = records_of((folder / TABLE).read_bytes().decode("utf-8"))
    except UnicodeDecodeError as error:
        raise WrongDatabase(f"{TABLE} is not in UTF-8: {error}.") from error
    if len(records) < 2:
        raise WrongDatabase(f"{TABLE} has no row, or no header.")
    header, *rows = records
    check_header(header)
    for number, row in enumerate(rows, 1):
        if len(row) != len(header):
            raise WrongDatabase(f"Row {number} has {len(row)} values, and the header has {len(header)}.")
    types = types_of(header, rows)
    return [dict(zip(header, (value_of(folder, *value) for value in zip(header, types, row)))) for row in rows]


def value_of(folder, name, kind, value):
    if type_of(value) is None:
        return None
    if not name.startswith(FILES):
        return kind(value)
    if urllib.parse.urlparse(value).scheme:
        return value
    path = folder / value
    if not path.is_file():
        raise WrongDatabase(f"{path} is missing.")
    return path


def main():
    if len(sys.argv) != 2:
        print(__doc__.strip())
        return 2
    try:
        rows = read_database(sys.argv[1])
    except WrongDatabase as error:
        print(f"read_cinema.py: {error}", file=sys.stderr)
        return 1
    for name, value in rows[0].items():
        print(name, "file" if name.startswith(FILES) else type(value).__name__)
    print(len(rows), "rows")
    return 0


if __name__ == "__main__":
    sys.exit(main())
