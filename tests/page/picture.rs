//! What is on the screen, in pixels.

/// Colours of the roles on light paper, as the page's style sheet has them.
pub(crate) const CRANK: [u8; 3] = [0x00, 0x72, 0xB2];
pub(crate) const COUPLER: [u8; 3] = [0xD5, 0x5E, 0x00];
pub(crate) const ROCKER: [u8; 3] = [0x00, 0x9E, 0x73];
pub(crate) const WHEEL5: [u8; 3] = [0x7A, 0x4A, 0x8C];

/// A picture of a part of the page.
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    rgb: Vec<[u8; 3]>,
}

/// Where pixels of a colour lie, in pixels from the upper left corner.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cloud {
    pub(crate) count: usize,
    pub(crate) x: f64,
    pub(crate) y: f64,
    /// Direction of its longest extent, degrees counter-clockwise, modulo 180.
    pub(crate) direction: f64,
    /// Its extent that way.
    pub(crate) length: f64,
    /// The middle of that extent: where a bar's middle is, whatever lies over it.
    pub(crate) middle: (f64, f64),
}

impl Picture {
    pub(crate) fn decode(png: &[u8]) -> Self {
        let mut reader = png::Decoder::new(std::io::Cursor::new(png))
            .read_info()
            .unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        let channels = info.color_type.samples();
        assert!(channels >= 3, "a picture in colours");
        let bytes = &bytes[..info.buffer_size()];
        Self {
            width: info.width as usize,
            height: info.height as usize,
            rgb: bytes.chunks(channels).map(|p| [p[0], p[1], p[2]]).collect(),
        }
    }

    /// The places of pixels of a colour.
    pub(crate) fn places(&self, colour: [u8; 3]) -> impl Iterator<Item = (usize, usize)> {
        let all = self.rgb.iter().enumerate();
        let found = all.filter(move |(_, pixel)| alike(**pixel, colour, 6));
        found.map(|(index, _)| (index % self.width, index / self.width))
    }

    /// The middle of the rectangle around the pixels of a colour. Unlike the middle of an extent it does not depend on how
    /// the edges of something round are smoothed.
    pub(crate) fn centre(&self, colour: [u8; 3]) -> (f64, f64) {
        let (across, down): (Vec<usize>, Vec<usize>) = self.places(colour).unzip();
        let middle = |all: Vec<usize>| {
            let [least, greatest] = [all.iter().min(), all.iter().max()].map(Option::unwrap);
            (least + greatest) as f64 / 2.0
        };
        (middle(across), middle(down))
    }

    /// Where the pixels of a colour lie.
    pub(crate) fn cloud(&self, colour: [u8; 3]) -> Cloud {
        let places: Vec<(f64, f64)> = self
            .places(colour)
            .map(|(x, y)| (x as f64 + 0.5, y as f64 + 0.5))
            .collect();
        let count = places.len();
        let mean =
            |f: &dyn Fn(&(f64, f64)) -> f64| places.iter().map(f).sum::<f64>() / count as f64;
        let (x, y) = (mean(&|p| p.0), mean(&|p| p.1));
        let [xx, xy, yy] = [
            mean(&|p| (p.0 - x) * (p.0 - x)),
            mean(&|p| -(p.0 - x) * (p.1 - y)),
            mean(&|p| (p.1 - y) * (p.1 - y)),
        ];
        let direction = 0.5 * (2.0 * xy).atan2(xx - yy);
        let (sin, cos) = direction.sin_cos();
        let along = |p: &(f64, f64)| (p.0 - x) * cos - (p.1 - y) * sin;
        let from = places.iter().map(along).fold(f64::INFINITY, f64::min);
        let to = places.iter().map(along).fold(f64::NEG_INFINITY, f64::max);
        let half = 0.5 * (from + to);
        Cloud {
            count,
            x,
            y,
            direction: direction.to_degrees().rem_euclid(180.0),
            length: to - from,
            middle: (x + half * cos, y - half * sin),
        }
    }

    /// How many pixels differ from another picture's.
    pub(crate) fn difference(&self, other: &Self) -> usize {
        assert_eq!((self.width, self.height), (other.width, other.height));
        let pairs = self.rgb.iter().zip(&other.rgb);
        pairs.filter(|(a, b)| !alike(**a, **b, 24)).count()
    }

    /// Mean brightness distance from the paper: how strongly things are drawn.
    pub(crate) fn ink(&self) -> f64 {
        let dark = self.rgb.as_flattened().iter().map(|c| f64::from(255 - c));
        dark.sum::<f64>() / self.rgb.len() as f64
    }
}

/// Whether two colours differ by no more than so much in each channel.
fn alike(a: [u8; 3], b: [u8; 3], by: u8) -> bool {
    a.iter().zip(b).all(|(a, b)| a.abs_diff(b) <= by)
}

/// The angle between two directions modulo 180, degrees.
pub(crate) fn apart(a: f64, b: f64) -> f64 {
    ((a - b + 90.0).rem_euclid(180.0) - 90.0).abs()
}
