//! What drawing yields.

/// Pixels in the order in which a browser's `ImageData` has them: from left to right, then from top to bottom.
///
/// Every pixel is opaque. Premultiplied and straight alpha are then the same,
/// and the bytes can be handed over as they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// In pixels.
    pub width: u32,
    /// In pixels.
    pub height: u32,
    /// Four bytes for each pixel: red, green, blue and 255.
    pub rgba: Vec<u8>,
}

/// Bytes of one pixel.
pub(crate) const BYTES_PER_PIXEL: usize = 4;
