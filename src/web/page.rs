//! The program of the page: the window in a browser. A thin shell over
//! [`sinew::app`].

#![warn(clippy::unwrap_used, clippy::expect_used)]

fn main() {
    #[cfg(target_arch = "wasm32")]
    sinew::app::page::open();
    #[cfg(not(target_arch = "wasm32"))]
    eprintln!("this program runs in a browser: see web/build");
}
