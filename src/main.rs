//! The command `sinew`: a thin shell over the library's [`sinew::cli`].

use std::process::ExitCode;

fn main() -> ExitCode {
    sinew::cli::run()
}
