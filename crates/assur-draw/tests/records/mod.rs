//! Reading of display lists.

/// Cuts a list into its records, by the counts that the records contain.
pub(crate) fn records(mut numbers: &[f32]) -> Vec<Vec<f32>> {
    let mut found = Vec::new();
    while let Some(kind) = numbers.first() {
        let length = match *kind as u8 {
            0 => 2,
            1 => {
                let mut length = 4;
                for _ in 0..numbers[3] as usize {
                    length += 1 + 2 * numbers[length] as usize;
                }
                length
            }
            2 => 4 + 2 * numbers[3] as usize,
            3 => 6,
            4 => 7,
            other => panic!("record {other}"),
        };
        found.push(numbers[..length].to_vec());
        numbers = &numbers[length..];
    }
    found
}
