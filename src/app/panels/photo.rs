//! What can be done with the photograph while it is selected.
