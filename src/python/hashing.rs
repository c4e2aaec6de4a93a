//! Look-up by key in dicts and sets: equality and hashes that may run Python code.
