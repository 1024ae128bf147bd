//! FEED: feed and spindle speed.

pub(crate) mod arc_feed_not_stated;
pub(crate) mod arithmetic_width;
pub(crate) mod coarse_reciprocal;
pub(crate) mod geometric_width;
pub(crate) mod no_feed;
pub(crate) mod no_own_feed;
pub(crate) mod not_in_1058;
pub(crate) mod reciprocal_on_parabola;
pub(crate) mod second_digit_zero;
pub(crate) mod shift_not_stated;
pub(crate) mod short_reciprocal;
pub(crate) mod slow_reading;
pub(crate) mod spindle_without_speed;
pub(crate) mod stop_or_rapid;
pub(crate) mod too_fast;
pub(crate) mod unlisted_code;

use crate::format::{Control, FeedCoding};

/// The coding of F or S, where it fixes how many digits the word has.
pub(super) fn coding(address: u8, control: &Control) -> Option<FeedCoding> {
    let coding = match address {
        b'F' => control.feed,
        b'S' => control.spindle,
        _ => return None,
    };
    matches!(coding, FeedCoding::Arithmetic | FeedCoding::Geometric).then_some(coding)
}
