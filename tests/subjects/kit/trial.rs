// SPDX-License-Identifier: GPL-3.0-or-later
//! A subject that misbehaves as the first coordinate of A says.
#[path = "../../../verify/subjects/kit/fathom_subject.rs"]
mod fathom_subject;
use fathom_subject::{run, Body, Reply};

fn solve(a: &Body, b: &Body) -> Result<Reply, String> {
    let reply = Reply { overlap: true, ..Default::default() };
    match a.vertices[0][0] as i32 {
        1 => return Ok(Reply { depth: Some(f64::NAN), direction: Some([f64::INFINITY, f64::NEG_INFINITY, -0.5]), ..reply }),
        2 => println!("a stray line\nand one from below"),
        3 => panic!("no \"way\" out"),
        4 => return Err("too flat".to_string()),
        5 => return Ok(Reply::default()),
        8 => return Ok(Reply { distance: Some(f64::INFINITY), ..Default::default() }),
        9 => panic!("half a pair: \u{fffd}"),
        10 => std::panic::panic_any("x".repeat(17 << 20)),
        11 => std::panic::panic_any(11),
        13 => return Ok(Reply { microseconds: Some(12.5), ..reply }),
        14 => return Ok(Reply { witness: Some([a.vertices[1], b.vertices[1]]), ..reply }),
        15 => return Ok(Reply { derivative: Some(a.twist.unwrap()[0][0] + b.twist.unwrap()[1][2]), ..reply }),
        _ => {}
    }
    let faces = a.fields.get("faces").map_or(0, |faces| faces.items().len());
    Ok(Reply { depth: Some(1.0 / 3.0 + faces as f64), ..reply })
}

fn main() {
    let said = r#""name":"trial","version":"7","precision":{"points":"binary32","answers":"binary64"},"settings":{"limit":"3"},
"conventions":{"touching":"overlap","depth":"negative","moves":"b","unit":false,"claims":"separating"},
"capabilities":{"faces":true,"shapes":["capsule","box","margin"],"twist":true},"promises":["depth"],"rounding":{"vertices":0.1,"box":0.25},
"manifold":{"most":4,"margin":0.125}"#;
    let plane = if std::env::var("FATHOM_KIT_PLANE").is_ok() { r#","dimension":2"# } else { "" };
    run(&(said.replace('\n', "") + plane), solve);
}
