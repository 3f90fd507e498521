//! What can be done with the measurements while they are selected.
