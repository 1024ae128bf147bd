//! Curves as blocks of a format: parabolas and cubics, and spans by points in successive blocks.

use super::motion::{Move, Part};
use super::{Fault, TapeWriter};
use crate::execute::cubic::Cubic;
use crate::format::{ArcCentre, ParabolaParameters};

impl TapeWriter<'_> {
    pub(super) fn parabola(&mut self, tangent: [f64; 3], end: &[i64], motion: &Move) -> Result<(), Fault> {
        let start: [f64; 3] = std::array::from_fn(|axis| self.position(axis));
        let to: [f64; 3] = std::array::from_fn(|axis| crate::execute::in_unit(&self.control.axes[axis], end[axis]));
        let used: Vec<usize> = (0..3).filter(|&axis| tangent[axis] != start[axis] || to[axis] != start[axis]).collect();
        let letters = used.iter().all(|&axis| self.designation(['I', 'J', 'K'][axis]).is_ok());
        if letters
            && self.control.parabola_parameters == ParabolaParameters::Tangent
            && self.control.arc_centre != ArcCentre::Quadrant
        {
            let mut words = self.dimensions(end, motion)?;
            for &axis in &used {
                words.push(self.parameter(axis, tangent[axis])?);
            }
            words.extend(self.feed(motion, 1.0, None)?);
            words.extend(self.interpolation(6)?);
            self.block(words);
            self.at.copy_from_slice(end);
            return Ok(());
        }
        // By its point opposite the middle of the chord, which is halfway to where the tangents meet.
        let mut middle = end.to_vec();
        let kept = self.rounding;
        for axis in used {
            let (letter, decimals) = (self.control.axes[axis].letter, self.control.axes[axis].decimals);
            let at = (start[axis] + 2.0 * tangent[axis] + to[axis]) / 4.0;
            middle[axis] = self.increments(at, decimals, letter)?;
        }
        self.rounding = kept;
        self.two_blocks(6, &middle, end, motion, Part { share: 1.0, sweep: 0.0 })
    }

    /// A span by an intermediate point and its end. The F of the last block is that of the span.
    pub(super) fn two_blocks(
        &mut self,
        code: u8,
        middle: &[i64],
        end: &[i64],
        motion: &Move,
        part: Part,
    ) -> Result<(), Fault> {
        let sweep = (code != 6).then_some(part.sweep);
        for point in [middle, end] {
            let mut words = self.point(point, motion)?;
            words.extend(self.feed(motion, part.share, sweep)?);
            words.extend(self.interpolation(code)?);
            self.block(words);
            self.at.copy_from_slice(point);
        }
        Ok(())
    }

    /// A cubic in three blocks, by its points at 1/3 and 2/3 of its parameter and its end. Another axis goes in
    /// proportion. The F of the last block is that of the span.
    pub(super) fn cubic(&mut self, control: [[f64; 3]; 2], end: &[i64], motion: &Move) -> Result<(), Fault> {
        let code = (0..100).find(|&code| self.control.is_curve(code)).ok_or(Fault::NoCubic)?;
        let start: [f64; 3] = std::array::from_fn(|axis| self.position(axis));
        let to: [f64; 3] = std::array::from_fn(|axis| crate::execute::in_unit(&self.control.axes[axis], end[axis]));
        let (curve, from) = (Cubic { start, control, end: to }, self.at.clone());
        for share in [1.0 / 3.0, 2.0 / 3.0, 1.0] {
            let mut point = end.to_vec();
            if share < 1.0 {
                let at = curve.point(share);
                for axis in 0..point.len() {
                    let way = (end[axis] - from[axis]) as f64;
                    match at.get(axis) {
                        Some(&at) if self.control.axes[axis].sign.is_some() => {
                            self.place(&mut point, [axis, axis], [at, at])?;
                        }
                        Some(_) => point[axis] = from[axis],
                        None => point[axis] = from[axis] + (share * way).round() as i64,
                    }
                }
            }
            let mut words = self.point(&point, motion)?;
            words.extend(self.feed(motion, 1.0, None)?);
            words.extend(self.interpolation(code)?);
            self.block(words);
            self.at.copy_from_slice(&point);
        }
        Ok(())
    }

    /// Dimension words of a point of a span: one at least, because a block without any is no point.
    fn point(&mut self, to: &[i64], motion: &Move) -> Result<Vec<(char, String)>, Fault> {
        let mut words = self.dimensions(to, motion)?;
        if words.is_empty()
            && let Some(axis) = (0..to.len()).find(|&axis| self.control.axes[axis].sign.is_some())
        {
            let letter = self.control.axes[axis].letter;
            let number = if self.is_incremental(axis) { 0 } else { to[axis] };
            words.push((letter, self.dimension_word(letter, number)?));
        }
        Ok(words)
    }
}
