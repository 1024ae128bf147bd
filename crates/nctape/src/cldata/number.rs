//! Numbers (5.9, 5.10): an integer has no point, a real has one. A lone point is zero.

use super::element::ElementKind;

/// The powers of ten that an f64 holds without rounding.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// The kind and value of a number without layout; `None` where it is none. A number beyond all bounds is infinite.
pub(super) fn read(text: &str) -> Option<(ElementKind, f64)> {
    let bytes = text.as_bytes();
    let signed = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let (mut mantissa, mut digits, mut behind, mut point, mut at) = (0_u64, 0_usize, 0_i64, false, signed);
    while let Some(&byte) = bytes.get(at) {
        match byte {
            b'0'..=b'9' => {
                // More than 19 digits do not fit, and the slow way is taken then.
                mantissa = mantissa.wrapping_mul(10).wrapping_add(u64::from(byte - b'0'));
                digits += 1;
                behind += i64::from(point);
            }
            b'.' if !point => point = true,
            _ => break,
        }
        at += 1;
    }
    let mut exponent = 0_i64;
    if matches!(bytes.get(at), Some(b'E' | b'e')) {
        exponent = read_exponent(&text[at + 1..])?;
        at = bytes.len();
    }
    let has_exponent = at == bytes.len() && exponent != 0 || text.contains(['E', 'e']);
    if at < bytes.len() || !point && (digits == 0 || has_exponent) {
        return None;
    }
    let kind = if point { ElementKind::Real } else { ElementKind::Integer };
    let negative = bytes.first() == Some(&b'-');
    let scale = exponent - behind;
    // Both are exact, and the one operation rounds once: the nearest number is found.
    let exact = digits <= 15 && scale.unsigned_abs() <= 22;
    let value = match (digits, exact) {
        (0, _) => 0.0,
        (_, true) if scale < 0 => mantissa as f64 / POWERS[scale.unsigned_abs() as usize],
        (_, true) => mantissa as f64 * POWERS[scale as usize],
        // `+1.E5` and `.5` are numbers of Rust too; without digits before and behind the point it was zero.
        _ => text[signed..].parse().ok()?,
    };
    Some((kind, if negative { -value } else { value }))
}

/// The digits behind an `E`; one beyond all bounds is as good as the bound.
fn read_exponent(text: &str) -> Option<i64> {
    let digits = text.strip_prefix(['+', '-']).unwrap_or(text);
    if digits.is_empty() || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let value = digits.parse::<i64>().unwrap_or(i64::MAX).min(1_000_000);
    Some(if text.starts_with('-') { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::read;
    use crate::cldata::ElementKind::{Integer, Real};

    #[test]
    fn the_printed_examples_and_the_edges() {
        // 5.8.2, 5.9.2 and 5.10.2, whose blanks the reader has passed over.
        for (text, number) in [
            ("+45", Some((Integer, 45.0))),
            ("-.82844E-3", Some((Real, -0.00082844))),
            ("72.6", Some((Real, 72.6))),
            ("123", Some((Integer, 123.0))),
            ("-14", Some((Integer, -14.0))),
            ("+4527", Some((Integer, 4527.0))),
            ("123.", Some((Real, 123.0))),
            ("-.14", Some((Real, -0.14))),
            ("+45.27", Some((Real, 45.27))),
            (".6428E-2", Some((Real, 0.006428))),
            (".", Some((Real, 0.0))),
            ("-.", Some((Real, 0.0))),
            (".E5", Some((Real, 0.0))),
            ("1.e5", Some((Real, 100000.0))),
            ("007", Some((Integer, 7.0))),
            ("0.1234567890123456789", Some((Real, 0.123_456_789_012_345_68))),
            ("1.E400", Some((Real, f64::INFINITY))),
            ("1E5", None),
            ("1.E", None),
            ("1.E0", Some((Real, 1.0))),
            ("1E0", None),
            ("1.2.3", None),
            ("1-2", None),
            ("+", None),
            ("", None),
        ] {
            assert_eq!(read(text), number, "{text}");
        }
    }
}
