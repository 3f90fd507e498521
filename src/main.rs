//! The command `sinew`: a thin shell over the library's [`sinew::cli`].

#![warn(clippy::unwrap_used, clippy::expect_used)]

use std::process::ExitCode;

fn main() -> ExitCode {
    sinew::cli::run()
}
