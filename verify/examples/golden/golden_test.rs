// SPDX-License-Identifier: Apache-2.0
// How a project that computes penetration depths tests itself with golden cases in Rust, without crates. The sample,
// from the golden kit, is copied beside this file; `fathom golden export --format rust` makes other cases. Alone:
//   rustc --test golden_test.rs && ./golden_test
#![cfg(test)]

#[path = "fathom_golden_sample.rs"]
#[allow(dead_code)]
mod golden;

use golden::{Case, Tolerance, CASES};

// ---- what stands for the project's own code: the separating axis test over all pairs of differences ----

type Vector = [f64; 3];

fn minus(p: Vector, q: Vector) -> Vector {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

fn cross(p: Vector, q: Vector) -> Vector {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

fn dot(p: Vector, q: Vector) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

fn differences(body: &[Vector]) -> Vec<Vector> {
    (0..body.len()).flat_map(|i| (0..i).map(move |j| minus(body[i], body[j]))).collect()
}

/// The least and the greatest.
fn range(body: &[Vector], axis: Vector) -> (f64, f64) {
    body.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &p| (low.min(dot(axis, p)), high.max(dot(axis, p))))
}

/// Depth and direction of two bodies that overlap.
fn penetration(a: &[Vector], b: &[Vector], pairs_of_edges: bool) -> Option<(f64, Vector)> {
    let edges = [differences(a), differences(b)];
    let pairs: &[(usize, usize)] = if pairs_of_edges { &[(0, 0), (1, 1), (0, 1)] } else { &[(0, 0), (1, 1)] };
    let mut best = (f64::INFINITY, [0.0; 3]);
    for &(i, j) in pairs {
        for axis in edges[i].iter().flat_map(|&e| edges[j].iter().map(move |&f| cross(e, f))) {
            let length = dot(axis, axis).sqrt();
            if length == 0.0 {
                continue;
            }
            let (of_a, of_b) = (range(a, axis), range(b, axis));
            for (depth, direction) in [(of_b.1 - of_a.0, axis), (of_a.1 - of_b.0, axis.map(|x| -x))] {
                if depth / length < best.0 {
                    best = (depth / length, direction);
                }
            }
        }
    }
    if best.0 > 0.0 { Some(best) } else { None }
}

// ---- the tests ----

fn is_right(case: &Case, pairs_of_edges: bool) -> bool {
    let tolerance = Tolerance { relative: 1e-9, absolute: 1e-12 };
    match penetration(case.a, case.b, pairs_of_edges) {
        Some((depth, direction)) => case.accept(Some(direction), depth, tolerance),
        None => case.accept_apart(tolerance),
    }
}

#[test]
fn penetration_is_right_in_every_golden_case() {
    for case in &CASES {
        assert!(is_right(case, true), "{}, whose signed depth is {}", case.name, case.signed_depth);
    }
}

#[test]
fn without_pairs_of_edges_it_is_found_to_be_wrong() {
    assert!(!CASES.iter().all(|case| is_right(case, false)));
}
