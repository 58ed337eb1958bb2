// SPDX-License-Identifier: CC0-1.0
// A golden case of fathom, and whether an answer to it is right. It stands at the head of each file that
// `fathom golden export --format rust` writes.
//
// For a vector u, h(u) is the greatest <u,b> less the least <u,a>, over the points b of B and a of A; its separating distance is h(u)/|u|.
// Moved that far along u, A lies behind a plane across u and B before it. The least separating distance of all directions is the signed
// depth: of bodies that overlap the penetration depth, of bodies that touch 0, of bodies that are apart minus their distance.

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Status {
    Penetrating,
    Touching,
    Disjoint,
}

/// The bodies are the convex hulls of the points, of N coordinates: 3, or 2 of bodies of the plane.
#[derive(Debug)]
pub struct Case<const N: usize = 3> {
    pub name: &'static str,
    pub status: Status,
    /// Correctly rounded to nearest.
    pub signed_depth: f64,
    /// Its square, exact: "2" or "1/3".
    pub squared: &'static str,
    /// What is special about the case.
    pub flags: &'static [&'static str],
    /// The longest side of the bodies' boxes, correctly rounded.
    pub size: f64,
    /// The largest magnitude of a coordinate.
    pub largest: f64,
    /// Exact.
    pub a: &'static [[f64; N]],
    pub b: &'static [[f64; N]],
    /// Unit vectors, rounded: all whose separating distance is the depth. Of bodies that touch one whose is 0; of bodies that are apart
    /// that of the distance, from B to A.
    pub directions: &'static [[f64; N]],
    /// Of cases of contacts, for each direction: the corners, on A, of all points where the bodies touch once A is moved that way, rounded:
    /// one of a point, two of a segment.
    pub patches: &'static [&'static [[f64; 3]]],
    /// Of these, where the signed depth is smooth, rounded. A moves with v + w x p at its points p: the first times v and the second times w
    /// are its rate.
    pub gradient: Option<[[f64; 3]; 2]>,
}

/// How wrong an answer may be: by the larger of relative * depth (or distance) and absolute * size.
#[derive(Clone, Copy, Debug)]
pub struct Tolerance {
    pub relative: f64,
    pub absolute: f64,
}

fn dot<const N: usize>(u: [f64; N], p: [f64; N]) -> f64 {
    u.iter().zip(p).map(|(x, y)| x * y).sum()
}

fn support<const N: usize>(points: &[[f64; N]], u: [f64; N]) -> f64 {
    points.iter().map(|&p| dot(u, p)).fold(f64::NEG_INFINITY, f64::max)
}

impl<const N: usize> Case<N> {
    /// The separating distance of a direction of any length; infinite if it is zero, infinite or NaN. It is off by less than 2^-47 of the
    /// largest coordinate (and 2^-1068).
    pub fn separating_distance(&self, direction: [f64; N]) -> f64 {
        let longest = direction.iter().fold(0.0, |longest: f64, x| longest.max(x.abs()));
        if longest == 0.0 || direction.iter().any(|x| !x.is_finite()) {
            return f64::INFINITY;
        }
        let u = direction.map(|x| x / longest / 8.0); // an eighth, so that no sum overflows
        (support(self.b, u) + support(self.a, u.map(|x| -x))) / dot(u, u).sqrt()
    }

    /// By how much an answer may be off: the tolerance, and what rounding costs it and the separating distance.
    pub fn allowance(&self, tolerance: Tolerance) -> f64 {
        let wrong = (tolerance.relative * self.signed_depth.abs()).max(tolerance.absolute * self.size);
        wrong + 32.0 * f64::EPSILON * self.largest + 64.0 * f64::EPSILON * f64::MIN_POSITIVE
    }

    /// Whether "A and B overlap by `depth`; A gets free along `direction`" is right: neither the depth nor the separating distance of the
    /// direction is off by more than the allowance. Any direction that is good enough is right, not only the best. A distance is a depth
    /// below 0. The direction may have any length.
    pub fn accept(&self, direction: Option<[f64; N]>, depth: f64, tolerance: Tolerance) -> bool {
        let allowed = self.allowance(tolerance);
        (depth - self.signed_depth).abs() <= allowed
            && direction.map_or(true, |u| self.separating_distance(u) - self.signed_depth <= allowed)
    }

    /// Whether "A and B do not overlap" is right, without a distance.
    pub fn accept_apart(&self, tolerance: Tolerance) -> bool {
        self.signed_depth <= self.allowance(tolerance)
    }
}
