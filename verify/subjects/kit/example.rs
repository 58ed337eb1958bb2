// SPDX-License-Identifier: Apache-2.0
//! A subject on fathom_subject.rs: the boxes around two bodies, which are right about boxes along the axes.
mod fathom_subject;
use fathom_subject::{run, Body, Reply};

fn solve(a: &Body, b: &Body) -> Result<Reply, String> {
    let (mut depth, mut direction) = (f64::INFINITY, [0.0; 3]);
    for axis in 0..3 {
        let end = |body: &Body, sign: f64| body.vertices.iter().map(|p| sign * p[axis]).fold(f64::NEG_INFINITY, f64::max);
        for sign in [1.0, -1.0] {
            let length = end(b, sign) + end(a, -sign); // how far A must go
            if length < depth {
                depth = length;
                direction = [0.0; 3];
                direction[axis] = sign;
            }
        }
    }
    Ok(Reply { overlap: depth > 0.0, depth: Some(depth), direction: Some(direction), ..Default::default() })
}

fn main() {
    let conventions = r#""conventions":{"touching":"either","depth":"positive","moves":"a","unit":true}"#;
    run(&format!(r#""name":"boxes-rust","version":"1","precision":"binary64",{}"#, conventions), solve);
}
