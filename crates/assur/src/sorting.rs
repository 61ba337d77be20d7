//! Sorting of any list by a single instantiation of the standard library's sort, which sorts indices. Each further
//! instantiation would add several kilobytes to the page.

use std::cmp::Ordering;

/// Sorts a list in ascending order.
pub fn sort<T: Ord>(list: &mut [T]) {
    sort_by(list, T::cmp);
}

/// Sorts a list by a comparison; stable.
pub fn sort_by<T>(list: &mut [T], compare: impl Fn(&T, &T) -> Ordering) {
    if list.is_sorted_by(|a, b| compare(a, b).is_le()) {
        return;
    }
    let order = order(list.len(), &|a, b| compare(&list[a], &list[b]));
    permute(list, order);
}

/// Sorts a list by a key, computed once for each item; stable.
pub fn sort_by_key<T, K: Ord>(list: &mut [T], key: impl Fn(&T) -> K) {
    let keys: Vec<K> = list.iter().map(key).collect();
    if keys.is_sorted() {
        return;
    }
    permute(list, order(keys.len(), &|a, b| keys[a].cmp(&keys[b])));
}

/// Minimum and maximum of the values; +∞ and −∞ if there are no values.
pub fn extremes(values: impl Iterator<Item = f64>) -> [f64; 2] {
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[min, max], value| {
        [min.min(value), max.max(value)]
    })
}

/// The indices 0 … `count` − 1, sorted by a comparison of the items at these indices; stable.
#[inline(never)]
fn order(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| compare(a, b));
    order
}

/// Moves the item at index `order[k]` to index k, for every k; follows the cycles of the permutation.
pub(crate) fn permute<T>(list: &mut [T], mut order: Vec<usize>) {
    for start in 0..order.len() {
        let mut place = start;
        while order[place] != start {
            let from = order[place];
            list.swap(place, from);
            order[place] = place;
            place = from;
        }
        order[place] = place;
    }
}

#[cfg(test)]
mod tests {
    use super::{sort_by, sort_by_key};

    /// Unsorted numbers, many of them repeated, with their indices.
    fn shuffled(count: u32) -> Vec<(u32, u32)> {
        (0..count).map(|at| ((at * 37 + 11) % 23, at)).collect()
    }

    #[test]
    fn equal_ones_stay_as_they_were() {
        for count in [0, 1, 2, 3, 20, 21, 500] {
            let mut sorted = shuffled(count);
            sorted.sort_by_key(|&(value, _)| value);
            let mut by_key = shuffled(count);
            sort_by_key(&mut by_key, |&(value, _)| value);
            assert_eq!(by_key, sorted);
            let mut by = shuffled(count);
            sort_by(&mut by, |a, b| a.0.cmp(&b.0));
            assert_eq!(by, sorted);
        }
    }
}
