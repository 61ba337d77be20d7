//! Names that are valid for a linkage.

/// Maximum number of characters in a name.
const MAX_NAME: usize = 40;

/// Names already in use.
#[derive(Default)]
pub(super) struct Names(Vec<String>);

impl Names {
    /// Makes a list of link names in which only the frame's name is in use.
    pub(super) fn links() -> Self {
        Self(vec![super::FRAME.to_owned()])
    }

    /// Returns an unused name close to the wanted one or, if the wanted name is empty, a letter for the number.
    pub(super) fn take(&mut self, wished: &str, number: usize) -> String {
        let plain: String = wished.chars().filter(|c| !c.is_control()).collect();
        let mut plain = plain.trim().to_owned();
        if plain.is_empty() {
            plain = letter(number);
        }
        let cut = |room: usize| plain.chars().take(room).collect::<String>();
        let mut name = cut(MAX_NAME);
        let mut again = 2;
        while self.0.contains(&name) {
            let end = format!(" {again}");
            name = cut(MAX_NAME - end.len()) + &end;
            again += 1;
        }
        self.0.push(name.clone());
        name
    }
}

/// Letter for a number: A, B, …, Z, A1, …
pub(crate) fn letter(number: usize) -> String {
    let letter = char::from(b'A' + (number % 26) as u8);
    match number / 26 {
        0 => letter.to_string(),
        round => format!("{letter}{round}"),
    }
}

#[cfg(test)]
mod tests {
    use super::Names;

    #[test]
    fn names_are_unlike_each_other_and_short() {
        let mut names = Names::links();
        let long = "x".repeat(60);
        let taken = ["A", "A", "frame", " \u{7}", &long, &long].map(|name| names.take(name, 27));
        assert_eq!(taken[..4], ["A", "A 2", "frame 2", "B1"]);
        assert_eq!(taken[4], "x".repeat(40));
        assert_eq!(taken[5], format!("{} 2", "x".repeat(38)));
    }
}
