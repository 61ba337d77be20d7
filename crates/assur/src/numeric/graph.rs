//! Connected parts of a graph.

/// A partition of the integers from 0 to n − 1 into sets that can be joined (Galler and Fischer, *An improved
/// equivalence algorithm*, 1964). The least member of a set represents the set.
pub(crate) struct Partition(Vec<usize>);

impl Partition {
    /// Puts each of `count` numbers into a set of its own.
    pub(crate) fn new(count: usize) -> Self {
        Self((0..count).collect())
    }

    /// Least member of the set that contains a number.
    pub(crate) fn representative(&self, mut number: usize) -> usize {
        while self.0[number] != number {
            number = self.0[number];
        }
        number
    }

    /// True if two numbers are in the same set.
    pub(crate) fn joins(&self, a: usize, b: usize) -> bool {
        self.representative(a) == self.representative(b)
    }

    /// Joins the sets that contain the given numbers. Returns true if there was more than one such set.
    pub(crate) fn join(&mut self, numbers: impl IntoIterator<Item = usize>) -> bool {
        let mut numbers = numbers.into_iter();
        let Some(first) = numbers.next() else {
            return false;
        };
        let mut joined = false;
        for other in numbers {
            let [a, b] = [first, other].map(|number| self.representative(number));
            self.0[a.max(b)] = a.min(b);
            joined |= a != b;
        }
        joined
    }
}

#[cfg(test)]
mod tests {
    use super::Partition;

    #[test]
    fn joined_sets() {
        let mut parts = Partition::new(6);
        assert!(parts.join([4, 2]) && parts.join([5, 4]) && parts.join([0, 1]));
        assert!(!parts.join([2, 5]) && !parts.join([3]) && !parts.join([]));
        let representatives: Vec<usize> = (0..6).map(|k| parts.representative(k)).collect();
        assert_eq!(representatives, [0, 0, 2, 3, 2, 2]);
        assert!(parts.joins(2, 5) && !parts.joins(1, 3));
    }

    /// A square with one diagonal has 5 edges on 4 corners: 3 of them join sets, and each of the others closes a loop.
    #[test]
    fn an_edge_joins_two_sets_or_closes_a_loop() {
        let edges = [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]];
        let mut parts = Partition::new(4);
        assert_eq!(
            edges.map(|edge| parts.join(edge)),
            [true, true, true, false, false]
        );
    }

    /// Two chains, 5-4-3 and 2-1-0, then the edge between their ends. The order of the edges does not matter.
    #[test]
    fn the_least_member_represents_a_set_in_any_order() {
        for edges in [
            [[5, 4], [4, 3], [2, 1], [1, 0]],
            [[1, 0], [4, 3], [2, 1], [5, 4]],
        ] {
            let mut parts = Partition::new(6);
            edges.into_iter().for_each(|edge| {
                parts.join(edge);
            });
            let representatives: Vec<usize> = (0..6).map(|k| parts.representative(k)).collect();
            assert_eq!(representatives, [0, 0, 0, 3, 3, 3]);
            assert!(parts.join([5, 2]) && parts.joins(0, 3));
            assert_eq!(parts.representative(5), 0);
        }
    }
}
