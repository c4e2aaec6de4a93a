//! Arithmetic of ints, floats and complex numbers, traced.
