// SPDX-License-Identifier: Apache-2.0
//! Lets `fathom certify` put cases to your code: one function that answers a pair of bodies. Copy this file; it needs Rust 1.63, Unix, and no
//! crate. `example.rs` is a whole subject: `rustc --edition 2021 -O example.rs`, then `fathom certify --subject ./example cases.jsonl`. It speaks the protocol
//! fathom/subject/1 (verify/PROTOCOL.md): NaN and infinities are written so that they are judged, what your code prints goes to standard
//! error, a panic becomes the answer `failed`, and each answer says how many microseconds it took.
#![allow(dead_code)]
use std::io::{BufRead, Write};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// One body of a case: the convex hull of `vertices`; or a shape, if you declared some, whose fields are those of docs/shapes.md. With
/// `"dimension":2` in the hello z is 0 everywhere, and not sent: the body is the hull of `vertices`, grown by the field `margin`.
pub struct Body<'a> {
    pub vertices: Vec<[f64; 3]>,
    pub fields: &'a Json,
    /// v and w: its point p begins to move with the velocity v + w x p, w about the origin of the world; if you declared "twist".
    pub twist: Option<[[f64; 3]; 2]>,
}

/// What your code answers. Only `overlap` is needed, and what is there is judged: the depth with the sign that is declared, the direction in
/// which the declared body moves out (or farther away), points of A and B, and the distance of bodies that are apart. And of bodies with a
/// twist how fast the signed depth grows from then on: deeper is positive, whatever sign depths have.
#[derive(Default)]
pub struct Reply {
    pub overlap: bool,
    pub depth: Option<f64>,
    pub distance: Option<f64>,
    pub direction: Option<[f64; 3]>,
    pub witness: Option<[[f64; 3]; 2]>,
    pub derivative: Option<f64>,
    pub microseconds: Option<f64>, // if you timed a part of your function yourself
}

/// A value of JSON. An object is the list of its names and values; true, false and null are texts.
pub enum Json {
    Number(f64),
    Text(String),
    List(Vec<Json>),
}

impl Json {
    /// The value of that name in an object.
    pub fn get(&self, name: &str) -> Option<&Json> {
        self.items().chunks(2).find(|member| member[0].text() == name)?.get(1)
    }
    pub fn items(&self) -> &[Json] {
        if let Json::List(items) = self { items } else { &[] }
    }
    pub fn text(&self) -> &str {
        if let Json::Text(text) = self { text } else { "" }
    }
    pub fn number(&self) -> Option<f64> {
        if let Json::Number(x) = self { Some(*x) } else { None }
    }
    /// Reads what `fathom` writes: texts hold no quotation marks, and signs between values need no look.
    fn read(rest: &mut &str) -> Option<Json> {
        *rest = rest.trim_start_matches(|c| " \t,:".contains(c));
        if let Some(behind) = rest.strip_prefix('"') {
            let (text, behind) = behind.split_once('"')?;
            *rest = behind;
            return Some(Json::Text(text.into()));
        }
        if !rest.starts_with(|c| "[{".contains(c)) {
            let (word, behind) = rest.split_at(rest.find(|c| " \t,:[]{}\"".contains(c)).unwrap_or(rest.len()));
            *rest = behind;
            return if ["true", "false", "null"].contains(&word) { Some(Json::Text(word.into())) } else { word.parse().ok().map(Json::Number) };
        }
        let mut items = Vec::new();
        *rest = &rest[1..];
        loop {
            *rest = rest.trim_start_matches(|c| " \t,:".contains(c));
            if rest.starts_with(|c| "]}".contains(c)) {
                *rest = &rest[1..];
                return Some(Json::List(items));
            }
            items.push(Json::read(rest)?);
        }
    }
}

fn number(x: f64) -> String {
    if x.is_finite() { format!("{:?}", x) } else { format!("\"{}\"", x).to_lowercase() }
}

fn vector(v: [f64; 3], dimension: usize) -> String {
    format!("[{}]", v[..dimension].iter().map(|&x| number(x)).collect::<Vec<_>>().join(","))
}

fn quoted(text: &str) -> String {
    format!("{:?}", text.chars().take(1000).map(|c| if (' '..='~').contains(&c) { c } else { '?' }).collect::<String>())
}

fn body<'a>(message: &'a Json, name: &str, dimension: usize) -> Option<Body<'a>> {
    let fields = message.get(name)?;
    let point = |v: &Json| -> Option<[f64; 3]> {
        let mut numbers: Vec<f64> = v.items().iter().filter_map(Json::number).collect();
        if numbers.len() != dimension {
            return None;
        }
        numbers.resize(3, 0.0);
        numbers.try_into().ok()
    };
    let twist = message.get("twist").and_then(|of| of.get(name)).and_then(|of| Some([point(of.get("v")?)?, point(of.get("w")?)?]));
    let vertices = fields.get("vertices").map_or(Some(vec![]), |list| list.items().iter().map(point).collect())?;
    Some(Body { vertices, fields, twist })
}

fn answer(solve: &dyn Fn(&Body, &Body) -> Result<Reply, String>, a: Body, b: Body, dimension: usize) -> String {
    let start = std::time::Instant::now();
    let result = catch_unwind(AssertUnwindSafe(|| solve(&a, &b)));
    let spent = start.elapsed().as_nanos() as f64 / 1000.0;
    let reply = match result {
        Ok(Ok(reply)) => reply,
        Ok(Err(why)) => return format!("\"unsupported\":{}", quoted(&why)),
        Err(why) => {
            let text = why.downcast_ref::<String>().map(String::as_str).or_else(|| why.downcast_ref::<&str>().copied());
            return format!("\"failed\":{}", quoted(text.unwrap_or("a panic without a text")));
        }
    };
    let mut said = format!("\"overlap\":{},\"microseconds\":{}", reply.overlap, number(reply.microseconds.unwrap_or(spent)));
    let vector = |v| vector(v, dimension);
    let witness = reply.witness.map(|[p, q]| format!("{{\"a\":{},\"b\":{}}}", vector(p), vector(q)));
    let values = [reply.depth.map(number), reply.distance.map(number), reply.direction.map(vector), witness, reply.derivative.map(number)];
    for (name, value) in ["depth", "distance", "direction", "witness", "derivative"].iter().zip(values) {
        said += &value.map_or(String::new(), |value| format!(",\"{}\":{}", name, value));
    }
    said
}

/// Answers cases until there are no more. solve(a, b) returns a reply, or why it does not take such a pair. `declared` is what stands in the
/// hello beside type and protocol: r#""name":"mine","version":"1.0","precision":"binary64","conventions":{...}"#.
pub fn run(declared: &str, solve: impl Fn(&Body, &Body) -> Result<Reply, String>) {
    extern "C" {
        fn dup(file: i32) -> i32;
        fn dup2(from: i32, to: i32) -> i32;
    }
    // SAFETY: the copy of standard output is nobody else's; what is printed from here on goes to standard error.
    let mut out: std::fs::File = unsafe { std::os::unix::io::FromRawFd::from_raw_fd(dup(1)) };
    unsafe { dup2(2, 1) };
    let dimension = if declared.contains("\"dimension\":2") { 2 } else { 3 };
    for line in std::io::stdin().lock().lines().map(|line| line.expect("a line")) {
        let message = Json::read(&mut line.as_str()).unwrap_or_else(|| panic!("no message: {}", line));
        let said = match message.get("type").map(Json::text) {
            Some("hello") => format!("{{\"type\":\"hello\",\"protocol\":\"fathom/subject/1\",{}}}", declared),
            Some("run") => {
                let bodies = body(&message, "a", dimension).zip(body(&message, "b", dimension));
                let (a, b) = bodies.unwrap_or_else(|| panic!("bodies without vertices: {}", line));
                format!("{{\"type\":\"reply\",\"id\":\"{}\",{}}}", message.get("id").map_or("", Json::text), answer(&solve, a, b, dimension))
            }
            _ => return,
        };
        out.write_all((said + "\n").as_bytes()).expect("the reply is written");
    }
}
