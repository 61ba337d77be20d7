//! The start data of the homotopy: one generic set of nine complex points and its 1,442 curves.
//!
//! Format of the bytes, all little-endian: `MARK`; the number of curves (u32); the 16 complex displacements (f64); for
//! each curve the 8 complex coordinates of one four-bar (f32); the checksum of all preceding bytes (u64). Newton's
//! method restores the digits that f32 lacks.

use super::alt::{Displacements, Dyads};
use super::tracker::polished;
use super::{C, CURVES};

const MARK: &[u8; 8] = b"assur-9p";
const HEAD: usize = 8 + 4 + 16 * 16;
const EACH: usize = 8 * 8;

/// A generic set of nine points with one four-bar of each curve through them.
#[derive(Clone, Debug)]
pub struct Start {
    pub(super) displacements: Displacements,
    pub(super) dyads: Vec<Dyads>,
}

/// Reasons why bytes are not start data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StartError {
    /// The bytes have another format, or are incomplete.
    Form,
    /// The checksum does not agree with the bytes.
    Checksum,
    /// Newton's method does not converge from the curve with this index.
    Curve(usize),
}

/// Checksum of bytes: FNV-1a with 64 bits.
pub fn checksum(bytes: &[u8]) -> u64 {
    let add = |sum: u64, byte: &u8| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, add)
}

impl Start {
    /// Start data from their bytes.
    ///
    /// # Errors
    /// [`StartError`] if the bytes are damaged.
    pub fn read(bytes: &[u8]) -> Result<Self, StartError> {
        let (body, sum) = bytes.split_last_chunk::<8>().ok_or(StartError::Form)?;
        let rest = body.strip_prefix(MARK).ok_or(StartError::Form)?;
        if body.len() != HEAD + CURVES * EACH || rest[..4] != (CURVES as u32).to_le_bytes() {
            return Err(StartError::Form);
        }
        if checksum(body) != u64::from_le_bytes(*sum) {
            return Err(StartError::Checksum);
        }
        let (head, curves) = rest[4..].split_at(HEAD - 12);
        let mut doubles = head
            .as_chunks::<8>()
            .0
            .iter()
            .map(|b| f64::from_le_bytes(*b));
        let mut eight = || {
            [(); 8].map(|()| {
                let mut part = || doubles.next().unwrap_or(0.0);
                C::new(part(), part())
            })
        };
        let displacements = Displacements {
            forward: eight(),
            backward: eight(),
        };
        let singles = |b: &[u8; EACH]| {
            let mut parts = b.as_chunks::<4>().0.iter().map(|b| f32::from_le_bytes(*b));
            let mut part = || f64::from(parts.next().unwrap_or(0.0));
            [(); 8].map(|()| C::new(part(), part()))
        };
        let rough = curves.as_chunks::<EACH>().0.iter().map(singles);
        let dyads = rough
            .enumerate()
            .map(|(k, rough)| polished(rough, &displacements).ok_or(StartError::Curve(k)))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            displacements,
            dyads,
        })
    }

    /// The bytes of start data.
    pub fn write(&self) -> Vec<u8> {
        let mut bytes = MARK.to_vec();
        bytes.extend((self.dyads.len() as u32).to_le_bytes());
        let Displacements { forward, backward } = &self.displacements;
        for z in forward.iter().chain(backward) {
            bytes.extend(z.re.to_le_bytes());
            bytes.extend(z.im.to_le_bytes());
        }
        for z in self.dyads.iter().flatten() {
            bytes.extend((z.re as f32).to_le_bytes());
            bytes.extend((z.im as f32).to_le_bytes());
        }
        bytes.extend(checksum(&bytes).to_le_bytes());
        bytes
    }
}
