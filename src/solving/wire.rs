//! Orders and updates as bytes, for a solver that shares no memory with the
//! window. Numbers arrive bit for bit.

use super::{Order, Update};

/// Bytes that are no message of this version of the program.
#[derive(Clone, Debug, thiserror::Error)]
#[error("a message between the window and its solver cannot be read or written: {0}")]
pub struct WireError(#[from] postcard::Error);

/// An order as bytes.
///
/// # Errors
/// None is known; those of the format.
pub fn write_order(order: &Order) -> Result<Vec<u8>, WireError> {
    Ok(postcard::to_stdvec(order)?)
}

/// The order that the bytes say.
///
/// # Errors
/// When they are not those of an order.
pub fn read_order(bytes: &[u8]) -> Result<Order, WireError> {
    Ok(postcard::from_bytes(bytes)?)
}

/// An update as bytes.
///
/// # Errors
/// None is known; those of the format.
pub fn write_update(update: &Update) -> Result<Vec<u8>, WireError> {
    Ok(postcard::to_stdvec(update)?)
}

/// The update that the bytes say.
///
/// # Errors
/// When they are not those of an update.
pub fn read_update(bytes: &[u8]) -> Result<Update, WireError> {
    Ok(postcard::from_bytes(bytes)?)
}

#[cfg(test)]
mod tests {
    use super::super::tests::{live, problem, search};
    use super::*;
    use crate::solving::{Executor, StartFrom, Task, TaskId, Work};

    /// A live request, and one for a task of each kind.
    fn orders() -> [Order; 3] {
        let task = Order::Task(TaskId(3), search());
        let problem = problem();
        let shape = Order::Task(TaskId(4), Task::Shape { problem });
        [live(7, StartFrom::Straight), task, shape]
    }

    /// All that an order leads to, as bytes.
    fn answers(order: Order) -> Vec<Vec<u8>> {
        let mut executor = Executor::default();
        executor.take(order);
        let mut found = Vec::new();
        loop {
            match executor.work() {
                Work::More => {}
                Work::Found(update) => found.push(write_update(&update).unwrap()),
                Work::Done => return found,
            }
        }
    }

    #[test]
    fn an_order_that_went_by_wire_is_answered_bit_for_bit() {
        for order in orders() {
            let sent = read_order(&write_order(&order).unwrap()).unwrap();
            assert_eq!(answers(sent), answers(order));
        }
    }

    #[test]
    fn answers_are_the_same_after_the_wire() {
        for (order, least) in orders().into_iter().zip([2, 10, 1]) {
            let found = answers(order);
            assert!(found.len() >= least);
            for bytes in found {
                let again = write_update(&read_update(&bytes).unwrap()).unwrap();
                assert_eq!(again, bytes);
            }
        }
    }

    #[test]
    fn torn_messages_are_refused() {
        for order in orders() {
            let bytes = write_order(&order).unwrap();
            for length in 0..bytes.len() {
                assert!(read_order(&bytes[..length]).is_err(), "{length}");
            }
        }
    }
}
