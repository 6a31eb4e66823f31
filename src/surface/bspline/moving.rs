//! A B-spline surface whose control points move, at one instant.

use super::BsplineSurface;
use crate::diagnostic::{Code, Diagnostic};
use crate::expr::Derivative;
use crate::surface::Surface;
use crate::surface::validity::check_instant;

/// A B-spline surface at an instant, with the derivatives of its net in t as far as they are known.
#[derive(Debug, Clone)]
pub struct MovingBspline {
    /// The surface, then its derivatives of order 1, 2, … in t: all over the same knots.
    orders: Vec<BsplineSurface>,
    /// `None` if it rests: it is the same at every instant.
    instant: Option<f64>,
}

impl MovingBspline {
    /// A surface that is the same at every instant.
    #[must_use]
    pub fn resting(surface: BsplineSurface) -> MovingBspline {
        MovingBspline { orders: vec![surface], instant: None }
    }

    /// `surface` at `instant`, with the derivatives of its net in t in `rates`, order 1 first.
    #[must_use]
    pub fn moving(surface: BsplineSurface, rates: Vec<BsplineSurface>, instant: f64) -> MovingBspline {
        MovingBspline { orders: std::iter::once(surface).chain(rates).collect(), instant: Some(instant) }
    }

    /// The only instant at which it holds; `None` for a surface that rests.
    #[must_use]
    pub fn instant(&self) -> Option<f64> {
        self.instant
    }

    /// The net and knots behind a derivative in t; `None` where it is zero.
    fn of_order(&self, order: usize) -> Result<Option<&BsplineSurface>, Diagnostic> {
        match (self.orders.get(order), self.instant) {
            (Some(surface), _) => Ok(Some(surface)),
            (None, None) => Ok(None),
            (None, Some(_)) => {
                let message = format!("the derivative of order {order} in t is not known for this net");
                let known = self.orders.len() - 1;
                Err(Diagnostic::new(Code::UnsupportedByMethod, message).hint(format!("ask for orders up to {known}")))
            }
        }
    }
}

impl Surface for MovingBspline {
    fn evaluate(&self, derivative: Derivative, points: &[[f64; 3]], values: &mut [[f64; 3]]) -> Result<(), Diagnostic> {
        points.iter().try_for_each(|[_, _, t]| check_instant(self.instant, *t))?;
        match self.of_order(derivative.t)? {
            Some(surface) => surface.evaluate(Derivative { t: 0, ..derivative }, points, values),
            None => {
                values.fill([0.0; 3]);
                Ok(())
            }
        }
    }

    fn breaks(&self, domain: [[f64; 2]; 2], t: f64) -> Result<[Vec<f64>; 2], Diagnostic> {
        match self.orders.first() {
            Some(surface) => surface.breaks(domain, t),
            None => Ok([Vec::new(), Vec::new()]),
        }
    }

    fn evaluate_grid(
        &self,
        derivative: Derivative,
        (u, v, t): (&[f64], &[f64], f64),
        values: &mut [[f64; 3]],
    ) -> Result<(), Diagnostic> {
        check_instant(self.instant, t)?;
        match self.of_order(derivative.t)? {
            Some(surface) => surface.evaluate_grid(Derivative { t: 0, ..derivative }, (u, v, t), values),
            None => {
                values.fill([0.0; 3]);
                Ok(())
            }
        }
    }
}
