//! The operator table as functions with the C calling convention, which generated code can call.
//!
//! The table's own functions have Rust's calling convention, which is not specified; each shim calls one of them.
//! A function that is added to the table and not here does not compile.

use crate::expr::{Function, SplineCall};

/// A function of the table, callable from generated code.
#[derive(Clone, Copy)]
pub(super) enum Shim {
    Unary(extern "C" fn(f64) -> f64),
    Binary(extern "C" fn(f64, f64) -> f64),
}

macro_rules! shims {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        /// The shim of `function`.
        pub(super) fn shim(function: Function) -> Shim {
            match function {
                $(Function::$unary => {
                    extern "C" fn shim(x: f64) -> f64 {
                        Function::$unary.value(&[x])
                    }
                    Shim::Unary(shim)
                })*
                $(Function::$binary => {
                    extern "C" fn shim(x: f64, y: f64) -> f64 {
                        Function::$binary.value(&[x, y])
                    }
                    Shim::Binary(shim)
                })*
            }
        }
    };
}

shims! {
    unary: Sin Cos Tan Cot Sec Csc Asin Acos Atan Sinh Cosh Tanh Asinh Acosh Atanh Exp Ln Log10 Cbrt Abs Sign Floor;
    binary: Atan2 Min Max Pow;
}

/// The value of a spline, callable from generated code, which passes the address of one of its program's.
pub(super) extern "C" fn spline(call: &SplineCall, first: f64, second: f64) -> f64 {
    call.value(first, second)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shims_have_the_arity_of_the_table() {
        for &function in Function::ALL {
            let arity = match shim(function) {
                Shim::Unary(_) => 1,
                Shim::Binary(_) => 2,
            };
            assert_eq!(arity, function.arity(), "{}", function.row().name);
        }
    }
}
