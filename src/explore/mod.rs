//! Many equilibria of one robot at once: what it does along its whole pull.
