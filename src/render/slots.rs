//! Resources of pictures of the same kind on one screen, such as two
//! viewports: one slot a picture, in the order in which they are prepared.

/// Resources that last from frame to frame, handed out in order.
pub struct Slots<T> {
    items: Vec<T>,
    next: usize,
}

impl<T> Slots<T> {
    /// No resources yet.
    pub fn new() -> Self {
        Self {
            items: Vec::new(),
            next: 0,
        }
    }

    /// The index of the next picture's slot and what is in it, made where it
    /// is new.
    pub fn next(&mut self, make: impl FnOnce() -> T) -> (usize, &mut T) {
        let index = self.next;
        if index == self.items.len() {
            self.items.push(make());
        }
        self.next += 1;
        (index, &mut self.items[index])
    }

    /// Starts with the first slot again: all pictures of a frame are prepared.
    /// Drops the resources of those that are no longer shown.
    pub fn rewind(&mut self) {
        if self.next > 0 {
            self.items.truncate(self.next);
        }
        self.next = 0;
    }

    /// What is in a slot.
    pub fn get(&self, index: usize) -> Option<&T> {
        self.items.get(index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slots_keep_their_order_and_their_contents() {
        let mut slots = Slots::new();
        let frame = |slots: &mut Slots<u32>, makes: &[u32]| -> Vec<u32> {
            let of = |make: &u32| *slots.next(|| *make).1;
            let found = makes.iter().map(of).collect();
            slots.rewind();
            // Every picture's callback does.
            slots.rewind();
            found
        };
        assert_eq!(frame(&mut slots, &[1, 2]), [1, 2]);
        assert_eq!(frame(&mut slots, &[3, 4]), [1, 2]);
        assert_eq!(frame(&mut slots, &[5]), [1]);
        assert_eq!(slots.get(1), None);
        assert_eq!(frame(&mut slots, &[6, 7]), [1, 7]);
    }
}
