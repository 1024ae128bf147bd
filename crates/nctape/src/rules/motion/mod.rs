//! MOT: spans.

pub(crate) mod degenerate_parabola;
pub(crate) mod full_circle;
pub(crate) mod idle_parameter;
pub(crate) mod leaves_quadrant;
pub(crate) mod no_motion;
pub(crate) mod other_reading;
pub(crate) mod other_way;
pub(crate) mod out_of_plane;
pub(crate) mod overflow;
pub(crate) mod points_on_a_line;
pub(crate) mod radius_mismatch;
pub(crate) mod skewed_parabola;
pub(crate) mod too_many_axes;
pub(crate) mod unfinished_arc;
pub(crate) mod unfinished_parabola;
pub(crate) mod zero_radius;
