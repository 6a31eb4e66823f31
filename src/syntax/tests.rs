use super::*;
fn d(text: &str) {
    match parse(&Source::new("x", text), &Limits::default()) {
        Ok(doc) => println!("OK {text:?} {:?}", doc.boundaries.last().map(|b| b.constraints.len())),
        Err(e) => println!("ERR {text:?} {e:#?}"),
    }
}
#[test]
fn play() {
    d("at u = 0: S_x = (1-t)*b1*sinh(a1*v+a2)");
    d(
        "at u = 0:\n S_x(u, v, t) = (1 − t)[b_1 sinh(a_1 v + a_2) + b_2 sin(a_3 v)] + b_3 t cos(−v),\n S_y = 0.8(1-t)b6 sin(a5 v)\n ∂S_x(u, v, t)/∂u = 0.0,\n dS_y/du=0; x = sin^2 v + √√2 v² e^-t sin v\nat u = 1:\n S = [c e^-t sin v, d e^t cos v, 0]",
    );
    d(
        "pde β ∂⁴S/∂u⁴ + γ ∂⁴S/∂u²∂v² + λ d4S/dv4 + 3S = 0\n   with β = 1, γ = 12.1\nsolve sine, terms = 5, points = 11 x 11 : ends",
    );
    d("at u=0: x = sin πt/2\n y = a/2b\n z = (1 + ");
    d("at u = 0: S_x = 1 ) + 2");
    d("param h1 = -3 in [-6, 0]\nparam a = 1.6 b = 2");
    d("let f(x) = sin -x");
}
#[test]
fn stack() {
    let n: usize = std::env::var("N").unwrap().parse().unwrap();
    let k: usize = std::env::var("K").unwrap().parse().unwrap();
    for (o, c) in [("(", ")"), ("sin(", ")"), ("2^(", ")")] {
        let t = format!("at u = 0: S_x = {}1{}", o.repeat(n), c.repeat(n));
        let h = std::thread::Builder::new()
            .stack_size(k << 10)
            .spawn(move || {
                let r = parse(&Source::new("x", t), &Limits::default());
                r.is_ok()
            })
            .unwrap();
        println!("{n} {k} {o} {:?}", h.join().is_ok());
    }
}
