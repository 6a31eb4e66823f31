//! The tests that see the library as its users do: one binary, so that it is linked once.

mod evaluators;
