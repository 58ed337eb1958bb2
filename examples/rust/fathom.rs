// SPDX-License-Identifier: GPL-3.0-or-later
//! The exact penetration depth of two convex bodies, over libfathom-c.so.1. Needs Rust 1.63 and no crate.
//! To be copied; the declarations are those of fathom/fathom.h, which says what each function does.

use std::ffi::{CStr, CString};
use std::os::raw::{c_char, c_double, c_int, c_uint, c_void};
use std::ptr::{null, null_mut};

// ---- fathom.h ----

/// Handles, which only the library looks into.
#[repr(C)]
pub struct FathomBody {
    _private: [u8; 0],
}
#[repr(C)]
pub struct FathomAnswer {
    _private: [u8; 0],
}

#[repr(C)]
struct FathomClaim {
    size: usize,
    precision: c_int,
    touching: c_int,
    depth_negative: c_int,
    moves_b: c_int,
    not_unit: c_int,
    tol_relative: c_double,
    tol_absolute: c_double,
    tol_ulps: c_double,
    overlap: c_int,
    has_depth: c_int,
    has_direction: c_int,
    has_witness_a: c_int,
    has_witness_b: c_int,
    depth: c_double,
    direction: [c_double; 3],
    witness_a: [c_double; 3],
    witness_b: [c_double; 3],
    answers: c_int,
    separating: c_int,
    policy: c_int,
    policy_most: c_double,
    has_distance: c_int,
    distance: c_double,
    contact_count: usize,
    contact_positions: *const c_double,
    contact_depths: *const c_double,
    has_manifold: c_int,
    most_contacts: usize,
    contact_margin: c_double,
    has_patch_slack: c_int,
    patch_slack: c_double,
    has_derivative: c_int,
    derivative: c_double,
    twist_a: [c_double; 6],
    twist_b: [c_double; 6],
}

#[repr(C)]
struct FathomJudgement {
    size: usize,
    verdict: c_int,
    findings: c_uint,
    accuracy: c_int,
    status: c_int,
    numbers: [c_double; 17], // signed_depth to witness_gap
    excess_allowed: c_int,
    more: [c_double; 6], // relative_excess to deepest
    deepest_pair: c_double,
    deepest_pieces: [usize; 2],
    of_unions: [c_double; 3], // hulls to deeper
    of_contacts: [c_double; 4], // extent_missed to derivative_error
}

#[link(name = "fathom-c")]
extern "C" {
    fn fathom_last_error() -> *const c_char;
    fn fathom_text_free(text: *mut c_char);
    fn fathom_body_from_points(xyz: *const c_double, count: usize, body: *mut *mut FathomBody) -> c_int;
    fn fathom_body_from_shape(shape: *const c_char, decimals: c_int, body: *mut *mut FathomBody) -> c_int;
    fn fathom_body_moved(body: *const FathomBody, pose: *const c_double, moved: *mut *mut FathomBody) -> c_int;
    fn fathom_body_free(body: *mut FathomBody);
    fn fathom_depth(a: *const FathomBody, b: *const FathomBody, options: *const c_void, answer: *mut *mut FathomAnswer) -> c_int;
    fn fathom_answer_free(answer: *mut FathomAnswer);
    fn fathom_answer_status(answer: *const FathomAnswer) -> c_int;
    fn fathom_answer_signed_depth(answer: *const FathomAnswer, nearest: *mut c_double, low: *mut c_double, high: *mut c_double) -> c_int;
    fn fathom_answer_translation(answer: *const FathomAnswer, translation: *mut c_double) -> c_int;
    fn fathom_answer_exact(answer: *const FathomAnswer, quantity: c_int, text: *mut *mut c_char) -> c_int;
    fn fathom_answer_certificate(answer: *const FathomAnswer, id: *const c_char, options: *const c_void, text: *mut *mut c_char) -> c_int;
    fn fathom_check_certificate(
        certificate: *const c_char, length: usize, a: *const FathomBody, b: *const FathomBody, outcome: *mut c_int, line: *mut *mut c_char,
    ) -> c_int;
    fn fathom_claim_init(claim: *mut FathomClaim);
    fn fathom_judgement_init(judgement: *mut FathomJudgement);
    fn fathom_judge(
        a: *const FathomBody, b: *const FathomBody, claim: *const FathomClaim, judgement: *mut FathomJudgement, sentence: *mut *mut c_char,
    ) -> c_int;
    fn fathom_verdict_name(verdict: c_int) -> *const c_char;
}

const OK: c_int = 0;
const EXACT_DECIMALS: c_int = 1;
const SIGNED_DEPTH: c_int = 0;

// ---- safe ----

/// A code of fathom.h that is not FATHOM_OK, and what the library says about it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    pub code: i32,
    pub message: String,
}

pub type Result<T> = std::result::Result<T, Error>;

fn checked(code: c_int) -> Result<()> {
    if code == OK {
        return Ok(());
    }
    // The message stands until this thread calls the library again.
    let message = unsafe { CStr::from_ptr(fathom_last_error()) }.to_string_lossy().into_owned();
    Err(Error { code, message })
}

/// The text, freed.
fn taken(text: *mut c_char) -> String {
    let copy = unsafe { CStr::from_ptr(text) }.to_string_lossy().into_owned();
    unsafe { fathom_text_free(text) };
    copy
}

/// A convex body: the hull of points, or a shape.
pub struct Body(*mut FathomBody);
unsafe impl Send for Body {} // handles never change
unsafe impl Sync for Body {}

impl Body {
    pub fn from_points(points: &[[f64; 3]]) -> Result<Body> {
        let mut body = null_mut();
        checked(unsafe { fathom_body_from_points(points.as_ptr().cast(), points.len(), &mut body) })?;
        Ok(Body(body))
    }

    /// "capsule:r=1/10,h=0.5", every decimal exact.
    pub fn from_shape(shape: &str) -> Result<Body> {
        let text = CString::new(shape).map_err(|_| Error { code: 1, message: "shape: found a zero".to_string() })?;
        let mut body = null_mut();
        checked(unsafe { fathom_body_from_shape(text.as_ptr(), EXACT_DECIMALS, &mut body) })?;
        Ok(Body(body))
    }

    /// Rows (M | t): x goes to M x + t, exactly.
    pub fn moved(&self, pose: &[[f64; 4]; 3]) -> Result<Body> {
        let mut body = null_mut();
        checked(unsafe { fathom_body_moved(self.0, pose.as_ptr().cast(), &mut body) })?;
        Ok(Body(body))
    }
}

impl Drop for Body {
    fn drop(&mut self) {
        unsafe { fathom_body_free(self.0) }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    Penetrating,
    Touching,
    Disjoint,
    Undecided,
}

/// The answer about two bodies.
pub struct Answer(*mut FathomAnswer);
unsafe impl Send for Answer {}
unsafe impl Sync for Answer {}

pub fn depth(a: &Body, b: &Body) -> Result<Answer> {
    let mut answer = null_mut();
    checked(unsafe { fathom_depth(a.0, b.0, null(), &mut answer) })?;
    Ok(Answer(answer))
}

impl Answer {
    pub fn status(&self) -> Status {
        match unsafe { fathom_answer_status(self.0) } {
            0 => Status::Penetrating,
            1 => Status::Touching,
            2 => Status::Disjoint,
            _ => Status::Undecided,
        }
    }

    /// To nearest: the depth, or minus the distance. NaN if bounds leave it open.
    pub fn signed_depth(&self) -> f64 {
        let mut nearest = f64::NAN;
        let code = unsafe { fathom_answer_signed_depth(self.0, &mut nearest, null_mut(), null_mut()) };
        debug_assert_eq!(code, OK);
        nearest
    }

    /// Exactly: "3/5", "-sqrt(2)+1".
    pub fn exact_signed_depth(&self) -> Result<String> {
        let mut text = null_mut();
        checked(unsafe { fathom_answer_exact(self.0, SIGNED_DEPTH, &mut text) })?;
        Ok(taken(text))
    }

    /// Of A: the bodies touch after it.
    pub fn translation(&self) -> Result<[f64; 3]> {
        let mut translation = [0.0; 3];
        checked(unsafe { fathom_answer_translation(self.0, translation.as_mut_ptr()) })?;
        Ok(translation)
    }

    pub fn certificate(&self) -> Result<String> {
        let mut text = null_mut();
        checked(unsafe { fathom_answer_certificate(self.0, null(), null(), &mut text) })?;
        Ok(taken(text))
    }
}

impl Drop for Answer {
    fn drop(&mut self) {
        unsafe { fathom_answer_free(self.0) }
    }
}

/// Whether the text is a proof, and the checker's line about it.
pub fn check(certificate: &str) -> Result<(bool, String)> {
    let (mut outcome, mut line) = (0, null_mut());
    let text = certificate.as_bytes();
    checked(unsafe { fathom_check_certificate(text.as_ptr().cast(), text.len(), null(), null(), &mut outcome, &mut line) })?;
    Ok((outcome == 0, taken(line)))
}

/// The verdict on an implementation that says that A leaves B by `depth * direction`, and the reason.
pub fn judge(a: &Body, b: &Body, depth: f64, direction: [f64; 3]) -> Result<(String, String)> {
    let mut sentence = null_mut();
    unsafe {
        let mut claim: FathomClaim = std::mem::zeroed();
        let mut judgement: FathomJudgement = std::mem::zeroed();
        fathom_claim_init(&mut claim);
        fathom_judgement_init(&mut judgement);
        claim.overlap = 1;
        claim.has_depth = 1;
        claim.depth = depth;
        claim.has_direction = 1;
        claim.direction = direction;
        checked(fathom_judge(a.0, b.0, &claim, &mut judgement, &mut sentence))?;
        let verdict = CStr::from_ptr(fathom_verdict_name(judgement.verdict)).to_string_lossy().into_owned();
        Ok((verdict, taken(sentence)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> Body {
        let corners: Vec<[f64; 3]> = (0..8).map(|i| [(i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64]).collect();
        Body::from_points(&corners).unwrap()
    }

    fn beside(body: &Body, x: f64) -> Body {
        body.moved(&[[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]).unwrap()
    }

    #[test]
    fn cubes_overlap_by_a_quarter() {
        let (a, b) = (cube(), beside(&cube(), 0.75));
        let answer = depth(&a, &b).unwrap();
        assert_eq!(answer.status(), Status::Penetrating);
        assert_eq!(answer.signed_depth(), 0.25);
        assert_eq!(answer.exact_signed_depth().unwrap(), "1/4");
        assert_eq!(answer.translation().unwrap(), [-0.25, 0.0, 0.0]);
        let (proved, line) = check(&answer.certificate().unwrap()).unwrap();
        assert!(proved, "{}", line);
        assert!(!check("no certificate").unwrap().0);
    }

    #[test]
    fn round_bodies_are_exact() {
        let ball = Body::from_shape("sphere:r=1").unwrap();
        let answer = depth(&ball, &beside(&ball, 3.0)).unwrap();
        assert_eq!(answer.status(), Status::Disjoint);
        assert_eq!(answer.exact_signed_depth().unwrap(), "-1");
    }

    #[test]
    fn wrong_answers_are_judged() {
        let (a, b) = (cube(), beside(&cube(), 0.75));
        assert_eq!(judge(&a, &b, 0.25, [-1.0, 0.0, 0.0]).unwrap().0, "pass");
        assert_eq!(judge(&a, &b, 0.5, [-1.0, 0.0, 0.0]).unwrap().0, "too-deep");
    }

    #[test]
    fn bad_input_is_an_error() {
        let fault = Body::from_points(&[[0.0, f64::NAN, 0.0]]).err().unwrap();
        assert_eq!(fault.code, 1);
        assert!(fault.message.starts_with("point 0: expected finite coordinates"), "{}", fault.message);
        assert!(Body::from_points(&[]).is_err());
        assert!(Body::from_shape("ball").is_err());
    }

    #[test]
    fn answers_may_be_found_in_many_threads() {
        let (a, b) = (cube(), Body::from_shape("capsule:r=1/3,h=2").unwrap());
        let expected = depth(&a, &b).unwrap().exact_signed_depth().unwrap();
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| assert_eq!(depth(&a, &b).unwrap().exact_signed_depth().unwrap(), expected));
            }
        });
    }
}
