//! One sort for all lists that are short or seldom sorted.
//!
//! The standard library's is compiled anew for each kind of item, and each takes some six kilobytes of wasm. What is
//! sorted on the way of every check calls that one all the same.

/// Sorts by a key; what has the same key stays in the order that it is in.
pub(crate) fn order_by_key<T>(items: &mut Vec<T>, key: impl Fn(&T) -> (usize, usize)) {
    let mut order: Vec<((usize, usize), usize)> = items.iter().map(key).zip(0..).collect();
    order.sort_unstable();
    let mut taken: Vec<Option<T>> = items.drain(..).map(Some).collect();
    items.extend(order.into_iter().filter_map(|(_, index)| taken[index].take()));
}

#[cfg(test)]
mod tests {
    use super::order_by_key;

    #[test]
    fn sorts_and_keeps_the_order_of_what_is_alike() {
        let mut words = vec!["Y2", "X1", "X2", "Y1", "G0", "X0"];
        order_by_key(&mut words, |word| (usize::from(word.as_bytes()[0]), 0));
        assert_eq!(words, ["G0", "X1", "X2", "X0", "Y2", "Y1"]);
        order_by_key(&mut words, |word| (usize::from(word.as_bytes()[0]), usize::from(word.as_bytes()[1])));
        assert_eq!(words, ["G0", "X0", "X1", "X2", "Y1", "Y2"]);
    }
}
