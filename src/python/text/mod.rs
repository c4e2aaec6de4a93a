//! Text of values: number formatting and parsing, format specs, `%`, `str.format`, reprs of strings.
