//! Rank and null space of a sparse matrix of small dense blocks.
//!
//! Gaussian elimination by *fronts* (Duff, Reid, *The multifrontal solution of indefinite sparse symmetric linear
//! equations*, 1983). A front is a set of dense rows over a few blocks of columns. To eliminate a block, all fronts
//! that contain the block are merged. Each pivot is the greatest entry in the columns of the block, so no multiplier is
//! greater than 1. The remaining rows form one front without the block. The next block is the one with the smallest
//! merged front. Columns in which only zeros are left have no pivot and are *free*.

use super::screw::ZERO;

/// Homogeneous linear system, with entries of about 1 or less.
#[derive(Clone, Debug)]
pub(super) struct System {
    /// Columns of each block: the first, and one past the last.
    blocks: Vec<[usize; 2]>,
    fronts: Vec<Front>,
}

/// Dense rows over blocks of columns.
#[derive(Clone, Debug)]
struct Front {
    blocks: Vec<usize>,
    width: usize,
    /// Row-major entries.
    entries: Vec<f64>,
}

impl Front {
    fn rows(&self) -> usize {
        self.entries.len().checked_div(self.width).unwrap_or(0)
    }
}

#[derive(Clone, Debug)]
pub(super) struct Eliminated {
    columns: usize,
    pivots: Vec<Pivot>,
    /// The columns without a pivot, in the order of detection.
    free: Vec<Free>,
}

/// Pivot row, solved for the unknown of its column: this unknown is a combination of free unknowns and of unknowns
/// eliminated later.
#[derive(Clone, Debug)]
struct Pivot {
    column: usize,
    /// Coefficients of the other unknowns.
    others: Vec<(usize, f64)>,
}

/// A column without a pivot.
#[derive(Clone, Copy, Debug)]
struct Free {
    column: usize,
    /// Number of pivots found before the column proved free. No later pivot depends on the column.
    before: usize,
}

impl System {
    /// A system without rows; `sizes` gives the number of columns of each block.
    pub(super) fn new(sizes: impl Iterator<Item = usize>) -> Self {
        let blocks = sizes.scan(0, |end, size| {
            *end += size;
            Some([*end - size, *end])
        });
        Self {
            blocks: blocks.collect(),
            fronts: vec![],
        }
    }

    /// Adds rows over given blocks, with row-major entries.
    pub(super) fn push(&mut self, blocks: Vec<usize>, entries: Vec<f64>) {
        let width = blocks.iter().map(|block| self.size(*block)).sum();
        self.fronts.push(Front {
            blocks,
            width,
            entries,
        });
    }

    fn size(&self, block: usize) -> usize {
        let [start, end] = self.blocks[block];
        end - start
    }

    fn columns(&self) -> usize {
        self.blocks.last().map_or(0, |[_, end]| *end)
    }

    /// Eliminates every block except `kept`, whose columns stay free.
    pub(super) fn eliminated(mut self, kept: Option<usize>) -> Eliminated {
        let mut done = Eliminated {
            columns: self.columns(),
            pivots: vec![],
            free: vec![],
        };
        let mut fronts_of = vec![vec![]; self.blocks.len()];
        for (at, front) in self.fronts.iter().enumerate() {
            for &block in &front.blocks {
                fronts_of[block].push(at);
            }
        }
        let mut waiting: Vec<usize> = (0..self.blocks.len()).collect();
        waiting.retain(|block| Some(*block) != kept && self.size(*block) > 0);
        let mut marks = vec![usize::MAX; self.blocks.len()];
        let mut costs: Vec<usize> = (0..self.blocks.len())
            .map(|block| self.cost(block, &fronts_of[block], &mut marks))
            .collect();
        while let Some(next) = (0..waiting.len()).min_by_key(|at| costs[waiting[*at]]) {
            let block = waiting.swap_remove(next);
            let merged = std::mem::take(&mut fronts_of[block]);
            let mut front = self.merged(block, &merged, &mut marks);
            self.reduce(&mut front, &mut done);
            for &neighbour in &front.blocks {
                fronts_of[neighbour].retain(|at| !merged.contains(at));
                fronts_of[neighbour].push(self.fronts.len());
            }
            let touched = front.blocks.clone();
            self.fronts.push(front);
            for neighbour in touched {
                costs[neighbour] = self.cost(neighbour, &fronts_of[neighbour], &mut marks);
            }
        }
        if let Some(kept) = kept {
            let [start, end] = self.blocks[kept];
            done.set_free(start..end);
        }
        done
    }

    /// Number of entries of the merged front of a block. `marks` is scratch space.
    fn cost(&self, block: usize, fronts: &[usize], marks: &mut [usize]) -> usize {
        let (mut rows, mut width) = (0, 0);
        for &at in fronts {
            rows += self.fronts[at].rows();
            for &other in &self.fronts[at].blocks {
                if marks[other] != block {
                    marks[other] = block;
                    width += self.size(other);
                }
            }
        }
        for &at in fronts {
            for &other in &self.fronts[at].blocks {
                marks[other] = usize::MAX;
            }
        }
        rows * width
    }

    /// Merges fronts into one that begins with the columns of the block, and empties them. `starts` is scratch space.
    fn merged(&mut self, block: usize, fronts: &[usize], starts: &mut [usize]) -> Front {
        let mut blocks = vec![block];
        starts[block] = 0;
        let mut width = self.size(block);
        for &at in fronts {
            for &other in &self.fronts[at].blocks {
                if starts[other] == usize::MAX {
                    starts[other] = width;
                    width += self.size(other);
                    blocks.push(other);
                }
            }
        }
        let rows: usize = fronts.iter().map(|at| self.fronts[*at].rows()).sum();
        let mut entries = vec![0.0; rows * width];
        let mut row = 0;
        for &at in fronts {
            let old = std::mem::take(&mut self.fronts[at].entries);
            let part = &self.fronts[at];
            for values in old.chunks_exact(part.width.max(1)) {
                let target = &mut entries[row * width..][..width];
                let mut values = values;
                for &other in &part.blocks {
                    let (own, rest) = values.split_at(self.size(other));
                    target[starts[other]..][..own.len()].copy_from_slice(own);
                    values = rest;
                }
                row += 1;
            }
        }
        for &other in &blocks {
            starts[other] = usize::MAX;
        }
        Front {
            blocks,
            width,
            entries,
        }
    }

    /// Eliminates the first block of a front and removes this block from the front.
    fn reduce(&self, front: &mut Front, done: &mut Eliminated) {
        let (width, rows) = (front.width, front.rows());
        let block = front.blocks.remove(0);
        let [start, end] = self.blocks[block];
        let size = end - start;
        let others = front.blocks.iter();
        let others = others.flat_map(|other| self.blocks[*other][0]..self.blocks[*other][1]);
        let mut columns: Vec<usize> = (start..end).chain(others).collect();
        let entries = &mut front.entries;
        let mut rank = 0;
        while rank < size.min(rows) {
            let (at, value) = greatest(entries, width, rank, size);
            if value < ZERO {
                break;
            }
            let (row, column) = (at / width, at % width);
            swap_rows(entries, width, rank, row);
            if column != rank {
                columns.swap(column, rank);
                for line in entries.chunks_exact_mut(width) {
                    line.swap(column, rank);
                }
            }
            let (upper, lower) = entries.split_at_mut((rank + 1) * width);
            let pivot = &upper[rank * width..];
            let inverse = 1.0 / pivot[rank];
            for line in lower.chunks_exact_mut(width) {
                let factor = line[rank] * inverse;
                if factor != 0.0 {
                    let values = line[rank + 1..].iter_mut();
                    for (value, above) in values.zip(&pivot[rank + 1..]) {
                        *value -= factor * above;
                    }
                }
            }
            rank += 1;
        }
        for (at, line) in entries.chunks_exact(width).take(rank).enumerate() {
            let scale = -1.0 / line[at];
            let others = columns[at + 1..].iter().zip(&line[at + 1..]);
            let others = others.filter(|(_, value)| **value != 0.0);
            done.pivots.push(Pivot {
                column: columns[at],
                others: others
                    .map(|(column, value)| (*column, value * scale))
                    .collect(),
            });
        }
        done.set_free(columns[rank..size].iter().copied());
        front.width = width - size;
        let left = entries
            .chunks_exact(width)
            .skip(rank)
            .map(|line| &line[size..]);
        let left = left.filter(|line| line.iter().any(|value| value.abs() >= ZERO));
        front.entries = left.flatten().copied().collect();
    }
}

/// Index and absolute value of the entry largest in absolute value, in the rows `from..` and the columns `from..to`.
fn greatest(entries: &[f64], width: usize, from: usize, to: usize) -> (usize, f64) {
    let mut greatest = (from * width + from, 0.0);
    for (row, line) in entries.chunks_exact(width).enumerate().skip(from) {
        for (column, value) in line[from..to].iter().enumerate() {
            if value.abs() > greatest.1 {
                greatest = (row * width + from + column, value.abs());
            }
        }
    }
    greatest
}

fn swap_rows(entries: &mut [f64], width: usize, upper: usize, lower: usize) {
    if upper < lower {
        let (above, below) = entries.split_at_mut(lower * width);
        above[upper * width..][..width].swap_with_slice(&mut below[..width]);
    }
}

impl Eliminated {
    /// Number of independent rows.
    pub(super) fn rank(&self) -> usize {
        self.pivots.len()
    }

    pub(super) fn free(&self) -> impl ExactSizeIterator<Item = usize> + '_ {
        self.free.iter().map(|free| free.column)
    }

    fn set_free(&mut self, columns: impl Iterator<Item = usize>) {
        let before = self.pivots.len();
        self.free
            .extend(columns.map(|column| Free { column, before }));
    }

    /// Basis of the null space: in each vector one free unknown is 1, and the other free unknowns are 0. The vectors
    /// for the block kept by [`System::eliminated`], if any, come last.
    pub(super) fn solutions(&self) -> impl DoubleEndedIterator<Item = Vec<f64>> + '_ {
        self.free.iter().map(|free| {
            let mut values = vec![0.0; self.columns];
            values[free.column] = 1.0;
            self.substitute(&mut values, free.before);
            values
        })
    }

    /// Generic combination of the solutions for the `wanted` free unknowns: no two coefficients have a simple ratio.
    pub(super) fn mixture(&self, wanted: impl Fn(usize) -> bool) -> Vec<f64> {
        let mut values = vec![0.0; self.columns];
        for column in self.free().filter(|column| wanted(*column)) {
            // Fractional parts of multiples of the golden ratio have no simple ratios. Adding 0.5 avoids small values.
            values[column] = 0.5 + ((column + 1) as f64 * 0.618_033_988_749_895).fract();
        }
        self.substitute(&mut values, self.pivots.len());
        values
    }

    /// Computes the unknowns of the first `pivots` pivots from the other unknowns.
    fn substitute(&self, values: &mut [f64], pivots: usize) {
        for pivot in self.pivots[..pivots].iter().rev() {
            let others = pivot.others.iter();
            values[pivot.column] = others.map(|(column, per)| per * values[*column]).sum();
        }
    }
}
