//! FEED: feed and spindle speed.

pub(crate) mod arc_feed_not_stated;
pub(crate) mod no_feed;
pub(crate) mod no_own_feed;
