//! Truncated Taylor series: values and all derivatives of an expression along a line, without any symbolic step.

use trimline::expr::{Constant, ExprId, Function, Graph, Node, Variable};

/// The highest power that is kept.
pub const ORDER: usize = 8;

/// Coefficients of powers of s, from s^0.
pub type Jet = [f64; ORDER + 1];

/// The series of `expr` at `point + s direction`; `None` for a function this module does not know.
pub fn jet(graph: &Graph, expr: ExprId, symbols: &[f64], point: [f64; 3], direction: [f64; 3]) -> Option<Jet> {
    match graph.node(expr) {
        Node::Number(number) => Some(constant(number.to_f64())),
        Node::Constant(Constant::Pi) => Some(constant(std::f64::consts::PI)),
        Node::Constant(Constant::E) => Some(constant(std::f64::consts::E)),
        Node::Symbol(symbol) => Some(constant(symbols[symbol.index()])),
        Node::Variable(variable) => {
            let axis = Variable::ALL.iter().position(|other| other == variable)?;
            let mut series = constant(point[axis]);
            series[1] = direction[axis];
            Some(series)
        }
        Node::Sum(terms) => terms.iter().try_fold(constant(0.0), |sum, &term| {
            let term = jet(graph, term, symbols, point, direction)?;
            Some(std::array::from_fn(|n| sum[n] + term[n]))
        }),
        Node::Product(factors) => factors.iter().try_fold(constant(1.0), |product, &factor| {
            Some(times(&product, &jet(graph, factor, symbols, point, direction)?))
        }),
        Node::Power(base, exponent) => {
            let base = jet(graph, *base, symbols, point, direction)?;
            if let Some(number) = graph.as_number(*exponent) {
                return Some(match number.as_integer() {
                    Some(n) => whole_power(&base, n),
                    None => real_power(&base, number.to_f64()),
                });
            }
            let exponent = jet(graph, *exponent, symbols, point, direction)?;
            Some(exp(&times(&exponent, &ln(&base))))
        }
        Node::Spline(..) => None,
        Node::Call(function, arguments) => {
            let arguments: Option<Vec<Jet>> =
                arguments.iter().map(|&argument| jet(graph, argument, symbols, point, direction)).collect();
            call(*function, &arguments?)
        }
    }
}

fn call(function: Function, arguments: &[Jet]) -> Option<Jet> {
    let x = arguments.first()?;
    let one = constant(1.0);
    let square = times(x, x);
    let one_minus_square = std::array::from_fn(|n| one[n] - square[n]);
    let one_plus_square = std::array::from_fn(|n| one[n] + square[n]);
    let (sin, cos) = sine_and_cosine(x);
    let (plus, minus) = (exp(x), exp(&scaled(x, -1.0)));
    let sinh: Jet = std::array::from_fn(|n| 0.5 * (plus[n] - minus[n]));
    let cosh: Jet = std::array::from_fn(|n| 0.5 * (plus[n] + minus[n]));
    Some(match function {
        Function::Sin => sin,
        Function::Cos => cos,
        Function::Tan => over(&sin, &cos),
        Function::Cot => over(&cos, &sin),
        Function::Sec => over(&one, &cos),
        Function::Csc => over(&one, &sin),
        Function::Asin => integrated(x, &real_power(&one_minus_square, -0.5), x[0].asin()),
        Function::Acos => scaled_from(&integrated(x, &real_power(&one_minus_square, -0.5), 0.0), -1.0, x[0].acos()),
        Function::Atan => integrated(x, &over(&one, &one_plus_square), x[0].atan()),
        Function::Atan2 => {
            // Turned by -atan2(y0, x0) the point lies on the positive axis, where atan2 is atan of the quotient.
            let (y, x) = (arguments.first()?, arguments.get(1)?);
            let (a, b) = (x[0], y[0]);
            let along: Jet = std::array::from_fn(|n| a * x[n] + b * y[n]);
            let across: Jet = std::array::from_fn(|n| a * y[n] - b * x[n]);
            let quotient = over(&across, &along);
            let square = times(&quotient, &quotient);
            let slope = over(&one, &std::array::from_fn(|n| one[n] + square[n]));
            integrated(&quotient, &slope, b.atan2(a))
        }
        Function::Sinh => sinh,
        Function::Cosh => cosh,
        Function::Tanh => over(&sinh, &cosh),
        Function::Asinh => integrated(x, &real_power(&one_plus_square, -0.5), x[0].asinh()),
        Function::Acosh => integrated(x, &real_power(&std::array::from_fn(|n| square[n] - one[n]), -0.5), x[0].acosh()),
        Function::Atanh => integrated(x, &over(&one, &one_minus_square), x[0].atanh()),
        Function::Exp => plus,
        Function::Ln => ln(x),
        Function::Log10 => scaled(&ln(x), 1.0 / std::f64::consts::LN_10),
        Function::Cbrt if x[0] < 0.0 => scaled(&real_power(&scaled(x, -1.0), 1.0 / 3.0), -1.0),
        Function::Cbrt => real_power(x, 1.0 / 3.0),
        Function::Abs | Function::Sign | Function::Floor | Function::Min | Function::Max | Function::Pow => {
            return None;
        }
    })
}

fn constant(value: f64) -> Jet {
    let mut series = [0.0; ORDER + 1];
    series[0] = value;
    series
}

fn scaled(x: &Jet, factor: f64) -> Jet {
    x.map(|coefficient| factor * coefficient)
}

/// `factor * x` with another constant term.
fn scaled_from(x: &Jet, factor: f64, first: f64) -> Jet {
    let mut series = scaled(x, factor);
    series[0] = first;
    series
}

fn times(a: &Jet, b: &Jet) -> Jet {
    std::array::from_fn(|n| (0..=n).map(|k| a[k] * b[n - k]).sum())
}

fn over(a: &Jet, b: &Jet) -> Jet {
    let mut quotient = [0.0; ORDER + 1];
    for n in 0..=ORDER {
        let known: f64 = (1..=n).map(|k| b[k] * quotient[n - k]).sum();
        quotient[n] = (a[n] - known) / b[0];
    }
    quotient
}

/// The series with `y' = x' slope` and `y(0) = first`.
fn integrated(x: &Jet, slope: &Jet, first: f64) -> Jet {
    let mut y = constant(first);
    for n in 1..=ORDER {
        let sum: f64 = (1..=n).map(|k| k as f64 * x[k] * slope[n - k]).sum();
        y[n] = sum / n as f64;
    }
    y
}

fn exp(x: &Jet) -> Jet {
    let mut y = constant(x[0].exp());
    for n in 1..=ORDER {
        let sum: f64 = (1..=n).map(|k| k as f64 * x[k] * y[n - k]).sum();
        y[n] = sum / n as f64;
    }
    y
}

fn ln(x: &Jet) -> Jet {
    integrated(x, &over(&constant(1.0), x), x[0].ln())
}

fn sine_and_cosine(x: &Jet) -> (Jet, Jet) {
    let (mut sin, mut cos) = (constant(x[0].sin()), constant(x[0].cos()));
    for n in 1..=ORDER {
        let sum = |of: &Jet| (1..=n).map(|k| k as f64 * x[k] * of[n - k]).sum::<f64>() / n as f64;
        (sin[n], cos[n]) = (sum(&cos), -sum(&sin));
    }
    (sin, cos)
}

fn whole_power(x: &Jet, exponent: i32) -> Jet {
    let positive = (0..exponent.unsigned_abs()).fold(constant(1.0), |product, _| times(&product, x));
    if exponent < 0 { over(&constant(1.0), &positive) } else { positive }
}

/// For a positive first coefficient.
fn real_power(x: &Jet, exponent: f64) -> Jet {
    exp(&scaled(&ln(x), exponent))
}
