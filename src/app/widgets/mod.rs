//! What the panels and tables are made of: rows, and forms of fields.

mod form;
pub mod row;
mod typed;

pub use form::{Complaint, Form, Number};
pub use typed::Kind;
