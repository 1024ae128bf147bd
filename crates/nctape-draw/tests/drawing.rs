//! Measures the drawing of a tape with a rule: every hole where the punch's manual puts it.

use nctape_draw::svg;

/// Centres in millimetres from the reference edge, tracks 1 to 8, as the manual of the punch lists them.
const TRACKS: [f64; 8] = [2.34, 4.88, 7.42, 12.50, 15.04, 17.58, 20.12, 22.66];
const FEED: f64 = 9.96;

/// The numbers of one attribute, in order.
fn numbers(drawing: &str, element: &str, attribute: &str) -> Vec<f64> {
    let start = format!(" {attribute}=\"");
    let value = |piece: &str| {
        let piece = &piece[..piece.find('>').unwrap()];
        let from =
            piece.find(&start).map(|at| at + start.len()).unwrap_or_else(|| panic!("{piece} has no {attribute}"));
        piece[from..].split(['"', 'm']).next().unwrap().parse().unwrap()
    };
    drawing.split(&format!("<{element}")).skip(1).map(value).collect()
}

#[test]
fn every_hole_is_where_it_is_on_real_tape() {
    let rows: Vec<u8> = (0..=255).collect();
    let drawing = svg(&rows, 100);
    let (x, y, r) =
        (numbers(&drawing, "circle", "cx"), numbers(&drawing, "circle", "cy"), numbers(&drawing, "circle", "r"));
    let edges: Vec<f64> = numbers(&drawing, "rect", "y").iter().map(|top| top + 25.40).collect();
    assert_eq!(edges.len(), 3, "256 rows in lines of a hundred");

    let mut holes = 0;
    for (place, &byte) in rows.iter().chain(&[0; 44]).enumerate() {
        let (line, column) = (place / 100, place % 100);
        let wanted = (1..=8).filter(|track| byte >> (track - 1) & 1 == 1).map(|track: usize| (TRACKS[track - 1], 1.83));
        let mut wanted: Vec<(f64, f64)> = wanted.chain([(FEED, 1.17)]).collect();
        let centre = 2.54 * (column as f64 + 0.5);
        while holes < x.len() && (x[holes] - centre).abs() < 0.01 && (edges[line] - y[holes] - 12.7).abs() < 12.7 {
            let from_edge = edges[line] - y[holes];
            let fits = |&(track, diameter): &(f64, f64)| {
                (track - from_edge).abs() <= 0.01 && (2.0 * r[holes] - diameter).abs() <= 0.01
            };
            let found = wanted.iter().position(fits).unwrap_or_else(|| panic!("row {place}: a hole at {from_edge}"));
            wanted.remove(found);
            holes += 1;
        }
        assert!(wanted.is_empty(), "row {place} ({byte:08b}) lacks {wanted:?}");
    }
    assert_eq!(holes, x.len(), "a hole too many");
}

#[test]
fn the_drawing_states_its_size_in_millimetres() {
    let one = svg(&[0; 10], 100);
    assert!(one.contains(r#"width="25.40mm" height="25.40mm" viewBox="0 0 25.40 25.40""#), "{}", &one[..120]);
    let none = svg(&[], 100);
    assert_eq!(none.matches("<circle").count(), 1, "bare tape has its feed hole");
    assert_eq!(svg(&[0xff; 3], 0).matches("<rect").count(), 3, "a line holds a row at least");
}
