//! The program `sinew`: the window where nothing or a scene file is asked for,
//! and the command line. A thin shell over [`sinew::app`] and [`sinew::cli`].

#![warn(clippy::unwrap_used, clippy::expect_used)]

use std::process::ExitCode;

fn main() -> ExitCode {
    #[cfg(feature = "app")]
    if let Some(opening) = sinew::app::desktop::asked_for(std::env::args_os().skip(1)) {
        return sinew::app::desktop::open(&opening);
    }
    sinew::cli::run()
}
