//! The solver beside the window in a browser: a small program of its own, to
//! be run by a Web Worker. `web/page/worker.js` passes it messages and gives
//! it time; it knows neither.

#![warn(clippy::unwrap_used, clippy::expect_used)]

#[cfg(target_arch = "wasm32")]
mod solver {
    use sinew::solving::wire::{read_order, write_update};
    use sinew::solving::{Executor, Order, Work};
    use wasm_bindgen::prelude::*;

    /// Live work and tasks, from bytes to bytes.
    #[wasm_bindgen]
    #[derive(Default)]
    pub struct Solver {
        executor: Executor,
        busy: bool,
    }

    #[wasm_bindgen]
    impl Solver {
        /// A solver with nothing to do.
        #[wasm_bindgen(constructor)]
        pub fn new() -> Self {
            // What a panic says, as the error that the caller sees.
            std::panic::set_hook(Box::new(|panic| {
                wasm_bindgen::throw_str(&panic.to_string())
            }));
            Self::default()
        }

        /// Takes an order. Whether it is live work.
        ///
        /// # Errors
        /// When the bytes are none.
        pub fn take(&mut self, order: &[u8]) -> Result<bool, JsError> {
            let order = read_order(order)?;
            let is_live = matches!(order, Order::Live(_));
            self.executor.take(order);
            self.busy = true;
            Ok(is_live)
        }

        /// Works for a moment. What it has found, if anything.
        ///
        /// # Errors
        /// When that cannot be written.
        pub fn work(&mut self) -> Result<Option<Vec<u8>>, JsError> {
            Ok(match self.executor.work() {
                Work::More => None,
                Work::Found(update) => Some(write_update(&update)?),
                Work::Done => {
                    self.busy = false;
                    None
                }
            })
        }

        /// Whether there is anything left to do.
        #[wasm_bindgen(getter)]
        pub fn busy(&self) -> bool {
            self.busy
        }
    }
}

fn main() {
    #[cfg(not(target_arch = "wasm32"))]
    eprintln!("this program runs in a browser: see web/build");
}
